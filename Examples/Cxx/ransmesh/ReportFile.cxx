#include "ReportFile.h"

#include "Json.h"

#include <vtkCellData.h>
#include <vtkCellType.h>
#include <vtkDataArray.h>
#include <vtkFieldData.h>
#include <vtkMeshQualityReport.h>
#include <vtkPolyData.h>
#include <vtkRANSLayerAlgorithm.h>
#include <vtkStringArray.h>
#include <vtkUnstructuredGrid.h>

#include <map>

namespace commandline
{
namespace
{
Json textsOf(const std::vector<std::string>& texts)
{
  Json array = Json::array();
  for (const std::string& text : texts)
  {
    array.add(Json::text(text));
  }
  return array;
}

void addIfGiven(Json& object, const std::string& key, double value)
{
  if (value > 0)
  {
    object.add(key, Json::number(value));
  }
}

Json requestOf(const Options& options)
{
  Json request = Json::object();
  request.add("arguments", textsOf(options.words));
  request.add("surfaces", textsOf(options.surfaces));
  request.add("output", Json::text(options.output));
  request.add("isotropic_only", Json::truth(options.isotropicOnly));
  request.add("walls", textsOf(options.walls));
  addIfGiven(request, "far_field", options.farField);
  addIfGiven(request, "size", options.size);
  addIfGiven(request, "first_height", options.firstHeight);
  addIfGiven(request, "velocity", options.flow.velocity);
  addIfGiven(request, "reynolds", options.flow.reynoldsNumber);
  addIfGiven(request, "length", options.flow.length);
  addIfGiven(request, "y_plus", options.flow.yPlus);
  addIfGiven(request, "growth", options.growth);
  addIfGiven(request, "layers", options.layers);
  addIfGiven(request, "thickness", options.thickness);
  return request;
}

Json startOf(const Options& options, const std::string& error)
{
  Json report = Json::object();
  report.add("status", Json::text(error.empty() ? "done" : "failed"));
  if (!error.empty())
  {
    report.add("error", Json::text(error));
  }
  report.add("request", requestOf(options));
  return report;
}

Json timesOf(const Chain& chain)
{
  Json times = Json::object();
  for (const StageTime& time : chain.times())
  {
    times.add(time.name, Json::number(time.seconds));
  }
  return times;
}

Json flowOf(const vtkRANSLayerAlgorithm& layers)
{
  return Json::object()
    .add("reynolds_number", Json::number(layers.GetEstimatedReynoldsNumber()))
    .add("skin_friction", Json::number(layers.GetEstimatedSkinFriction()))
    .add("friction_velocity", Json::number(layers.GetEstimatedFrictionVelocity()))
    .add("first_height", Json::number(layers.GetEstimatedFirstHeight()))
    .add("boundary_layer_thickness", Json::number(layers.GetEstimatedBoundaryLayerThickness()))
    .add("layers", Json::number(layers.GetPlannedNumberOfLayers()))
    .add("total_thickness", Json::number(layers.GetPlannedTotalThickness()));
}

struct FaceCount
{
  int triangles = 0;
  int quadrilaterals = 0;
};

// Of each patch, by its number.
std::map<int, FaceCount> facesOf(vtkUnstructuredGrid* mesh)
{
  std::map<int, FaceCount> faces;
  vtkDataArray* ids = mesh->GetCellData()->GetArray("PatchId");
  for (vtkIdType cell = 0; ids && cell < ids->GetNumberOfTuples(); ++cell)
  {
    FaceCount& count = faces[static_cast<int>(ids->GetTuple1(cell))];
    ++(mesh->GetCellType(cell) == VTK_QUAD ? count.quadrilaterals : count.triangles);
  }
  return faces;
}

Json patchesOf(vtkUnstructuredGrid* mesh)
{
  std::map<int, FaceCount> faces = facesOf(mesh);
  auto* names = vtkStringArray::SafeDownCast(mesh->GetFieldData()->GetAbstractArray("PatchNames"));
  auto* types = vtkStringArray::SafeDownCast(mesh->GetFieldData()->GetAbstractArray("PatchTypes"));
  Json patches = Json::array();
  for (vtkIdType i = 1; names && types && i < names->GetNumberOfValues(); ++i)
  {
    const FaceCount& count = faces[static_cast<int>(i)];
    patches.add(Json::object()
                  .add("number", Json::number(static_cast<double>(i)))
                  .add("name", Json::text(names->GetValue(i)))
                  .add("type", Json::text(types->GetValue(i)))
                  .add("triangles", Json::number(count.triangles))
                  .add("quadrilaterals", Json::number(count.quadrilaterals)));
  }
  return patches;
}
} // namespace

std::string reportOf(const Options& options, const std::string& error)
{
  return startOf(options, error).write() + "\n";
}

std::string reportOf(const Options& options, const Chain& chain, const std::string& error)
{
  Json report = startOf(options, error);
  report.add("warnings", textsOf(chain.warnings()));
  report.add("seconds", timesOf(chain));
  if (options.flow.isGiven())
  {
    report.add("flow", flowOf(*chain.layers()));
  }
  if (error.empty())
  {
    report.add("patches", patchesOf(chain.mesh()));
    report.add("quality", Json::raw(chain.report()->GetReportJson()));
  }
  else
  {
    report.add("problem_triangles", Json::number(static_cast<double>(chain.problems()->GetNumberOfCells())));
  }
  return report.write() + "\n";
}
} // namespace commandline
