#include "CgalInsertion.h"

#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

namespace ransmesh_benchmarks
{
std::size_t insertByCgal(const std::vector<ransmesh::Vector3>& points)
{
  using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
  std::vector<Kernel::Point_3> converted;
  converted.reserve(points.size());
  for (const ransmesh::Vector3& p : points)
  {
    converted.emplace_back(p.x, p.y, p.z);
  }
  const CGAL::Delaunay_triangulation_3<Kernel> triangulation(converted.begin(), converted.end());
  return triangulation.number_of_finite_cells();
}
} // namespace ransmesh_benchmarks
