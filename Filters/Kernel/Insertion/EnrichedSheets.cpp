#include "Insertion/EnrichedSheets.h"

#include "Boundary/SheetFit.h"

namespace ransmesh
{
namespace
{
// The values of the points that remain: of those that became one, the first's.
std::vector<Index> keptValues(const std::vector<Index>& values, const std::vector<Index>& newNumber)
{
  std::vector<Index> kept;
  for (std::size_t v = 0; v < newNumber.size(); ++v)
  {
    if (static_cast<std::size_t>(newNumber[v]) == kept.size())
    {
      kept.push_back(values[v]);
    }
  }
  return kept;
}
} // namespace

Outcome enrichOpened(const MeshData& input, const OpenedSheets& opened, const PatchTable& patches,
  const LayerPlan& plan, const EnrichmentOptions& options, const Context& context, EnrichedMesh& result)
{
  Outcome outcome = enrich(input, patches, plan, options, context, result);
  if (!outcome.ok() || !opened.any() || fitSheets(result.mesh, opened.patches))
  {
    return outcome;
  }
  context.remark("the two sides of a sheet were divided differently: no tensor-product grids on sheets");
  EnrichmentOptions plain = options;
  plain.gridsOnWakes = false;
  return enrich(input, patches, plan, plain, context, result);
}

Outcome closeSheets(const OpenedSheets& opened, EnrichedMesh& enriched)
{
  if (!opened.any())
  {
    return Outcome::done();
  }
  std::vector<Index> newNumber;
  if (Outcome outcome = closeSheets(enriched.mesh, opened.patches, newNumber); !outcome.ok())
  {
    return outcome;
  }
  enriched.column = keptValues(enriched.column, newNumber);
  enriched.origin = keptValues(enriched.origin, newNumber);
  for (Index& v : enriched.origin)
  {
    v = v == None ? None : opened.origin[v];
  }
  for (WallPoint& point : enriched.wallPoints)
  {
    point.point = newNumber[point.point];
  }
  return Outcome::done();
}
} // namespace ransmesh
