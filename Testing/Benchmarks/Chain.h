// One case of the benchmarks: a surface, and what each stage makes of it, made when first asked for.
#pragma once

#include "BenchmarkCases.h"

#include "Insertion/Enrichment.h"
#include "Layers/LayerPlanning.h"
#include "Mesh/MeshData.h"
#include "Removal/PointRemoval.h"
#include "Support/Patch.h"

#include <vtkSmartPointer.h>

#include <optional>
#include <stdexcept>
#include <string>

class vtkPolyData;

namespace ransmesh_benchmarks
{
// Errors of stages are std::runtime_error here.
class Chain
{
public:
  explicit Chain(CaseDescription description)
    : description_(std::move(description))
  {
  }
  const CaseDescription& description() const { return description_; }
  const std::string& name() const { return description_.name; }

  // Each runs its stage on the result of the one before; that is kept, the stage's own result too.
  void mesh();
  ransmesh::RemovalResult remove(ransmesh::TetMesh& mesh) const;
  void enrich();
  // The enrichment as a filter, with its conversions from and to VTK's grids; gives the processor seconds.
  double runEnrichmentFilter();

  // Results of stages, which run first where they have not yet.
  const ransmesh::MeshData& isotropic();
  const ransmesh::MeshData& cleared();
  const ransmesh::EnrichedMesh& enriched();

  ransmesh::TetMesh editableIsotropic();
  void keepCleared(const ransmesh::TetMesh& mesh);
  const ransmesh::PatchTable& patches() const { return patches_; }
  const ransmesh::LayerPlan& plan() const { return plan_; }

  // Kept for comparison: points a second, and bytes a tetrahedron; 0: not measured.
  struct Figures
  {
    double enrichmentRate = 0;
    double filterRate = 0;
    double cgalRate = 0;
    double enrichmentBytes = 0;
  };
  Figures figures;

private:
  vtkSmartPointer<vtkPolyData> surface();

  CaseDescription description_;
  vtkSmartPointer<vtkPolyData> surface_;
  ransmesh::PatchTable patches_;
  ransmesh::LayerPlan plan_;
  std::optional<ransmesh::MeshData> isotropic_;
  std::optional<ransmesh::MeshData> cleared_;
  std::optional<ransmesh::EnrichedMesh> enriched_;
};
} // namespace ransmesh_benchmarks
