#include "Insertion/FrontMoves.h"

#include "Geometry/TetrahedronMeasures.h"

#include <algorithm>
#include <limits>

namespace ransmesh
{
namespace
{
// A move that makes tetrahedra flatter than this needs a better connectivity.
constexpr double FlattestKept = 0.01;
// Where a top's surroundings were poor from the beginning, this share of their quality is enough: needles
// on the wall make needles in the volume.
constexpr double ShareOfPoor = 0.3;
} // namespace

FrontMoves::FrontMoves(
  TetMesh& mesh, const ColumnSet& set, const Classification& classes, const SideTurns& turns, Front& front)
  : mesh_(mesh)
  , set_(set)
  , classes_(classes)
  , front_(front)
  , sides_(mesh, classes, turns)
  , star_(mesh)
  , traversal_(mesh)
  , grown_(mesh)
  , firstQuality_(set.columns.size(), -1)
{
}

double FrontMoves::worstQuality(const std::vector<Index>& tets) const
{
  double worst = std::numeric_limits<double>::infinity();
  for (const Index t : tets)
  {
    worst = std::min(worst, qualityOf(t));
  }
  return worst;
}

double FrontMoves::qualityOf(Index tet) const
{
  const auto& v = mesh_.tet(tet).vertex;
  return quality(mesh_.point(v[0]), mesh_.point(v[1]), mesh_.point(v[2]), mesh_.point(v[3]));
}

double FrontMoves::floorFor(Index column, double leastQuality, double before)
{
  double& first = firstQuality_[column];
  first = first < 0 ? before : first;
  return std::min(leastQuality, ShareOfPoor * first);
}

MoveVerdict FrontMoves::move(Index column, const Vector3& x, const MoveEffort& effort)
{
  if (!front_.slabAllows(column, x))
  {
    return MoveVerdict::SlabFolds;
  }
  const Column& c = set_.columns[column];
  traversal_.ball(c.vertex, ball_);
  const double before = worstQuality(ball_);
  const Vector3 old = mesh_.point(c.vertex);
  sides_.remember(c, ball_);
  mesh_.movePoint(c.vertex, x);
  const double after = worstQuality(ball_);
  const bool sidesHold = sides_.allowsMove();
  const bool isGood =
    after > GoodQuality || (after >= QualityKept * before && after > floorFor(column, FlattestKept, before));
  if (sidesHold && isGood)
  {
    return MoveVerdict::Moved;
  }
  const double least = floorFor(column, effort.leastQuality, before);
  const double wanted = sidesHold ? std::max(after, least) : least;
  if (restar(c, wanted, effort.cavityGrowth, sidesHold))
  {
    return MoveVerdict::Restarred;
  }
  if (sidesHold && after > least)
  {
    return MoveVerdict::Moved;
  }
  mesh_.movePoint(c.vertex, old);
  return MoveVerdict::NoRoom;
}

// Stars the ball of the column's top, which stands at its new place already, from the vertex that
// leaves the best tetrahedra; the cavity grows through faces below the quality wanted. Isotropic points
// inside vanish. Where no vertex sees the ball, it may see that part of it that the move spoils: most often one
// tetrahedron between tops, and what lies behind it.
bool FrontMoves::restar(const Column& column, double wanted, std::size_t growth, bool sidesHold)
{
  others_.clear();
  seed_ = ball_;
  if (starBest(column, wanted, growth, sidesHold))
  {
    return true;
  }
  std::erase_if(seed_, [&](Index t) { return qualityOf(t) > wanted; });
  return starBest(column, wanted, growth, sidesHold);
}

bool FrontMoves::starBest(const Column& column, double wanted, std::size_t growth, bool sidesHold)
{
  grown_.begin(seed_, mesh_.point(column.vertex));
  if (isStarrable(column, column.vertex, wanted, growth, sidesHold))
  {
    star_.apply();
    return true;
  }
  Index best = None;
  for (const Index apex : othersThan(column.vertex))
  {
    if (isStarrable(column, apex, wanted, growth, sidesHold))
    {
      wanted = grown_.worst();
      best_ = grown_.cavity();
      best = apex;
    }
  }
  if (best == None || star_.check(best_, best) != StarVerdict::Possible)
  {
    return false;
  }
  star_.apply();
  return true;
}

bool FrontMoves::isStarrable(
  const Column& column, Index apex, double wanted, std::size_t growth, bool sidesHold)
{
  const Column* ofSides = apex == column.vertex ? &column : nullptr;
  return grown_.grow(apex, wanted, ball_.size() + growth, ofSides) && grown_.worst() > wanted &&
    star_.check(grown_.cavity(), apex) == StarVerdict::Possible && mayStar(column, apex, sidesHold);
}

// The vertices of the ball; most often the top itself will do, and nobody asks.
const std::vector<Index>& FrontMoves::othersThan(Index vertex)
{
  if (!others_.empty())
  {
    return others_;
  }
  for (const Index t : ball_)
  {
    for (const Index v : mesh_.tet(t).vertex)
    {
      if (v != vertex && std::find(others_.begin(), others_.end(), v) == others_.end())
      {
        others_.push_back(v);
      }
    }
  }
  return others_;
}

// Starred from elsewhere, the sides' faces at the top stay as they are: they must hold then.
bool FrontMoves::mayStar(const Column& column, Index apex, bool sidesHold)
{
  return (sidesHold || apex == column.vertex) && mayLose(column, apex) &&
    sides_.allowsStar(grown_.cavity(), column.vertex, star_.lostVertices());
}

// Only isotropic points may vanish: those of the volume, and those of the column's own sides when the
// sides' triangles are starred with the rest.
bool FrontMoves::mayLose(const Column& column, Index apex) const
{
  return std::all_of(star_.lostVertices().begin(), star_.lostVertices().end(),
    [&](Index v)
    {
      if (classes_.kind[v] == VertexKind::Volume)
      {
        return true;
      }
      return apex == column.vertex && set_.ofVertex[v] == None && sides_.mayLose(column, v);
    });
}
} // namespace ransmesh
