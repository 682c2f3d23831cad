#include "PatchedSurface.h"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkFieldData.h>
#include <vtkIntArray.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkStringArray.h>

namespace surfaces
{
namespace
{
// What number `row` is called in a field data array, or nothing.
std::string textAt(vtkPolyData* data, const char* array, int row)
{
  auto* texts = vtkStringArray::SafeDownCast(data->GetFieldData()->GetAbstractArray(array));
  return texts && row >= 0 && row < texts->GetNumberOfValues() ? std::string(texts->GetValue(row)) : "";
}

// The numbers of the patches, as vtkIsotropicTetMesher finds them: the project's own array, or what another tool has
// left, if it tells several numbers apart.
vtkDataArray* patchArrayOf(vtkPolyData* data)
{
  vtkCellData* cells = data->GetCellData();
  if (vtkDataArray* own = cells->GetArray("PatchId"))
  {
    return own;
  }
  for (const char* name : { "CellEntityIds", "gmsh:physical", "ModelFaceID", "medit:ref", "su2:tag",
         "cell_tags", "netgen:index", "STLSolidLabeling", "GroupIds" })
  {
    vtkDataArray* ids = cells->GetArray(name);
    if (ids && ids->GetRange()[0] < ids->GetRange()[1])
    {
      return ids;
    }
  }
  return nullptr;
}
} // namespace

PatchedSurface::PatchedSurface()
{
  points_->SetDataTypeToDouble();
  patchIds_->SetName("PatchId");
}

PatchedSurface::~PatchedSurface() = default;

vtkIdType PatchedSurface::addPoint(double x, double y, double z)
{
  return points_->InsertNextPoint(x, y, z);
}

vtkIdType PatchedSurface::pointCount() const
{
  return points_->GetNumberOfPoints();
}

int PatchedSurface::patchOf(const std::string& name, const std::string& type)
{
  const auto [found, isNew] = numbers_.try_emplace(name, static_cast<int>(patches_.size()) + 1);
  if (isNew)
  {
    patches_.push_back({ name, type });
  }
  return found->second;
}

void PatchedSurface::startPatch(const std::string& name)
{
  current_ = patchOf(name, "");
}

void PatchedSurface::addPolygon(const std::vector<vtkIdType>& points)
{
  polygons_->InsertNextCell(static_cast<vtkIdType>(points.size()), points.data());
  patchIds_->InsertNextValue(current_);
}

void PatchedSurface::append(vtkPolyData* data, const std::string& name)
{
  const vtkIdType firstPoint = pointCount();
  for (vtkIdType i = 0; i < data->GetNumberOfPoints(); ++i)
  {
    points_->InsertNextPoint(data->GetPoint(i));
  }
  vtkDataArray* ids = patchArrayOf(data);
  // Polygons come after the vertices and lines in a data set's numbering of cells.
  const vtkIdType firstPolygon = data->GetNumberOfVerts() + data->GetNumberOfLines();
  std::vector<vtkIdType> polygon;
  for (vtkIdType i = 0; i < data->GetNumberOfPolys(); ++i)
  {
    vtkIdType size = 0;
    const vtkIdType* corners = nullptr;
    data->GetPolys()->GetCellAtId(i, size, corners);
    polygon.assign(corners, corners + size);
    for (vtkIdType& corner : polygon)
    {
      corner += firstPoint;
    }
    const int row = ids ? static_cast<int>(ids->GetTuple1(firstPolygon + i)) : 0;
    const std::string own = ids ? textAt(data, "PatchNames", row) : "";
    const std::string numbered = ids ? name + "_" + std::to_string(row) : name;
    current_ = patchOf(own.empty() ? numbered : own, ids ? textAt(data, "PatchTypes", row) : "");
    addPolygon(polygon);
  }
}

void PatchedSurface::nameOnlyPatch(const std::string& name)
{
  if (patches_.size() == 1)
  {
    patches_.front().name = name;
    numbers_ = { { name, 1 } };
  }
}

vtkSmartPointer<vtkPolyData> PatchedSurface::finish() const
{
  vtkNew<vtkStringArray> names;
  vtkNew<vtkStringArray> types;
  names->SetName("PatchNames");
  types->SetName("PatchTypes");
  names->InsertNextValue("fluid");
  types->InsertNextValue("fluid");
  bool typesKnown = false;
  for (const Patch& patch : patches_)
  {
    names->InsertNextValue(patch.name);
    types->InsertNextValue(patch.type.empty() ? "patch" : patch.type);
    typesKnown = typesKnown || !patch.type.empty();
  }
  auto data = vtkSmartPointer<vtkPolyData>::New();
  data->SetPoints(points_);
  data->SetPolys(polygons_);
  data->GetCellData()->AddArray(patchIds_);
  data->GetFieldData()->AddArray(names);
  if (typesKnown)
  {
    data->GetFieldData()->AddArray(types);
  }
  return data;
}
} // namespace surfaces
