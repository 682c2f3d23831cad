#include "Improvement/FlatTetrahedra.h"

#include "Improvement/LocalImprovement.h"
#include "Mesh/Builder.h"

#include <algorithm>

namespace ransmesh
{
namespace
{
constexpr double FlatQuality = 1e-13;
constexpr int MostPasses = 10; // each swap betters the worst around it, so that they end; few are needed

// True if a swap was made.
bool swapOnce(TetMesh& mesh, LocalImprovement& improvement)
{
  bool isChanged = false;
  for (Index t = 0; t < static_cast<Index>(mesh.tetSlots()); ++t)
  {
    if (mesh.tet(t).isAlive() && qualityOf(mesh, t) < FlatQuality)
    {
      isChanged = improvement.swap(t) || isChanged;
    }
  }
  return isChanged;
}
} // namespace

std::size_t countFlatTetrahedra(const MeshData& mesh)
{
  const auto& p = mesh.points;
  return std::count_if(mesh.tetrahedra.begin(), mesh.tetrahedra.end(),
    [&p](const auto& t) { return quality(p[t[0]], p[t[1]], p[t[2]], p[t[3]]) < FlatQuality; });
}

std::size_t swapFlatTetrahedra(const PatchTable& patches, MeshData& mesh)
{
  TetMesh tets;
  if (!buildTetMesh(mesh, tets).ok())
  {
    return countFlatTetrahedra(mesh);
  }
  const BoundaryRules rules{ classify(tets, patches), std::vector<char>(patches.size(), 0) };
  LocalImprovement improvement(tets, rules);
  for (int pass = 0; pass < MostPasses && swapOnce(tets, improvement); ++pass)
  {
  }
  mesh = toMeshData(tets);
  return countFlatTetrahedra(mesh);
}
} // namespace ransmesh
