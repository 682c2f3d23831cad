#include "Remeshing/EditableSurface.h"

#include "Triangles/SurfaceEdges.h"

#include <algorithm>

namespace ransmesh
{
namespace
{
constexpr Index Unnamed = -2; // a line's edge that has no number yet

std::uint64_t keyOf(Index a, Index b)
{
  const auto [low, high] = std::minmax(a, b);
  return static_cast<std::uint64_t>(low) << 32 | static_cast<std::uint32_t>(high);
}

bool has(const Corners& t, Index v)
{
  return t[0] == v || t[1] == v || t[2] == v;
}

void drop(std::vector<Index>& list, Index value)
{
  list.erase(std::remove(list.begin(), list.end(), value), list.end());
}
} // namespace

EditableSurface::EditableSurface(SurfaceMesh surface, double angle, std::vector<char> keep)
  : surface_(std::move(surface))
  , keep_(std::move(keep))
  , trianglesAt_(surface_.points.size())
  , freedom_(surface_.points.size(), PointFreedom::Surface)
{
  linkTriangles();
  findFeatures(cosineOfDegrees(angle));
  findFreedom(angle);
  nameLines();
}

void EditableSurface::linkTriangles()
{
  for (std::size_t t = 0; t < surface_.triangles.size(); ++t)
  {
    for (const Index v : surface_.triangles[t])
    {
      trianglesAt_[v].push_back(static_cast<Index>(t));
    }
  }
}

void EditableSurface::findFeatures(double cosine)
{
  forEachEdge(sortedEdges(surface_),
    [&](const SurfaceEdge* first, const SurfaceEdge* last)
    {
      bool isFeature = last - first != 2;
      if (!isFeature)
      {
        const Vector3 n = normalized(areaVector(surface_, surface_.triangles[first[0].triangle]));
        const Vector3 m = normalized(areaVector(surface_, surface_.triangles[first[1].triangle]));
        const double turn = first[0].forward != first[1].forward ? dot(n, m) : -dot(n, m);
        isFeature = surface_.patch[first[0].triangle] != surface_.patch[first[1].triangle] || turn < cosine ||
          (isKept(first->a) && isKept(first->b));
      }
      if (isFeature)
      {
        setFeature(first->a, first->b, Unnamed);
      }
    });
}

void EditableSurface::findFreedom(double angle)
{
  for (std::size_t i = 0; i < freedom_.size(); ++i)
  {
    const auto v = static_cast<Index>(i);
    const std::vector<Index> ends = neighboursOnLines(v);
    if (ends.size() == 2)
    {
      const double turn = degreesBetween(point(v) - point(ends[0]), point(ends[1]) - point(v));
      freedom_[v] = turn > angle ? PointFreedom::Fixed : PointFreedom::Line;
    }
    else if (!ends.empty())
    {
      freedom_[v] = PointFreedom::Fixed;
    }
    if (isKept(v))
    {
      freedom_[v] = PointFreedom::Fixed;
    }
  }
}

void EditableSurface::nameLines()
{
  std::vector<std::uint64_t> edges;
  edges.reserve(lineOf_.size());
  for (const auto& [key, line] : lineOf_)
  {
    edges.push_back(key);
  }
  std::sort(edges.begin(), edges.end());
  for (const std::uint64_t key : edges)
  {
    if (lineOf_[key] == Unnamed)
    {
      const auto a = static_cast<Index>(key >> 32);
      const auto b = static_cast<Index>(key & 0xffffffffU);
      lineOf_[key] = lineCount_;
      nameLineFrom(a, b);
      nameLineFrom(b, a);
      ++lineCount_;
    }
  }
}

// Goes on from an edge over points that lie on one line.
void EditableSurface::nameLineFrom(Index from, Index to)
{
  while (freedom_[to] == PointFreedom::Line)
  {
    const std::vector<Index> ends = neighboursOnLines(to);
    const Index next = ends[0] == from ? ends[1] : ends[0];
    Index& line = lineOf_[keyOf(to, next)];
    if (line != Unnamed)
    {
      return;
    }
    line = lineCount_;
    from = to;
    to = next;
  }
}

SurfaceMesh EditableSurface::result() const
{
  SurfaceMesh result;
  std::vector<Index> number(surface_.points.size(), None);
  for (std::size_t t = 0; t < surface_.triangles.size(); ++t)
  {
    if (!isAlive(static_cast<Index>(t)))
    {
      continue;
    }
    Corners corners = surface_.triangles[t];
    for (Index& v : corners)
    {
      if (number[v] == None)
      {
        number[v] = static_cast<Index>(result.points.size());
        result.points.push_back(surface_.points[v]);
      }
      v = number[v];
    }
    result.triangles.push_back(corners);
    result.patch.push_back(surface_.patch[t]);
  }
  return result;
}

std::vector<Index> EditableSurface::neighbours(Index v) const
{
  std::vector<Index> around;
  for (const Index t : trianglesAt_[v])
  {
    for (const Index w : triangle(t))
    {
      if (w != v)
      {
        around.push_back(w);
      }
    }
  }
  std::sort(around.begin(), around.end());
  around.erase(std::unique(around.begin(), around.end()), around.end());
  return around;
}

std::vector<Index> EditableSurface::trianglesAt(Index a, Index b) const
{
  // Points in the middle of fans may have thousands.
  const bool isFewer = trianglesAt_[a].size() < trianglesAt_[b].size();
  std::vector<Index> found;
  for (const Index t : trianglesAt_[isFewer ? a : b])
  {
    if (has(triangle(t), isFewer ? b : a))
    {
      found.push_back(t);
    }
  }
  return found;
}

Index EditableSurface::cornerOpposite(Index t, Index a, Index b) const
{
  const Corners& c = triangle(t);
  return c[0] != a && c[0] != b ? c[0] : c[1] != a && c[1] != b ? c[1] : c[2];
}

Index EditableSurface::lineOf(Index a, Index b) const
{
  const auto found = lineOf_.find(keyOf(a, b));
  return found == lineOf_.end() ? None : found->second;
}

std::vector<Index> EditableSurface::neighboursOnLines(Index v) const
{
  std::vector<Index> ends;
  for (const Index w : neighbours(v))
  {
    if (lineOf(v, w) != None)
    {
      ends.push_back(w);
    }
  }
  return ends;
}

bool EditableSurface::maySplit(Index a, Index b) const
{
  return !isKept(a) || !isKept(b);
}

Index EditableSurface::split(Index a, Index b, const Vector3& place)
{
  const auto middle = static_cast<Index>(surface_.points.size());
  const Index line = lineOf(a, b);
  surface_.points.push_back(place);
  trianglesAt_.emplace_back();
  freedom_.push_back(line == None ? PointFreedom::Surface : PointFreedom::Line);
  for (const Index t : trianglesAt(a, b))
  {
    Corners half = triangle(t);
    std::replace(half.begin(), half.end(), a, middle);
    std::replace(surface_.triangles[t].begin(), surface_.triangles[t].end(), b, middle);
    drop(trianglesAt_[b], t);
    trianglesAt_[middle].push_back(t);
    addTriangle(half, surface_.patch[t]);
  }
  if (line != None)
  {
    lineOf_.erase(keyOf(a, b));
    setFeature(a, middle, line);
    setFeature(middle, b, line);
  }
  return middle;
}

bool EditableSurface::mayCollapse(Index gone, Index kept) const
{
  const Index line = lineOf(gone, kept);
  if (freedom_[gone] == PointFreedom::Fixed || (freedom_[gone] == PointFreedom::Line && line == None))
  {
    return false;
  }
  // The points next to both are the third corners at the edge: nothing else would fold together.
  const std::vector<Index> at = trianglesAt(gone, kept);
  std::vector<Index> both = neighbours(gone);
  both.erase(std::remove_if(
               both.begin(), both.end(), [&](Index v) { return v == kept || trianglesAt(v, kept).empty(); }),
    both.end());
  if (both.size() != at.size() || trianglesAt_[gone].size() <= at.size())
  {
    return false;
  }
  // Two lines, or a line and its other half, must not become one.
  return std::all_of(
    both.begin(), both.end(), [&](Index v) { return lineOf(gone, v) == None || lineOf(kept, v) == None; });
}

void EditableSurface::collapse(Index gone, Index kept)
{
  const Index line = lineOf(gone, kept);
  for (const Index v : neighbours(gone))
  {
    const Index moved = lineOf(gone, v);
    if (moved != None)
    {
      lineOf_.erase(keyOf(gone, v));
      if (v != kept)
      {
        setFeature(kept, v, line == None ? moved : line);
      }
    }
  }
  const std::vector<Index> around = trianglesAt_[gone];
  for (const Index t : around)
  {
    if (has(triangle(t), kept))
    {
      removeTriangle(t);
      continue;
    }
    std::replace(surface_.triangles[t].begin(), surface_.triangles[t].end(), gone, kept);
    trianglesAt_[kept].push_back(t);
  }
  trianglesAt_[gone].clear();
}

bool EditableSurface::maySwap(Index a, Index b, std::array<Corners, 2>& made) const
{
  const std::vector<Index> at = trianglesAt(a, b);
  if (at.size() != 2 || lineOf(a, b) != None)
  {
    return false;
  }
  const Index c = cornerOpposite(at[0], a, b);
  const Index d = cornerOpposite(at[1], a, b);
  if (c == d || !trianglesAt(c, d).empty())
  {
    return false;
  }
  made = { triangle(at[0]), triangle(at[1]) };
  std::replace(made[0].begin(), made[0].end(), a, d);
  std::replace(made[1].begin(), made[1].end(), b, c);
  return true;
}

void EditableSurface::swap(Index a, Index b)
{
  const std::vector<Index> at = trianglesAt(a, b);
  std::array<Corners, 2> made;
  maySwap(a, b, made);
  for (int i = 0; i < 2; ++i)
  {
    const Index gone = i == 0 ? a : b;
    const Index come = cornerOpposite(at[1 - i], a, b);
    drop(trianglesAt_[gone], at[i]);
    trianglesAt_[come].push_back(at[i]);
  }
  surface_.triangles[at[0]] = made[0];
  surface_.triangles[at[1]] = made[1];
}

void EditableSurface::addTriangle(const Corners& corners, int patch)
{
  const auto t = static_cast<Index>(surface_.triangles.size());
  surface_.triangles.push_back(corners);
  surface_.patch.push_back(patch);
  for (const Index v : corners)
  {
    trianglesAt_[v].push_back(t);
  }
}

void EditableSurface::removeTriangle(Index t)
{
  for (const Index v : triangle(t))
  {
    drop(trianglesAt_[v], t);
  }
  surface_.triangles[t] = { None, None, None };
}

void EditableSurface::setFeature(Index a, Index b, Index line)
{
  lineOf_[keyOf(a, b)] = line;
}
} // namespace ransmesh
