#include "SurfaceOutput.h"

#include "PatchFieldData.h"

#include "Support/DataContract.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

namespace ransmesh
{
void writeSurface(const SurfaceMesh& surface, const PatchTable& patches, vtkPolyData* output)
{
  output->Initialize();
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->SetNumberOfPoints(static_cast<vtkIdType>(surface.points.size()));
  for (std::size_t i = 0; i < surface.points.size(); ++i)
  {
    const Vector3& p = surface.points[i];
    points->SetPoint(static_cast<vtkIdType>(i), p.x, p.y, p.z);
  }
  vtkNew<vtkCellArray> cells;
  vtkNew<vtkIntArray> patchIds;
  patchIds->SetName(contract::PatchId);
  patchIds->SetNumberOfValues(static_cast<vtkIdType>(surface.triangles.size()));
  for (std::size_t t = 0; t < surface.triangles.size(); ++t)
  {
    const auto& v = surface.triangles[t];
    const vtkIdType corners[3] = { v[0], v[1], v[2] };
    cells->InsertNextCell(3, corners);
    patchIds->SetValue(static_cast<vtkIdType>(t), surface.patch[t]);
  }
  output->SetPoints(points);
  output->SetPolys(cells);
  output->GetCellData()->AddArray(patchIds);
  writePatches(patches, output->GetFieldData());
}
} // namespace ransmesh
