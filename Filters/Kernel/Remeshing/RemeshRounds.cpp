#include "Remeshing/RemeshRounds.h"

#include "Remeshing/RemeshGuard.h"
#include "Remeshing/RemeshMeasures.h"
#include "Remeshing/RemeshSizes.h"

#include <algorithm>
#include <queue>
#include <tuple>

namespace ransmesh
{
namespace
{
constexpr int Rounds = 8;
constexpr int MovementsInRound = 2;
constexpr int MostPasses = 10;
constexpr std::size_t MostTriangles = 20'000'000;
// Edges outside of these parts of the wanted length are collapsed and split: half and twice would be the
// least that does not go round in circles.
constexpr double ShortEdge = 0.8;
constexpr double LongEdge = 1.35;
// Triangles with a smaller angle (degrees) lose their shortest edge at the end, where that betters them.
constexpr double NarrowAngle = 25;
constexpr double NarrowLongEdge = 2;
constexpr double LittleLonger = 1.1;
constexpr double LeastGain = 1e-3; // degrees, of the smallest angle by a swap
constexpr double NearShare = 0.5;  // of an edge: farther points of the given surface are not what was divided

// A flag a point: those of kept patches.
std::vector<char> keptPoints(const SurfaceMesh& given, const std::vector<char>& patches)
{
  std::vector<char> keep(given.points.size(), 0);
  for (std::size_t t = 0; t < given.triangles.size(); ++t)
  {
    const auto patch = static_cast<std::size_t>(given.patch[t]);
    for (const Index v : given.triangles[t])
    {
      keep[v] = keep[v] || (patch < patches.size() && patches[patch]);
    }
  }
  return keep;
}

class Remeshing
{
public:
  Remeshing(
    const SurfaceMesh& given, const RemeshingOptions& options, double strictness, const Context& context)
    : surface_(given, options.featureAngle, keptPoints(given, options.keptPatches))
    , options_(options)
    , strictness_(strictness)
    , context_(context)
    , reference_(surface_)
    , field_(reference_, options_)
    , guard_(surface_, reference_)
  {
  }

  Outcome run()
  {
    for (int round = 0; round < Rounds; ++round)
    {
      context_.report(static_cast<double>(round) / Rounds, "remeshing the surface");
      if (context_.stopped())
      {
        return Outcome::cancelled();
      }
      // Needles and slivers tell little of the curvature: it is looked for once they have gone.
      sizes_ = field_.at(surface_, round > 0);
      if (trianglesToCome() > MostTriangles)
      {
        return Outcome::badInput("the surface edges that are asked for make more than 20 million triangles; "
                                 "ask for longer ones");
      }
      // As far as it goes: what is split instead makes many triangles of needles.
      for (int pass = 0; collapseShortEdges() > 0 && pass < MostPasses; ++pass)
      {
      }
      splitLongEdges();
      collapseShortEdges();
      swapDiagonals();
      for (int i = 0; i < MovementsInRound; ++i)
      {
        movePoints();
        swapDiagonals();
      }
    }
    for (int i = 0; i < 2; ++i)
    {
      collapseNarrowTriangles();
      swapDiagonals();
      movePoints();
    }
    return Outcome::done();
  }

  SurfaceMesh result() const { return surface_.result(); }

  const SurfaceReference& reference() const { return reference_; }

private:
  // An edge by its need, the greatest first; a < b.
  using Entry = std::tuple<double, Index, Index>;
  using Queue = std::priority_queue<Entry>;

  double lengthOf(Index a, Index b) const { return distance(surface_.point(a), surface_.point(b)); }
  double wantedAt(Index a, Index b) const { return 0.5 * (sizes_[a] + sizes_[b]); }
  double ratio(Index a, Index b) const { return lengthOf(a, b) / wantedAt(a, b); }
  double toleranceAt(Index a, Index b) const
  {
    return strictness_ * (options_.deviation > 0 ? options_.deviation : DeviationShare * wantedAt(a, b));
  }

  std::size_t trianglesToCome() const
  {
    double count = 0;
    for (std::size_t i = 0; i < surface_.triangleCount(); ++i)
    {
      if (surface_.isAlive(static_cast<Index>(i)))
      {
        const Corners& t = surface_.triangle(static_cast<Index>(i));
        const double size = (sizes_[t[0]] + sizes_[t[1]] + sizes_[t[2]]) / 3;
        count += norm(areaVector(surface_.surface(), t)) / (0.87 * size * size);
      }
    }
    return static_cast<std::size_t>(std::min(count, 1e15));
  }

  template <class Visit>
  void forEachEdgeOnce(Visit visit) const
  {
    for (std::size_t i = 0; i < surface_.pointCount(); ++i)
    {
      const auto a = static_cast<Index>(i);
      for (const Index b : surface_.neighbours(a))
      {
        if (a < b)
        {
          visit(a, b);
        }
      }
    }
  }

  void offerShort(Queue& queue, Index a, Index b) const
  {
    if (const double r = ratio(a, b); r < ShortEdge)
    {
      queue.emplace(-r, std::min(a, b), std::max(a, b));
    }
  }

  // Gives the number of edges that went.
  std::size_t collapseShortEdges()
  {
    std::size_t count = 0;
    Queue queue;
    forEachEdgeOnce([&](Index a, Index b) { offerShort(queue, a, b); });
    while (!queue.empty())
    {
      const auto [need, a, b] = queue.top();
      queue.pop();
      if (surface_.trianglesAt(a, b).empty() || ratio(a, b) != -need)
      {
        continue;
      }
      std::vector<Index> around;
      const Index kept = collapseEither(a, b, LongEdge, around);
      count += kept == None ? 0 : 1;
      for (const Index w : around)
      {
        offerShort(queue, kept, w);
      }
    }
    return count;
  }

  // The point that remains, or None where neither may go; the ends of its edges that came.
  Index collapseEither(Index a, Index b, double longest, std::vector<Index>& around)
  {
    for (const auto& [gone, kept] : { std::pair(b, a), std::pair(a, b) })
    {
      if (surface_.mayCollapse(gone, kept) && staysShort(gone, kept, longest) &&
        guard_.allowsCollapse(gone, kept, toleranceAt(gone, kept)))
      {
        around = surface_.neighbours(gone);
        around.erase(std::find(around.begin(), around.end(), kept));
        surface_.collapse(gone, kept);
        return kept;
      }
    }
    return None;
  }

  // No edge becomes longer than wanted, or than the longest that goes.
  bool staysShort(Index gone, Index kept, double longest) const
  {
    const std::vector<Index> around = surface_.neighbours(gone);
    double now = 0;
    for (const Index w : around)
    {
      now = std::max(now, ratio(gone, w));
    }
    // What is too long already is split later.
    const double allowed = std::max(longest, LittleLonger * now);
    return std::all_of(
      around.begin(), around.end(), [&](Index w) { return w == kept || ratio(kept, w) <= allowed; });
  }

  void splitLongEdges()
  {
    Queue queue;
    const auto offer = [&](Index a, Index b)
    {
      if (const double r = ratio(a, b); r > LongEdge && surface_.maySplit(a, b))
      {
        queue.emplace(r, std::min(a, b), std::max(a, b));
      }
    };
    forEachEdgeOnce(offer);
    while (!queue.empty())
    {
      const auto [need, a, b] = queue.top();
      queue.pop();
      if (surface_.trianglesAt(a, b).empty())
      {
        continue; // gone since
      }
      const Index middle = surface_.split(a, b, placeBetween(a, b));
      sizes_.push_back(wantedAt(a, b));
      for (const Index w : surface_.neighbours(middle))
      {
        offer(middle, w);
      }
    }
  }

  // The middle of an edge, on the given surface where that is near.
  Vector3 placeBetween(Index a, Index b) const
  {
    const Vector3 middle = 0.5 * (surface_.point(a) + surface_.point(b));
    const Index line = surface_.lineOf(a, b);
    const Vector3 place = line != None
      ? reference_.closestOnLine(middle, line).place
      : reference_.closestOnPatch(middle, surface_.patch(surface_.trianglesAt(a, b)[0])).place;
    return distance(place, middle) <= NearShare * lengthOf(a, b) ? place : middle;
  }

  void swapDiagonals()
  {
    std::vector<std::pair<Index, Index>> edges;
    forEachEdgeOnce([&](Index a, Index b) { edges.emplace_back(a, b); });
    for (std::size_t i = 0; i < edges.size() && i < 20 * surface_.triangleCount(); ++i)
    {
      const auto [a, b] = edges[i];
      std::array<Corners, 2> made;
      if (!surface_.maySwap(a, b, made) || !isBetter(a, b, made) ||
        !guard_.allowsSwap(a, b, made, toleranceAt(a, b)))
      {
        continue;
      }
      surface_.swap(a, b);
      for (const Corners& t : made)
      {
        for (int k = 0; k < 3; ++k)
        {
          edges.emplace_back(std::min(t[k], t[(k + 1) % 3]), std::max(t[k], t[(k + 1) % 3]));
        }
      }
    }
  }

  bool isBetter(Index a, Index b, const std::array<Corners, 2>& made) const
  {
    const std::vector<Index> at = surface_.trianglesAt(a, b);
    const auto least = [this](const Corners& s, const Corners& t)
    { return std::min(smallestAngle(surface_.surface(), s), smallestAngle(surface_.surface(), t)); };
    return least(made[0], made[1]) > least(surface_.triangle(at[0]), surface_.triangle(at[1])) + LeastGain;
  }

  void movePoints()
  {
    for (std::size_t i = 0; i < surface_.pointCount(); ++i)
    {
      const auto v = static_cast<Index>(i);
      if (surface_.trianglesAt(v).empty() || surface_.freedom(v) == PointFreedom::Fixed)
      {
        continue;
      }
      const Vector3 place = surface_.freedom(v) == PointFreedom::Line ? evenPlaceOnLine(v) : evenPlace(v);
      guard_.moveIfBetter(v, place, toleranceAt(v, v));
    }
  }

  // The middle of the triangles around, weighed by how many of the wanted size they hold.
  Vector3 evenPlace(Index v) const
  {
    Vector3 sum;
    Vector3 normal;
    double total = 0;
    for (const Index t : surface_.trianglesAt(v))
    {
      const Corners& c = surface_.triangle(t);
      const double size = (sizes_[c[0]] + sizes_[c[1]] + sizes_[c[2]]) / 3;
      const Vector3 n = areaVector(surface_.surface(), c);
      const double weight = norm(n) / (size * size);
      normal += n;
      sum += weight * centreOf(surface_.surface(), t);
      total += weight;
    }
    if (!(total > 0))
    {
      return surface_.point(v);
    }
    const Vector3 n = normalized(normal);
    const Vector3 way = (1 / total) * sum - surface_.point(v);
    const Vector3 place = surface_.point(v) + way - dot(way, n) * n;
    return reference_.closestOnPatch(place, surface_.patch(surface_.trianglesAt(v)[0])).place;
  }

  Vector3 evenPlaceOnLine(Index v) const
  {
    const std::vector<Index> ends = surface_.neighboursOnLines(v);
    if (ends.size() != 2)
    {
      return surface_.point(v);
    }
    const Vector3& p = surface_.point(v);
    const double needA = ratio(v, ends[0]);
    const double needB = ratio(v, ends[1]);
    // Towards the end with the longer edge, by half of what makes both alike.
    const Index end = needA > needB ? ends[0] : ends[1];
    const double part = 0.25 * std::fabs(needA - needB) / std::max(needA, needB);
    return reference_.closestOnLine(p + part * (surface_.point(end) - p), surface_.lineOf(v, end)).place;
  }

  void collapseNarrowTriangles()
  {
    for (std::size_t i = 0; i < surface_.triangleCount(); ++i)
    {
      const auto t = static_cast<Index>(i);
      if (!surface_.isAlive(t) || smallestAngle(surface_.surface(), surface_.triangle(t)) >= NarrowAngle)
      {
        continue;
      }
      const Corners c = surface_.triangle(t);
      int shortest = 0;
      for (int k = 1; k < 3; ++k)
      {
        shortest =
          lengthOf(c[k], c[(k + 1) % 3]) < lengthOf(c[shortest], c[(shortest + 1) % 3]) ? k : shortest;
      }
      const Index a = c[shortest];
      const Index b = c[(shortest + 1) % 3];
      if (guard_.collapseBetters(a, b) || guard_.collapseBetters(b, a))
      {
        std::vector<Index> around;
        collapseEither(a, b, NarrowLongEdge, around);
      }
    }
  }

  EditableSurface surface_;
  RemeshingOptions options_;
  double strictness_;
  const Context& context_;
  SurfaceReference reference_;
  RemeshSizes field_;
  RemeshGuard guard_;
  std::vector<double> sizes_; // wanted, by point
};
} // namespace

Outcome remeshInRounds(const SurfaceMesh& given, const RemeshingOptions& options, double strictness,
  const Context& context, SurfaceMesh& made, RemeshingReport& report)
{
  Remeshing remeshing(given, options, strictness, context);
  Outcome outcome = remeshing.run();
  if (outcome.ok())
  {
    made = remeshing.result();
    report = measureRemeshing(remeshing.reference(), made, options.featureAngle);
  }
  return outcome;
}
} // namespace ransmesh
