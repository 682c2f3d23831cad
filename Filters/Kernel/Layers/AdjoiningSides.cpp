#include "Layers/AdjoiningSides.h"

#include "Boundary/SurfaceNormals.h"
#include "Geometry/Angles.h"

#include <algorithm>

namespace ransmesh
{
namespace
{
// A patch is a side where it rises from the wall at 30 to 150 degrees, and a little more for what is to be just that.
constexpr double SideRise = 0.48;
// In a corner of a side narrower than this (radians) the middle of its faces lies along the wall, however steep it is.
constexpr double NarrowCorner = 60 / DegreesOfRadian;
// Normals of a side's faces that differ by more than this make it curved.
constexpr double PlaneCosine = 0.99985; // 1 degree

// Unit, from the vertex into the face.
Vector3 middleOf(const FaceAtVertex& face, const TetMesh& mesh)
{
  const Vector3& at = mesh.point(face.vertex[0]);
  return normalized(
    normalized(mesh.point(face.vertex[1]) - at) + normalized(mesh.point(face.vertex[2]) - at));
}

double riseOf(const std::vector<FaceAtVertex>& group, const TetMesh& mesh, const Vector3& wallNormal)
{
  Vector3 middle;
  double angle = 0;
  for (const FaceAtVertex& face : group)
  {
    middle += face.angle * middleOf(face, mesh);
    angle += face.angle;
  }
  const Vector3 normal = weightedNormal(group);
  const Vector3 steepest = wallNormal - dot(wallNormal, normal) * normal;
  const bool isNarrow = angle < NarrowCorner && dot(middle, steepest) > 0;
  return isNarrow ? norm(steepest) : dot(normalized(middle), wallNormal);
}

bool shareAnEdge(const FaceAtVertex& a, const FaceAtVertex& b)
{
  return a.vertex[1] == b.vertex[2] || a.vertex[2] == b.vertex[1];
}

// The least rise to the group from one of the wall's faces beside it; 1 where there is none.
double leastRiseBeside(const std::vector<FaceAtVertex>& group, const std::vector<FaceAtVertex>& walls)
{
  double least = 1;
  for (const FaceAtVertex& face : group)
  {
    for (const FaceAtVertex& wall : walls)
    {
      least = shareAnEdge(face, wall) ? std::min(least, norm(cross(face.normal, wall.normal))) : least;
    }
  }
  return least;
}

std::vector<Side> findGroups(
  const TetMesh& mesh, std::vector<FaceAtVertex> others, const std::vector<FaceAtVertex>& walls)
{
  const Vector3 wallNormal = weightedNormal(walls);
  std::stable_sort(others.begin(), others.end(),
    [](const FaceAtVertex& a, const FaceAtVertex& b) { return a.patch < b.patch; });
  std::vector<Side> sides;
  for (auto begin = others.begin(); begin != others.end();)
  {
    const auto end =
      std::find_if(begin, others.end(), [&begin](const FaceAtVertex& f) { return f.patch != begin->patch; });
    for (const auto& group : smoothGroups({ begin, end }))
    {
      const double rise = std::min(riseOf(group, mesh, wallNormal), leastRiseBeside(group, walls));
      sides.push_back({ begin->patch, weightedNormal(group), rise });
    }
    begin = end;
  }
  return sides;
}
} // namespace

bool findSides(const TetMesh& mesh, const std::vector<FaceAtVertex>& others,
  const std::vector<FaceAtVertex>& walls, std::vector<Side>& sides)
{
  std::vector<Side> flat;
  for (const Side& group : findGroups(mesh, others, walls))
  {
    (group.rise > SideRise ? sides : flat).push_back(group);
  }
  return std::none_of(flat.begin(), flat.end(),
    [&sides](const Side& f)
    { return std::any_of(sides.begin(), sides.end(), [&f](const Side& s) { return s.patch == f.patch; }); });
}

bool arePlane(const std::vector<FaceAtVertex>& others, const std::vector<Side>& sides)
{
  return std::all_of(others.begin(), others.end(),
    [&sides](const FaceAtVertex& f)
    {
      return std::any_of(sides.begin(), sides.end(),
        [&f](const Side& side) { return side.patch == f.patch && dot(f.normal, side.normal) > PlaneCosine; });
    });
}

std::vector<Vector3> normalsOf(const std::vector<Side>& sides)
{
  std::vector<Vector3> normals;
  std::transform(
    sides.begin(), sides.end(), std::back_inserter(normals), [](const Side& side) { return side.normal; });
  return normals;
}
} // namespace ransmesh
