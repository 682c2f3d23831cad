#include "Boundary/SurfaceNormals.h"

#include "Boundary/Classification.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace ransmesh
{
namespace
{
// Do the two faces share an edge at their common vertex?
bool areNeighbours(const FaceAtVertex& a, const FaceAtVertex& b)
{
  return a.vertex[1] == b.vertex[2] || a.vertex[2] == b.vertex[1];
}
} // namespace

std::vector<std::vector<FaceAtVertex>> smoothGroups(std::span<const FaceAtVertex> facesOfOnePatch)
{
  const double cosine = std::cos(defaults::featureAngle * std::numbers::pi / 180);
  std::vector<std::vector<FaceAtVertex>> groups;
  std::vector<char> taken(facesOfOnePatch.size(), 0);
  for (std::size_t first = 0; first < taken.size(); ++first)
  {
    if (taken[first])
    {
      continue;
    }
    taken[first] = 1;
    std::vector<FaceAtVertex> group{ facesOfOnePatch[first] };
    for (std::size_t i = 0; i < group.size(); ++i)
    {
      for (std::size_t j = 0; j < taken.size(); ++j)
      {
        const FaceAtVertex& other = facesOfOnePatch[j];
        if (!taken[j] && areNeighbours(group[i], other) && dot(group[i].normal, other.normal) >= cosine)
        {
          taken[j] = 1;
          group.push_back(other);
        }
      }
    }
    groups.push_back(std::move(group));
  }
  return groups;
}

Vector3 weightedNormal(std::span<const FaceAtVertex> faces)
{
  Vector3 n;
  for (const FaceAtVertex& f : faces)
  {
    n += f.angle * f.normal;
  }
  return normalized(n);
}

SurfaceNormals::SurfaceNormals(
  const TetMesh& mesh, const BoundaryStars& stars, const std::vector<char>& wanted)
{
  std::vector<FaceAtVertex> faces;
  for (std::size_t i = 0; i < mesh.vertexCount(); ++i)
  {
    const auto v = static_cast<Index>(i);
    faces.clear();
    for (const Index face : stars.facesAt(v))
    {
      if (wanted[mesh.boundaryFace(face).patch])
      {
        faces.push_back(stars.seenFrom(v, face));
      }
    }
    std::stable_sort(faces.begin(), faces.end(),
      [](const FaceAtVertex& a, const FaceAtVertex& b) { return a.patch < b.patch; });
    for (auto begin = faces.begin(); begin != faces.end();)
    {
      const auto end =
        std::find_if(begin, faces.end(), [&begin](const FaceAtVertex& f) { return f.patch != begin->patch; });
      for (const auto& group : smoothGroups({ begin, end }))
      {
        entries_.push_back({ v, begin->patch, weightedNormal(group) });
      }
      begin = end;
    }
  }
}

Vector3 SurfaceNormals::at(Index v, int patch, const Vector3& like) const
{
  const auto first = std::lower_bound(
    entries_.begin(), entries_.end(), v, [](const Entry& e, Index vertex) { return e.vertex < vertex; });
  Vector3 best;
  double bestCosine = -2;
  for (auto e = first; e != entries_.end() && e->vertex == v; ++e)
  {
    if (e->patch == patch && dot(e->normal, like) > bestCosine)
    {
      best = e->normal;
      bestCosine = dot(best, like);
    }
  }
  return best;
}
} // namespace ransmesh
