#include "Vtk/ChainRun.h"

#include "Bodies/Cases.h"
#include "Boundary/SheetSides.h"
#include "Geometry/TetrahedronMeasures.h"
#include "Mesh/Validation.h"
#include "MeshConversion.h"
#include "Support/DataContract.h"
#include "Vtk/BodyPolyData.h"
#include "Vtk/LayerMeasures.h"

#include <vtkCallbackCommand.h>
#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkDirectionalEnrichment.h>
#include <vtkFieldData.h>
#include <vtkIsotropicTetMesher.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkRANSPointRemoval.h>
#include <vtkStringArray.h>
#include <vtkUnstructuredGrid.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <set>
#include <stdexcept>

namespace chain_run
{
namespace
{
namespace contract = ransmesh::contract;

double runStage(vtkAlgorithm* stage)
{
  std::string errors;
  vtkNew<vtkCallbackCommand> listener;
  listener->SetClientData(&errors);
  listener->SetCallback([](vtkObject*, unsigned long, void* text, void* message)
    { *static_cast<std::string*>(text) += static_cast<const char*>(message); });
  const auto observer = stage->AddObserver(vtkCommand::ErrorEvent, listener);
  const auto begin = std::chrono::steady_clock::now();
  stage->Update();
  stage->RemoveObserver(observer);
  if (!errors.empty())
  {
    throw std::runtime_error(errors);
  }
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

void countColumns(vtkPolyData* boundary, ChainResult& result)
{
  vtkPointData* data = boundary->GetPointData();
  vtkDataArray* asked = data->GetArray(contract::LayersAsked);
  vtkDataArray* achieved = data->GetArray(contract::LayersAchieved);
  vtkDataArray* reason = data->GetArray(contract::StopReason);
  auto* names =
    vtkStringArray::SafeDownCast(boundary->GetFieldData()->GetAbstractArray(contract::StopReasonNames));
  for (vtkIdType i = 0; i < boundary->GetNumberOfPoints(); ++i)
  {
    if (asked->GetTuple1(i) > 0)
    {
      result.asked += static_cast<vtkIdType>(asked->GetTuple1(i));
      ++result.columns;
      result.fullColumns += achieved->GetTuple1(i) == asked->GetTuple1(i) ? 1 : 0;
      ++result.stopReasons[names->GetValue(static_cast<vtkIdType>(reason->GetTuple1(i)))];
    }
  }
}

void measureAngles(const ransmesh::MeshData& mesh, vtkDataArray* layer, ChainResult& result)
{
  result.tetrahedra = static_cast<vtkIdType>(mesh.tetrahedra.size());
  for (vtkIdType t = 0; t < result.tetrahedra; ++t)
  {
    const auto& v = mesh.tetrahedra[t];
    const auto& p = mesh.points;
    const double angle = ransmesh::largestDihedral(p[v[0]], p[v[1]], p[v[2]], p[v[3]]);
    if (layer->GetTuple1(t) > 0)
    {
      ++result.layerTetrahedra;
      result.over175 += angle > 175 ? 1 : 0;
      result.over179 += angle > 179 ? 1 : 0;
      result.largestAngle = std::max(result.largestAngle, angle);
    }
    else
    {
      result.largestAngleOutside = std::max(result.largestAngleOutside, angle);
    }
  }
}

using Face = std::array<ransmesh::Index, 3>;

Face sorted(Face face)
{
  std::sort(face.begin(), face.end());
  return face;
}

// The faces whose corners lie on three columns.
std::set<Face> facesOfColumns(const ransmesh::MeshData& mesh, vtkDataArray* column)
{
  std::set<Face> faces;
  for (const auto& t : mesh.tetrahedra)
  {
    for (int skip = 0; skip < 4; ++skip)
    {
      const Face face = { t[(skip + 1) % 4], t[(skip + 2) % 4], t[(skip + 3) % 4] };
      const double c[3] = { column->GetTuple1(face[0]), column->GetTuple1(face[1]),
        column->GetTuple1(face[2]) };
      if (c[0] >= 0 && c[1] >= 0 && c[2] >= 0 && c[0] != c[1] && c[1] != c[2] && c[2] != c[0])
      {
        faces.insert(sorted(face));
      }
    }
  }
  return faces;
}

void countCopies(const ransmesh::MeshData& mesh, vtkDataArray* column, int layers, ChainResult& result)
{
  const std::set<Face> faces = facesOfColumns(mesh, column);
  std::map<int, std::vector<ransmesh::Index>> pointsOf; // from the wall outward
  for (std::size_t i = 0; i < mesh.points.size(); ++i)
  {
    pointsOf[static_cast<int>(column->GetTuple1(static_cast<vtkIdType>(i)))].push_back(
      static_cast<ransmesh::Index>(i));
  }
  std::size_t wanted = 0;
  std::size_t found = 0;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
  {
    if (std::find(result.walls.begin(), result.walls.end(), mesh.trianglePatch[t]) == result.walls.end())
    {
      continue;
    }
    for (int level = 0; level <= layers; ++level, ++wanted)
    {
      Face face{};
      bool isThere = true;
      for (int i = 0; i < 3; ++i)
      {
        const int c = static_cast<int>(column->GetTuple1(mesh.triangles[t][i]));
        const auto& points = pointsOf[c];
        isThere = isThere && c >= 0 && static_cast<int>(points.size()) > level;
        face[i] = isThere ? points[level] : 0;
      }
      found += isThere && faces.count(sorted(face)) > 0 ? 1 : 0;
    }
  }
  result.copiesOfWallFaces = wanted > 0 ? static_cast<double>(found) / static_cast<double>(wanted) : 0;
}

double volumeOf(vtkUnstructuredGrid* grid)
{
  ransmesh::MeshData mesh;
  ransmesh::PatchTable patches;
  return ransmesh::readMesh(grid, mesh, patches).ok() ? ransmesh::totalVolume(mesh) : 0;
}

void judge(vtkPolyData* boundary, const ChainOptions& options, ChainResult& result)
{
  ransmesh::MeshData mesh;
  ransmesh::PatchTable patches;
  if (const ransmesh::Outcome outcome = ransmesh::readMesh(result.mesh, mesh, patches); !outcome.ok())
  {
    throw std::runtime_error(outcome.message);
  }
  const ransmesh::LayerPlan plan = ransmesh::readPlan(result.mesh->GetFieldData());
  for (std::size_t i = 1; i < plan.size(); ++i)
  {
    if (plan[i].hasLayers())
    {
      result.walls.push_back(static_cast<int>(i));
    }
  }
  for (const ransmesh::SheetTriangle& sheet : ransmesh::findSheets(mesh))
  {
    const int patch = mesh.trianglePatch[sheet.triangle];
    if (std::find(result.sheets.begin(), result.sheets.end(), patch) == result.sheets.end())
    {
      result.sheets.push_back(patch);
    }
  }
  const ransmesh::MeshFaults faults = ransmesh::findFaults(mesh);
  result.faults = faults.none() ? "" : faults.text();
  countColumns(boundary, result);
  measureAngles(mesh, result.mesh->GetCellData()->GetArray(contract::LayerId), result);
  vtkDataArray* column = result.mesh->GetPointData()->GetArray(contract::ColumnId);
  countCopies(mesh, column, options.layers, result);
  const std::vector<int> inGaps = levelsInGaps(mesh, boundary);
  const FirstHeightShares firstHeights = firstHeightShares(mesh, plan, inGaps);
  result.areaWithFirstHeight = firstHeights.ofAll;
  result.areaAwayFromGaps = firstHeights.awayFromGaps;
  result.columnsWithTheirLayers = columnsWithTheirLayers(mesh, plan, inGaps);
  result.growthOff = growthOff(mesh, column, plan);
}

ChainResult runFilters(vtkIsotropicTetMesher* mesher, vtkPolyData* surface, const ChainOptions& options)
{
  ChainResult result;
  vtkNew<vtkRANSPointRemoval> removal;
  vtkNew<vtkDirectionalEnrichment> enrichment;
  mesher->SetInputData(surface);
  mesher->SetFarField(options.farField);
  if (options.symmetryPlace)
  {
    mesher->SetSymmetryPlane(vtkIsotropicTetMesher::ACROSS_Z);
    mesher->SetSymmetryPosition(*options.symmetryPlace);
  }
  mesher->SetSurfaceEdgeLength(options.surfaceSize);
  mesher->SetImproveSurfaceTriangles(options.swapAngle > 0);
  mesher->SetMaximumSurfaceAngle(options.swapAngle);
  removal->SetInputConnection(mesher->GetOutputPort());
  removal->SetFirstHeight(options.firstHeight);
  removal->SetGrowthRate(options.growth);
  removal->SetNumberOfLayers(options.layers);
  for (const std::string& pattern : options.walls)
  {
    removal->AddWallPatch(pattern.c_str());
  }
  for (const PatchLayers& p : options.patchLayers)
  {
    removal->SetPatchLayers(p.pattern.c_str(), p.firstHeight, p.growth, p.layers);
  }
  enrichment->SetInputConnection(removal->GetOutputPort());
  mesher->ReleaseDataFlagOn();
  removal->ReleaseDataFlagOn();
  result.seconds[0] = runStage(mesher);
  result.volume = volumeOf(mesher->GetOutput());
  result.seconds[1] = runStage(removal);
  const double cleared = volumeOf(removal->GetOutput());
  result.seconds[2] = runStage(enrichment);
  result.marked = removal->GetNumberOfMarkedPoints();
  result.removed = removal->GetNumberOfRemovedPoints();
  result.ofShape = removal->GetNumberOfShapePoints();
  result.requested = enrichment->GetNumberOfRequestedPoints();
  result.inserted = enrichment->GetNumberOfInsertedPoints();
  result.mesh = vtkUnstructuredGrid::SafeDownCast(enrichment->GetOutputDataObject(0));
  result.volumeChangeByRemoval = std::fabs(cleared - result.volume) / result.volume;
  result.volumeChange = std::fabs(volumeOf(result.mesh) - cleared) / result.volume;
  judge(vtkPolyData::SafeDownCast(enrichment->GetOutputDataObject(1)), options, result);
  return result;
}
} // namespace

ChainOptions optionsFor(const bodies::Case& c, const bodies::Layers& layers, const bodies::Body& body)
{
  ChainOptions options;
  options.firstHeight = layers.firstHeight;
  options.growth = layers.growth;
  options.layers = layers.number;
  for (const bodies::PatchLayers& p : c.patchLayers)
  {
    options.patchLayers.push_back({ p.patch, p.firstHeight * layers.firstHeight, p.growth, p.number });
  }
  // Where some are named, all walls must be.
  for (std::size_t i = 1; i < body.patches.size() && !c.patchLayers.empty(); ++i)
  {
    if (body.patches[i].type == ransmesh::PatchType::Wall)
    {
      options.walls.push_back(body.patches[i].name);
    }
  }
  return options;
}

ChainResult runChain(vtkPolyData* surface, const ChainOptions& options)
{
  vtkNew<vtkIsotropicTetMesher> mesher;
  return runFilters(mesher, surface, options);
}

ChainResult runChain(const bodies::Body& body, ChainOptions options)
{
  vtkNew<vtkIsotropicTetMesher> mesher;
  options.farField = body.farField;
  for (const bodies::Body& sheet : body.sheets)
  {
    mesher->AddSheetData(toPolyData(sheet));
    for (std::size_t i = 1; i < sheet.patches.size(); ++i)
    {
      mesher->SetPatchType(sheet.patches[i].name.c_str(), std::string(nameOf(sheet.patches[i].type)).c_str());
    }
  }
  return runFilters(mesher, toPolyData(body), options);
}
} // namespace chain_run
