#include "Removal/LayerRegion.h"

#include "Geometry/SpatialOrder.h"
#include "Mesh/LocalNumbers.h"
#include "Mesh/Traversal.h"
#include "Removal/WallReach.h"

#include <algorithm>
#include <cstdint>
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
    , isInside_(mesh.vertexCount(), 0)
  {
  }

  void run()
  {
    startFromWalls();
    // They become more as the loop goes.
    for (std::size_t i = 0; i < inside_.size(); ++i) // NOLINT(modernize-loop-convert)
    {
      passOn(inside_[i]);
    }
  }

  // In the order in which they were found.
  const std::vector<Index>& inside() const { return inside_; }
  double reach(Index v) const { return walls_.reach(triangle_[v]); }
  double attainableQuality(Index v) const { return walls_.attainableQuality(triangle_[v]); }

private:
  // The neighbours of the walls' vertices. One look at all tetrahedra in their order is quicker than a
  // walk around each vertex.
  void startFromWalls()
  {
    for (std::size_t t = 0; t < mesh_.tetSlots(); ++t)
    {
      const Tetrahedron& tet = mesh_.tet(static_cast<Index>(t));
      if (!tet.isAlive() || !walls_.isAtWall(tet))
      {
        continue;
      }
      for (const Index w : tet.vertex)
      {
        if (walls_.isWall(w))
        {
          offerTrianglesAt(w, tet);
        }
      }
    }
  }

  void offerTrianglesAt(Index w, const Tetrahedron& tet)
  {
    for (const Index v : tet.vertex)
    {
      // The ceiling leaves out most, without a look at each of the triangles.
      if (walls_.isWall(v) || isInside_[v] || !offered_.isNew(w, v) ||
        walls_.ceilingOver(w).isBelow(mesh_.point(v)))
      {
        continue;
      }
      const auto& around = walls_.at(w);
      const auto found = std::find_if(around.begin(), around.end(),
        [&](Index triangle) { return walls_.reaches(mesh_.point(v), triangle); });
      if (found != around.end())
      {
        enter(v, *found);
      }
    }
  }

  void enter(Index v, Index triangle)
  {
    triangle_[v] = triangle;
    isInside_[v] = 1;
    inside_.push_back(v);
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
        if (!isInside_[v] && !walls_.isWall(v) && offeredNow_.set(v))
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
    const Index nearest = walls_.approach(mesh_.point(v), triangle);
    if (nearest == triangle_[v])
    {
      return; // in vain once already
    }
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
  std::vector<char> isInside_;
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

LayerRegion findLayerRegion(const TetMesh& mesh, const Classification& classification,
  const std::vector<char>& changeable, const LayerPlan& plan, double margin)
{
  const WallReach walls(mesh, plan, margin);
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
