// Sheets for the tests, as poly data.
#ifndef TestSheets_h
#define TestSheets_h

#include "vtkCellArray.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <array>
#include <vector>

namespace TestSheets
{
using Place = std::array<double, 3>;

// The parallelogram at a corner, with two sides, in so many cells of two triangles each.
inline vtkSmartPointer<vtkPolyData> Flat(
  const Place& corner, const Place& first, const Place& second, int cellsAlongFirst, int cellsAlongSecond)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (int j = 0; j <= cellsAlongSecond; ++j)
  {
    for (int i = 0; i <= cellsAlongFirst; ++i)
    {
      Place p;
      for (int k = 0; k < 3; ++k)
      {
        p[k] = corner[k] + first[k] * i / cellsAlongFirst + second[k] * j / cellsAlongSecond;
      }
      points->InsertNextPoint(p.data());
    }
  }
  vtkNew<vtkCellArray> triangles;
  const vtkIdType row = cellsAlongFirst + 1;
  for (vtkIdType j = 0; j < cellsAlongSecond; ++j)
  {
    for (vtkIdType i = 0; i < cellsAlongFirst; ++i)
    {
      const vtkIdType v = j * row + i;
      triangles->InsertNextCell({ v, v + 1, v + row + 1 });
      triangles->InsertNextCell({ v, v + row + 1, v + row });
    }
  }
  vtkNew<vtkPolyData> sheet;
  sheet->SetPoints(points);
  sheet->SetPolys(triangles);
  return sheet;
}

// The box [0, 1] x [0, 1] x [0, 1] with so many cells along each side, for sheets that end on it.
inline std::vector<vtkSmartPointer<vtkPolyData>> UnitBoxSides(int cells)
{
  const Place o = { 0, 0, 0 };
  const Place x = { 1, 0, 0 };
  const Place y = { 0, 1, 0 };
  const Place z = { 0, 0, 1 };
  return { Flat(o, z, y, cells, cells), Flat(x, y, z, cells, cells), Flat(o, x, z, cells, cells),
    Flat(y, z, x, cells, cells), Flat(o, y, x, cells, cells), Flat(z, x, y, cells, cells) };
}
} // namespace TestSheets

#endif
