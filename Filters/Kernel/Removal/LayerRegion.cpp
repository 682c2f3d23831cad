#include "Removal/LayerRegion.h"

#include "Geometry/Distance.h"
#include "Geometry/SpatialOrder.h"
#include "Geometry/TetrahedronMeasures.h"
#include "Mesh/Traversal.h"

#include <algorithm>
#include <deque>
#include <limits>

namespace ransmesh
{
namespace
{
struct WallTriangle
{
  std::array<Index, 3> vertex;
  int patch;
  double reach;
};

// A sphere that holds a triangle, grown by the triangle's reach: for quick bounds.
struct Ball
{
  Vector3 centre;
  double radius;
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

  bool isWall(Index v) const { return first_[v] != first_[v + 1]; }
  Index someTriangleAt(Index v) const { return triangleAt_[first_[v]]; }
  double reach(Index t) const { return triangles_[t].reach; }

  // The quality of the tetrahedron from triangle t to the end of its reach.
  double attainableQuality(Index t) const
  {
    const WallTriangle& w = triangles_[t];
    const Vector3& a = mesh_.point(w.vertex[0]);
    const Vector3& b = mesh_.point(w.vertex[1]);
    const Vector3& c = mesh_.point(w.vertex[2]);
    const Vector3 top = balls_[t].centre + w.reach * normalized(cross(b - a, c - a));
    return std::clamp(quality(a, b, c, top), 0.0, 1.0);
  }

  // By how far p lies beyond the reach of triangle t; not above 0 inside the region.
  double excess(const Vector3& p, Index t) const
  {
    const WallTriangle& w = triangles_[t];
    return distanceToTriangle(
             p, mesh_.point(w.vertex[0]), mesh_.point(w.vertex[1]), mesh_.point(w.vertex[2])) -
      w.reach;
  }

  // A lower bound of the excess, quickly.
  double leastExcess(const Vector3& p, Index t) const
  {
    return distance(p, balls_[t].centre) - balls_[t].radius;
  }

  // Walks over the wall from triangle t, whose excess is given, to where the excess is smallest.
  Index descend(const Vector3& p, Index t, double& excessHere) const
  {
    for (bool moved = true; moved;)
    {
      moved = false;
      for (const Index v : triangles_[t].vertex)
      {
        for (Index i = first_[v]; i < first_[v + 1]; ++i)
        {
          const Index other = triangleAt_[i];
          if (leastExcess(p, other) >= excessHere)
          {
            continue;
          }
          const double there = excess(p, other);
          if (there < excessHere)
          {
            excessHere = there;
            t = other;
            moved = true;
          }
        }
        if (moved)
        {
          break;
        }
      }
    }
    return t;
  }

private:
  void collect(const LayerPlan& plan)
  {
    for (std::size_t b = 0; b < mesh_.boundarySlots(); ++b)
    {
      const BoundaryFace& face = mesh_.boundaryFace(static_cast<Index>(b));
      const auto patch = static_cast<std::size_t>(face.patch);
      if (face.isAlive() && patch < plan.size() && plan[patch].hasLayers())
      {
        triangles_.push_back({ mesh_.boundaryVertices(static_cast<Index>(b)), face.patch, 0 });
      }
    }
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
    for (std::size_t v = 1; v < first_.size(); ++v)
    {
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
    for (Index i = first_[v]; i < first_[v + 1]; ++i)
    {
      const auto& w = triangles_[triangleAt_[i]].vertex;
      sum += distance(mesh_.point(w[0]), mesh_.point(w[1])) + distance(mesh_.point(w[1]), mesh_.point(w[2])) +
        distance(mesh_.point(w[2]), mesh_.point(w[0]));
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
    for (WallTriangle& t : triangles_)
    {
      const double size = std::max({ sizes[t.vertex[0]], sizes[t.vertex[1]], sizes[t.vertex[2]] });
      const double thickness = limitedThickness(heights[t.patch], plan[t.patch].isotropicFraction, size);
      t.reach = thickness > 0 ? thickness + margin * size : 0;
      const Vector3& a = mesh_.point(t.vertex[0]);
      const Vector3& b = mesh_.point(t.vertex[1]);
      const Vector3& c = mesh_.point(t.vertex[2]);
      const Vector3 centre = (1.0 / 3) * (a + b + c);
      const double radius = std::max({ distance(centre, a), distance(centre, b), distance(centre, c) });
      balls_.push_back({ centre, radius + t.reach });
    }
  }

  const TetMesh& mesh_;
  std::vector<WallTriangle> triangles_;
  std::vector<Ball> balls_;  // of triangles_
  std::vector<Index> first_; // by vertex: its triangles are triangleAt_[first_[v]] up to first_[v + 1]
  std::vector<Index> triangleAt_;
};

// Spreads, from the walls outward, the wall triangle that counts for each vertex.
class Advance
{
public:
  Advance(const TetMesh& mesh, const Walls& walls)
    : mesh_(mesh)
    , walls_(walls)
    , traversal_(mesh)
    , nearest_(mesh.vertexCount(), None)
    , excess_(mesh.vertexCount(), std::numeric_limits<double>::infinity())
  {
  }

  void run()
  {
    std::vector<Index> start;
    for (std::size_t v = 0; v < mesh_.vertexCount(); ++v)
    {
      if (walls_.isWall(static_cast<Index>(v)))
      {
        start.push_back(static_cast<Index>(v));
      }
    }
    sortSpatially(mesh_.points(), start);
    for (const Index v : start)
    {
      nearest_[v] = walls_.someTriangleAt(v);
      excess_[v] = -walls_.reach(nearest_[v]);
      front_.push_back(v);
    }
    while (!front_.empty())
    {
      const Index v = front_.front();
      front_.pop_front();
      passOn(v);
    }
  }

  bool isInside(Index v) const { return excess_[v] <= 0; }
  double excess(Index v) const { return excess_[v]; }
  double reach(Index v) const { return walls_.reach(nearest_[v]); }
  double attainableQuality(Index v) const { return walls_.attainableQuality(nearest_[v]); }

private:
  void passOn(Index from)
  {
    const Index triangle = nearest_[from];
    traversal_.ball(from, ball_);
    seen_.clear(mesh_.vertexCount());
    for (const Index t : ball_)
    {
      for (const Index v : mesh_.tet(t).vertex)
      {
        if (seen_.set(v) && !walls_.isWall(v) && nearest_[v] != triangle)
        {
          offer(v, triangle);
        }
      }
    }
  }

  void offer(Index v, Index triangle)
  {
    if (walls_.leastExcess(mesh_.point(v), triangle) >= excess_[v])
    {
      return;
    }
    double excess = walls_.excess(mesh_.point(v), triangle);
    if (excess >= excess_[v])
    {
      return;
    }
    const Index best = walls_.descend(mesh_.point(v), triangle, excess);
    // What is known already within a thousandth is not passed on again.
    const bool isNews = excess <= 0 && (excess_[v] > 0 || excess_[v] - excess > 1e-3 * walls_.reach(best));
    excess_[v] = excess;
    nearest_[v] = best;
    if (isNews)
    {
      front_.push_back(v);
    }
  }

  const TetMesh& mesh_;
  const Walls& walls_;
  Traversal traversal_;
  std::vector<Index> nearest_;
  std::vector<double> excess_;
  std::deque<Index> front_;
  std::vector<Index> ball_;
  Marks seen_;
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
  int level = 0;
  while (level < heights.count() && heights.spacing(level + 1) <= isotropicFraction * size)
  {
    ++level;
  }
  return heights.height(level);
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
  for (std::size_t i = 0; i < mesh.vertexCount(); ++i)
  {
    const auto v = static_cast<Index>(i);
    if (advance.isInside(v) && !walls.isWall(v) && mayGo(classification, changeable, v))
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
