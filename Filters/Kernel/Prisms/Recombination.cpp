#include "Prisms/Recombination.h"

#include "Mesh/FaceMatching.h"
#include "Prisms/PrismGroups.h"
#include "Prisms/PrismJoints.h"
#include "Prisms/PrismShapes.h"
#include "Prisms/QuadChoice.h"

#include <algorithm>

namespace ransmesh
{
namespace
{
// Collects cells of each kind with their origins, and puts them together.
class CellCollector
{
public:
  explicit CellCollector(RecombinedMesh& result)
    : result_(result)
  {
  }

  void addTet(const std::array<Index, 4>& tet, Index origin)
  {
    result_.mesh.tetrahedra.push_back(tet);
    result_.cellOrigin.push_back(origin);
  }

  void add(PrismCells& cells, const PrismGroup& group, Index beside)
  {
    const auto newNumber = static_cast<Index>(result_.mesh.points.size());
    if (cells.hasNewPoint)
    {
      result_.mesh.points.push_back(cells.newPoint);
      result_.newPointOrigin.push_back(beside);
      ++result_.report.newPoints;
    }
    addCells(cells.tetrahedra, newNumber, group.tet[0], result_.mesh.tetrahedra, result_.cellOrigin);
    addCells(cells.pyramids, newNumber, group.tet[0], result_.mesh.pyramids, pyramidOrigin_);
    addCells(cells.wedges, newNumber, group.tet[0], result_.mesh.wedges, wedgeOrigin_);
    addCells(cells.hexahedra, newNumber, group.tet[0], result_.mesh.hexahedra, hexahedronOrigin_);
    result_.report.tetsInWedges +=
      cells.wedges.empty() && cells.hexahedra.empty() ? 0 : static_cast<std::size_t>(group.size);
  }

  void finish()
  {
    auto& origin = result_.cellOrigin;
    origin.insert(origin.end(), pyramidOrigin_.begin(), pyramidOrigin_.end());
    origin.insert(origin.end(), wedgeOrigin_.begin(), wedgeOrigin_.end());
    origin.insert(origin.end(), hexahedronOrigin_.begin(), hexahedronOrigin_.end());
  }

private:
  template <class Cells>
  static void addCells(Cells& cells, Index newNumber, Index from, Cells& to, std::vector<Index>& origins)
  {
    for (auto& cell : cells)
    {
      std::replace(cell.begin(), cell.end(), PrismCells::NewPoint, newNumber);
      to.push_back(cell);
      origins.push_back(from);
    }
  }

  RecombinedMesh& result_;
  std::vector<Index> pyramidOrigin_;
  std::vector<Index> wedgeOrigin_;
  std::vector<Index> hexahedronOrigin_;
};

void addCells(const MeshData& mesh, const PrismGroups& groups, RecombinedMesh& result)
{
  CellCollector cells(result);
  for (std::size_t t = 0; t < mesh.tetrahedra.size(); ++t)
  {
    if (groups.groupOf[t] == None)
    {
      cells.addTet(mesh.tetrahedra[t], static_cast<Index>(t));
    }
  }
  const PrismShapes shapes(mesh, groups);
  for (std::size_t g = 0; g < groups.groups.size(); ++g)
  {
    auto made = shapes.make(static_cast<Index>(g));
    const PrismGroup& group = groups.groups[g];
    cells.add(*made, group, mesh.tetrahedra[group.tet[0]][0]);
  }
  cells.finish();
}

void addBoundary(const MeshData& mesh, const PrismGroups& groups, RecombinedMesh& result)
{
  std::vector<Index> quadAt(mesh.triangles.size(), None);
  for (std::size_t i = 0; i < groups.quads.size(); ++i)
  {
    const LateralQuad& quad = groups.quads[i];
    if (quad.isKept && quad.triangle[0] != None)
    {
      quadAt[quad.triangle[0]] = quadAt[quad.triangle[1]] = static_cast<Index>(i);
    }
  }
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i)
  {
    const auto& v = mesh.triangles[i];
    Polygon polygon{ v[0], v[1], v[2], None };
    if (quadAt[i] != None)
    {
      const LateralQuad& quad = groups.quads[quadAt[i]];
      if (static_cast<Index>(i) != std::min(quad.triangle[0], quad.triangle[1]))
      {
        continue;
      }
      const auto& c = quad.corner; // turned into the first prism
      polygon = { c[0], c[3], c[2], c[1] };
    }
    result.mesh.boundary.push_back(polygon);
    result.mesh.boundaryPatch.push_back(mesh.trianglePatch[i]);
    result.boundaryOrigin.push_back(static_cast<Index>(i));
  }
}
} // namespace

Outcome recombinePrisms(const MeshData& given, const std::vector<Index>& prism,
  double maximumNonOrthogonality, const Context& context, RecombinedMesh& result)
{
  result = {};
  MeshData mesh = given;
  const FaceMatching matching = matchFaces(mesh);
  if (!matching.ok())
  {
    return Outcome::badInput("the mesh is not valid: its faces do not match; the quality report tells more");
  }
  context.report(0.3, "choice of prisms");
  if (context.stopped())
  {
    return Outcome::cancelled();
  }
  const std::vector<Index> joined = joinPrisms(mesh, matching, prism);
  if (maximumNonOrthogonality < 90)
  {
    result.report.orthogonality = improveOrthogonality(mesh, matching, joined, maximumNonOrthogonality);
  }
  PrismGroups groups = findPrismGroups(mesh, matching, joined);
  chooseQuads(mesh, groups);
  context.report(0.7, "recombination");
  if (context.stopped())
  {
    return Outcome::cancelled();
  }
  result.mesh.points = mesh.points;
  result.report.prismTets = static_cast<std::size_t>(
    std::count_if(prism.begin(), prism.end(), [](Index number) { return number >= 0; }));
  addCells(mesh, groups, result);
  addBoundary(mesh, groups, result);
  return Outcome::done();
}
} // namespace ransmesh
