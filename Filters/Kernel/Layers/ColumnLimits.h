// How high the columns may grow: by the local isotropic size and by their neighbours. The gap to the
// opposite surface has a file of its own (GapLimits.h).
#pragma once

#include "Boundary/BoundaryStars.h"
#include "Layers/Column.h"

namespace ransmesh
{
// No level whose spacing exceeds the isotropic fraction of the local size (the paper's section 3).
void limitByIsotropicSize(const LayerPlan& plan, ColumnSet& set);

// By so much of the distance between their feet may the heights of neighbours differ.
inline constexpr double LargestSlope = 0.7;

// Heights of neighbours differ by no more than the largest slope allows, also where walls of other layers
// begin, and where the wall ends in a surface without layers: no cliffs for tall layers, no effect on thin
// ones.
void limitBySlope(const TetMesh& mesh, const BoundaryStars& stars, ColumnSet& set);

// The highest level of the column that does not exceed the height.
int levelBelow(const ColumnSet& set, const Column& column, double height);

// Lowers the column, one of the set, so that it does not exceed the height. Where it has all its layers, and these can
// be squeezed so far, it keeps them; else it stops, for the reason given, at the highest level below.
void limitHeight(ColumnSet& set, Column& column, double height, StopReason why);
} // namespace ransmesh
