#include "Boundary/SurfaceRemeshing.h"

#include "Boundary/SurfaceEdges.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/detect_features.h>
#include <CGAL/Polygon_mesh_processing/orient_polygon_soup.h>
#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/Polygon_mesh_processing/remesh.h>
#include <CGAL/Surface_mesh.h>

#include <array>

namespace ransmesh
{
namespace
{
namespace Processing = CGAL::Polygon_mesh_processing;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using PatchOfFace = Mesh::Property_map<Mesh::Face_index, int>;

bool isManifold(const SurfaceMesh& surface, Vector3& fault)
{
  bool manifold = true;
  forEachEdge(sortedEdges(surface),
    [&](const SurfaceEdge* first, const SurfaceEdge* last)
    {
      if (last - first != 2 && manifold)
      {
        manifold = false;
        fault = surface.points[first->a];
      }
    });
  return manifold;
}

PatchOfFace toCgal(const SurfaceMesh& surface, Mesh& mesh)
{
  std::vector<Kernel::Point_3> points;
  points.reserve(surface.points.size());
  for (const Vector3& p : surface.points)
  {
    points.emplace_back(p.x, p.y, p.z);
  }
  std::vector<std::vector<std::size_t>> triangles;
  triangles.reserve(surface.triangles.size());
  for (const auto& t : surface.triangles)
  {
    triangles.push_back(
      { static_cast<std::size_t>(t[0]), static_cast<std::size_t>(t[1]), static_cast<std::size_t>(t[2]) });
  }
  Processing::orient_polygon_soup(points, triangles);
  Processing::polygon_soup_to_polygon_mesh(points, triangles, mesh);
  PatchOfFace patch = mesh.add_property_map<Mesh::Face_index, int>("f:patch", 0).first;
  std::size_t t = 0; // faces follow the order of the triangles
  for (const auto face : mesh.faces())
  {
    patch[face] = surface.patch[t++];
  }
  return patch;
}

SurfaceMesh fromCgal(const Mesh& mesh, const PatchOfFace& patch)
{
  SurfaceMesh surface;
  for (const auto v : mesh.vertices())
  {
    const Kernel::Point_3& p = mesh.point(v);
    surface.points.push_back({ p.x(), p.y(), p.z() });
  }
  for (const auto face : mesh.faces())
  {
    std::array<Index, 3> corners{};
    auto side = mesh.halfedge(face);
    for (Index& corner : corners)
    {
      corner = static_cast<Index>(std::size_t(mesh.target(side)));
      side = mesh.next(side);
    }
    surface.triangles.push_back(corners);
    surface.patch.push_back(patch[face]);
  }
  return surface;
}
} // namespace

Outcome remeshSurface(SurfaceMesh& surface, double length, double angle)
{
  if (Vector3 fault; !isManifold(surface, fault))
  {
    return Outcome::badInput(
      "the surface cannot be remeshed: more than two triangles meet at an edge near (" +
      std::to_string(fault.x) + ", " + std::to_string(fault.y) + ", " + std::to_string(fault.z) +
      "); separate the parts there, or keep the surface as it is");
  }
  Mesh mesh;
  const PatchOfFace patch = toCgal(surface, mesh);
  const auto feature = mesh.add_property_map<Mesh::Edge_index, bool>("e:feature", false).first;
  Processing::detect_sharp_edges(mesh, angle, feature);
  constexpr unsigned iterations = 5;
  Processing::isotropic_remeshing(mesh.faces(), length, mesh,
    CGAL::parameters::number_of_iterations(iterations)
      .edge_is_constrained_map(feature)
      .face_patch_map(patch)
      .protect_constraints(false)
      .relax_constraints(true));
  mesh.collect_garbage();
  surface = fromCgal(mesh, patch);
  return Outcome::done();
}
} // namespace ransmesh
