#include "BenchmarkSurfaces.h"

#ifdef RANSMESHING_READS_SURFACES
#include "SurfaceReader.h"
#endif

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkFieldData.h>
#include <vtkIntArray.h>
#include <vtkMath.h>
#include <vtkNew.h>
#include <vtkPlatonicSolidSource.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkStringArray.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <filesystem>
#include <map>

namespace ransmesh_benchmarks
{
namespace
{
// The sides of a lattice of nx x ny x nz cubes.
class LatticeShell
{
public:
  LatticeShell(std::array<int, 3> count, double size)
    : count_(count)
    , size_(size)
  {
    patchIds_->SetName("PatchId");
    for (int axis = 0; axis < 3; ++axis)
    {
      addSide(axis, 0, 1 + 2 * axis);
      addSide(axis, count[axis], 2 + 2 * axis);
    }
  }

  vtkSmartPointer<vtkPolyData> surface(
    const std::array<const char*, 7>& names, const std::array<const char*, 7>& types)
  {
    auto result = vtkSmartPointer<vtkPolyData>::New();
    result->SetPoints(points_);
    result->SetPolys(triangles_);
    result->GetCellData()->AddArray(patchIds_);
    addStrings("PatchNames", names, result);
    addStrings("PatchTypes", types, result);
    return result;
  }

private:
  static void addStrings(const char* name, const std::array<const char*, 7>& texts, vtkPolyData* surface)
  {
    vtkNew<vtkStringArray> array;
    array->SetName(name);
    for (const char* text : texts)
    {
      array->InsertNextValue(text);
    }
    surface->GetFieldData()->AddArray(array);
  }

  vtkIdType pointAt(const std::array<int, 3>& place)
  {
    const auto [it, isNew] = numbers_.try_emplace(place, points_->GetNumberOfPoints());
    if (isNew)
    {
      points_->InsertNextPoint(size_ * place[0], size_ * place[1], size_ * place[2]);
    }
    return it->second;
  }

  // Diagonals alternate, so that no direction is preferred.
  void addSquare(const std::array<vtkIdType, 4>& c, bool other, int patch)
  {
    const int first = other ? 1 : 0;
    for (const int second : { first + 1, first + 2 })
    {
      const vtkIdType corners[3] = { c[first], c[second % 4], c[(second + 1) % 4] };
      triangles_->InsertNextCell(3, corners);
      patchIds_->InsertNextValue(patch);
    }
  }

  void addSide(int axis, int level, int patch)
  {
    const int u = (axis + 1) % 3;
    const int v = (axis + 2) % 3;
    for (int i = 0; i < count_[u]; ++i)
    {
      for (int j = 0; j < count_[v]; ++j)
      {
        const auto corner = [&](int di, int dj)
        {
          std::array<int, 3> place{};
          place[axis] = level;
          place[u] = i + di;
          place[v] = j + dj;
          return pointAt(place);
        };
        std::array<vtkIdType, 4> c = { corner(0, 0), corner(1, 0), corner(1, 1), corner(0, 1) };
        if (level == 0) // outward is downward
        {
          std::swap(c[1], c[3]);
        }
        addSquare(c, (i + j) % 2 != 0, patch);
      }
    }
  }

  std::array<int, 3> count_;
  double size_;
  std::map<std::array<int, 3>, vtkIdType> numbers_;
  vtkNew<vtkPoints> points_;
  vtkNew<vtkCellArray> triangles_;
  vtkNew<vtkIntArray> patchIds_;
};

vtkIdType addOnSphere(const double* direction, vtkPoints* points)
{
  double x[3] = { direction[0], direction[1], direction[2] };
  vtkMath::Normalize(x);
  return points->InsertNextPoint(0.5 * x[0], 0.5 * x[1], 0.5 * x[2]);
}

// Each triangle becomes four, with the new points on the sphere.
vtkSmartPointer<vtkCellArray> cutInFour(vtkCellArray* triangles, vtkPoints* points)
{
  std::map<std::pair<vtkIdType, vtkIdType>, vtkIdType> middles;
  const auto middle = [&](vtkIdType a, vtkIdType b)
  {
    const auto [it, isNew] = middles.try_emplace(std::minmax(a, b), points->GetNumberOfPoints());
    if (isNew)
    {
      double x[3];
      double y[3];
      points->GetPoint(a, x);
      points->GetPoint(b, y);
      vtkMath::Add(x, y, x);
      addOnSphere(x, points);
    }
    return it->second;
  };
  auto result = vtkSmartPointer<vtkCellArray>::New();
  vtkIdType size = 0;
  const vtkIdType* v = nullptr;
  for (vtkIdType t = 0; t < triangles->GetNumberOfCells(); ++t)
  {
    triangles->GetCellAtId(t, size, v);
    const vtkIdType m[3] = { middle(v[0], v[1]), middle(v[1], v[2]), middle(v[2], v[0]) };
    result->InsertNextCell({ v[0], m[0], m[2] });
    result->InsertNextCell({ m[0], v[1], m[1] });
    result->InsertNextCell({ m[2], m[1], v[2] });
    result->InsertNextCell({ m[0], m[1], m[2] });
  }
  return result;
}
} // namespace

vtkSmartPointer<vtkPolyData> plate(int n)
{
  LatticeShell shell({ n, n, n / 4 }, 1.0 / n);
  return shell.surface({ "fluid", "west", "east", "south", "north", "floor", "lid" },
    { "fluid", "symmetry", "symmetry", "symmetry", "symmetry", "wall", "farfield" });
}

vtkSmartPointer<vtkPolyData> sphere(int level)
{
  vtkNew<vtkPlatonicSolidSource> solid;
  solid->SetSolidTypeToIcosahedron();
  solid->Update();
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (vtkIdType i = 0; i < solid->GetOutput()->GetNumberOfPoints(); ++i)
  {
    addOnSphere(solid->GetOutput()->GetPoint(i), points);
  }
  vtkSmartPointer<vtkCellArray> triangles = solid->GetOutput()->GetPolys();
  for (int i = 0; i < level; ++i)
  {
    triangles = cutInFour(triangles, points);
  }
  auto surface = vtkSmartPointer<vtkPolyData>::New();
  surface->SetPoints(points);
  surface->SetPolys(triangles);
  return surface;
}

std::string hullFile()
{
  const char* chosen = std::getenv("RANSMESHING_HULL");
  return chosen ? chosen : RANSMESHING_HULL;
}

bool hullIsThere()
{
#ifdef RANSMESHING_READS_SURFACES
  return std::filesystem::exists(hullFile());
#else
  return false;
#endif
}

vtkSmartPointer<vtkPolyData> hull()
{
#ifdef RANSMESHING_READS_SURFACES
  return hullIsThere() ? surfaces::readSurfaces({ hullFile() }) : nullptr;
#else
  return nullptr;
#endif
}
} // namespace ransmesh_benchmarks
