#include "Surface/Repair.h"

#include "Surface/Folds.h"
#include "Surface/HoleFilling.h"
#include "Surface/ShortEdges.h"
#include "Surface/Stitching.h"
#include "Triangles/SurfaceCheck.h"
#include "Triangles/SurfaceRepair.h"

#include <cstdio>

namespace ransmesh
{
namespace
{
constexpr double AutomaticWeld = 1e-6; // of the largest extent
constexpr double AutomaticEdge = 1e-9;
constexpr double LargestFold = 0.05;

std::string counted(std::size_t n, const char* one, const char* many)
{
  return std::to_string(n) + " " + (n == 1 ? one : many);
}

std::string numberText(double x)
{
  char text[32];
  std::snprintf(text, sizeof text, "%.3g", x);
  return text;
}

class RepairShop
{
public:
  RepairShop(SurfaceMesh& surface, PatchTable& patches, const RepairOptions& options)
    : surface_(surface)
    , patches_(patches)
    , options_(options)
  {
  }

  std::vector<Repair> run()
  {
    mergeEqualPoints(surface_);
    size_ = extentOf(surface_.points).largestLength();
    weld();
    note(dropCollapsedTriangles(surface_), "triangle", "triangles", "with two equal corners dropped");
    note(swapFlatTriangles(surface_), "flat triangle", "flat triangles",
      "(three corners on a line) swapped with a neighbour");
    duplicates();
    mergeEqualPoints(surface_); // drops the points that are not used any more
    collapse();
    turn();
    fill();
    return std::move(repairs_);
  }

private:
  void add(std::size_t count, const std::string& text, const Vector3& where)
  {
    if (count > 0)
    {
      repairs_.push_back({ text, count, where });
    }
  }

  void note(std::size_t count, const char* one, const char* many, const char* what)
  {
    add(count, counted(count, one, many) + " " + what, {});
  }

  void weld()
  {
    const double tolerance = options_.weldTolerance < 0 ? AutomaticWeld * size_ : options_.weldTolerance;
    const GapReport report = closeGaps(surface_, tolerance);
    add(report.weld.points,
      counted(report.weld.points, "point", "points") + " of open edges welded to others, moved by at most " +
        numberText(report.weld.farthest) + ", the first at " + placeOf(report.weld.where),
      report.weld.where);
    add(report.stitch.points,
      counted(report.stitch.points, "point", "points") +
        " of a rim put into open edges of the other, which moved by at most " +
        numberText(report.stitch.farthest) + ", the first at " + placeOf(report.stitch.where),
      report.stitch.where);
  }

  void duplicates()
  {
    const DuplicateReport report = dropDuplicates(surface_, LargestFold * size_);
    const std::string place = ", the first at " + placeOf(report.where);
    add(report.dropped,
      counted(report.dropped, "duplicate triangle", "duplicate triangles") + " dropped" + place,
      report.where);
    add(report.folded,
      counted(report.folded, "triangle", "triangles") +
        " of folds without thickness (back to back in pairs) dropped" + place,
      report.where);
  }

  void collapse()
  {
    const double shortest = options_.shortestEdge < 0 ? AutomaticEdge * size_ : options_.shortestEdge;
    const CollapseReport report = collapseShortEdges(surface_, shortest);
    add(report.edges,
      counted(report.edges, "edge", "edges") + " shorter than " + numberText(shortest) +
        " collapsed, the first at " + placeOf(report.where),
      report.where);
  }

  void turn()
  {
    const std::vector<char> isTurned = turnedTriangles(surface_);
    std::size_t count = 0;
    Vector3 where;
    for (std::size_t t = 0; t < isTurned.size(); ++t)
    {
      if (isTurned[t])
      {
        where = count++ == 0 ? centreOf(surface_, static_cast<Index>(t)) : where;
        std::swap(surface_.triangles[t][1], surface_.triangles[t][2]);
      }
    }
    add(count,
      counted(count, "triangle that ran", "triangles that ran") +
        " against the neighbours' orientation turned, the first at " + placeOf(where),
      where);
  }

  void fill()
  {
    if (options_.largestHole <= 0)
    {
      return;
    }
    const std::size_t before = patches_.size();
    const FillReport report = fillHoles(surface_, patches_, options_.largestHole, options_.closedBy);
    const std::string names = report.newPatches == 0 ? ""
      : report.newPatches == 1
      ? ", patch '" + patches_[before].name + "'"
      : ", patches '" + patches_[before].name + "' to '" + patches_.back().name + "'";
    add(report.holes,
      counted(report.holes, "hole", "holes") + " filled by " +
        counted(report.triangles, "triangle", "triangles") + names + ", the first at " +
        placeOf(report.where),
      report.where);
  }

  SurfaceMesh& surface_;
  PatchTable& patches_;
  const RepairOptions& options_;
  double size_ = 0;
  std::vector<Repair> repairs_;
};
} // namespace

std::vector<Repair> repairSurface(SurfaceMesh& surface, PatchTable& patches, const RepairOptions& options)
{
  return RepairShop(surface, patches, options).run();
}
} // namespace ransmesh
