#include "ProblemOutput.h"

#include "Support/DataContract.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkFieldData.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkStringArray.h"

#include <map>

namespace ransmesh
{
namespace
{
// Where a point is shown: one that is no number, at the middle of the triangle's other corners.
Vector3 shownPlace(const SurfaceMesh& surface, Index triangle, Index v)
{
  if (isUsable(surface.points[v]))
  {
    return surface.points[v];
  }
  Vector3 sum;
  int usable = 0;
  for (const Index corner : surface.triangles[triangle])
  {
    if (isUsable(surface.points[corner]))
    {
      sum = sum + surface.points[corner];
      ++usable;
    }
  }
  return usable > 0 ? (1.0 / usable) * sum : Vector3();
}

vtkNew<vtkIntArray> namedArray(const char* name)
{
  vtkNew<vtkIntArray> array;
  array->SetName(name);
  return array;
}
} // namespace

void writeProblems(
  const SurfaceMesh& surface, const std::vector<SurfaceFinding>& findings, vtkPolyData* output)
{
  output->Initialize();
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> cells;
  const auto reasons = namedArray(contract::Reason);
  const auto partners = namedArray(contract::PartnerId);
  const auto patches = namedArray(contract::PatchId);

  std::map<Index, int> cellOf; // the first finding about a triangle
  for (std::size_t i = 0; i < findings.size(); ++i)
  {
    cellOf.emplace(findings[i].triangle, static_cast<int>(i));
  }
  std::map<Index, vtkIdType> pointOf;
  for (const SurfaceFinding& finding : findings)
  {
    vtkIdType corners[3];
    for (int k = 0; k < 3; ++k)
    {
      const Index v = surface.triangles[finding.triangle][k];
      const auto [place, isNew] = pointOf.emplace(v, points->GetNumberOfPoints());
      if (isNew)
      {
        const Vector3 p = shownPlace(surface, finding.triangle, v);
        points->InsertNextPoint(p.x, p.y, p.z);
      }
      corners[k] = place->second;
    }
    cells->InsertNextCell(3, corners);
    reasons->InsertNextValue(static_cast<int>(finding.fault));
    const auto partner = cellOf.find(finding.partner);
    partners->InsertNextValue(partner == cellOf.end() ? -1 : partner->second);
    patches->InsertNextValue(surface.patch[finding.triangle]);
  }
  output->SetPoints(points);
  output->SetPolys(cells);
  output->GetCellData()->SetScalars(reasons); // ParaView colours by it
  output->GetCellData()->AddArray(partners);
  output->GetCellData()->AddArray(patches);
  vtkNew<vtkStringArray> names;
  names->SetName(contract::ReasonNames);
  for (const std::string_view name : SurfaceFaultNames)
  {
    names->InsertNextValue(std::string(name));
  }
  output->GetFieldData()->AddArray(names);
}
} // namespace ransmesh
