// Boxes around a surface's triangles, for CGAL's search of those that meet.
#pragma once

#include "Triangles/SurfaceMesh.h"

#include <CGAL/Bbox_3.h>
#include <CGAL/box_intersection_d.h>

#include <array>
#include <vector>

namespace ransmesh
{
// Its handle is the triangle, in the surface's own list.
using TriangleBox = CGAL::Box_intersection_d::Box_with_handle_d<double, 3, const std::array<Index, 3>*>;

// A box a triangle, in their order, larger by the margin on every side.
inline std::vector<TriangleBox> boxesAround(const SurfaceMesh& surface, double margin = 0)
{
  std::vector<TriangleBox> boxes;
  boxes.reserve(surface.triangles.size());
  for (const auto& t : surface.triangles)
  {
    CGAL::Bbox_3 box;
    for (const Index v : t)
    {
      const Vector3& p = surface.points[v];
      box += CGAL::Bbox_3(p.x - margin, p.y - margin, p.z - margin, p.x + margin, p.y + margin, p.z + margin);
    }
    boxes.emplace_back(box, &t);
  }
  return boxes;
}
} // namespace ransmesh
