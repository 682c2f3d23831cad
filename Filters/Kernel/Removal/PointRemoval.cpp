#include "Removal/PointRemoval.h"

#include "Geometry/Angles.h"
#include "Geometry/SpatialOrder.h"
#include "Layers/LayerPlanning.h"
#include "Removal/CornerRegion.h"
#include "Removal/PoorMending.h"
#include "Removal/ValenceReduction.h"
#include "Removal/VertexRemover.h"

#include <algorithm>
#include <array>
#include <iterator>
#include <string>
#include <unordered_map>

namespace ransmesh
{
namespace
{
// The limits of the passes: collapse first, then cavities, then less and less quality.
constexpr RemovalLimits Passes[] = {
  { 0.20, 0, 0, 0 },
  { 0.15, 0, 0, 0 },
  { 0.15, 4, 0, 1 },
  { 0.12, 6, 0, 1 },
  { 0.09, 12, 0, 1 },
  { 0.06, 20, 0, 1 },
  { 0.06, 0, 12, 1 },
  { 0.05, 20, 12, 1 },
  { 0.03, 20, 12, 1 },
  { 0.02, 40, 12, 1 },
  { 0.02, 40, 40, 0.8 },
  { 0.02, 40, 40, 0.5 },
  { 0.02, 40, 40, 0.3 },
  { 0.02, 40, 40, 0.2 },
  { 0.02, 40, 40, 0.1 },
  { 0.02, 40, 40, 0.05 },
};
constexpr int LooseningFrom = 5; // pass
constexpr int DrivingFrom = 7;
constexpr int PatienceWithSurfaces = 2; // refusals by the surface, once passes are the same for these
constexpr double WallAngleAtLast = 155; // degrees, of a wall's triangles
constexpr int PassCount = static_cast<int>(std::size(Passes));

class Removal
{
public:
  Removal(TetMesh& mesh, BoundaryRules& rules, LayerRegion& region, const RemovalOptions& options,
    const Context& context)
    : mesh_(mesh)
    , rules_(rules)
    , region_(region)
    , context_(context)
    , surfaces_(mesh)
    , ridges_(mesh)
    , remover_(mesh, rules, region, cosineOfDegrees(options.maximumSurfaceAngle), surfaces_, ridges_)
    , mending_(mesh, rules)
    , valence_(mesh, rules, cosineOfDegrees(options.maximumSurfaceAngle), surfaces_)
  {
  }

  void run(RemovalResult& result)
  {
    result.marked = region_.marked.size();
    std::vector<Index> left = orderByKind(region_.marked);
    for (int pass = 0; pass < PassCount && !left.empty(); ++pass)
    {
      if (pass >= LooseningFrom)
      {
        loosen(left, pass, result);
      }
      if (!removeAll(left, pass, result))
      {
        result.outcome = Outcome::cancelled();
        break;
      }
    }
    if (result.outcome.ok())
    {
      improveWalls(result);
      separateRidges(result);
      mending_.begin();
      result.swaps += mending_.mendAll(PoorQualityAtLast);
    }
    std::copy_if(givenUp_.begin(), givenUp_.end(), std::back_inserter(left),
      [this](Index v) { return region_.isMarked[v] != 0; }); // others may have taken them along
    result.remaining = left;
    result.removed = result.marked - left.size();
    result.remainingOnWalls = static_cast<std::size_t>(
      std::count_if(left.begin(), left.end(), [this](Index v) { return region_.wallNormal.count(v) > 0; }));
    result.neededByShape = static_cast<std::size_t>(std::count_if(
      left.begin(), left.end(), [this](Index v) { return remover_.isNeededByShape(v, WallAngleAtLast); }));
    countOf(result.verdicts, RemovalVerdict::Absorbed) = remover_.absorbed();
  }

private:
  // Ridge points first, then those on surfaces: theirs is the least freedom.
  std::vector<Index> orderByKind(const std::vector<Index>& marked) const
  {
    std::vector<Index> order = marked;
    std::stable_sort(order.begin(), order.end(),
      [this](Index a, Index b) { return rules_.classification.kind[a] > rules_.classification.kind[b]; });
    return order;
  }

  // One attempt for each point left; those that stay are left then. False when cancelled.
  bool removeAll(std::vector<Index>& left, int pass, RemovalResult& result)
  {
    constexpr std::size_t askEvery = 1024;
    bool stopped = false;
    for (std::size_t i = 0; i < left.size() && !stopped; ++i)
    {
      if (i % askEvery == 0)
      {
        reportProgress(static_cast<double>(left.size()) - 0.5 * static_cast<double>(i));
        stopped = context_.stopped();
      }
      if (!stopped && region_.isMarked[left[i]])
      {
        const RemovalVerdict verdict = attempt(left[i], limitsAt(left[i], pass));
        ++countOf(result.verdicts, verdict);
        noteRefusal(left[i], verdict, pass);
      }
    }
    std::erase_if(left, [this](Index v) { return !region_.isMarked[v] || isGivenUp(v); });
    return !stopped;
  }

  // From DrivingFrom on, only the quality asked for becomes less from pass to pass: that does not help where the
  // surface refuses.
  void noteRefusal(Index v, RemovalVerdict verdict, int pass)
  {
    if (pass >= DrivingFrom && isOfSurface(verdict) && ++refusedBySurface_[v] == PatienceWithSurfaces)
    {
      givenUp_.push_back(v);
    }
  }

  bool isGivenUp(Index v) const
  {
    const auto found = refusedBySurface_.find(v);
    return found != refusedBySurface_.end() && found->second >= PatienceWithSurfaces;
  }

  // A pass leaves about half of its points to the next: stillToDo counts with that.
  void reportProgress(double stillToDo)
  {
    progress_ = std::max(progress_, 1 - stillToDo / static_cast<double>(region_.marked.size()));
    context_.report(progress_, "removing points");
  }

  // The share of the usual quality that the walls allow at a point.
  double allowedAt(Index v) const
  {
    constexpr double least = 0.01;
    return std::clamp(1.25 * region_.attainable[v], least, 1.0);
  }

  // The limits of a pass at a point: no better quality is asked for than the walls allow, and in the last
  // pass less.
  RemovalLimits limitsAt(Index v, int pass) const
  {
    const double allowed = allowedAt(v);
    RemovalLimits limits = Passes[pass];
    limits.quality *= pass + 1 == PassCount ? allowed * allowed : allowed;
    limits.wallAngle = pass < LooseningFrom ? 120 : pass < DrivingFrom ? 140 : WallAngleAtLast;
    return limits;
  }

  RemovalVerdict attempt(Index v, const RemovalLimits& limits)
  {
    RemovalVerdict verdict = remover_.remove(v, limits);
    RemovalLimits plain = limits;
    plain.growth = 0;
    const auto wall = region_.wallNormal.find(v);
    const bool onWall = wall != region_.wallNormal.end();
    if (limits.cuts > 0 && region_.isMarked[v])
    {
      onWall ? valence_.beginOnWall(v, limits, wall->second) : valence_.begin(v, limits);
    }
    for (int cut = 0; cut < limits.cuts && region_.isMarked[v] && valence_.cutEdge(); ++cut)
    {
      mending_.note(valence_.made(), PoorQualityAtLast);
      verdict = remover_.remove(v, plain);
    }
    if (!region_.isMarked[v])
    {
      mending_.note(remover_.made(), remover_.worstMade() < PoorQualityAtLast ? PoorQualityAtLast : 0);
    }
    if (!region_.isMarked[v] && onWall)
    {
      noteWallFaces(remover_.made());
    }
    return verdict;
  }

  void noteWallFaces(const std::vector<Index>& made)
  {
    for (const Index t : made)
    {
      for (const HalfFace beyond : mesh_.tet(t).neighbour)
      {
        if (isBoundary(beyond) && !rules_.changeable[mesh_.patchOf(beyond)])
        {
          wallFaces_.push_back(boundaryFaceOf(beyond));
        }
      }
    }
  }

  // Moves v to where it would best be collapsed to, as far as it comes.
  bool driveToApex(Index v, int pass)
  {
    constexpr double share = 0.2; // of the pass's limit: swaps mend it, or the next collapse
    const RemovalLimits limits = limitsAt(v, pass);
    const Index apex = remover_.nearestApex(v, limits);
    return mending_.moveTowards(v, mesh_.point(apex), share * limits.quality);
  }

  // Changes the surroundings of the points that would not go.
  void loosen(const std::vector<Index>& left, int pass, RemovalResult& result)
  {
    constexpr double keep = 0.5;
    const bool drive = pass >= DrivingFrom;
    mending_.begin();
    for (const Index v : left)
    {
      result.movements += drive ? driveToApex(v, pass) : mending_.move(v, keep);
      result.swaps += mending_.swapAround(v, PoorQuality);
    }
  }

  // Turns edges of the walls where that makes the largest angle of the triangles smaller.
  void improveWalls(RemovalResult& result)
  {
    constexpr int rounds = 3;
    const RemovalLimits limits{ 0.05, 0, 0, 0.5, 0 };
    std::sort(wallFaces_.begin(), wallFaces_.end());
    wallFaces_.erase(std::unique(wallFaces_.begin(), wallFaces_.end()), wallFaces_.end());
    for (int round = 0; round < rounds; ++round)
    {
      for (const Index face : wallFaces_)
      {
        if (mesh_.boundaryFace(face).isAlive() && turnLongestEdge(face, limits))
        {
          ++result.swaps;
          mending_.note(valence_.made(), PoorQualityAtLast);
        }
      }
    }
  }

  // Turns edges of the walls that join two ridges: the grids of both ridges need points between them.
  void separateRidges(RemovalResult& result)
  {
    const RemovalLimits limits{ 0.03, 0, 0, 0.5, 140 };
    const auto onRidge = [this](Index v) { return rules_.classification.kind[v] >= VertexKind::Ridge; };
    for (const Index face : wallFaces_)
    {
      for (int j = 0; j < 3 && mesh_.boundaryFace(face).isAlive(); ++j)
      {
        const auto v = mesh_.boundaryVertices(face);
        const Index from = v[j];
        const Index to = v[(j + 1) % 3];
        if (onRidge(from) && onRidge(to) && !rules_.classification.ridges.has(from, to) &&
          valence_.swapOnWall(from, to, limits, {}))
        {
          ++result.swaps;
          mending_.note(valence_.made(), PoorQualityAtLast);
          break;
        }
      }
    }
  }

  bool turnLongestEdge(Index face, const RemovalLimits& limits)
  {
    constexpr double large = 110; // degrees
    const auto v = mesh_.boundaryVertices(face);
    const Vector3& a = mesh_.point(v[0]);
    const Vector3& b = mesh_.point(v[1]);
    const Vector3& c = mesh_.point(v[2]);
    const std::array<double, 3> opposite = { distance(b, c), distance(c, a), distance(a, b) };
    const auto j = std::max_element(opposite.begin(), opposite.end()) - opposite.begin();
    return largestAngle(a, b, c) > large && valence_.swapOnWall(v[(j + 1) % 3], v[(j + 2) % 3], limits, {});
  }

  TetMesh& mesh_;
  BoundaryRules& rules_;
  LayerRegion& region_;
  const Context& context_;
  SurfaceMemory surfaces_;
  SurfaceMemory ridges_;
  VertexRemover remover_;
  PoorMending mending_;
  ValenceReduction valence_;
  std::vector<Index> wallFaces_;                    // made by removal of points of walls
  std::unordered_map<Index, int> refusedBySurface_; // how often, of the points left
  std::vector<Index> givenUp_;
  double progress_ = 0;
};

bool patchesAreKnown(const TetMesh& mesh, const PatchTable& patches)
{
  for (std::size_t b = 0; b < mesh.boundarySlots(); ++b)
  {
    const BoundaryFace& face = mesh.boundaryFace(static_cast<Index>(b));
    if (face.isAlive() && (face.patch < 1 || static_cast<std::size_t>(face.patch) >= patches.size()))
    {
      return false;
    }
  }
  return true;
}

// Marks the points of walls in corners, too.
void addCornerPoints(const std::vector<CornerPoint>& points, const TetMesh& mesh, LayerRegion& region)
{
  for (const CornerPoint& point : points)
  {
    region.marked.push_back(point.vertex);
    region.isMarked[point.vertex] = 1;
    region.reach[point.vertex] = static_cast<float>(point.reach);
    region.wallNormal[point.vertex] = point.normal;
  }
  sortSpatially(mesh.points(), region.marked);
}
} // namespace

std::string RemovalResult::text() const
{
  return std::to_string(marked) + " points in the layers' region, " + std::to_string(removed) + " removed, " +
    std::to_string(remaining.size()) + " remain" +
    (remainingOnWalls > 0 ? ", of these " + std::to_string(remainingOnWalls) + " on walls in corners" : "") +
    (neededByShape > 0 ? ", " + std::to_string(neededByShape) + " that the surface's shape needs" : "");
}

RemovalResult removePoints(TetMesh& mesh, const PatchTable& patches, const LayerPlan& plan,
  const RemovalOptions& options, const Context& context)
{
  RemovalResult result;
  if (!patchesAreKnown(mesh, patches))
  {
    result.outcome = Outcome::badInput(
      "a boundary triangle has a patch that the patch table does not have: give every patch a row");
    return result;
  }
  context.report(0, "marking points");
  const BoundaryStars stars(mesh);
  BoundaryRules rules{ classify(mesh, stars, patches), changeablePatches(patches, plan) };
  LayerRegion region =
    findLayerRegion(mesh, stars, rules.classification, rules.changeable, plan, options.margin);
  const std::vector<CornerPoint> corners =
    findCornerPoints(mesh, stars, rules.classification, rules.changeable, plan, options.cornerMargin);
  addCornerPoints(corners, mesh, region);
  result.markedOnWalls = corners.size();
  if (region.marked.empty())
  {
    return result;
  }
  Removal(mesh, rules, region, options, context).run(result);
  return result;
}
} // namespace ransmesh
