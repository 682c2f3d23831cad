// Directional enrichment: layers of stretched tetrahedra on the viscous walls.
//
// After R. Loehner, Generation of non-isotropic unstructured grids via directional enrichment, Int. J.
// Numer. Meth. Engng 49 (2000) 219-232. Where the paper inserts point after point by cavities, this
// stage moves the wall's triangulation out along the normals to the layers' outermost level, the mesh
// beyond giving way by local changes of connectivity, and writes the levels below in closed form.
#pragma once

#include "Insertion/CornerChoice.h"
#include "Insertion/FanOpening.h"
#include "Insertion/FrontRaising.h"
#include "Layers/Column.h"
#include "Mesh/MeshData.h"
#include "Support/Context.h"
#include "Support/Outcome.h"
#include "Support/Patch.h"

#include <vector>

namespace ransmesh
{
struct EnrichmentOptions
{
  double gapFraction = defaults::gapFraction;                 // (0, 0.5]
  double maximumSurfaceAngle = defaults::maximumSurfaceAngle; // degrees, [0, 90]
  bool gridsOnWakes = true; // whether patches of type wake may have tensor corners with other walls
};

// What became of one point of a wall.
struct WallPoint
{
  Index point = None; // in the mesh that comes out
  int patch = 0;
  int layersAsked = 0;
  int layersAchieved = 0;
  double firstHeightAsked = 0;
  double firstHeightAchieved = 0; // height of the first point above the wall faces; 0 without layers
  StopReason reason = StopReason::Complete;
};

struct EnrichmentReport
{
  std::size_t columns = 0;
  std::size_t pointsRequested = 0; // after the limits by size, gap and slope; with tensor-product corners
  std::size_t pointsInserted = 0;
  std::size_t layerTets = 0;
  std::size_t improvements = 0; // swaps and movements beyond the front
  std::size_t restarts = 0;     // times that folded stacks were lowered and the stage began anew
  std::array<std::size_t, static_cast<std::size_t>(StopReason::Count)> columnsByReason{};
  FanReport fans;
  GridReport grids;
  RaisingReport raising;
};

struct EnrichedMesh
{
  MeshData mesh;
  std::vector<int> layer; // of each tetrahedron: 0 none, else 1 at the wall, counting outward
  std::vector<Index>
    stacks; // the first tetrahedron of each stack of layers, in order; all others come before
  std::vector<Index> column; // of each point: its column; None
  std::vector<Index> origin; // of each point: the point of the input it is or, for a new one, stands over
  // One for each column's root, in order of number; then one for each new point of the walls, in
  // tensor-product corners, where what is asked ends with the wall's share of the corner.
  std::vector<WallPoint> wallPoints;
  EnrichmentReport report;
};

// Of each tetrahedron: those of one prism, which is one layer of a stack, share a number, from 0; None. Made on
// demand, as it takes as much memory as a quarter of the tetrahedra.
std::vector<Index> numberPrisms(const EnrichedMesh& enriched);

// Enriches a valid mesh by a plan as planLayers makes it. The result is valid: every tetrahedron exactly
// positive, every face matched; or the outcome says why there is none.
Outcome enrich(const MeshData& input, const PatchTable& patches, const LayerPlan& plan,
  const EnrichmentOptions& options, const Context& context, EnrichedMesh& result);
} // namespace ransmesh
