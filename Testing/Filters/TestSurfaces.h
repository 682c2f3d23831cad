// Closed surfaces for the tests of the mesher, as poly data.
#ifndef TestSurfaces_h
#define TestSurfaces_h

#include "vtkAppendPolyData.h"
#include "vtkCellArray.h"
#include "vtkCleanPolyData.h"
#include "vtkCubeSource.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"
#include "vtkSphereSource.h"
#include "vtkTriangleFilter.h"

#include <array>
#include <vector>

namespace TestSurfaces
{
inline vtkSmartPointer<vtkPolyData> Cube(double low, double high)
{
  vtkNew<vtkCubeSource> source;
  source->SetBounds(low, high, low, high, low, high);
  source->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
  vtkNew<vtkTriangleFilter> triangles;
  triangles->SetInputConnection(source->GetOutputPort());
  triangles->Update();
  vtkNew<vtkPolyData> bare; // without the source's normals
  bare->SetPoints(triangles->GetOutput()->GetPoints());
  bare->SetPolys(triangles->GetOutput()->GetPolys());
  return bare;
}

inline vtkSmartPointer<vtkPolyData> Sphere(double radius, int resolution, double x = 0)
{
  vtkNew<vtkSphereSource> source;
  source->SetRadius(radius);
  source->SetCenter(x, 0, 0);
  source->SetThetaResolution(resolution);
  source->SetPhiResolution(resolution);
  source->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
  source->Update();
  vtkNew<vtkPolyData> bare;
  bare->SetPoints(source->GetOutput()->GetPoints());
  bare->SetPolys(source->GetOutput()->GetPolys());
  return bare;
}

inline vtkSmartPointer<vtkPolyData> Together(const std::vector<vtkPolyData*>& parts)
{
  vtkNew<vtkAppendPolyData> append;
  append->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
  for (vtkPolyData* part : parts)
  {
    append->AddInputData(part);
  }
  append->Update();
  return append->GetOutput();
}

// A closed cup with walls of the given thickness: the square tube [0, 1] x [0, 1] x [0, 2], open above.
inline vtkSmartPointer<vtkPolyData> Cup(double wall)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  const auto ring = [&points](double inset, double z)
  {
    const double a = inset;
    const double b = 1 - inset;
    points->InsertNextPoint(a, a, z);
    points->InsertNextPoint(b, a, z);
    points->InsertNextPoint(b, b, z);
    points->InsertNextPoint(a, b, z);
  };
  ring(0, 0);
  ring(0, 2);
  ring(wall, 2);
  ring(wall, wall);
  vtkNew<vtkCellArray> quads;
  for (vtkIdType level = 0; level < 3; ++level)
  {
    for (vtkIdType i = 0; i < 4; ++i)
    {
      const vtkIdType j = (i + 1) % 4;
      quads->InsertNextCell({ 4 * level + i, 4 * level + j, 4 * level + 4 + j, 4 * level + 4 + i });
    }
  }
  quads->InsertNextCell({ 3, 2, 1, 0 });
  quads->InsertNextCell({ 12, 13, 14, 15 });
  vtkNew<vtkPolyData> cup;
  cup->SetPoints(points);
  cup->SetPolys(quads);
  return cup;
}

inline vtkSmartPointer<vtkPolyData> Triangles(
  const std::vector<std::array<double, 3>>& places, const std::vector<std::array<vtkIdType, 3>>& cells)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (const auto& p : places)
  {
    points->InsertNextPoint(p.data());
  }
  vtkNew<vtkCellArray> polygons;
  for (const auto& t : cells)
  {
    polygons->InsertNextCell({ t[0], t[1], t[2] });
  }
  vtkNew<vtkPolyData> surface;
  surface->SetPoints(points);
  surface->SetPolys(polygons);
  return surface;
}
} // namespace TestSurfaces

#endif
