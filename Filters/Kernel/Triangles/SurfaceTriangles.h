// The shape of one triangle of a surface.
#pragma once

#include "Geometry/Angles.h"
#include "Triangles/SurfaceMesh.h"

#include <algorithm>
#include <array>

namespace ransmesh
{
using Corners = std::array<Index, 3>;

// Along (b - a) x (c - a); twice the area long.
inline Vector3 areaVector(const SurfaceMesh& surface, const Corners& t)
{
  const auto& p = surface.points;
  return cross(p[t[1]] - p[t[0]], p[t[2]] - p[t[0]]);
}

// The angle at corner i, 0 to 180 degrees.
inline double angleAt(const SurfaceMesh& surface, const Corners& t, int i)
{
  const Vector3& apex = surface.points[t[i]];
  return degreesBetween(surface.points[t[(i + 1) % 3]] - apex, surface.points[t[(i + 2) % 3]] - apex);
}

// 60 to 180 degrees.
inline double largestAngle(const SurfaceMesh& surface, const Corners& t)
{
  return std::fmax(angleAt(surface, t, 0), std::fmax(angleAt(surface, t, 1), angleAt(surface, t, 2)));
}

// 0 to 60 degrees.
inline double smallestAngle(const SurfaceMesh& surface, const Corners& t)
{
  return std::min({ angleAt(surface, t, 0), angleAt(surface, t, 1), angleAt(surface, t, 2) });
}

// The distance of the corner opposite to the longest side from this side.
inline double smallestHeight(const SurfaceMesh& surface, const Corners& t)
{
  const auto& p = surface.points;
  const double longest =
    std::fmax(distance(p[t[0]], p[t[1]]), std::fmax(distance(p[t[1]], p[t[2]]), distance(p[t[2]], p[t[0]])));
  return longest > 0 ? norm(areaVector(surface, t)) / longest : 0;
}
} // namespace ransmesh
