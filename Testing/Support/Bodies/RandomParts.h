// What random bodies are put together from: dice, solids, and the way from solids to surfaces. Lengths are about 1.
#pragma once

#include "Geometry/Vector3.h"
#include "Triangles/SurfaceMesh.h"

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>

#include <array>
#include <cstdint>
#include <random>
#include <vector>

namespace bodies
{
class Dice
{
public:
  explicit Dice(std::uint32_t seed)
    : random_(seed)
  {
  }
  // The library's distributions differ from one standard library to the next; this does not.
  double between(double low, double high) { return low + (high - low) * (random_() / 4294967296.0); }
  int upTo(int count) { return static_cast<int>(random_() % static_cast<std::uint32_t>(count)); }
  ransmesh::Vector3 direction();

private:
  std::mt19937 random_;
};

struct Frame
{
  ransmesh::Vector3 x = { 1, 0, 0 };
  ransmesh::Vector3 y = { 0, 1, 0 };
  ransmesh::Vector3 z = { 0, 0, 1 };

  ransmesh::Vector3 operator()(const ransmesh::Vector3& p) const { return p.x * x + p.y * y + p.z * z; }
};

Frame randomFrame(Dice& dice);

using SolidKernel = CGAL::Exact_predicates_exact_constructions_kernel;
using Solid = CGAL::Surface_mesh<SolidKernel::Point_3>;

struct Facets
{
  std::vector<ransmesh::Vector3> points;
  std::vector<std::array<std::size_t, 3>> triangles; // turned outward
};

Solid solidOf(const Facets& facets);
// The upright body over a regular polygon in an ellipse with these half axes, from -height to height; its upper end is
// so many times as large as the lower one, and a point if that is 0.
Facets prism(int corners, double a, double b, double height, double taper = 1);
// Rings of points around the axis, and the poles.
Facets ball(double radius, std::size_t rings, std::size_t around);

// Cuts off what lies beyond a random plane, upright on the z axis half of the times; where all lies there, nothing.
void cutByRandomPlane(Dice& dice, Solid& solid);

// The solid's surface, all of it patch 1. The points come in order of coordinates, and the triangles in order of
// points: what CGAL gives comes in an order of its own each time.
ransmesh::SurfaceMesh toSurface(const Solid& solid);
} // namespace bodies
