// In which order columns rise in the first level.
//
// The tetrahedron on a triangle of the wall is as high as that of its columns which rises first is above it. Where the
// wall turns, a column may be right above some of its triangles only. So columns come first that are right above all of
// theirs, then those that are right above all that are left.
#pragma once

#include "Insertion/BaseFaces.h"

namespace ransmesh
{
// Sets the columns' firstRank, once the fans are open, and the order in the faces, which are all of them, as
// collectBaseFaces gives them. Where not all triangles can be right the least area is given up.
void orderFirstRise(const TetMesh& mesh, std::vector<BaseFace>& faces, ColumnSet& set);
} // namespace ransmesh
