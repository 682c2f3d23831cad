#include "Removal/LayerRegion.h"

#include "Geometry/Distance.h"
#include "Geometry/SpatialOrder.h"
#include "Geometry/TetrahedronMeasures.h"
#include "Mesh/LocalNumbers.h"
#include "Mesh/Traversal.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <span>
#include <utility>

namespace ransmesh
{
namespace
{
struct WallTriangle
{
  std::array<Index, 3> vertex;
  int patch;
  double perimeter;
};

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

// For quick bounds, all in one line of the cache: a sphere that holds a triangle, grown by the triangle's reach, and
// its plane.
struct alignas(64) Bounds
{
  Vector3 centre;
  double radius;
  Vector3 normal; // unit, or zero
  double reach;
};

// The walls' triangles, those at each vertex, and how far the region reaches from each.
class Walls
{
public:
  Walls(const TetMesh& mesh, const LayerPlan& plan, double margin)
    : mesh_(mesh)
  {
    collect(plan);
    linkToVertices();
    findReaches(plan, margin);
  }

  bool isWall(Index v) const { return isWall_[v] != 0; }
  // Has the tetrahedron vertices of walls and others? Without branches: whether one is of a wall is a toss.
  bool isAtWall(const Tetrahedron& tet) const
  {
    int ofWalls = 0;
    for (const Index v : tet.vertex)
    {
      ofWalls += isWall_[v];
    }
    return ofWalls != 0 && ofWalls != 4;
  }
  // The triangles at a vertex of the walls.
  std::span<const Index> at(Index v) const
  {
    return { triangleAt_.data() + first_[v], triangleAt_.data() + first_[v + 1] };
  }
  double reach(Index t) const { return bounds_[t].reach; }

  // The quality of the tetrahedron from triangle t to the end of its reach.
  double attainableQuality(Index t) const
  {
    const WallTriangle& w = triangles_[t];
    const Vector3& a = mesh_.point(w.vertex[0]);
    const Vector3& b = mesh_.point(w.vertex[1]);
    const Vector3& c = mesh_.point(w.vertex[2]);
    const Vector3 top = bounds_[t].centre + bounds_[t].reach * bounds_[t].normal;
    return std::clamp(quality(a, b, c, top), 0.0, 1.0);
  }

  // Whether p lies within the reach of triangle t.
  bool reaches(const Vector3& p, Index t) const
  {
    const Bounds& bounds = bounds_[t];
    const Vector3 offset = p - bounds.centre;
    if (!(std::fabs(dot(offset, bounds.normal)) <= bounds.reach) ||
      !(dot(offset, offset) <= bounds.radius * bounds.radius))
    {
      return false;
    }
    const auto& v = triangles_[t].vertex;
    return distanceToTriangle(p, mesh_.point(v[0]), mesh_.point(v[1]), mesh_.point(v[2])) <= bounds.reach;
  }

  // Walks over the wall from triangle t to one whose centre is closer to p than those around it.
  Index approach(const Vector3& p, Index t) const
  {
    double best = squareOf(p - bounds_[t].centre);
    for (Index from = None; from != t;)
    {
      from = t;
      for (const Index v : triangles_[from].vertex)
      {
        for (const Index other : at(v))
        {
          const double square = squareOf(p - bounds_[other].centre);
          t = square < best ? other : t;
          best = std::min(best, square);
        }
      }
    }
    return t;
  }

  // A triangle that reaches p: t or one around it; None if none does.
  Index reachingAround(const Vector3& p, Index t) const
  {
    if (reaches(p, t))
    {
      return t;
    }
    for (const Index v : triangles_[t].vertex)
    {
      for (const Index other : at(v))
      {
        if (other != t && reaches(p, other))
        {
          return other;
        }
      }
    }
    return None;
  }

private:
  static double squareOf(const Vector3& a) { return dot(a, a); }

  void collect(const LayerPlan& plan)
  {
    for (std::size_t b = 0; b < mesh_.boundarySlots(); ++b)
    {
      const BoundaryFace& face = mesh_.boundaryFace(static_cast<Index>(b));
      const auto patch = static_cast<std::size_t>(face.patch);
      if (face.isAlive() && patch < plan.size() && plan[patch].hasLayers())
      {
        const auto v = mesh_.boundaryVertices(static_cast<Index>(b));
        triangles_.push_back({ v, face.patch, addBounds(v) });
      }
    }
  }

  // Gives the perimeter.
  double addBounds(const std::array<Index, 3>& v)
  {
    const Vector3& a = mesh_.point(v[0]);
    const Vector3& b = mesh_.point(v[1]);
    const Vector3& c = mesh_.point(v[2]);
    const Vector3 centre = (1.0 / 3) * (a + b + c);
    const double radius = std::max({ distance(centre, a), distance(centre, b), distance(centre, c) });
    bounds_.push_back({ centre, radius, normalized(cross(b - a, c - a)), 0 });
    return distance(a, b) + distance(b, c) + distance(c, a);
  }

  void linkToVertices()
  {
    first_.assign(mesh_.vertexCount() + 1, 0);
    for (const WallTriangle& t : triangles_)
    {
      for (const Index v : t.vertex)
      {
        ++first_[v + 1];
      }
    }
    isWall_.resize(mesh_.vertexCount());
    for (std::size_t v = 1; v < first_.size(); ++v)
    {
      isWall_[v - 1] = first_[v] != 0;
      first_[v] += first_[v - 1];
    }
    triangleAt_.resize(3 * triangles_.size());
    std::vector<Index> next(first_.begin(), first_.end() - 1);
    for (std::size_t t = 0; t < triangles_.size(); ++t)
    {
      for (const Index v : triangles_[t].vertex)
      {
        triangleAt_[next[v]++] = static_cast<Index>(t);
      }
    }
  }

  // The mean edge of the wall triangles at v.
  double sizeAt(Index v) const
  {
    double sum = 0;
    for (const Index t : at(v))
    {
      sum += triangles_[t].perimeter;
    }
    return sum / (3 * (first_[v + 1] - first_[v]));
  }

  void findReaches(const LayerPlan& plan, double margin)
  {
    std::vector<LayerHeights> heights;
    for (const LayerSpecification& s : plan)
    {
      heights.emplace_back(s);
    }
    std::vector<double> sizes(mesh_.vertexCount(), 0);
    for (std::size_t v = 0; v < sizes.size(); ++v)
    {
      sizes[v] = isWall(static_cast<Index>(v)) ? sizeAt(static_cast<Index>(v)) : 0;
    }
    for (std::size_t i = 0; i < triangles_.size(); ++i)
    {
      const WallTriangle& t = triangles_[i];
      const double size = std::max({ sizes[t.vertex[0]], sizes[t.vertex[1]], sizes[t.vertex[2]] });
      const double thickness = limitedThickness(heights[t.patch], plan[t.patch].isotropicFraction, size);
      bounds_[i].reach = thickness > 0 ? thickness + margin * size : 0;
      bounds_[i].radius += bounds_[i].reach;
    }
  }

  const TetMesh& mesh_;
  std::vector<WallTriangle> triangles_;
  std::vector<Bounds> bounds_; // of triangles_
  std::vector<Index> first_;   // by vertex: its triangles are triangleAt_[first_[v]] up to first_[v + 1]
  std::vector<Index> triangleAt_;
  std::vector<char> isWall_; // by vertex; small, so that it stays in the cache
};

// Finds the vertices inside the region, from the walls outward: for each, a wall triangle within whose
// reach it lies.
class Advance
{
public:
  Advance(const TetMesh& mesh, const Walls& walls)
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
      if (walls_.isWall(v) || isInside_[v] || !offered_.isNew(w, v))
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
  const Walls& walls_;
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

double limitedThickness(const LayerHeights& heights, double isotropicFraction, double size)
{
  return heights.height(levelsOfIsotropicSize(heights, isotropicFraction, size));
}

LayerRegion findLayerRegion(const TetMesh& mesh, const Classification& classification,
  const std::vector<char>& changeable, const LayerPlan& plan, double margin)
{
  const Walls walls(mesh, plan, margin);
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
