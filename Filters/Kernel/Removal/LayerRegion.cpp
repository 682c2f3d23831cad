#include "Removal/LayerRegion.h"

#include "Geometry/SpatialOrder.h"
#include "Mesh/LocalNumbers.h"
#include "Mesh/Traversal.h"
#include "Removal/WallReach.h"

#include <algorithm>
#include <bit>
#include <cstdint>
#include <span>
#include <utility>

namespace ransmesh
{
namespace
{
// Remembers the pairs that came lately: those that come again soon are most.
class RecentPairs
{
public:
  // Whether (a, b) is not among those remembered. Remembers it.
  bool isNew(Index a, Index b)
  {
    const auto pair = static_cast<std::uint64_t>(a) << 32 | static_cast<std::uint32_t>(b);
    std::uint64_t& place = pairs_[(pair * 0x9e3779b97f4a7c15ULL) >> 52];
    return std::exchange(place, pair) != pair;
  }

private:
  std::vector<std::uint64_t> pairs_ = std::vector<std::uint64_t>(4096, ~std::uint64_t{ 0 });
};

// Finds the vertices inside the region, from the walls outward: for each, a wall triangle within whose
// reach it lies.
class Advance
{
public:
  Advance(const TetMesh& mesh, const WallReach& walls)
    : mesh_(mesh)
    , walls_(walls)
    , traversal_(mesh)
    , triangle_(mesh.vertexCount(), None)
    , place_(mesh.vertexCount(), Outside)
  {
    for (std::size_t v = 0; v < place_.size(); ++v)
    {
      place_[v] = walls.isWall(static_cast<Index>(v)) ? OfWall : Outside;
    }
  }

  void run()
  {
    startFromWalls();
    for (std::size_t next = 0; next < inside_.size();)
    {
      const std::size_t end = inside_.size();
      passOnAll(next, end);
      next = end;
    }
  }

  // In the order in which they were found.
  const std::vector<Index>& inside() const { return inside_; }
  double reach(Index v) const { return walls_.reach(triangle_[v]); }
  double attainableQuality(Index v) const { return walls_.attainableQuality(triangle_[v]); }

private:
  enum Place : char // bits, so that those of a tetrahedron are soon together
  {
    Outside = 1,
    Front = 2, // inside, to be passed on from now
    OfWall = 4,
    Later = 8, // inside, found meanwhile: to be passed on after the front
    Behind = 16
  };

  // The neighbours of the walls' vertices. One look at all tetrahedra in their order is quicker than a
  // walk around each vertex; what is needed of a pair waits for memory, so that is asked for ahead.
  void startFromWalls()
  {
    constexpr std::size_t ahead = 12;
    std::vector<std::pair<Index, Index>> pairs;
    forEachTouching(OfWall,
      [&](Index w, Index v)
      {
        pairs.emplace_back(w, v);
        walls_.fetchAhead(w);
      });
    for (std::size_t i = 0; i < pairs.size(); ++i)
    {
      const auto& later = pairs[std::min(i + ahead, pairs.size() - 1)];
      walls_.fetchCeilingAhead(later.first);
      mesh_.fetchPointAhead(later.second);
      if (place_[pairs[i].second] == Outside)
      {
        offerTrianglesAt(pairs[i].first, pairs[i].second);
      }
    }
  }

  // All pairs of neighbours of which the one is there and the other one is still outside.
  template <class Visit>
  void forEachTouching(Place there, Visit visit)
  {
    for (std::size_t t = 0; t < mesh_.tetSlots(); ++t)
    {
      const Tetrahedron& tet = mesh_.tet(static_cast<Index>(t));
      if (!tet.isAlive())
      {
        continue;
      }
      const auto& v = tet.vertex;
      const int places = place_[v[0]] | place_[v[1]] | place_[v[2]] | place_[v[3]];
      if ((places & (there | Outside)) == (there | Outside))
      {
        visitTouching(tet, there, visit);
      }
    }
  }

  template <class Visit>
  void visitTouching(const Tetrahedron& tet, Place there, Visit visit)
  {
    unsigned from = 0; // bit i for corner i
    for (int i = 0; i < 4; ++i)
    {
      from |= static_cast<unsigned>(place_[tet.vertex[i]] == there) << i;
    }
    for (; from != 0; from &= from - 1)
    {
      const Index one = tet.vertex[std::countr_zero(from)];
      for (const Index other : tet.vertex)
      {
        if (place_[other] == Outside && offered_.isNew(one, other))
        {
          visit(one, other);
        }
      }
    }
  }

  void offerTrianglesAt(Index w, Index v)
  {
    // The ceiling leaves out most, without a look at each of the triangles.
    if (walls_.ceilingOver(w).isBelow(mesh_.point(v)))
    {
      return;
    }
    const auto around = walls_.at(w);
    const auto found = std::find_if(
      around.begin(), around.end(), [&](Index triangle) { return walls_.reaches(mesh_.point(v), triangle); });
    if (found != around.end())
    {
      enter(v, *found);
    }
  }

  void enter(Index v, Index triangle)
  {
    triangle_[v] = triangle;
    place_[v] = Later;
    inside_.push_back(v);
  }

  // From those found as number first to end - 1 to their neighbours.
  void passOnAll(std::size_t first, std::size_t end)
  {
    // Where they are many, one more look at all tetrahedra is quicker than a walk around each.
    constexpr std::size_t many = 100; // tetrahedra to each of them
    const std::span<const Index> front(inside_.data() + first, end - first);
    if (mesh_.tetSlots() < many * front.size())
    {
      place(front, Front);
      forEachTouching(Front, [this](Index from, Index v) { offer(v, triangle_[from]); });
      place({ inside_.data() + first, end - first }, Behind);
    }
    else
    {
      for (std::size_t i = first; i < end; ++i)
      {
        passOn(inside_[i]);
      }
    }
  }

  void place(std::span<const Index> vertices, Place there)
  {
    for (const Index v : vertices)
    {
      place_[v] = there;
    }
  }

  void passOn(Index from)
  {
    const Index triangle = triangle_[from];
    traversal_.ball(from, ball_);
    offeredNow_.clear();
    for (const Index t : ball_)
    {
      for (const Index v : mesh_.tet(t).vertex)
      {
        if (place_[v] == Outside && offeredNow_.set(v))
        {
          offer(v, triangle);
        }
      }
    }
  }

  // v is not inside yet; is it, as seen from near this triangle?
  void offer(Index v, Index triangle)
  {
    if (walls_.reaches(mesh_.point(v), triangle))
    {
      enter(v, triangle);
      return;
    }
    if (walls_.isFarOver(mesh_.point(v), triangle))
    {
      return; // those around will hardly reach it either
    }
    if (triangle_[v] != None && !walls_.isNearer(mesh_.point(v), triangle, triangle_[v]))
    {
      return; // in vain from nearer already
    }
    const Index nearest = walls_.approach(mesh_.point(v), triangle);
    triangle_[v] = nearest;
    const Index reaching = walls_.reachingAround(mesh_.point(v), nearest);
    if (reaching != None)
    {
      enter(v, reaching);
    }
  }

  const TetMesh& mesh_;
  const WallReach& walls_;
  Traversal traversal_;
  std::vector<Index> ball_;
  LocalMarks offeredNow_;
  RecentPairs offered_;
  std::vector<Index> triangle_; // by vertex: one that reaches it; or else the last one looked at
  std::vector<char> place_;     // by vertex: a Place
  std::vector<Index> inside_;
};

bool mayGo(const Classification& classification, const std::vector<char>& changeable, Index v)
{
  if (classification.kind[v] == VertexKind::Corner || classification.frozen[v])
  {
    return false;
  }
  const auto patches = classification.patchesAt(v);
  return std::all_of(patches.begin(), patches.end(), [&](int p) { return changeable[p] != 0; });
}
} // namespace

LayerRegion findLayerRegion(const TetMesh& mesh, const BoundaryStars& stars,
  const Classification& classification, const std::vector<char>& changeable, const LayerPlan& plan,
  double margin)
{
  const WallReach walls(mesh, stars, plan, margin);
  Advance advance(mesh, walls);
  advance.run();
  LayerRegion region;
  region.isMarked.assign(mesh.vertexCount(), 0);
  region.reach.assign(mesh.vertexCount(), 0);
  region.attainable.assign(mesh.vertexCount(), 1);
  for (const Index v : advance.inside())
  {
    if (mayGo(classification, changeable, v))
    {
      region.marked.push_back(v);
      region.isMarked[v] = 1;
      region.reach[v] = static_cast<float>(advance.reach(v));
      region.attainable[v] = static_cast<float>(advance.attainableQuality(v));
    }
  }
  sortSpatially(mesh.points(), region.marked);
  return region;
}
} // namespace ransmesh
