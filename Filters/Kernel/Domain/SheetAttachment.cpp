#include "Domain/SheetAttachment.h"

#include "Domain/SheetCutting.h"
#include "Geometry/Distance.h"
#include "Support/Numbers.h"
#include "Triangles/SurfaceEdges.h"
#include "Triangles/SurfaceIntersections.h"
#include "Triangles/SurfaceRepair.h"

#include <CGAL/Bbox_3.h>
#include <CGAL/box_intersection_d.h>

#include <algorithm>
#include <cmath>
#include <unordered_map>

namespace ransmesh
{
namespace
{
// Points, found by their place. Cells are as wide as the tolerance: what is within it of a point lies in its
// own cell or in one next to it.
class PointGrid
{
public:
  PointGrid(const Vector3& low, double tolerance)
    : low_(low)
    , tolerance_(tolerance)
  {
  }

  void add(const Vector3& p, Index number) { cells_[keyOf(cellOf(p))].push_back(number); }

  // The point nearest to p within the tolerance, or None.
  Index nearest(const std::vector<Vector3>& points, const Vector3& p) const
  {
    Index best = None;
    double shortest = tolerance_;
    const Cell centre = cellOf(p);
    for (int step = 0; step < 27; ++step)
    {
      const auto found = cells_.find(
        keyOf({ centre[0] + step % 3 - 1, centre[1] + step / 3 % 3 - 1, centre[2] + step / 9 - 1 }));
      if (found == cells_.end())
      {
        continue;
      }
      for (const Index v : found->second)
      {
        if (const double d = distance(points[v], p); d < shortest || (d == shortest && v < best))
        {
          best = v;
          shortest = d;
        }
      }
    }
    return best;
  }

private:
  using Cell = std::array<std::int64_t, 3>;

  Cell cellOf(const Vector3& p) const
  {
    const auto at = [this, &p](int axis)
    {
      constexpr double farthest = 1e15; // beyond, cells are no longer told apart
      const double cell = std::floor((p[axis] - low_[axis]) / tolerance_);
      return static_cast<std::int64_t>(std::clamp(cell, -farthest, farthest));
    };
    return { at(0), at(1), at(2) };
  }
  static std::uint64_t keyOf(const Cell& cell)
  {
    std::uint64_t key = 0;
    for (const std::int64_t c : cell)
    {
      key = (key ^ static_cast<std::uint64_t>(c)) * 0x9E3779B97F4A7C15u;
      key ^= key >> 29;
    }
    return key;
  }

  Vector3 low_;
  double tolerance_;
  std::unordered_map<std::uint64_t, std::vector<Index>> cells_;
};

class Attachment
{
public:
  Attachment(SurfaceMesh& surface, const PatchTable& patches)
    : surface_(surface)
    , patches_(patches)
    , firstPoint_(surface.points.size())
    , firstTriangle_(surface.triangles.size())
    , extent_(extentOf(surface.points))
    , tolerance_(SheetTolerance * extent_.largestLength())
  {
  }

  SurfaceVerdict run(SurfaceMesh sheets, const std::optional<Extent>& box)
  {
    verdict_.outcome = checkCoordinates(sheets, "sheet");
    if (verdict_.outcome.ok())
    {
      mend(sheets);
      verdict_.outcome = box ? fitIntoBox(sheets, *box) : Outcome::done();
    }
    if (verdict_.outcome.ok())
    {
      weld(sheets);
      findDegenerate() || findCrossings() || findTouchingBorders();
    }
    return std::move(verdict_);
  }

private:
  bool isSheet(Index triangle) const { return static_cast<std::size_t>(triangle) >= firstTriangle_; }
  const std::string& nameOf(Index triangle) const { return patches_[surface_.patch[triangle]].name; }

  void note(std::size_t count, const char* what)
  {
    if (count > 0)
    {
      verdict_.repairs.push_back(std::to_string(count) + " " + what + " of sheets");
    }
  }

  void mend(SurfaceMesh& sheets)
  {
    mergeEqualPoints(sheets);
    note(dropCollapsedTriangles(sheets), "triangles with two equal corners dropped");
    note(swapFlatTriangles(sheets), "flat triangles swapped with a neighbour");
    note(dropRepeatedTriangles(sheets), "duplicate triangles dropped");
    mergeEqualPoints(sheets);
  }

  Outcome fitIntoBox(SurfaceMesh& sheets, const Extent& box)
  {
    const std::string name = sheets.patch.empty() ? "" : patches_[sheets.patch[0]].name;
    note(cutByBox(sheets, box, tolerance_), "triangles cut off at the far-field box");
    mergeEqualPoints(sheets);
    return !sheets.triangles.empty() || name.empty()
      ? Outcome::done()
      : Outcome::badInput("all sheets ('" + name +
          "' and what follows) lie outside the far-field box: check their place, or enlarge FarFieldMargins");
  }

  void weld(const SurfaceMesh& sheets)
  {
    PointGrid grid(extent_.low, tolerance_);
    for (std::size_t v = 0; v < firstPoint_; ++v)
    {
      grid.add(surface_.points[v], static_cast<Index>(v));
    }
    std::vector<Index> number;
    for (const Vector3& p : sheets.points)
    {
      Index v = grid.nearest(surface_.points, p);
      if (v == None)
      {
        v = static_cast<Index>(surface_.points.size());
        surface_.points.push_back(p);
        grid.add(p, v);
      }
      number.push_back(v);
    }
    for (std::size_t t = 0; t < sheets.triangles.size(); ++t)
    {
      const auto& v = sheets.triangles[t];
      surface_.triangles.push_back({ number[v[0]], number[v[1]], number[v[2]] });
      surface_.patch.push_back(sheets.patch[t]);
    }
    note(dropCollapsedTriangles(surface_), "triangles smaller than the tolerance dropped");
    note(dropRepeatedTriangles(surface_), "triangles that lie on a surface dropped");
  }

  bool findDegenerate()
  {
    for (std::size_t t = firstTriangle_; t < surface_.triangles.size(); ++t)
    {
      if (isDegenerate(surface_, static_cast<Index>(t)))
      {
        verdict_.findings.push_back({ SurfaceFault::Degenerate, static_cast<Index>(t), None });
      }
    }
    if (verdict_.findings.empty())
    {
      return false;
    }
    verdict_.outcome = Outcome::badInput("the sheets have " + std::to_string(verdict_.findings.size()) +
      " triangles without area that could not be mended, the first at " +
      ransmesh::placeOf(surface_, verdict_.findings[0].triangle, patches_) +
      "; clean or remesh the sheet there");
    return true;
  }

  void addPair(Index s, Index t)
  {
    verdict_.findings.push_back({ SurfaceFault::Intersection, s, t });
    verdict_.findings.push_back({ SurfaceFault::Intersection, t, s });
  }

  bool findCrossings()
  {
    std::size_t count = 0;
    for (const auto& [s, t] : findIntersections(surface_))
    {
      addPair(s, t); // s < t: only t may be a sheet's alone
      ++count;
    }
    if (count > 0)
    {
      const SurfaceFinding& first = verdict_.findings[1];
      verdict_.outcome = Outcome::badInput("the sheet '" + nameOf(first.triangle) + "' cuts or touches '" +
        nameOf(first.partner) + "' (" + std::to_string(count) + " pairs of triangles, the first at " +
        placeOf(centreOf(surface_, first.triangle)) + "); " + remedy());
    }
    return count > 0;
  }

  static std::string remedy()
  {
    return "where a sheet ends on a surface or on another sheet, their points must coincide, each edge of "
           "its "
           "border an edge of both; else they must keep apart";
  }

  // Points of a sheet's border that lie on a surface, but on none of its points.
  bool findTouchingBorders()
  {
    using Box = CGAL::Box_intersection_d::Box_with_handle_d<double, 3, const Index*>;
    const std::vector<Index> border = looseBorderPoints();
    std::vector<Index> triangles(surface_.triangles.size());
    std::vector<Box> pointBoxes;
    std::vector<Box> triangleBoxes;
    for (const Index& v : border)
    {
      const Vector3& p = surface_.points[v];
      const double d = tolerance_;
      pointBoxes.emplace_back(CGAL::Bbox_3(p.x - d, p.y - d, p.z - d, p.x + d, p.y + d, p.z + d), &v);
    }
    for (std::size_t t = 0; t < triangles.size(); ++t)
    {
      triangles[t] = static_cast<Index>(t);
      CGAL::Bbox_3 box;
      for (const Index v : surface_.triangles[t])
      {
        const Vector3& p = surface_.points[v];
        box += CGAL::Bbox_3(p.x, p.y, p.z, p.x, p.y, p.z);
      }
      triangleBoxes.emplace_back(box, &triangles[t]);
    }
    std::vector<std::pair<Index, Index>> touching;
    CGAL::box_intersection_d(pointBoxes.begin(), pointBoxes.end(), triangleBoxes.begin(), triangleBoxes.end(),
      [&](const Box& point, const Box& triangle)
      {
        if (touches(*point.handle(), *triangle.handle()))
        {
          touching.emplace_back(*point.handle(), *triangle.handle());
        }
      });
    reportTouching(touching);
    return !touching.empty();
  }

  std::vector<Index> looseBorderPoints() const
  {
    std::vector<char> isBorder(surface_.points.size(), 0);
    forEachEdge(sortedEdges(surface_),
      [&](const SurfaceEdge* first, const SurfaceEdge* last)
      {
        if (last - first == 1)
        {
          isBorder[first->a] = isBorder[first->b] = 1;
        }
      });
    std::vector<Index> points;
    for (std::size_t v = firstPoint_; v < isBorder.size(); ++v)
    {
      if (isBorder[v])
      {
        points.push_back(static_cast<Index>(v));
      }
    }
    return points;
  }

  bool touches(Index v, Index triangle) const
  {
    const auto& t = surface_.triangles[triangle];
    const auto& p = surface_.points;
    return t[0] != v && t[1] != v && t[2] != v &&
      distanceToTriangle(p[v], p[t[0]], p[t[1]], p[t[2]]) <= tolerance_;
  }

  void reportTouching(std::vector<std::pair<Index, Index>>& touching)
  {
    if (touching.empty())
    {
      return;
    }
    std::sort(touching.begin(), touching.end());
    for (std::size_t t = firstTriangle_; t < surface_.triangles.size(); ++t)
    {
      for (const auto& [v, other] : touching)
      {
        const auto& own = surface_.triangles[t];
        if (own[0] == v || own[1] == v || own[2] == v)
        {
          addPair(other, static_cast<Index>(t));
          break;
        }
      }
    }
    const SurfaceFinding& first = verdict_.findings[1];
    verdict_.outcome =
      Outcome::badInput("the border of the sheet '" + nameOf(first.triangle) + "' lies on '" +
        nameOf(first.partner) + "' without sharing its points (" + std::to_string(touching.size()) +
        " places, the first at " + placeOf(surface_.points[touching[0].first]) + "); " + remedy());
  }

  SurfaceMesh& surface_;
  const PatchTable& patches_;
  std::size_t firstPoint_;    // of the sheets
  std::size_t firstTriangle_; // of the sheets
  Extent extent_;
  double tolerance_;
  SurfaceVerdict verdict_;
};
} // namespace

SurfaceVerdict attachSheets(
  SurfaceMesh& surface, SurfaceMesh sheets, const PatchTable& patches, const std::optional<Extent>& box)
{
  return Attachment(surface, patches).run(std::move(sheets), box);
}

SurfaceMesh withoutSheets(const SurfaceMesh& surface, const std::vector<char>& isSheet)
{
  SurfaceMesh rest;
  rest.points = surface.points;
  for (std::size_t t = 0; t < surface.triangles.size(); ++t)
  {
    const auto patch = static_cast<std::size_t>(surface.patch[t]);
    if (patch >= isSheet.size() || !isSheet[patch])
    {
      rest.triangles.push_back(surface.triangles[t]);
      rest.patch.push_back(surface.patch[t]);
    }
  }
  mergeEqualPoints(rest);
  return rest;
}
} // namespace ransmesh
