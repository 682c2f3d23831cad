#include "Geometry/Predicates.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

namespace ransmesh
{
namespace
{
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;

Kernel::Point_3 toCgal(const Vector3& p)
{
  return { p.x, p.y, p.z };
}
} // namespace

int detail::exactOrientation(const Vector3& a, const Vector3& b, const Vector3& c, const Vector3& d)
{
  return static_cast<int>(CGAL::orientation(toCgal(a), toCgal(b), toCgal(c), toCgal(d)));
}

int inSphere(const Vector3& a, const Vector3& b, const Vector3& c, const Vector3& d, const Vector3& e)
{
  return static_cast<int>(
    CGAL::side_of_oriented_sphere(toCgal(a), toCgal(b), toCgal(c), toCgal(d), toCgal(e)));
}
} // namespace ransmesh
