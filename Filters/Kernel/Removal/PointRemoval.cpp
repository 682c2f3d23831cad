#include "Removal/PointRemoval.h"

#include "Geometry/Angles.h"
#include "Geometry/SpatialOrder.h"
#include "Layers/LayerPlanning.h"
#include "Removal/CornerRegion.h"
#include "Removal/PoorMending.h"
#include "Removal/RefillRemover.h"
#include "Removal/ValenceReduction.h"
#include "Removal/VertexRemover.h"
#include "Removal/WallTurning.h"

#include <algorithm>
#include <iterator>
#include <string>
#include <unordered_map>
#include <unordered_set>

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
    , turning_(mesh, rules, valence_, mending_)
    , refiller_(mesh)
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
    std::copy_if(givenUp_.begin(), givenUp_.end(), std::back_inserter(left),
      [this](Index v) { return region_.isMarked[v] != 0; }); // others may have taken them along
    if (result.outcome.ok())
    {
      result.swaps += turning_.turnAll();
      mending_.begin();
      result.swaps += mending_.mendAll(PoorQualityAtLast);
      tryAgain(left, result);
    }
    countAll(left, result);
  }

private:
  void countAll(const std::vector<Index>& left, RemovalResult& result)
  {
    result.remaining = left;
    result.removed = result.marked - left.size();
    result.remainingOnWalls = static_cast<std::size_t>(
      std::count_if(left.begin(), left.end(), [this](Index v) { return region_.wallNormal.count(v) > 0; }));
    result.neededByShape = static_cast<std::size_t>(
      std::count_if(left.begin(), left.end(), [this](Index v) { return isNeededByShape(v); }));
    countOf(result.verdicts, RemovalVerdict::Absorbed) = remover_.absorbed();
  }

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

  bool isNeededByShape(Index v)
  {
    return remover_.isNeededByShape(v, WallAngleAtLast) ||
      std::find(neededInside_.begin(), neededInside_.end(), v) != neededInside_.end();
  }

  // Much has changed since the points left were refused: tries them again, as long as some of them go.
  void tryAgain(std::vector<Index>& left, RemovalResult& result)
  {
    for (std::size_t before = left.size() + 1; left.size() < before;)
    {
      before = left.size();
      mending_.begin();
      for (const Index v : left)
      {
        if (region_.isMarked[v] && !remover_.isNeededByShape(v, WallAngleAtLast))
        {
          ++countOf(result.verdicts, attemptAtLast(v));
        }
      }
      std::erase_if(left, [this](Index v) { return !region_.isMarked[v]; });
      result.swaps += left.size() < before ? mending_.mendAll(PoorQualityAtLast) : 0;
    }
  }

  RemovalVerdict attemptAtLast(Index v)
  {
    const RemovalLimits limits = limitsAt(v, PassCount - 1);
    const RemovalVerdict verdict = attempt(v, limits);
    if (!region_.isMarked[v] || rules_.classification.kind[v] != VertexKind::Volume ||
      !refillTried_.insert(v).second)
    {
      return verdict;
    }
    const RefillRemover::Verdict refilled = refiller_.remove(v, remover_.floorAt(v, limits));
    if (refilled == RefillRemover::Verdict::Removed)
    {
      region_.isMarked[v] = 0;
      mending_.note(refiller_.made(), PoorQualityAtLast);
      return RemovalVerdict::RemovedWithCavity;
    }
    if (refilled == RefillRemover::Verdict::Needed)
    {
      neededInside_.push_back(v);
    }
    return verdict;
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
      turning_.note(remover_.made());
    }
    return verdict;
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

  TetMesh& mesh_;
  BoundaryRules& rules_;
  LayerRegion& region_;
  const Context& context_;
  SurfaceMemory surfaces_;
  SurfaceMemory ridges_;
  VertexRemover remover_;
  PoorMending mending_;
  ValenceReduction valence_;
  WallTurning turning_;
  RefillRemover refiller_;
  std::unordered_map<Index, int> refusedBySurface_; // how often, of the points left
  std::vector<Index> givenUp_;
  std::unordered_set<Index> refillTried_;
  std::vector<Index> neededInside_; // points of the volume that nothing can be filled without
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
