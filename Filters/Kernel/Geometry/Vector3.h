// Points and vectors in space.
#pragma once

#include <cmath>

namespace ransmesh
{
struct Vector3
{
  double x = 0;
  double y = 0;
  double z = 0;

  double& operator[](int i) { return i == 0 ? x : i == 1 ? y : z; }
  double operator[](int i) const { return i == 0 ? x : i == 1 ? y : z; }
  bool operator==(const Vector3&) const = default;

  Vector3& operator+=(const Vector3& b)
  {
    x += b.x;
    y += b.y;
    z += b.z;
    return *this;
  }
};

inline Vector3 operator+(const Vector3& a, const Vector3& b)
{
  return { a.x + b.x, a.y + b.y, a.z + b.z };
}
inline Vector3 operator-(const Vector3& a, const Vector3& b)
{
  return { a.x - b.x, a.y - b.y, a.z - b.z };
}
inline Vector3 operator*(double s, const Vector3& a)
{
  return { s * a.x, s * a.y, s * a.z };
}
inline double dot(const Vector3& a, const Vector3& b)
{
  return a.x * b.x + a.y * b.y + a.z * b.z;
}
inline Vector3 cross(const Vector3& a, const Vector3& b)
{
  return { a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x };
}
inline double norm(const Vector3& a)
{
  return std::sqrt(dot(a, a));
}
inline double distance(const Vector3& a, const Vector3& b)
{
  return norm(a - b);
}
// The unit vector along a; zero stays zero.
inline Vector3 normalized(const Vector3& a)
{
  const double length = norm(a);
  return length > 0 ? (1 / length) * a : a;
}
inline bool isFinite(const Vector3& a)
{
  return std::isfinite(a.x) && std::isfinite(a.y) && std::isfinite(a.z);
}
} // namespace ransmesh
