#include "FarField.h"

#include "PatchNaming.h"

#include "Triangles/SurfaceRepair.h"

#include <algorithm>
#include <cmath>

namespace ransmesh
{
namespace
{
Patch patchOf(const SideName& side)
{
  const PatchType guessed = guessType(side.name);
  const PatchType usual = guessed == PatchType::Patch ? PatchType::FarField : guessed;
  return { side.name, side.type.empty() ? usual : patchTypeOf(side.type).value_or(usual) };
}

// Sides of one name become one patch.
int patchOfSide(const Patch& side, std::size_t firstOfBox, PatchTable& patches)
{
  for (std::size_t i = firstOfBox; i < patches.size(); ++i)
  {
    if (patches[i].name == side.name && patches[i].type == side.type)
    {
      return static_cast<int>(i);
    }
  }
  return addPatch(side, patches);
}

// A sphere of radius 1: the faces of an icosahedron in n^2 triangles each.
SurfaceMesh unitSphere(int n)
{
  const double g = (1 + std::sqrt(5.0)) / 2;
  const std::array<Vector3, 12> corners = { { { -1, g, 0 }, { 1, g, 0 }, { -1, -g, 0 }, { 1, -g, 0 },
    { 0, -1, g }, { 0, 1, g }, { 0, -1, -g }, { 0, 1, -g }, { g, 0, -1 }, { g, 0, 1 }, { -g, 0, -1 },
    { -g, 0, 1 } } };
  constexpr int faces[20][3] = { { 0, 11, 5 }, { 0, 5, 1 }, { 0, 1, 7 }, { 0, 7, 10 }, { 0, 10, 11 },
    { 1, 5, 9 }, { 5, 11, 4 }, { 11, 10, 2 }, { 10, 7, 6 }, { 7, 1, 8 }, { 3, 9, 4 }, { 3, 4, 2 },
    { 3, 2, 6 }, { 3, 6, 8 }, { 3, 8, 9 }, { 4, 9, 5 }, { 2, 4, 11 }, { 6, 2, 10 }, { 8, 6, 7 },
    { 9, 8, 1 } };
  SurfaceMesh sphere;
  for (const auto& face : faces)
  {
    const auto first = static_cast<Index>(sphere.points.size());
    // Row i has i + 1 points, from the first corner on.
    const auto at = [first](int i, int j) { return first + static_cast<Index>(i * (i + 1) / 2 + j); };
    for (int i = 0; i <= n; ++i)
    {
      for (int j = 0; j <= i; ++j)
      {
        // In integers times corners, so that faces that share a side agree about its points.
        std::array<std::pair<int, int>, 3> share = { { { face[0], n - i }, { face[1], i - j },
          { face[2], j } } };
        std::sort(share.begin(), share.end());
        Vector3 x;
        for (const auto& [corner, weight] : share)
        {
          x += static_cast<double>(weight) * corners[corner];
        }
        sphere.points.push_back((1 / norm(x)) * x);
        if (i < n)
        {
          sphere.triangles.push_back({ at(i, j), at(i + 1, j), at(i + 1, j + 1) });
        }
        if (i < n && j < i)
        {
          sphere.triangles.push_back({ at(i, j), at(i + 1, j + 1), at(i, j + 1) });
        }
      }
    }
  }
  mergeEqualPoints(sphere);
  return sphere;
}
} // namespace

int addPatch(Patch patch, PatchTable& patches)
{
  const std::string name = patch.name;
  const auto isTaken = [&patches](const std::string& wanted)
  {
    return std::any_of(
      patches.begin(), patches.end(), [&wanted](const Patch& other) { return other.name == wanted; });
  };
  for (int copy = 2; isTaken(patch.name); ++copy)
  {
    patch.name = name + "_" + std::to_string(copy);
  }
  patches.push_back(std::move(patch));
  return static_cast<int>(patches.size()) - 1;
}

Outcome checkSides(const FarFieldOptions& options)
{
  for (int i = 0; i < 6; ++i)
  {
    const auto& side = options.sides[i];
    if (side && options.isSphere)
    {
      return Outcome::badInput(
        "the side " + std::string(SideNames[i]) + " has a name, but the far field is a sphere: take a box");
    }
    if (side && !side->type.empty() && !patchTypeOf(side->type))
    {
      return Outcome::badInput("'" + side->type +
        "' is no type of patch: use wall, symmetry, farfield, inlet, outlet, interface or patch");
    }
  }
  return Outcome::done();
}

FarFieldBox makeFarField(const Extent& bodies, const FarFieldOptions& options,
  const std::vector<DomainPlane>& planes, PatchTable& patches)
{
  FarFieldBox box;
  const double length = bodies.largestLength();
  std::array<double, 6> place{};
  std::array<Patch, 6> side;
  for (int i = 0; i < 6; ++i)
  {
    const double margin = options.margins[i] * length;
    place[i] = i % 2 == 0 ? bodies.low[i / 2] - margin : bodies.high[i / 2] + margin;
    side[i] = { std::string("farfield_") + SideNames[i], PatchType::FarField };
  }
  for (const DomainPlane& plane : planes)
  {
    place[sideOf(plane.plane)] = plane.plane.place;
    side[sideOf(plane.plane)] = plane.patch;
  }
  for (int i = 0; i < 8; ++i)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      box.corners[i][axis] = place[2 * axis + (i >> axis & 1)];
    }
  }
  box.sides = { { { 0, 2, 6, 4 }, { 1, 3, 7, 5 }, { 0, 1, 5, 4 }, { 2, 3, 7, 6 }, { 0, 1, 3, 2 },
    { 4, 5, 7, 6 } } };
  const std::size_t firstOfBox = patches.size();
  for (int i = 0; i < 6; ++i)
  {
    const Patch patch = options.sides[i] ? patchOf(*options.sides[i]) : side[i];
    box.patches[i] = patchOfSide(patch, firstOfBox, patches);
  }
  return box;
}

SurfaceMesh makeSphere(const Extent& bodies, double margin, double edge,
  const std::vector<DomainPlane>& planes, PatchTable& patches)
{
  Vector3 centre = 0.5 * (bodies.low + bodies.high);
  Vector3 half = 0.5 * (bodies.high - bodies.low);
  for (const DomainPlane& plane : planes)
  {
    const int axis = plane.plane.axis;
    centre[axis] = plane.plane.place;
    half[axis] = std::fmax(bodies.high[axis] - centre[axis], centre[axis] - bodies.low[axis]);
  }
  const double radius = norm(half) + margin * bodies.largestLength();
  const double wanted = edge > 0 ? std::fmin(edge, 0.2 * radius) : 0.2 * radius;
  constexpr double longest = 1.2; // edge of a unit sphere's triangle for n = 1, at most
  constexpr double mostDivisions = 100;
  SurfaceMesh sphere =
    unitSphere(static_cast<int>(std::ceil(std::fmin(longest * radius / wanted, mostDivisions))));
  for (Vector3& p : sphere.points)
  {
    p = centre + radius * p;
  }
  sphere.patch.assign(sphere.triangles.size(), addPatch({ "farfield", PatchType::FarField }, patches));
  for (const DomainPlane& plane : planes)
  {
    cutByPlane(sphere, plane.plane, PlaneTolerance * radius);
  }
  return sphere;
}
} // namespace ransmesh
