#include "Remeshing/SurfaceSwaps.h"

#include "Triangles/SurfaceEdges.h"
#include "Triangles/SurfaceIntersections.h"
#include "Triangles/SurfaceTriangles.h"

#include <algorithm>
#include <cstdint>
#include <queue>
#include <unordered_set>

namespace ransmesh
{
namespace
{
constexpr double LeastGain = 1e-6; // degrees; less may be rounding
constexpr int MostAttempts = 5;    // to swap without making the surface cut itself

// Side i of triangle t runs from corner i to the next; its code is 3 t + i.
using Side = Index;

int next(int i)
{
  return i == 2 ? 0 : i + 1;
}

std::uint64_t edgeKey(Index a, Index b)
{
  const auto [low, high] = std::minmax(a, b);
  return static_cast<std::uint64_t>(low) << 32 | static_cast<std::uint32_t>(high);
}

// The normals that the surface had at each point when this was built.
class FirstNormals
{
public:
  FirstNormals(const SurfaceMesh& surface, double lineHeight)
    : start_(surface.points.size() + 1, 0)
    , normals_(3 * surface.triangles.size())
    , patches_(normals_.size())
  {
    for (const Corners& t : surface.triangles)
    {
      for (const Index v : t)
      {
        ++start_[v + 1];
      }
    }
    for (std::size_t v = 1; v < start_.size(); ++v)
    {
      start_[v] += start_[v - 1];
    }
    std::vector<Index> end(start_.begin(), start_.end() - 1);
    for (std::size_t t = 0; t < surface.triangles.size(); ++t)
    {
      const Corners& corners = surface.triangles[t];
      const bool isLine = smallestHeight(surface, corners) <= lineHeight;
      for (const Index v : corners)
      {
        normals_[end[v]] = isLine ? Vector3{} : normalized(areaVector(surface, corners));
        patches_[end[v]++] = surface.patch[t];
      }
    }
  }

  // Whether the patch had a triangle at v whose normal is within the angle of `normal`, or not known.
  bool allows(Index v, int patch, const Vector3& normal, double cosine) const
  {
    for (Index i = start_[v]; i < start_[v + 1]; ++i)
    {
      if (patches_[i] == patch && (normals_[i] == Vector3{} || dot(normals_[i], normal) >= cosine))
      {
        return true;
      }
    }
    return false;
  }

private:
  std::vector<Index> start_;
  std::vector<Vector3> normals_;
  std::vector<int> patches_;
};

class Swapping
{
public:
  Swapping(SurfaceMesh& surface, double angle, const std::vector<char>& keep)
    : surface_(surface)
    , keep_(keep)
    , cosine_(cosineOfDegrees(angle))
    , lineHeight_(LineHeight * extentOf(surface.points).largestLength())
    , first_(surface, lineHeight_)
    , twin_(3 * surface.triangles.size(), None)
    , angle_(surface.triangles.size())
  {
    edges_.reserve(2 * surface.triangles.size());
    forEachEdge(sortedEdges(surface),
      [this](const SurfaceEdge* begin, const SurfaceEdge* end)
      {
        edges_.insert(edgeKey(begin->a, begin->b));
        if (end - begin == 2 && begin[0].forward != begin[1].forward)
        {
          link(sideOf(begin[0]), sideOf(begin[1]));
        }
      });
  }

  // Makes swaps until none is left that gains; gives how many.
  std::size_t run()
  {
    for (std::size_t t = 0; t < angle_.size(); ++t)
    {
      measure(static_cast<Index>(t));
    }
    std::size_t swaps = 0;
    while (!queue_.empty())
    {
      const auto [angle, minusTriangle] = queue_.top();
      queue_.pop();
      const Side best = angle == angle_[-minusTriangle] ? bestSwap(-minusTriangle) : None;
      if (best != None)
      {
        swap(best);
        ++swaps;
      }
    }
    return swaps;
  }

  // The greatest distance between a side that went and the one that came.
  double largestShift() const { return largestShift_; }

private:
  // The corners of two triangles at a side: a to b is the side of the first, c and d lie opposite.
  struct Quad
  {
    Index a, b, c, d;
    Corners first() const { return { c, d, b }; }
    Corners second() const { return { d, c, a }; }
  };

  Side sideOf(const SurfaceEdge& edge) const
  {
    const Corners& t = surface_.triangles[edge.triangle];
    const Index from = edge.forward ? edge.a : edge.b;
    const Index to = edge.forward ? edge.b : edge.a;
    int i = 0;
    while (i < 2 && (t[i] != from || t[next(i)] != to))
    {
      ++i;
    }
    return 3 * edge.triangle + i;
  }

  void link(Side s, Side t)
  {
    twin_[s] = t;
    if (t != None)
    {
      twin_[t] = s;
    }
  }

  void measure(Index t)
  {
    angle_[t] = largestAngle(surface_, surface_.triangles[t]);
    if (angle_[t] > ObtuseTriangleAngle)
    {
      queue_.emplace(angle_[t], -t);
    }
  }

  Quad quadAt(Side s) const
  {
    const Corners& t = surface_.triangles[s / 3];
    const Side other = twin_[s];
    const int i = s % 3;
    return { t[i], t[next(i)], t[next(next(i))], surface_.triangles[other / 3][next(next(other % 3))] };
  }

  // The side of t whose swap leaves the best triangles; None where none is allowed that gains.
  Side bestSwap(Index t) const
  {
    Side best = None;
    double least = 180;
    for (Side s = 3 * t; s < 3 * t + 3; ++s)
    {
      if (twin_[s] == None || surface_.patch[s / 3] != surface_.patch[twin_[s] / 3])
      {
        continue;
      }
      const Quad quad = quadAt(s);
      const double now = std::fmax(angle_[s / 3], angle_[twin_[s] / 3]);
      const double then =
        std::fmax(largestAngle(surface_, quad.first()), largestAngle(surface_, quad.second()));
      if (then < now - LeastGain && then < least && isAllowed(s, quad))
      {
        best = s;
        least = then;
      }
    }
    return best;
  }

  bool isAllowed(Side s, const Quad& q) const
  {
    if ((keep_[q.a] && keep_[q.b]) || q.c == q.d || edges_.contains(edgeKey(q.c, q.d)))
    {
      return false;
    }
    const int patch = surface_.patch[s / 3];
    for (const Corners& made : { q.first(), q.second() })
    {
      const Vector3 normal = normalized(areaVector(surface_, made));
      if (!continues(s / 3, normal) || !continues(twin_[s] / 3, normal) ||
        (!isLine(made) && !isFirst(made, patch, normal)))
      {
        return false;
      }
    }
    return true;
  }

  bool isLine(const Corners& t) const { return smallestHeight(surface_, t) <= lineHeight_; }

  bool continues(Index old, const Vector3& normal) const
  {
    const Corners& t = surface_.triangles[old];
    return isLine(t) || dot(normalized(areaVector(surface_, t)), normal) >= cosine_;
  }

  bool isFirst(const Corners& t, int patch, const Vector3& normal) const
  {
    return std::all_of(t.begin(), t.end(), [&](Index v) { return first_.allows(v, patch, normal, cosine_); });
  }

  // The distance between the lines of the two diagonals.
  double shiftOf(const Quad& q) const
  {
    const auto& p = surface_.points;
    const Vector3 across = normalized(cross(p[q.b] - p[q.a], p[q.d] - p[q.c]));
    return std::fabs(dot(across, p[q.c] - p[q.a]));
  }

  void swap(Side s)
  {
    const Quad q = quadAt(s);
    const Side t = twin_[s];
    largestShift_ = std::fmax(largestShift_, shiftOf(q));
    const auto after = [](Side side) { return side / 3 * 3 + next(side % 3); };
    const Side bc = twin_[after(s)];
    const Side ca = twin_[after(after(s))];
    const Side ad = twin_[after(t)];
    const Side db = twin_[after(after(t))];
    edges_.erase(edgeKey(q.a, q.b));
    edges_.insert(edgeKey(q.c, q.d));
    const Side first = s / 3 * 3;
    const Side second = t / 3 * 3;
    surface_.triangles[s / 3] = q.first();
    surface_.triangles[t / 3] = q.second();
    link(first, second);
    link(first + 1, db);
    link(first + 2, bc);
    link(second + 1, ca);
    link(second + 2, ad);
    remeasure(first, second);
  }

  // Also of the neighbours, for which a swap may have become possible.
  void remeasure(Side first, Side second)
  {
    for (const Side triangle : { first, second })
    {
      measure(triangle / 3);
      for (const Side side : { triangle + 1, triangle + 2 })
      {
        if (twin_[side] != None)
        {
          measure(twin_[side] / 3);
        }
      }
    }
  }

  SurfaceMesh& surface_;
  const std::vector<char>& keep_;
  double cosine_;
  double lineHeight_;
  double largestShift_ = 0;
  FirstNormals first_;
  std::vector<Side> twin_;
  std::vector<double> angle_; // the largest of each triangle
  std::unordered_set<std::uint64_t> edges_;
  std::priority_queue<std::pair<double, Index>> queue_; // largest angle and minus the triangle, worst first
};

// Marks the points of triangles that cut or touch each other; false where there are none.
bool keepIntersecting(const SurfaceMesh& surface, std::vector<char>& keep)
{
  const auto pairs = findIntersections(surface);
  for (const auto& [s, t] : pairs)
  {
    for (int i = 0; i < 3; ++i)
    {
      keep[surface.triangles[s][i]] = 1;
      keep[surface.triangles[t][i]] = 1;
    }
  }
  return !pairs.empty();
}

void countFlat(const SurfaceMesh& surface, double& largest, std::size_t& flat)
{
  for (const Corners& t : surface.triangles)
  {
    const double angle = largestAngle(surface, t);
    largest = std::fmax(largest, angle);
    flat += angle > FlatTriangleAngle ? 1 : 0;
  }
}
} // namespace

SwapReport swapDiagonals(SurfaceMesh& surface, double angle, std::vector<char> keep)
{
  SwapReport report;
  countFlat(surface, report.largestBefore, report.flatBefore);
  const SurfaceMesh before = surface;
  keep.resize(surface.points.size(), 0);
  bool isFree = report.largestBefore <= ObtuseTriangleAngle;
  for (int attempt = 0; !isFree && attempt < MostAttempts; ++attempt)
  {
    surface = before;
    Swapping swapping(surface, angle, keep);
    report.swaps = swapping.run();
    report.largestShift = swapping.largestShift();
    isFree = report.swaps == 0 || !keepIntersecting(surface, keep);
  }
  if (!isFree)
  {
    surface = before;
    report.swaps = 0;
    report.largestShift = 0;
    report.isRefused = true;
  }
  countFlat(surface, report.largestAfter, report.flatAfter);
  return report;
}
} // namespace ransmesh
