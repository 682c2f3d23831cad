// Stacks that would fold: found from the columns alone, and mended by lowering columns.
#pragma once

#include "Insertion/BaseFaces.h"
#include "Layers/Column.h"
#include "Mesh/TetMesh.h"

#include <vector>

namespace ransmesh
{
// Before the front rises: lowers, step by step, the columns of faces whose slab, taken as one layer of full height, has a
// tetrahedron that is not positive, and the highest columns of those whose stack has one, until none has. Gives the
// boundary's faces that still fold with their columns as low as they can be, and with the tops where they are now: to
// raise the front with these would be in vain. faces: all of them, as collectBaseFaces gives them.
std::vector<Index> limitByFolds(const TetMesh& mesh, const std::vector<BaseFace>& faces, ColumnSet& set);

// After it: do all stacks of these faces have only positive tetrahedra, with the tops where the mesh's
// vertices are? Gives the numbers of those that have not.
std::vector<Index> findFoldedStacks(
  const TetMesh& mesh, const ColumnSet& set, const std::vector<BaseFace>& faces);

// Lowers the tops at folded stacks, if the mesh beyond allows it, until no stack folds. False if some
// stack can not be mended so; its faces are left in folded.
bool mendFolds(TetMesh& mesh, ColumnSet& set, std::vector<Index>& foldedFaces);

// Lowers the top of a column onto the highest level not above the given one where the mesh beyond stays
// valid, down to the wall. False, and nothing is changed, where there is none.
bool lowerTop(TetMesh& mesh, ColumnSet& set, Index column, int level);
} // namespace ransmesh
