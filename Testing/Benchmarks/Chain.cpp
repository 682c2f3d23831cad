#include "Chain.h"

#include "Mesh/Builder.h"
#include "MeshConversion.h"

#include <vtkCallbackCommand.h>
#include <vtkDirectionalEnrichment.h>
#include <vtkFieldData.h>
#include <vtkIsotropicTetMesher.h>
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkUnstructuredGrid.h>

#include <ctime>

namespace ransmesh_benchmarks
{
namespace
{
double processorSeconds()
{
  return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

void require(const ransmesh::Outcome& outcome)
{
  if (!outcome.ok())
  {
    throw std::runtime_error(outcome.message);
  }
}
} // namespace

vtkSmartPointer<vtkPolyData> Chain::surface()
{
  if (!surface_)
  {
    surface_ = description_.surface();
  }
  if (!surface_)
  {
    throw std::runtime_error("left out: its surface is not there");
  }
  return surface_;
}

void Chain::mesh()
{
  vtkNew<vtkIsotropicTetMesher> mesher;
  std::string errors;
  vtkNew<vtkCallbackCommand> listener;
  listener->SetClientData(&errors);
  listener->SetCallback([](vtkObject*, unsigned long, void* text, void* message)
    { *static_cast<std::string*>(text) += static_cast<const char*>(message); });
  mesher->AddObserver(vtkCommand::ErrorEvent, listener);
  mesher->SetInputData(surface());
  mesher->SetFarField(description_.farField);
  mesher->Update();
  if (!errors.empty())
  {
    throw std::runtime_error(errors);
  }
  ransmesh::MeshData mesh;
  require(ransmesh::readMesh(mesher->GetOutput(), mesh, patches_));
  ransmesh::LayerRequest request;
  request.general.firstHeight = description_.firstHeight;
  request.general.numberOfLayers = description_.layers;
  request.wallPatterns = description_.walls;
  require(ransmesh::planLayers(mesh, patches_, request, plan_));
  isotropic_ = std::move(mesh);
}

ransmesh::RemovalResult Chain::remove(ransmesh::TetMesh& mesh) const
{
  ransmesh::RemovalResult result = ransmesh::removePoints(mesh, patches_, plan_, {}, {});
  require(result.outcome);
  return result;
}

void Chain::enrich()
{
  const ransmesh::MeshData& input = cleared();
  enriched_.reset();
  ransmesh::EnrichedMesh result;
  require(ransmesh::enrich(input, patches_, plan_, {}, {}, result));
  enriched_ = std::move(result);
}

double Chain::runEnrichmentFilter()
{
  vtkNew<vtkUnstructuredGrid> grid;
  ransmesh::writeMesh(cleared(), patches_, grid);
  ransmesh::writePlan(plan_, grid->GetFieldData());
  vtkNew<vtkDirectionalEnrichment> filter;
  filter->SetInputData(grid);
  const double begin = processorSeconds();
  filter->Update();
  return processorSeconds() - begin;
}

ransmesh::TetMesh Chain::editableIsotropic()
{
  ransmesh::TetMesh mesh;
  require(ransmesh::buildTetMesh(isotropic(), mesh));
  return mesh;
}

void Chain::keepCleared(const ransmesh::TetMesh& mesh)
{
  cleared_ = ransmesh::toMeshData(mesh);
}

const ransmesh::MeshData& Chain::isotropic()
{
  if (!isotropic_)
  {
    mesh();
  }
  return *isotropic_;
}

const ransmesh::MeshData& Chain::cleared()
{
  if (!cleared_)
  {
    ransmesh::TetMesh mesh = editableIsotropic();
    remove(mesh);
    keepCleared(mesh);
  }
  return *cleared_;
}

const ransmesh::EnrichedMesh& Chain::enriched()
{
  if (!enriched_)
  {
    enrich();
  }
  return *enriched_;
}
} // namespace ransmesh_benchmarks
