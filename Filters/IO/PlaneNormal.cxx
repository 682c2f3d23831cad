#include "PlaneNormal.h"

#include <cmath>

namespace ransmesh
{
namespace
{
using Vector = std::array<double, 3>;

Vector unitNormal(const MeshView& mesh, const Corners& face)
{
  const Vector a = mesh.point(face[0]);
  const Vector b = mesh.point(face[1]);
  const Vector c = mesh.point(face[2]);
  const Vector d = mesh.point(face[face.count - 1]);
  // For a triangle c is d: twice the area. For a quadrilateral: the diagonals' product.
  const bool triangle = face.count == 3;
  Vector u;
  Vector v;
  for (int i = 0; i < 3; ++i)
  {
    u[i] = triangle ? b[i] - a[i] : c[i] - a[i];
    v[i] = triangle ? c[i] - a[i] : d[i] - b[i];
  }
  Vector n = { u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0] };
  const double length = std::hypot(n[0], n[1], n[2]);
  for (double& component : n)
  {
    component /= length;
  }
  return n;
}
} // namespace

std::optional<Vector> planeNormal(const MeshView& mesh, const BoundaryPatch& patch, double tolerance)
{
  Vector mean = { 0, 0, 0 };
  for (vtkIdType f = patch.first; f < patch.first + patch.count(); ++f)
  {
    const Vector n = unitNormal(mesh, mesh.face(f));
    for (int i = 0; i < 3; ++i)
    {
      mean[i] += n[i] / static_cast<double>(patch.count());
    }
  }
  for (vtkIdType f = patch.first; f < patch.first + patch.count(); ++f)
  {
    const Vector n = unitNormal(mesh, mesh.face(f));
    const double off = std::hypot(n[0] - mean[0], n[1] - mean[1], n[2] - mean[2]);
    if (!(off <= tolerance))
    {
      return std::nullopt;
    }
  }
  return mean;
}
} // namespace ransmesh
