// The examples' own body: a cone with a spherical nose, at incidence.
#pragma once

#include <vtkSmartPointer.h>

class vtkPolyData;

namespace nosecone
{
struct Shape
{
  double length = 1.0;
  double noseRadius = 0.1;
  double halfAngle = 9.0;       // degrees, of the cone
  double shoulderRadius = 0.06; // between cone and base; 0 gives a sharp ridge
  double incidence = 10.0;      // degrees, nose up from the x axis
  double edgeLength = 0.02;     // of the triangles
};

// A closed surface of nearly equal triangles, the nose's tip at the origin, with the wall patches "body" and
// "base" (PatchId, PatchNames, PatchTypes). Throws std::invalid_argument for a shape that cannot be.
vtkSmartPointer<vtkPolyData> makeSurface(const Shape& shape);
} // namespace nosecone
