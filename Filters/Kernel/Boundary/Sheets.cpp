#include "Boundary/Sheets.h"

#include "Boundary/SheetDivision.h"
#include "Boundary/SheetSides.h"
#include "Mesh/Tidying.h"
#include "Support/Numbers.h"

#include <algorithm>
#include <map>
#include <numeric>
#include <set>
#include <tuple>

namespace ransmesh
{
namespace
{
std::string placeOf(const Vector3& p)
{
  return "(" + textOf(p.x) + ", " + textOf(p.y) + ", " + textOf(p.z) + ")";
}

Vector3 centreOf(const MeshData& mesh, Index triangle)
{
  const auto& v = mesh.triangles[triangle];
  return (1.0 / 3) * (mesh.points[v[0]] + mesh.points[v[1]] + mesh.points[v[2]]);
}

// Divides until everything falls apart. The points that come are told by origin.
Outcome divide(MeshData& mesh, std::vector<SheetTriangle>& sheets, OpenedSheets& opened)
{
  for (;;)
  {
    const SheetSides sides(mesh, sheets);
    const std::vector<SheetJoint> joints = findJoints(mesh, sheets, sides);
    if (joints.empty())
    {
      return Outcome::done();
    }
    for (const SheetJoint& joint : joints)
    {
      opened.origin.push_back(opened.origin[joint.vertex[0]]);
    }
    if (const SheetJoint* refused = divideJoints(mesh, joints, sides))
    {
      return Outcome::badInput("a sheet cannot be cut open near " + placeOf(mesh.points[refused->vertex[0]]) +
        ": the tetrahedra there are too flat; improve the mesh around the sheet's border");
    }
    sheets = findSheets(mesh);
  }
}

// Gives each tetrahedron and triangle at the sheets the copies of its own side.
class Cut
{
public:
  Cut(MeshData& mesh, const std::vector<SheetTriangle>& sheets, OpenedSheets& opened)
    : mesh_(mesh)
    , sheets_(sheets)
    , opened_(opened)
    , sides_(mesh, sheets)
  {
  }

  void run()
  {
    addCopies();
    const std::vector<std::array<Index, 3>> triangles = renumberBoundary();
    renumberTets();
    mesh_.triangles = triangles;
    coverSheets();
  }

private:
  void addCopies()
  {
    firstCopy_.resize(mesh_.points.size(), None);
    for (const Index v : sides_.points())
    {
      firstCopy_[v] = static_cast<Index>(mesh_.points.size());
      for (int copy = 1; copy < sides_.partsAt(v); ++copy)
      {
        const Vector3 place = mesh_.points[v];
        mesh_.points.push_back(place);
        opened_.origin.push_back(opened_.origin[v]);
      }
    }
  }

  Index copyFor(Index v, Index tet) const
  {
    if (!sides_.isOnSheet(v) || sides_.partsAt(v) == 1)
    {
      return v;
    }
    const int part = sides_.partOf(v, tet);
    return part == 0 ? v : firstCopy_[v] + part - 1;
  }

  // The one tetrahedron on a boundary triangle that has the sheet's point v.
  Index tetBehind(const std::array<Index, 3>& triangle, Index v) const
  {
    const auto tets = sides_.tetsAt(v);
    const auto found = std::find_if(tets.begin(), tets.end(),
      [&](Index t)
      {
        const auto& tet = mesh_.tetrahedra[t];
        return std::all_of(triangle.begin(), triangle.end(),
          [&tet](Index p) { return std::find(tet.begin(), tet.end(), p) != tet.end(); });
      });
    return found == tets.end() ? None : *found;
  }

  std::vector<std::array<Index, 3>> renumberBoundary() const
  {
    std::vector<std::array<Index, 3>> triangles = mesh_.triangles;
    for (auto& triangle : triangles)
    {
      const auto onSheet =
        std::find_if(triangle.begin(), triangle.end(), [this](Index v) { return sides_.isOnSheet(v); });
      const Index tet = onSheet == triangle.end() ? None : tetBehind(triangle, *onSheet);
      for (Index& v : triangle)
      {
        v = tet == None ? v : copyFor(v, tet);
      }
    }
    return triangles;
  }

  void renumberTets()
  {
    for (const Index v : sides_.points())
    {
      for (const Index t : sides_.tetsAt(v))
      {
        auto& tet = mesh_.tetrahedra[t];
        std::replace(tet.begin(), tet.end(), v, copyFor(v, t));
      }
    }
  }

  // After the tetrahedra: a sheet's triangles are the faces of theirs.
  void coverSheets()
  {
    const auto outward = [this](HalfFace h)
    {
      const auto& tet = mesh_.tetrahedra[tetOf(h)];
      const int* corner = FaceCorners[faceOf(h)];
      return std::array<Index, 3>{ tet[corner[0]], tet[corner[2]], tet[corner[1]] };
    };
    for (const SheetTriangle& sheet : sheets_)
    {
      mesh_.triangles[sheet.triangle] = outward(sheet.face[0]);
      mesh_.triangles.push_back(outward(sheet.face[1]));
      mesh_.trianglePatch.push_back(mesh_.trianglePatch[sheet.triangle]);
    }
  }

  MeshData& mesh_;
  const std::vector<SheetTriangle>& sheets_;
  OpenedSheets& opened_;
  SheetSides sides_;
  std::vector<Index> firstCopy_;
};

// The number of each point when points of equal coordinates on these patches are one.
std::vector<Index> mergedNumbers(const MeshData& mesh, const std::vector<char>& isSheet)
{
  std::vector<char> onSheet(mesh.points.size(), 0);
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i)
  {
    for (const Index v : mesh.triangles[i])
    {
      onSheet[v] = onSheet[v] || isSheet[i];
    }
  }
  std::vector<Index> order;
  for (std::size_t v = 0; v < onSheet.size(); ++v)
  {
    if (onSheet[v])
    {
      order.push_back(static_cast<Index>(v));
    }
  }
  const auto& p = mesh.points;
  std::sort(order.begin(), order.end(),
    [&p](Index a, Index b)
    { return std::tie(p[a].x, p[a].y, p[a].z, a) < std::tie(p[b].x, p[b].y, p[b].z, b); });
  std::vector<Index> original(mesh.points.size());
  std::iota(original.begin(), original.end(), 0);
  for (std::size_t i = 1; i < order.size(); ++i)
  {
    if (p[order[i - 1]] == p[order[i]])
    {
      original[order[i]] = original[order[i - 1]];
    }
  }
  std::vector<Index> number(mesh.points.size());
  Index next = 0;
  for (std::size_t v = 0; v < number.size(); ++v)
  {
    const bool isFirst = original[v] == static_cast<Index>(v);
    number[v] = isFirst ? next++ : number[original[v]];
  }
  return number;
}

void renumber(const std::vector<Index>& number, MeshData& mesh)
{
  std::vector<Vector3> points;
  for (std::size_t v = 0; v < number.size(); ++v)
  {
    if (static_cast<std::size_t>(number[v]) == points.size())
    {
      points.push_back(mesh.points[v]);
    }
  }
  mesh.points.swap(points);
  renumberCorners(number, mesh);
}
} // namespace

Outcome openSheets(MeshData& mesh, OpenedSheets& opened)
{
  opened = {};
  std::vector<SheetTriangle> sheets = findSheets(mesh);
  if (sheets.empty())
  {
    return Outcome::done();
  }
  std::set<int> numbers;
  for (const SheetTriangle& sheet : sheets)
  {
    numbers.insert(mesh.trianglePatch[sheet.triangle]);
  }
  opened.patches.assign(numbers.begin(), numbers.end());
  opened.origin.resize(mesh.points.size());
  std::iota(opened.origin.begin(), opened.origin.end(), 0);
  if (Outcome outcome = divide(mesh, sheets, opened); !outcome.ok())
  {
    return outcome;
  }
  Cut(mesh, sheets, opened).run();
  mesh.isOpened = true;
  return Outcome::done();
}

Outcome closeSheets(MeshData& mesh, const std::vector<int>& sheetPatches, std::vector<Index>& newNumber)
{
  std::vector<char> isSheet(mesh.triangles.size(), 0);
  for (std::size_t i = 0; i < isSheet.size(); ++i)
  {
    isSheet[i] = std::binary_search(sheetPatches.begin(), sheetPatches.end(), mesh.trianglePatch[i]);
  }
  newNumber = mergedNumbers(mesh, isSheet);
  renumber(newNumber, mesh);
  mesh.isOpened = false;
  std::map<std::array<Index, 3>, std::size_t> waiting; // triangles without their partner, by their points
  std::vector<char> goes(mesh.triangles.size(), 0);
  for (std::size_t i = 0; i < isSheet.size(); ++i)
  {
    if (isSheet[i])
    {
      auto key = mesh.triangles[i];
      std::sort(key.begin(), key.end());
      const auto [partner, isFirst] = waiting.emplace(key, i);
      if (!isFirst)
      {
        goes[i] = 1;
        waiting.erase(partner);
      }
    }
  }
  if (!waiting.empty())
  {
    const auto triangle = static_cast<Index>(waiting.begin()->second);
    return Outcome::internalFault("the two sides of a sheet do not fit together at " +
      placeOf(centreOf(mesh, triangle)) + "; nothing was written. Leave the sheet out");
  }
  std::size_t kept = 0;
  for (std::size_t i = 0; i < goes.size(); ++i)
  {
    if (!goes[i])
    {
      mesh.triangles[kept] = mesh.triangles[i];
      mesh.trianglePatch[kept++] = mesh.trianglePatch[i];
    }
  }
  mesh.triangles.resize(kept);
  mesh.trianglePatch.resize(kept);
  return Outcome::done();
}
} // namespace ransmesh
