// What makes a mesh valid, as counted faults.
#pragma once

#include "Mesh/FaceMatching.h"
#include "Mesh/TetMesh.h"

#include <cstddef>
#include <string>

namespace ransmesh
{
struct MeshFaults
{
  std::size_t indicesOutOfRange = 0;
  std::size_t pointsNotFinite = 0;
  std::size_t pointsCoincident = 0;
  std::size_t pointsUnused = 0;
  std::size_t tetsNotPositive = 0; // in exact arithmetic
  std::size_t facesInMoreThanTwoTets = 0;
  std::size_t facesWithoutTriangle = 0;
  std::size_t trianglesOffTheBoundary = 0;
  std::size_t repeatedTriangles = 0;
  std::size_t trianglesTurnedInward = 0;
  std::size_t brokenLinks = 0; // of a TetMesh: neighbours that do not agree
  Index firstTet = None;       // a tetrahedron that has a fault
  Index firstTriangle = None;  // a triangle that has a fault
  Index firstPoint = None;     // a point that has a fault

  bool none() const;
  // All faults in one line, with the first places.
  std::string text() const;
};

// Complete: these invariants are the whole contract of a valid mesh. Triangles between two tetrahedra are
// sheets, and right, if all triangles of their patch are so. Gives the matching on request.
MeshFaults findFaults(const MeshData& mesh, FaceMatching* matching = nullptr);

// The same for a mesh under change, with its links.
MeshFaults findFaults(const TetMesh& mesh);

// Volume of all tetrahedra, in the cube of the length unit.
double totalVolume(const MeshData& mesh);
} // namespace ransmesh
