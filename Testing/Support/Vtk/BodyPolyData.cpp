#include "Vtk/BodyPolyData.h"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkFieldData.h>
#include <vtkIntArray.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkStringArray.h>

namespace bodies
{
namespace
{
void addPatches(const ransmesh::PatchTable& patches, vtkFieldData* fieldData)
{
  vtkNew<vtkStringArray> names;
  names->SetName("PatchNames");
  vtkNew<vtkStringArray> types;
  types->SetName("PatchTypes");
  for (const ransmesh::Patch& patch : patches)
  {
    names->InsertNextValue(patch.name);
    types->InsertNextValue(std::string(nameOf(patch.type)));
  }
  fieldData->AddArray(names);
  fieldData->AddArray(types);
}
} // namespace

vtkSmartPointer<vtkPolyData> toPolyData(const Body& body)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (const ransmesh::Vector3& p : body.surface.points)
  {
    points->InsertNextPoint(p.x, p.y, p.z);
  }
  vtkNew<vtkCellArray> triangles;
  vtkNew<vtkIntArray> patchIds;
  patchIds->SetName("PatchId");
  for (std::size_t t = 0; t < body.surface.triangles.size(); ++t)
  {
    const auto& v = body.surface.triangles[t];
    triangles->InsertNextCell({ v[0], v[1], v[2] });
    patchIds->InsertNextValue(body.surface.patch[t]);
  }
  auto result = vtkSmartPointer<vtkPolyData>::New();
  result->SetPoints(points);
  result->SetPolys(triangles);
  result->GetCellData()->AddArray(patchIds);
  addPatches(body.patches, result->GetFieldData());
  return result;
}
} // namespace bodies
