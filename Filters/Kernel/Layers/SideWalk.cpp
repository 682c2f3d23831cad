#include "Layers/SideWalk.h"

#include "Boundary/Classification.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace ransmesh
{
namespace
{
// A column that bends away from its first direction by more than this has no straight neighbours to
// match (cosine of 45 degrees).
constexpr double LargestBend = 0.7;
// Parts of the way that are shorter than this share of the edge they end on have no direction.
constexpr double Shortest = 1e-10;
constexpr int MostSteps = 10000;

double featureCosine()
{
  return std::cos(defaults::featureAngle * std::numbers::pi / 180);
}

bool isSideOf(const SideStart& start, int patch)
{
  return patch != 0 && (start.sides[0] == patch || start.sides[1] == patch);
}

// Lengthens the way by a node; gives the reason if it ends there.
std::optional<WalkEnd> lengthen(
  const SideStart& start, const SidePath::Node& node, double reach, SideWay& way)
{
  const Vector3 step = node.point - way.path.nodes.back().point;
  const double length = norm(step);
  const double along = dot(step, start.direction) / norm(start.direction);
  if (along < LargestBend * length || node.height <= way.path.top())
  {
    return WalkEnd::Bent;
  }
  way.path.nodes.push_back(node);
  return node.height >= reach ? std::optional(WalkEnd::Reached) : std::nullopt;
}
} // namespace

SideWay SideWalk::follow(const SideStart& start, double reach) const
{
  return start.sides[1] != 0 ? followRidge(start, reach) : followSurface(start, reach);
}

SideWay SideWalk::followSurface(const SideStart& start, double reach) const
{
  SideWay way;
  CutPlane plane;
  std::optional<Crossing> crossing = firstCrossing(start, plane);
  if (!crossing)
  {
    return way;
  }
  way.path.up = start.up;
  way.path.nodes.push_back(nodeAt(start, start.vertex, { normalOf(crossing->face), {} }));
  for (int steps = 0; steps < MostSteps; ++steps)
  {
    const double edge = distance(mesh_.point(crossing->right), mesh_.point(crossing->left));
    const SidePath::Node node = nodeAt(start, plane, *crossing);
    if (distance(node.point, way.path.nodes.back().point) > Shortest * edge)
    {
      if (const auto end = lengthen(start, node, reach, way))
      {
        way.end = *end;
        return way;
      }
    }
    const Index next = faceBeyond(*crossing);
    const int patch = mesh_.boundaryFace(crossing->face).patch;
    const bool goesOn = next != None && dot(normalOf(next), normalOf(crossing->face)) >= featureCosine();
    if (!goesOn || mesh_.boundaryFace(next).patch != patch)
    {
      way.end = goesOn ? WalkEnd::Continued : WalkEnd::Border;
      return way;
    }
    const auto corners = mesh_.boundaryVertices(next);
    const Index apex = *std::find_if(corners.begin(), corners.end(),
      [&crossing](Index v) { return v != crossing->right && v != crossing->left; });
    const bool toTheLeft = plane.isLeft(mesh_.point(apex));
    crossing = toTheLeft ? Crossing{ next, crossing->right, apex } : Crossing{ next, apex, crossing->left };
  }
  return way;
}

// The triangle at the foot that the direction points into.
std::optional<SideWalk::Crossing> SideWalk::firstCrossing(const SideStart& start, CutPlane& plane) const
{
  for (const Index face : stars_.facesAt(start.vertex))
  {
    const FaceAtVertex seen = stars_.seenFrom(start.vertex, face);
    if (!isSideOf(start, seen.patch))
    {
      continue;
    }
    const Vector3 normal = normals_.at(start.vertex, seen.patch, seen.normal);
    plane = { mesh_.point(start.vertex), normalized(cross(normal, start.direction)) };
    if (plane.isLeft(mesh_.point(seen.vertex[1])) || !plane.isLeft(mesh_.point(seen.vertex[2])))
    {
      continue;
    }
    const Crossing crossing{ face, seen.vertex[1], seen.vertex[2] };
    if (dot(nodeAt(start, plane, crossing).point - plane.origin, start.direction) > 0)
    {
      return crossing;
    }
  }
  return std::nullopt;
}

SidePath::Node SideWalk::nodeAt(const SideStart& start, const CutPlane& plane, const Crossing& crossing) const
{
  const Vector3& right = mesh_.point(crossing.right);
  const Vector3& left = mesh_.point(crossing.left);
  const double before = -plane.distance(right);
  const double after = plane.distance(left);
  const double part = before + after > 0 ? before / (before + after) : 1;
  const int patch = mesh_.boundaryFace(crossing.face).patch;
  const Vector3 like = normalOf(crossing.face);
  const Vector3 low = normals_.at(crossing.right, patch, like);
  const Vector3 high = normals_.at(crossing.left, patch, like);
  SidePath::Node node;
  node.point = right + part * (left - right);
  node.height = dot(node.point - plane.origin, start.up);
  node.normal[0] = normalized(low + part * (high - low));
  return node;
}

SidePath::Node SideWalk::nodeAt(const SideStart& start, Index v, const std::array<Vector3, 2>& like) const
{
  SidePath::Node node;
  node.point = mesh_.point(v);
  node.height = dot(node.point - mesh_.point(start.vertex), start.up);
  for (int side = 0; side < 2 && start.sides[side] != 0; ++side)
  {
    node.normal[side] = normals_.at(v, start.sides[side], like[side]);
  }
  return node;
}

SideWay SideWalk::followRidge(const SideStart& start, double reach) const
{
  SideWay way;
  way.path.up = start.up;
  Index from = None;
  Index at = start.vertex;
  Vector3 along = start.direction;
  for (int steps = 0; steps < MostSteps; ++steps)
  {
    const Index next = ridgeEdgeAt(start, at, from, along);
    if (next == None)
    {
      way.end = from == None ? WalkEnd::NoWay : WalkEnd::Border;
      return way;
    }
    std::array<Vector3, 2> like;
    ridgeNormals(start, at, next, like);
    if (from == None)
    {
      way.path.nodes.push_back(nodeAt(start, at, like));
    }
    if (const auto end = lengthen(start, nodeAt(start, next, like), reach, way))
    {
      way.end = *end;
      return way;
    }
    along = mesh_.point(next) - mesh_.point(at);
    from = at;
    at = next;
  }
  return way;
}

// The other end of the ridge's edge at v that goes on best along a direction, or None.
Index SideWalk::ridgeEdgeAt(const SideStart& start, Index v, Index from, const Vector3& along) const
{
  Index best = None;
  double bestCosine = 0;
  std::array<Vector3, 2> unused;
  for (const Index face : stars_.facesAt(v))
  {
    for (const Index w : mesh_.boundaryVertices(face))
    {
      const double cosine = dot(normalized(mesh_.point(w) - mesh_.point(v)), normalized(along));
      if (w != v && w != from && cosine > bestCosine && ridgeNormals(start, v, w, unused))
      {
        best = w;
        bestCosine = cosine;
      }
    }
  }
  return best;
}

// Does the edge lie between the two sides? Gives the normals of its faces, in the order of the sides.
bool SideWalk::ridgeNormals(const SideStart& start, Index v, Index w, std::array<Vector3, 2>& normals) const
{
  std::array<int, 2> patch{ 0, 0 };
  int count = 0;
  for (const Index face : stars_.facesAt(v))
  {
    const auto corners = mesh_.boundaryVertices(face);
    if (std::find(corners.begin(), corners.end(), w) == corners.end())
    {
      continue;
    }
    if (count == 2)
    {
      return false;
    }
    patch[count] = mesh_.boundaryFace(face).patch;
    normals[count++] = normalOf(face);
  }
  if (count == 2 && patch[0] != start.sides[0])
  {
    std::swap(patch[0], patch[1]);
    std::swap(normals[0], normals[1]);
  }
  const bool isSharp = patch[0] != patch[1] || dot(normals[0], normals[1]) < featureCosine();
  return count == 2 && patch == start.sides && isSharp;
}

// The other face of the patch's surface at the crossed edge, or None.
Index SideWalk::faceBeyond(const Crossing& crossing) const
{
  Index beyond = None;
  for (const Index face : stars_.facesAt(crossing.right))
  {
    const auto corners = mesh_.boundaryVertices(face);
    const bool hasEdge = std::find(corners.begin(), corners.end(), crossing.left) != corners.end();
    if (face == crossing.face || !hasEdge)
    {
      continue;
    }
    if (beyond != None)
    {
      return None; // surfaces touch here
    }
    beyond = face;
  }
  return beyond;
}

Vector3 SideWalk::normalOf(Index face) const
{
  const auto v = mesh_.boundaryVertices(face);
  return normalized(cross(mesh_.point(v[1]) - mesh_.point(v[0]), mesh_.point(v[2]) - mesh_.point(v[0])));
}
} // namespace ransmesh
