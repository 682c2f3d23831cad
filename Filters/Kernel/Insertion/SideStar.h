// What moving a column's top, and starring its ball anew, does to the sides that the column stays in.
#pragma once

#include "Boundary/Classification.h"
#include "Boundary/EdgeUses.h"
#include "Insertion/SideTurns.h"
#include "Mesh/Star.h"

#include <vector>

namespace ransmesh
{
class SideStar
{
public:
  SideStar(const TetMesh& mesh, const Classification& classes, const SideTurns& turns)
    : mesh_(mesh)
    , classes_(classes)
    , turns_(turns)
  {
  }

  // Remembers the faces of the column's sides in the ball of its top, before that moves.
  void remember(const Column& column, const std::vector<Index>& ball);

  // With the top at its new place: do all these faces keep to the surface?
  bool allowsMove() const;

  // May a star from the column's top take out this vertex of the boundary? Those of the column's own sides
  // may go, and the next one on its ridge, if that turns the ridge no more than a surface may turn.
  bool mayLose(const Column& column, Index vertex) const;

  // May the cavity's faces be replaced by triangles from their rim to the top? They must hang together
  // with those at the top, no patch edge and no ridge may vanish but at the top itself, no vertex may be
  // left inside the volume, and no triangle may turn away from the surface. lost: the vertices that go
  // with the star.
  bool allowsStar(const Cavity& cavity, Index top, const std::vector<Index>& lost);

private:
  struct Face
  {
    Index number;
    double before; // its faithfulness before the move
  };

  double faithfulnessBefore(Index face) const;
  bool rimAllows(const EdgeUse& rim, Index top) const;
  bool mayVanish(const EdgeUse& one, const EdgeUse& other, Index top, const std::vector<Index>& lost) const;
  bool ridgeGoesOn(Index top, Index vertex) const;
  bool hangTogether(const std::vector<Index>& faces, Index top) const;
  bool keepsVertices(const std::vector<Index>& faces, Index top, const std::vector<Index>& lost) const;

  const TetMesh& mesh_;
  const Classification& classes_;
  const SideTurns& turns_;
  std::vector<Face> faces_;
  std::vector<EdgeUse> edges_;
  std::vector<Index> rim_;
};
} // namespace ransmesh
