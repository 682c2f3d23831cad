// The edge lengths that a surface is to have.
#pragma once

#include "Remeshing/EditableSurface.h"
#include "Remeshing/SurfaceGaps.h"
#include "Remeshing/SurfaceReference.h"
#include "Remeshing/SurfaceRemeshing.h"

#include <memory>
#include <vector>

namespace ransmesh
{
class RemeshSizes
{
public:
  // Both must live as long as this.
  RemeshSizes(const SurfaceReference& reference, const RemeshingOptions& options);

  // The wanted edge length at each point of a surface with the reference's patches and lines. Curvature is
  // measured on the surface's own triangles: edges that are longer than wanted see less of it.
  std::vector<double> at(const EditableSurface& surface, bool byCurvature) const;

private:
  double wantedAt(const EditableSurface& surface, Index v, bool byCurvature) const;
  double smallestOf(int patch) const;
  double curvedLength(const EditableSurface& surface, Index v) const;
  double bentLength(const EditableSurface& surface, Index v) const;
  double stripLength(const EditableSurface& surface, Index v) const;
  double givenLength(const EditableSurface& surface, Index v, int patch) const;

  const SurfaceReference& reference_;
  const RemeshingOptions& options_;
  std::vector<double> lengths_; // by patch
  std::unique_ptr<SurfaceGaps> gaps_;
};

// Lowers sizes so that along an edge they grow by at most slope times its length.
void limitGrowth(const EditableSurface& surface, double slope, std::vector<double>& sizes);
} // namespace ransmesh
