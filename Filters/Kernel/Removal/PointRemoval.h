// Makes room for the layers: takes the isotropic points out of the region that they are going to fill
// (R. Loehner, Int. J. Numer. Meth. Engng 49 (2000) 219-232, section 6).
#pragma once

#include "Layers/LayerSpecification.h"
#include "Mesh/TetMesh.h"
#include "Removal/RemovalVerdict.h"
#include "Support/Context.h"
#include "Support/Outcome.h"
#include "Support/Patch.h"

#include <array>
#include <cstddef>
#include <vector>

namespace ransmesh
{
struct RemovalOptions
{
  // How far beyond the layers points are taken out as well, times the size of the wall's triangles.
  double margin = 0.4;
  // The same for points of walls in the layers of other walls, at concave ridges. Measured in cavities of
  // four and six walls: at 0.35 the enrichment gives up 3 to 40 times as many corners as at 0.7.
  double cornerMargin = 0.7;
  // How far a boundary face may turn, degrees, 0 to 90.
  double maximumSurfaceAngle = defaults::maximumSurfaceAngle;
};

struct RemovalResult
{
  Outcome outcome;
  std::size_t marked = 0;           // points in the region that may go
  std::size_t removed = 0;          // of these
  std::vector<Index> remaining;     // marked points that are still there, by their number in the mesh
  std::size_t markedOnWalls = 0;    // of all marked: points of walls, in the layers of another wall
  std::size_t remainingOnWalls = 0; // of these
  // Of remaining: points that the boundary's shape needs, as they are in the end. On it (MaximumSurfaceAngle and
  // Removal/SurfaceMemory.h), most lie on curved walls beside concave ridges; in the volume, the space between walls
  // cannot be filled without them (Removal/RefillRemover.h; E. Schoenhardt, Math. Ann. 98, 1928).
  std::size_t neededByShape = 0;
  RemovalTally verdicts{}; // of all attempts, many of which concern the same point
  std::size_t movements = 0;
  std::size_t swaps = 0;

  // One line for the user.
  std::string text() const;
};

// Removes from the mesh what findLayerRegion marks. Points go by collapse onto the neighbour that leaves
// the best quality, by starring an enlarged cavity, with limits that relax from pass to pass, and with
// swaps and movement between. Points of walls stay but for those in corners (Removal/CornerRegion.h), and so do corners
// and interfaces; points on surfaces go along their own surface or ridge. The mesh is valid at every moment, and stays
// so when the outcome is Cancelled. BadInput if a triangle's patch is missing in patches. The same input gives the
// same result.
RemovalResult removePoints(TetMesh& mesh, const PatchTable& patches, const LayerPlan& plan,
  const RemovalOptions& options, const Context& context);
} // namespace ransmesh
