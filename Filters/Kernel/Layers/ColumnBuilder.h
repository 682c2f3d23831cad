// One column for each point of the viscous walls: its direction, its sides, its heights.
#pragma once

#include "Boundary/BoundaryStars.h"
#include "Layers/Column.h"
#include "Support/Patch.h"

namespace ransmesh
{
// The direction is the angle-weighted normal of the wall faces, turned until it sees all faces that it
// stands on as well as possible (the most-visible normal), and laid into the adjoining patches that the
// layers run into (symmetry, inflow ...): one makes a surface column, two make a ridge column. The step
// is scaled so that the height above the wall faces is the level's. Where no direction serves, the
// column has no levels and says why. gridsOnWakes: whether patches of type wake may have tensor corners.
ColumnSet buildColumns(const TetMesh& mesh, const BoundaryStars& stars, const PatchTable& patches,
  const LayerPlan& plan, bool gridsOnWakes = true);

// A face that has a standing column for which its patch is not a side carries layers. Where its columns disagree,
// those that stand on it are dropped (StopReason::Corner), so that every face is the one or the other. Gives whether
// any was dropped.
bool settleDisagreements(const TetMesh& mesh, ColumnSet& set);
} // namespace ransmesh
