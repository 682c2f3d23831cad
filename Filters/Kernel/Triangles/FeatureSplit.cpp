#include "Triangles/FeatureSplit.h"

#include "Triangles/SurfaceEdges.h"

#include <numbers>

namespace ransmesh
{
namespace
{
Vector3 normalOf(const SurfaceMesh& surface, Index triangle)
{
  const auto& v = surface.triangles[triangle];
  const auto& p = surface.points;
  return normalized(cross(p[v[1]] - p[v[0]], p[v[2]] - p[v[0]]));
}

// The triangles that continue each other smoothly, of one patch.
std::vector<std::vector<Index>> smoothNeighbours(const SurfaceMesh& surface, int patch, double angle)
{
  const double smallest = std::cos(angle * std::numbers::pi / 180);
  std::vector<std::vector<Index>> neighbours(surface.triangles.size());
  forEachEdge(sortedEdges(surface),
    [&](const SurfaceEdge* first, const SurfaceEdge* last)
    {
      if (last - first != 2)
      {
        return;
      }
      const Index s = first[0].triangle;
      const Index t = first[1].triangle;
      const double turn = first[0].forward == first[1].forward ? -1 : 1;
      if (surface.patch[s] == patch && surface.patch[t] == patch &&
        turn * dot(normalOf(surface, s), normalOf(surface, t)) >= smallest)
      {
        neighbours[s].push_back(t);
        neighbours[t].push_back(s);
      }
    });
  return neighbours;
}
} // namespace

void splitByAngle(SurfaceMesh& surface, PatchTable& patches, int patch, double angle)
{
  const auto neighbours = smoothNeighbours(surface, patch, angle);
  std::vector<char> seen(surface.triangles.size(), 0);
  const Patch whole = patches[patch];
  int parts = 0;
  for (std::size_t seed = 0; seed < seen.size(); ++seed)
  {
    if (seen[seed] || surface.patch[seed] != patch)
    {
      continue;
    }
    std::vector<Index> part = { static_cast<Index>(seed) };
    seen[seed] = 1;
    for (std::size_t i = 0; i < part.size(); ++i)
    {
      for (const Index t : neighbours[part[i]])
      {
        if (!seen[t])
        {
          seen[t] = 1;
          part.push_back(t);
        }
      }
    }
    if (++parts == 1)
    {
      continue;
    }
    const auto number = static_cast<int>(patches.size());
    patches.push_back({ whole.name + "_" + std::to_string(parts), whole.type });
    for (const Index t : part)
    {
      surface.patch[t] = number;
    }
  }
  if (parts > 1)
  {
    patches[patch].name = whole.name + "_1";
  }
}
} // namespace ransmesh
