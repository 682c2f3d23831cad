// The two exact predicates on which the validity of every mesh rests.
#pragma once

#include "Geometry/Vector3.h"

namespace ransmesh
{
// Exact sign (+1, 0, -1) of the volume of (a, b, c, d): +1 when d lies on the side of the triangle
// (a, b, c) to which its normal (b - a) x (c - a) points. This is VTK's sense of a tetrahedron.
inline int orientation(const Vector3& a, const Vector3& b, const Vector3& c, const Vector3& d);

// Exact: +1 when e lies inside the sphere through the positive tetrahedron (a, b, c, d), 0 on it, -1 outside.
int inSphere(const Vector3& a, const Vector3& b, const Vector3& c, const Vector3& d, const Vector3& e);

namespace detail
{
int exactOrientation(const Vector3& a, const Vector3& b, const Vector3& c, const Vector3& d);
}

// Six times the volume of (a, b, c, d), rounded.
inline double sixVolumes(const Vector3& a, const Vector3& b, const Vector3& c, const Vector3& d)
{
  return dot(cross(b - a, c - a), d - a);
}

inline int orientation(const Vector3& a, const Vector3& b, const Vector3& c, const Vector3& d)
{
  // Shewchuk's static filter (Discrete Comput. Geom. 18, 1997): the sign of the rounded determinant
  // is right when it exceeds the bound below; only the rest needs exact arithmetic.
  const Vector3 u = a - d;
  const Vector3 v = b - d;
  const Vector3 w = c - d;
  const double vxwy = v.x * w.y;
  const double wxvy = w.x * v.y;
  const double wxuy = w.x * u.y;
  const double uxwy = u.x * w.y;
  const double uxvy = u.x * v.y;
  const double vxuy = v.x * u.y;
  const double determinant = u.z * (vxwy - wxvy) + v.z * (wxuy - uxwy) + w.z * (uxvy - vxuy);
  const double permanent = (std::fabs(vxwy) + std::fabs(wxvy)) * std::fabs(u.z) +
    (std::fabs(wxuy) + std::fabs(uxwy)) * std::fabs(v.z) +
    (std::fabs(uxvy) + std::fabs(vxuy)) * std::fabs(w.z);
  constexpr double bound = 7.771561172376103e-16; // (7 + 56 eps) eps, eps = 2^-53
  if (determinant > bound * permanent)
  {
    return -1;
  }
  if (-determinant > bound * permanent)
  {
    return 1;
  }
  return detail::exactOrientation(a, b, c, d);
}

inline bool isPositive(const Vector3& a, const Vector3& b, const Vector3& c, const Vector3& d)
{
  return orientation(a, b, c, d) > 0;
}
} // namespace ransmesh
