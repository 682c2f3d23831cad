#include "Surface/Wrapping.h"

#include "Triangles/SurfaceRepair.h"
#include "Triangles/SurfaceTriangles.h"

#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/AABB_triangle_primitive.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/alpha_wrap_3.h>

#include <cstdio>

namespace ransmesh
{
namespace
{
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Triangles = std::vector<Kernel::Triangle_3>;
using Tree = CGAL::AABB_tree<
  CGAL::AABB_traits<Kernel, CGAL::AABB_triangle_primitive<Kernel, Triangles::const_iterator>>>;

constexpr double OffsetOfAlpha = 1.0 / 30;
constexpr double MostTriangles = 2e7;

Kernel::Point_3 cgalPoint(const Vector3& p)
{
  return { p.x, p.y, p.z };
}

// The patch of the nearest triangle of the given surface.
class PatchSearch
{
public:
  explicit PatchSearch(const SurfaceMesh& surface)
    : surface_(surface)
  {
    for (std::size_t t = 0; t < surface.triangles.size(); ++t)
    {
      const auto& v = surface.triangles[t];
      const Kernel::Triangle_3 triangle(
        cgalPoint(surface.points[v[0]]), cgalPoint(surface.points[v[1]]), cgalPoint(surface.points[v[2]]));
      if (!triangle.is_degenerate())
      {
        triangles_.push_back(triangle);
        patch_.push_back(surface.patch[t]);
      }
    }
    tree_.rebuild(triangles_.begin(), triangles_.end());
  }

  int patchNear(const Vector3& p) const
  {
    return patch_[tree_.closest_point_and_primitive(cgalPoint(p)).second - triangles_.begin()];
  }

private:
  const SurfaceMesh& surface_;
  Triangles triangles_;
  std::vector<int> patch_;
  Tree tree_;
};

Mesh wrap(const SurfaceMesh& surface, double alpha, double offset)
{
  std::vector<Kernel::Point_3> points;
  for (const Vector3& p : surface.points)
  {
    points.push_back(cgalPoint(p));
  }
  std::vector<std::array<std::size_t, 3>> triangles;
  for (std::size_t t = 0; t < surface.triangles.size(); ++t)
  {
    if (!isDegenerate(surface, static_cast<Index>(t)))
    {
      const auto& v = surface.triangles[t];
      triangles.push_back(
        { static_cast<std::size_t>(v[0]), static_cast<std::size_t>(v[1]), static_cast<std::size_t>(v[2]) });
    }
  }
  Mesh mesh;
  CGAL::alpha_wrap_3(points, triangles, alpha, offset, mesh);
  return mesh;
}

SurfaceMesh fromCgal(const Mesh& mesh, const PatchSearch& search)
{
  SurfaceMesh surface;
  std::vector<Index> number(mesh.number_of_vertices() + mesh.number_of_removed_vertices(), None);
  for (const auto v : mesh.vertices())
  {
    number[v] = static_cast<Index>(surface.points.size());
    const auto& p = mesh.point(v);
    surface.points.push_back({ p.x(), p.y(), p.z() });
  }
  for (const auto face : mesh.faces())
  {
    std::array<Index, 3> corners{};
    int i = 0;
    for (const auto v : CGAL::vertices_around_face(mesh.halfedge(face), mesh))
    {
      corners[i++] = number[v];
    }
    surface.triangles.push_back(corners);
    surface.patch.push_back(search.patchNear(centreOf(surface, static_cast<Index>(surface.patch.size()))));
  }
  return surface;
}

// As if the wrap had the area of the extent's box twice: triangles of size alpha there.
Outcome checkOptions(const SurfaceMesh& surface, const WrapOptions& options)
{
  if (!(options.alpha > 0) || !(options.offset >= 0))
  {
    return Outcome::badInput("the wrap's alpha must be above 0, and its offset not negative");
  }
  const Extent extent = extentOf(surface.points);
  const double x = extent.length(0) / options.alpha;
  const double y = extent.length(1) / options.alpha;
  const double z = extent.length(2) / options.alpha;
  if (8 * (x * y + y * z + z * x) > MostTriangles)
  {
    char text[160];
    std::snprintf(text, sizeof text,
      "the wrap's alpha of %g asks for too many triangles on a surface of extent %g; try %.2g", options.alpha,
      extent.largestLength(), proposedAlpha(surface));
    return Outcome::badInput(text);
  }
  return Outcome::done();
}
} // namespace

double proposedAlpha(const SurfaceMesh& surface)
{
  const double exact = extentOf(surface.points).largestLength() / 100;
  char text[32];
  std::snprintf(text, sizeof text, "%.1g", exact); // a round number reads better in a message
  return std::strtod(text, nullptr);
}

Outcome wrapSurface(
  SurfaceMesh& surface, const WrapOptions& options, const Context& context, WrapReport& report)
{
  mergeEqualPoints(surface);
  if (Outcome outcome = checkOptions(surface, options); !outcome.ok())
  {
    return outcome;
  }
  context.report(0.1, "wrapping");
  report.alpha = options.alpha;
  report.offset = options.offset > 0 ? options.offset : OffsetOfAlpha * options.alpha;
  const PatchSearch search(surface);
  surface = fromCgal(wrap(surface, report.alpha, report.offset), search);
  report.triangles = surface.triangles.size();
  if (surface.triangles.empty())
  {
    return Outcome::badInput("the wrap is empty: alpha is larger than the surface");
  }
  return Outcome::done();
}
} // namespace ransmesh
