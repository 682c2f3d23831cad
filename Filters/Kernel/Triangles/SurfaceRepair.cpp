#include "Triangles/SurfaceRepair.h"

#include "Geometry/Predicates.h"
#include "Triangles/SurfaceEdges.h"

#include <numeric>

namespace ransmesh
{
namespace
{
std::array<Index, 3> sorted(std::array<Index, 3> t)
{
  std::sort(t.begin(), t.end());
  return t;
}

template <class Keep>
std::size_t keepTrianglesIf(SurfaceMesh& surface, Keep keep)
{
  std::size_t kept = 0;
  for (std::size_t t = 0; t < surface.triangles.size(); ++t)
  {
    if (keep(t))
    {
      surface.triangles[kept] = surface.triangles[t];
      surface.patch[kept++] = surface.patch[t];
    }
  }
  const std::size_t dropped = surface.triangles.size() - kept;
  surface.triangles.resize(kept);
  surface.patch.resize(kept);
  return dropped;
}

// Exact: three points lie on a line when a point aside along each axis is in one plane with them.
bool onALine(const Vector3& a, const Vector3& b, const Vector3& c)
{
  const double size = std::fmax(norm(b - a), norm(c - a));
  if (norm(cross(b - a, c - a)) > 1e-10 * size * size)
  {
    return false;
  }
  for (int axis = 0; axis < 3; ++axis)
  {
    Vector3 aside = a;
    aside[axis] += std::fmax(size, std::fabs(a[axis])); // must not vanish in rounding
    if (orientation(a, b, c, aside) != 0)
    {
      return false;
    }
  }
  return true;
}

void dropUnusedPoints(SurfaceMesh& surface)
{
  std::vector<Index> number(surface.points.size(), None);
  std::vector<Vector3> points;
  for (auto& t : surface.triangles)
  {
    for (Index& v : t)
    {
      if (number[v] == None)
      {
        number[v] = static_cast<Index>(points.size());
        points.push_back(surface.points[v]);
      }
      v = number[v];
    }
  }
  surface.points = std::move(points);
}

// The side of the triangle that is longest, as the place of its first corner.
int longestSide(const SurfaceMesh& surface, const std::array<Index, 3>& t)
{
  const auto length = [&](int i) { return distance(surface.points[t[i]], surface.points[t[(i + 1) % 3]]); };
  return length(0) >= length(1) ? (length(0) >= length(2) ? 0 : 2) : (length(1) >= length(2) ? 1 : 2);
}

// The one other triangle at an edge; None where there is none or more than one.
Index soleNeighbour(const std::vector<SurfaceEdge>& edges, Index a, Index b, Index triangle)
{
  const SurfaceEdge wanted{ std::min(a, b), std::max(a, b), None, true };
  const auto before = [](const SurfaceEdge& x, const SurfaceEdge& y)
  { return std::tie(x.a, x.b) < std::tie(y.a, y.b); };
  const auto [first, last] = std::equal_range(edges.begin(), edges.end(), wanted, before);
  if (last - first != 2)
  {
    return None;
  }
  return first->triangle == triangle ? std::next(first)->triangle : first->triangle;
}

// Swaps the longest side of a flat triangle; false where that is impossible.
bool swapLongestSide(
  SurfaceMesh& surface, const std::vector<SurfaceEdge>& edges, Index flat, std::vector<char>& touched)
{
  auto& t = surface.triangles[flat];
  const int side = longestSide(surface, t);
  const Index a = t[side];
  const Index b = t[(side + 1) % 3];
  const Index middle = t[(side + 2) % 3];
  const Index other = soleNeighbour(edges, a, b, flat);
  if (other == None || touched[flat] || touched[other])
  {
    return false;
  }
  auto& n = surface.triangles[other];
  const Index far = n[0] + n[1] + n[2] - a - b;
  if (far == middle)
  {
    return false;
  }
  const int at = n[0] == far ? 0 : n[1] == far ? 1 : 2;
  const Index first = n[(at + 1) % 3];
  const Index second = n[(at + 2) % 3];
  n = { far, first, middle };
  t = { far, middle, second };
  surface.patch[flat] = surface.patch[other];
  touched[flat] = touched[other] = 1;
  return true;
}
} // namespace

void mergeEqualPoints(SurfaceMesh& surface)
{
  for (Vector3& p : surface.points)
  {
    p = { p.x + 0.0, p.y + 0.0, p.z + 0.0 }; // -0 and 0 are one place
  }
  std::vector<Index> order(surface.points.size());
  std::iota(order.begin(), order.end(), 0);
  const auto& p = surface.points;
  const auto key = [&p](Index i) { return std::tie(p[i].x, p[i].y, p[i].z); };
  std::sort(
    order.begin(), order.end(), [&](Index i, Index j) { return key(i) != key(j) ? key(i) < key(j) : i < j; });
  std::vector<Index> representative(surface.points.size());
  for (std::size_t i = 0; i < order.size(); ++i)
  {
    const bool same = i > 0 && p[order[i]] == p[order[i - 1]];
    representative[order[i]] = same ? representative[order[i - 1]] : order[i];
  }
  for (auto& t : surface.triangles)
  {
    for (Index& v : t)
    {
      v = representative[v];
    }
  }
  dropUnusedPoints(surface);
}

bool isDegenerate(const SurfaceMesh& surface, Index triangle)
{
  const auto& t = surface.triangles[triangle];
  return t[0] == t[1] || t[1] == t[2] || t[2] == t[0] ||
    onALine(surface.points[t[0]], surface.points[t[1]], surface.points[t[2]]);
}

std::size_t dropCollapsedTriangles(SurfaceMesh& surface)
{
  const auto& tri = surface.triangles;
  return keepTrianglesIf(surface,
    [&tri](std::size_t t)
    { return tri[t][0] != tri[t][1] && tri[t][1] != tri[t][2] && tri[t][2] != tri[t][0]; });
}

std::size_t keepTriangles(SurfaceMesh& surface, const std::vector<char>& stays)
{
  return keepTrianglesIf(surface, [&stays](std::size_t t) { return stays[t] != 0; });
}

std::vector<Index> firstOfEqual(const SurfaceMesh& surface)
{
  std::vector<Index> order(surface.triangles.size());
  std::iota(order.begin(), order.end(), 0);
  std::vector<std::array<Index, 3>> key;
  key.reserve(order.size());
  for (const auto& t : surface.triangles)
  {
    key.push_back(sorted(t));
  }
  std::sort(
    order.begin(), order.end(), [&](Index i, Index j) { return key[i] != key[j] ? key[i] < key[j] : i < j; });
  std::vector<Index> first(order.size());
  for (std::size_t i = 0; i < order.size(); ++i)
  {
    const bool repeats = i > 0 && key[order[i]] == key[order[i - 1]];
    first[order[i]] = repeats ? first[order[i - 1]] : order[i];
  }
  return first;
}

std::size_t dropRepeatedTriangles(SurfaceMesh& surface)
{
  const std::vector<Index> first = firstOfEqual(surface);
  return keepTrianglesIf(surface, [&](std::size_t t) { return first[t] == static_cast<Index>(t); });
}

std::size_t swapFlatTriangles(SurfaceMesh& surface)
{
  std::size_t mended = 0;
  constexpr int passes = 10; // a row of flat triangles side by side needs several
  for (int pass = 0; pass < passes; ++pass)
  {
    std::vector<Index> flat;
    for (std::size_t t = 0; t < surface.triangles.size(); ++t)
    {
      if (isDegenerate(surface, static_cast<Index>(t)))
      {
        flat.push_back(static_cast<Index>(t));
      }
    }
    if (flat.empty())
    {
      break;
    }
    const auto edges = sortedEdges(surface);
    std::vector<char> touched(surface.triangles.size(), 0);
    std::size_t swapped = 0;
    for (const Index t : flat)
    {
      swapped += swapLongestSide(surface, edges, t, touched);
    }
    mended += swapped;
    if (swapped == 0)
    {
      break;
    }
  }
  return mended;
}

std::vector<char> turnedTriangles(const SurfaceMesh& surface)
{
  struct Link
  {
    Index neighbour;
    bool turned;
  };
  std::vector<std::vector<Link>> links(surface.triangles.size());
  forEachEdge(sortedEdges(surface),
    [&](const SurfaceEdge* first, const SurfaceEdge* last)
    {
      if (last - first == 2)
      {
        const bool turned = first[0].forward == first[1].forward;
        links[first[0].triangle].push_back({ first[1].triangle, turned });
        links[first[1].triangle].push_back({ first[0].triangle, turned });
      }
    });
  std::vector<char> isTurned(surface.triangles.size(), 0);
  std::vector<char> isKnown(surface.triangles.size(), 0);
  std::vector<Index> piece;
  for (std::size_t seed = 0; seed < isKnown.size(); ++seed)
  {
    if (isKnown[seed])
    {
      continue;
    }
    piece = { static_cast<Index>(seed) };
    isKnown[seed] = 1;
    std::size_t turned = 0;
    for (std::size_t i = 0; i < piece.size(); ++i)
    {
      turned += isTurned[piece[i]] ? 1 : 0;
      for (const Link& link : links[piece[i]])
      {
        if (!isKnown[link.neighbour])
        {
          isKnown[link.neighbour] = 1;
          isTurned[link.neighbour] = isTurned[piece[i]] != (link.turned ? 1 : 0);
          piece.push_back(link.neighbour);
        }
      }
    }
    if (2 * turned > piece.size())
    {
      for (const Index t : piece)
      {
        isTurned[t] = !isTurned[t];
      }
    }
  }
  return isTurned;
}
} // namespace ransmesh
