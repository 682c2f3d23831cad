#include "Insertion/Enrichment.h"

#include "Insertion/EnrichedOutput.h"
#include "Insertion/FanOpening.h"
#include "Insertion/FirstRise.h"
#include "Insertion/FrontCrossings.h"
#include "Insertion/FrontImprovement.h"
#include "Insertion/StackFolds.h"
#include "Layers/ColumnBuilder.h"
#include "Layers/ColumnLimits.h"
#include "Layers/GapLimits.h"
#include "Layers/LayerPlanning.h"
#include "Layers/SideColumns.h"
#include "Mesh/Builder.h"
#include "Mesh/Validation.h"
#include "Support/Numbers.h"

#include <algorithm>

namespace ransmesh
{
namespace
{
constexpr int MostRestarts = 20;

// Levels that an earlier attempt found to fold, by vertex.
using LevelCaps = std::vector<int>;

ColumnSet planColumns(
  const TetMesh& mesh, const PatchTable& patches, const LayerPlan& plan, const EnrichmentOptions& options)
{
  const BoundaryStars stars(mesh);
  ColumnSet set = buildColumns(mesh, stars, patches, plan, options.gridsOnWakes);
  limitByIsotropicSize(plan, set);
  followSides(mesh, stars, plan, options.gapFraction, set);
  limitByGap(mesh, stars, options.gapFraction, set);
  limitBySlope(mesh, stars, set);
  if (settleDisagreements(mesh, set))
  {
    limitBySlope(mesh, stars, set);
  }
  return set;
}

void limitByCaps(const TetMesh& mesh, const LevelCaps& caps, ColumnSet& set)
{
  for (Column& c : set.columns)
  {
    c.limit(caps[c.root], StopReason::Refused);
  }
  if (settleDisagreements(mesh, set))
  {
    limitBySlope(mesh, BoundaryStars(mesh), set);
  }
}

std::size_t countPoints(const ColumnSet& set)
{
  std::size_t count = 0;
  for (const Column& c : set.columns)
  {
    count += static_cast<std::size_t>(c.levels);
  }
  return count;
}

// Halves the columns at the folded faces for the next attempt.
void lowerFolded(
  const TetMesh& mesh, const ColumnSet& set, const std::vector<Index>& foldedFaces, LevelCaps& caps)
{
  for (const Index face : foldedFaces)
  {
    for (const Index v : mesh.boundaryVertices(face))
    {
      if (const Index c = set.standingAt(v); c != None)
      {
        caps[set.columns[c].root] = set.columns[c].levels / 2;
      }
    }
  }
}

Outcome check(const EnrichmentOptions& options)
{
  if (!(options.gapFraction > 0 && options.gapFraction <= 0.5))
  {
    return Outcome::badInput("the gap fraction is " + textOf(options.gapFraction) +
      "; it must lie above 0 and not exceed 0.5: set GapFraction");
  }
  if (!(options.maximumSurfaceAngle >= 0 && options.maximumSurfaceAngle <= 90))
  {
    return Outcome::badInput("the maximum surface angle is " + textOf(options.maximumSurfaceAngle) +
      "; it must lie between 0 and 90 degrees: set MaximumSurfaceAngle");
  }
  return Outcome::done();
}
} // namespace

Outcome enrich(const MeshData& input, const PatchTable& patches, const LayerPlan& plan,
  const EnrichmentOptions& options, const Context& context, EnrichedMesh& result)
{
  if (Outcome outcome = check(options); !outcome.ok())
  {
    return outcome;
  }
  context.report(0, "building the mesh's neighbourhoods");
  TetMesh mesh;
  if (Outcome outcome = buildTetMesh(input, mesh); !outcome.ok())
  {
    return outcome;
  }
  context.report(0.1, "planning columns");
  const ColumnSet planned = planColumns(mesh, patches, plan, options);
  LevelCaps caps(input.points.size(), MaximumNumberOfLayers);
  for (int attempt = 0; attempt < MostRestarts; ++attempt)
  {
    ColumnSet set = planned;
    if (attempt > 0)
    {
      context.report(0.1, "planning columns");
      buildTetMesh(input, mesh);
      limitByCaps(mesh, caps, set);
    }
    EnrichedMesh enriched;
    enriched.report.restarts = attempt;
    enriched.report.fans = openFans(mesh, set);
    std::vector<BaseFace> faces = collectBaseFaces(mesh, set);
    orderFirstRise(mesh, faces, set);
    std::vector<Index> folded = limitByFolds(mesh, faces, set);
    if (folded.empty() && limitByCrossings(mesh, set) > 0)
    {
      folded = limitByFolds(mesh, faces, set);
    }
    if (folded.empty())
    {
      const BoundaryRules rules{ classify(mesh, patches), changeablePatches(patches, plan) };
      enriched.report.columns = set.columns.size();
      enriched.report.pointsRequested = countPoints(set);
      if (!raiseFront(
            mesh, set, rules.classification, options.maximumSurfaceAngle, context, enriched.report.raising))
      {
        return Outcome::cancelled();
      }
      context.report(0.7, "improving the mesh beyond the layers");
      if (mendFolds(mesh, set, folded))
      {
        enriched.report.improvements = improveBeyondFront(mesh, set, rules, context);
        context.report(0.9, "writing the layers");
        writeEnriched(mesh, set, options.maximumSurfaceAngle, enriched);
        result = std::move(enriched);
        return Outcome::done();
      }
    }
    context.remark(std::to_string(folded.size()) + " stacks of layers fold; their columns are lowered");
    lowerFolded(mesh, set, folded, caps);
  }
  return Outcome::internalFault("the layers still fold after " + std::to_string(MostRestarts) +
    " attempts; nothing was written. Ask for a smaller total thickness");
}
} // namespace ransmesh
