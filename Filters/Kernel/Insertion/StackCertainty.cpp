#include "Insertion/StackCertainty.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace ransmesh
{
namespace
{
// A corner of the wall triangle with the line of points above it.
struct Line
{
  Vector3 base;
  Vector3 rise; // from the base to the top
  // Of the least rise by one level, half its share of the whole: the other half covers rounded heights.
  double step = 0;
};

// False where the points do not stand on a line, or where there is no triangle below.
bool findLines(const TetMesh& mesh, const ColumnSet& set, const BaseFace& face, std::array<Line, 3>& lines)
{
  const auto& r = face.root;
  if (r[0] == r[1] || r[1] == r[2] || r[2] == r[0])
  {
    return false;
  }
  for (int j = 0; j < 3; ++j)
  {
    if (face.column[j] == None)
    {
      lines[j].base = mesh.point(face.vertex[j]);
      continue;
    }
    const Column& c = set.columns[face.column[j]];
    if (c.path != None || c.bend != None)
    {
      return false;
    }
    lines[j].base = c.base;
    if (c.levels > 0)
    {
      lines[j].rise = set.thickness(c) * c.direction;
      lines[j].step = 0.5 * set.heightsOf(c).height(1) / set.thickness(c);
    }
  }
  return true;
}

double largestCoordinate(const Vector3& a)
{
  return std::max({ std::fabs(a.x), std::fabs(a.y), std::fabs(a.z) });
}
} // namespace

bool isSurelyPositive(const TetMesh& mesh, const ColumnSet& set, const BaseFace& face)
{
  std::array<Line, 3> lines;
  if (!findLines(mesh, set, face, lines))
  {
    return false;
  }
  double largest = 0; // of all coordinates
  double length = 0;  // no edge of the stack is longer
  for (int j = 0; j < 3; ++j)
  {
    largest = std::max(largest, largestCoordinate(lines[j].base) + largestCoordinate(lines[j].rise));
    length = std::max(length,
      distance(lines[j].base, lines[(j + 1) % 3].base) + norm(lines[j].rise) + norm(lines[(j + 1) % 3].rise));
  }
  // A point is off its line by at most 4 u of the largest coordinate (u = 2^-53), which changes six volumes by
  // at most four times that and the square of the length: 1e-13 is fifty times more, and covers the rounding
  // here too.
  const double margin = 1e-13 * largest * length * length;
  for (int j = 0; j < 3; ++j)
  {
    const Line& next = lines[(j + 1) % 3];
    const Line& last = lines[(j + 2) % 3];
    const Vector3 a = next.base - lines[j].base;
    const Vector3 b = last.base - lines[j].base;
    const double least = std::min({ dot(cross(a, b), lines[j].rise),
      dot(cross(a + next.rise, b), lines[j].rise), dot(cross(a, b + last.rise), lines[j].rise),
      dot(cross(a + next.rise, b + last.rise), lines[j].rise) });
    if (lines[j].step > 0 && !(lines[j].step * least > margin))
    {
      return false;
    }
  }
  return true;
}
} // namespace ransmesh
