#include "Remeshing/RemeshSizes.h"

#include <algorithm>
#include <map>
#include <numbers>
#include <queue>

namespace ransmesh
{
namespace
{
constexpr double ShareOfExtent = 0.1;
constexpr double SmallestShare = 0.01;
// Edges in a strip are longer than it is wide by this: its triangles have angles of 34 degrees and more.
constexpr double EdgesToStrip = 1.5;
constexpr double SmallestInStrip = 0.1; // of the edge that is wanted otherwise
constexpr double StripAngle = 15;       // degrees: lines that meet at more than this bound no strip

// The largest edge of each patch.
std::vector<double> lengthsOfPatches(const SurfaceMesh& surface, const RemeshingOptions& options)
{
  std::map<int, std::vector<Vector3>> corners;
  int patches = 0;
  for (std::size_t t = 0; t < surface.triangles.size(); ++t)
  {
    patches = std::max(patches, surface.patch[t]);
    for (const Index v : surface.triangles[t])
    {
      corners[surface.patch[t]].push_back(surface.points[v]);
    }
  }
  std::vector<double> lengths(patches + 1, options.length);
  for (const auto& [patch, points] : corners)
  {
    if (static_cast<std::size_t>(patch) < options.patchLengths.size() && options.patchLengths[patch] > 0)
    {
      lengths[patch] = options.patchLengths[patch];
    }
    else if (options.length <= 0)
    {
      lengths[patch] = ShareOfExtent * extentOf(points).largestLength();
    }
  }
  return lengths;
}

// Whether a line of feature edges passes w nearly in parallel to the edge a b, without touching it.
bool runsAlong(const EditableSurface& surface, Index a, Index b, Index w)
{
  const std::vector<Index> next = surface.neighboursOnLines(w);
  const auto touches = [a, b](Index n) { return n == a || n == b; };
  const Vector3 along = surface.point(b) - surface.point(a);
  const auto isParallel = [&](Index n)
  {
    const double angle = degreesBetween(along, surface.point(n) - surface.point(w));
    return std::min(angle, 180 - angle) < StripAngle;
  };
  return std::none_of(next.begin(), next.end(), touches) && std::any_of(next.begin(), next.end(), isParallel);
}

// The largest absolute curvature of a tensor in the plane normal to n.
double largestCurvature(const std::array<Vector3, 3>& tensor, const Vector3& n)
{
  const Vector3 any = std::fabs(n.x) < 0.6 ? Vector3{ 1, 0, 0 } : Vector3{ 0, 1, 0 };
  const Vector3 u = normalized(cross(n, any));
  const Vector3 w = cross(n, u);
  const auto times = [&tensor](const Vector3& a) {
    return Vector3{ dot(tensor[0], a), dot(tensor[1], a), dot(tensor[2], a) };
  };
  const double uu = dot(u, times(u));
  const double ww = dot(w, times(w));
  const double uw = dot(u, times(w));
  const double mean = 0.5 * (uu + ww);
  return std::fabs(mean) + std::sqrt(0.25 * (uu - ww) * (uu - ww) + uw * uw);
}
} // namespace

RemeshSizes::RemeshSizes(const SurfaceReference& reference, const RemeshingOptions& options)
  : reference_(reference)
  , options_(options)
  , lengths_(lengthsOfPatches(reference.surface(), options))
  , gaps_(options.edgesAcrossGap > 0 ? new SurfaceGaps(reference.surface(), options.gapSide) : nullptr)
{
}

double RemeshSizes::smallestOf(int patch) const
{
  return options_.smallest > 0 ? options_.smallest : SmallestShare * lengths_[patch];
}

// The curvature tensor at a point is the sum over the edges around it of their turn, along the edge, by the
// area (D. Cohen-Steiner, J.-M. Morvan, Restricted Delaunay triangulations and normal cycle, SoCG 2003).
double RemeshSizes::curvedLength(const EditableSurface& surface, Index v) const
{
  std::array<Vector3, 3> tensor{};
  Vector3 normal;
  double area = 0;
  for (const Index t : surface.trianglesAt(v))
  {
    const Vector3 n = areaVector(surface.surface(), surface.triangle(t));
    normal += n;
    area += norm(n) / 6; // a third of the triangle's
  }
  for (const Index w : surface.neighbours(v))
  {
    const std::vector<Index> at = surface.trianglesAt(v, w);
    if (at.size() != 2 || surface.lineOf(v, w) != None)
    {
      continue;
    }
    const Vector3 along = surface.point(w) - surface.point(v);
    const Vector3 n = areaVector(surface.surface(), surface.triangle(at[0]));
    const Vector3 m = areaVector(surface.surface(), surface.triangle(at[1]));
    const Vector3 e = normalized(along);
    const Vector3& far = surface.point(surface.cornerOpposite(at[0], v, w));
    const double sign = dot(m, far - surface.point(v)) < 0 ? 1 : -1; // convex or concave
    const double turn = sign * degreesBetween(n, m) / DegreesOfRadian;
    for (int k = 0; k < 3; ++k)
    {
      tensor[k] += (0.5 * turn * norm(along) * e[k]) * e;
    }
  }
  const double curvature = area > 0 ? largestCurvature(tensor, normalized(normal)) / area : 0;
  return curvature > 0 ? 2 * std::numbers::pi / (options_.edgesPerCircle * curvature) : INFINITY;
}

// Where a line of feature edges is bent.
double RemeshSizes::bentLength(const EditableSurface& surface, Index v) const
{
  const std::vector<Index> ends = surface.neighboursOnLines(v);
  if (ends.size() != 2)
  {
    return INFINITY;
  }
  const Vector3 in = surface.point(v) - surface.point(ends[0]);
  const Vector3 out = surface.point(ends[1]) - surface.point(v);
  const double turn = degreesBetween(in, out) / DegreesOfRadian;
  const double length = 0.5 * (norm(in) + norm(out));
  const double allowed = 2 * std::numbers::pi / options_.edgesPerCircle;
  // Edges of the given line tell no more than this.
  const double given = reference_.closestOnLine(surface.point(v), surface.lineOf(v, ends[0])).edge;
  return turn > 0 ? std::max(given, length * allowed / turn) : INFINITY;
}

// Where two lines of feature edges run side by side with one triangle between them, as at blunt trailing edges.
double RemeshSizes::stripLength(const EditableSurface& surface, Index v) const
{
  double width = INFINITY;
  for (const Index t : surface.trianglesAt(v))
  {
    const Corners& corners = surface.triangle(t);
    for (int i = 0; i < 3; ++i)
    {
      const Index a = corners[i];
      const Index b = corners[(i + 1) % 3];
      if (surface.lineOf(a, b) != None && runsAlong(surface, a, b, corners[(i + 2) % 3]))
      {
        width = std::min(
          width, norm(areaVector(surface.surface(), corners)) / distance(surface.point(a), surface.point(b)));
      }
    }
  }
  return EdgesToStrip * width;
}

double RemeshSizes::givenLength(const EditableSurface& surface, Index v, int patch) const
{
  const ReferencePoint closest = reference_.closestOnPatch(surface.point(v), patch);
  if (closest.triangle == None)
  {
    return INFINITY;
  }
  const SurfaceMesh& given = reference_.surface();
  const Corners& t = given.triangles[closest.triangle];
  double sum = 0;
  double area = 0;
  for (int i = 0; i < 3; ++i)
  {
    const Vector3& a = given.points[t[(i + 1) % 3]];
    const Vector3& b = given.points[t[(i + 2) % 3]];
    const double part = norm(cross(a - closest.place, b - closest.place));
    sum += part * options_.pointLengths[t[i]];
    area += part;
  }
  return area > 0 ? sum / area : options_.pointLengths[t[0]];
}

double RemeshSizes::wantedAt(const EditableSurface& surface, Index v, bool byCurvature) const
{
  double size = INFINITY;
  double smallest = INFINITY;
  bool isAsked = options_.length > 0; // by more than a default
  for (const Index t : surface.trianglesAt(v))
  {
    const auto patch = static_cast<std::size_t>(surface.patch(t));
    isAsked = isAsked || (patch < options_.patchLengths.size() && options_.patchLengths[patch] > 0);
    size = std::min(size, lengths_[surface.patch(t)]);
    smallest = std::min(smallest, smallestOf(surface.patch(t)));
  }
  if (!options_.pointLengths.empty())
  {
    const double given = givenLength(surface, v, surface.patch(surface.trianglesAt(v)[0]));
    size = !isAsked && given < INFINITY ? given : std::min(size, given);
  }
  if (byCurvature && options_.edgesPerCircle > 0)
  {
    const int patch = surface.patch(surface.trianglesAt(v)[0]);
    const Index t = reference_.closestOnPatch(surface.point(v), patch).triangle;
    // Between flat triangles that are given there is no more curvature to be found.
    const double facet =
      t == None ? 0 : smallestHeight(reference_.surface(), reference_.surface().triangles[t]);
    size = std::min(size, std::max({ smallest, facet, curvedLength(surface, v) }));
    size = std::min(size, std::max(smallest, bentLength(surface, v)));
  }
  if (gaps_)
  {
    const double reach = options_.edgesAcrossGap * size;
    size = std::min(size, std::max(smallest, gaps_->widthAt(surface, v, reach) / options_.edgesAcrossGap));
  }
  size = std::min(size, std::max({ smallest, SmallestInStrip * size, stripLength(surface, v) }));
  return options_.limit ? std::min(size, options_.limit(surface.point(v))) : size;
}

std::vector<double> RemeshSizes::at(const EditableSurface& surface, bool byCurvature) const
{
  std::vector<double> sizes(surface.pointCount(), INFINITY);
  for (std::size_t v = 0; v < sizes.size(); ++v)
  {
    if (!surface.trianglesAt(static_cast<Index>(v)).empty())
    {
      sizes[v] = wantedAt(surface, static_cast<Index>(v), byCurvature);
    }
  }
  limitGrowth(surface, options_.slope, sizes);
  return sizes;
}

// Dijkstra's way, from the smallest size outward.
void limitGrowth(const EditableSurface& surface, double slope, std::vector<double>& sizes)
{
  using Entry = std::pair<double, Index>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue;
  for (std::size_t v = 0; v < sizes.size(); ++v)
  {
    queue.emplace(sizes[v], static_cast<Index>(v));
  }
  while (!queue.empty())
  {
    const auto [here, v] = queue.top();
    queue.pop();
    if (here != sizes[v])
    {
      continue; // a smaller size has come since
    }
    for (const Index w : surface.neighbours(v))
    {
      const double allowed = here + slope * distance(surface.point(v), surface.point(w));
      if (allowed < sizes[w])
      {
        sizes[w] = allowed;
        queue.emplace(allowed, w);
      }
    }
  }
}
} // namespace ransmesh
