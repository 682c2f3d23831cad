// The moves of a single top of the front.
#pragma once

#include "Boundary/Classification.h"
#include "Insertion/Front.h"
#include "Insertion/SideStar.h"
#include "Insertion/TopCavity.h"
#include "Mesh/Star.h"
#include "Mesh/Traversal.h"

namespace ransmesh
{
// How hard a move may try: what it accepts grows with the effort.
// The least quality that a move may be content with: in layers and gaps much thinner than the surface's size all
// tetrahedra are needles, but in a plane side a flatter one is positive by rounding alone, and its triangle may be
// turned over.
inline constexpr double LeastQualityOfMoves = 1e-11;

struct MoveEffort
{
  double leastQuality;      // of the tetrahedra after a move that makes them worse
  std::size_t cavityGrowth; // tetrahedra that a cavity may gain beyond the ball
};

enum class MoveVerdict
{
  Moved,     // the top moved, the mesh's connectivity is as before
  Restarred, // its ball was starred anew
  SlabFolds, // a tetrahedron between wall and front would not be positive
  NoRoom,    // no way was found that leaves the mesh beyond valid and good enough
  Count
};

inline bool isDone(MoveVerdict verdict)
{
  return verdict == MoveVerdict::Moved || verdict == MoveVerdict::Restarred;
}

class FrontMoves
{
public:
  FrontMoves(
    TetMesh& mesh, const ColumnSet& set, const Classification& classes, const SideTurns& turns, Front& front);

  // Moves the column's top to x, if that can be done; otherwise changes nothing.
  MoveVerdict move(Index column, const Vector3& x, const MoveEffort& effort);

  // Below this a tetrahedron is worth changing the connectivity for. Between narrow triangles of the front and points
  // far beyond all tetrahedra are needles: at 0.12 most changes on an aircraft were made for these, in vain, and what
  // is poor at the end of the way is mended then (FrontImprovement.h).
  static constexpr double GoodQuality = 0.01;
  // A move that keeps this part of the worst quality before it needs no new connectivity either.
  static constexpr double QualityKept = 0.9;

private:
  double worstQuality(const std::vector<Index>& tets) const;
  double qualityOf(Index tet) const;
  double floorFor(Index column, double leastQuality, double before);
  bool restar(const Column& column, double wanted, std::size_t growth, bool sidesHold);
  bool starBest(const Column& column, double wanted, std::size_t growth, bool sidesHold);
  bool isStarrable(const Column& column, Index apex, double wanted, std::size_t growth, bool sidesHold);
  const std::vector<Index>& othersThan(Index vertex);
  bool mayStar(const Column& column, Index apex, bool sidesHold);
  bool mayLose(const Column& column, Index apex) const;

  TetMesh& mesh_;
  const ColumnSet& set_;
  const Classification& classes_;
  Front& front_;
  SideStar sides_;
  Star star_;
  Traversal traversal_;
  TopCavity grown_;
  std::vector<double> firstQuality_; // around each top before its first single move; < 0: not known yet
  std::vector<Index> ball_;
  std::vector<Index> seed_;   // the tetrahedra that a cavity begins with
  std::vector<Index> others_; // from which it may be starred
  Cavity best_;
};
} // namespace ransmesh
