// Puts a body together from rows of points, lattices and filled planes.
#pragma once

#include "Bodies/Body.h"

#include <array>
#include <map>
#include <string>
#include <vector>

namespace bodies
{
using ransmesh::Index;
using ransmesh::PatchType;
using ransmesh::Vector3;
using Row = std::vector<Vector3>;

class SurfaceBuilder
{
public:
  SurfaceBuilder();

  // The number of the patch of this name, which is new or has this type.
  int patch(const std::string& name, PatchType type);
  // Points closer than 1e-9 are one point.
  Index point(const Vector3& p);
  // Nothing, if two of the points are one.
  void triangle(const Vector3& a, const Vector3& b, const Vector3& c, int patch);
  // Between two rows, of as many points as they like; one point makes a fan.
  void strip(const Row& a, const Row& b, int patch);
  void grid(const std::vector<Row>& rows, int patch);

  // The triangles of each connected piece are turned alike.
  Body finish(bool farField);

private:
  Body body_;
  std::map<std::array<long, 3>, Index> numbers_;
};

// n + 1 points from a to b.
Row straightRow(const Vector3& a, const Vector3& b, int n);
// How many edges of about this size a line has; at least one.
int divisions(double length, double size);
} // namespace bodies
