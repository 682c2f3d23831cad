#include "Boundary/Classification.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <tuple>

namespace ransmesh
{
std::span<const Index> Ridges::at(Index v) const
{
  const bool known = static_cast<std::size_t>(v) < slot_.size() && slot_[v] != None;
  return known ? std::span<const Index>(ends_[slot_[v]]) : std::span<const Index>();
}

bool Ridges::has(Index a, Index b) const
{
  const auto ends = at(a);
  return std::find(ends.begin(), ends.end(), b) != ends.end();
}

std::vector<Index>& Ridges::endsOf(Index v)
{
  if (slot_.size() <= static_cast<std::size_t>(v))
  {
    slot_.resize(static_cast<std::size_t>(v) + 1, None);
  }
  if (slot_[v] == None)
  {
    slot_[v] = static_cast<Index>(ends_.size());
    ends_.emplace_back();
  }
  return ends_[slot_[v]];
}

void Ridges::add(Index a, Index b)
{
  if (!has(a, b))
  {
    endsOf(a).push_back(b);
    endsOf(b).push_back(a);
  }
}

void Ridges::remove(Index a, Index b)
{
  if (has(a, b))
  {
    std::erase(endsOf(a), b);
    std::erase(endsOf(b), a);
  }
}

namespace
{
struct EdgeUse
{
  Index low;
  Index high;
  Index face;
};

Vector3 unitNormal(const TetMesh& mesh, Index b)
{
  const auto v = mesh.boundaryVertices(b);
  return normalized(cross(mesh.point(v[1]) - mesh.point(v[0]), mesh.point(v[2]) - mesh.point(v[0])));
}

std::vector<EdgeUse> sortedEdges(const TetMesh& mesh)
{
  std::vector<EdgeUse> edges;
  edges.reserve(3 * mesh.boundarySlots());
  for (std::size_t i = 0; i < mesh.boundarySlots(); ++i)
  {
    const auto b = static_cast<Index>(i);
    if (mesh.boundaryFace(b).isAlive())
    {
      const auto v = mesh.boundaryVertices(b);
      for (int j = 0; j < 3; ++j)
      {
        edges.push_back({ std::min(v[j], v[(j + 1) % 3]), std::max(v[j], v[(j + 1) % 3]), b });
      }
    }
  }
  std::sort(edges.begin(), edges.end(),
    [](const EdgeUse& a, const EdgeUse& b)
    { return std::tie(a.low, a.high, a.face) < std::tie(b.low, b.high, b.face); });
  return edges;
}

bool isRidgeEdge(const TetMesh& mesh, const EdgeUse* use, std::size_t count, double cosine)
{
  if (count != 2)
  {
    return true;
  }
  return mesh.boundaryFace(use[0].face).patch != mesh.boundaryFace(use[1].face).patch ||
    dot(unitNormal(mesh, use[0].face), unitNormal(mesh, use[1].face)) < cosine;
}

void findRidges(const TetMesh& mesh, const std::vector<EdgeUse>& edges, double cosine, Ridges& ridges)
{
  for (std::size_t i = 0; i < edges.size();)
  {
    std::size_t end = i + 1;
    while (end < edges.size() && edges[end].low == edges[i].low && edges[end].high == edges[i].high)
    {
      ++end;
    }
    if (isRidgeEdge(mesh, &edges[i], end - i, cosine))
    {
      ridges.add(edges[i].low, edges[i].high);
    }
    i = end;
  }
}

// The boundary faces at each vertex: those of v are face[start[v]] to face[start[v + 1] - 1].
struct FacesAtVertices
{
  std::vector<std::size_t> start;
  std::vector<Index> face;

  explicit FacesAtVertices(const TetMesh& mesh)
    : start(mesh.vertexCount() + 1, 0)
  {
    forEach(mesh, [this](Index v, Index) { ++start[v + 1]; });
    for (std::size_t v = 1; v < start.size(); ++v)
    {
      start[v] += start[v - 1];
    }
    face.resize(start.back());
    std::vector<std::size_t> next(start.begin(), start.end() - 1);
    forEach(mesh, [&](Index v, Index b) { face[next[v]++] = b; });
  }
  std::span<const Index> at(Index v) const { return { face.data() + start[v], face.data() + start[v + 1] }; }

private:
  template <class Visit>
  static void forEach(const TetMesh& mesh, Visit visit)
  {
    for (std::size_t b = 0; b < mesh.boundarySlots(); ++b)
    {
      if (mesh.boundaryFace(static_cast<Index>(b)).isAlive())
      {
        for (const Index v : mesh.boundaryVertices(static_cast<Index>(b)))
        {
          visit(v, static_cast<Index>(b));
        }
      }
    }
  }
};

// Whether the boundary faces at v hang together through their edges at v. Where they do not, surfaces
// only touch in v.
bool isOneFan(const TetMesh& mesh, std::span<const Index> faces, Index v)
{
  // Walk from face to face: from the vertex after v to the face in which it comes before v.
  const auto neighbours = [&](Index b)
  {
    const auto w = mesh.boundaryVertices(b);
    const int i = w[0] == v ? 0 : w[1] == v ? 1 : 2;
    return std::pair(w[(i + 1) % 3], w[(i + 2) % 3]);
  };
  const Index first = neighbours(faces.front()).first;
  Index at = neighbours(faces.front()).second;
  std::size_t walked = 1;
  while (at != first && walked <= faces.size())
  {
    const auto next =
      std::find_if(faces.begin(), faces.end(), [&](Index b) { return neighbours(b).first == at; });
    if (next == faces.end())
    {
      return false;
    }
    at = neighbours(*next).second;
    ++walked;
  }
  return walked == faces.size();
}

VertexKind kindOf(
  const TetMesh& mesh, const Ridges& ridges, std::span<const Index> faces, Index v, double cosine)
{
  if (faces.empty())
  {
    return VertexKind::Volume;
  }
  if (!isOneFan(mesh, faces, v))
  {
    return VertexKind::Corner;
  }
  const auto ends = ridges.at(v);
  if (ends.empty())
  {
    return VertexKind::Surface;
  }
  if (ends.size() != 2)
  {
    return VertexKind::Corner;
  }
  const Vector3 in = normalized(mesh.point(v) - mesh.point(ends[0]));
  const Vector3 out = normalized(mesh.point(ends[1]) - mesh.point(v));
  return dot(in, out) < cosine ? VertexKind::Corner : VertexKind::Ridge;
}

void collectPatches(const TetMesh& mesh, const FacesAtVertices& faces, Classification& result)
{
  result.patchStart.assign(1, 0);
  result.patchStart.reserve(mesh.vertexCount() + 1);
  for (std::size_t v = 0; v < mesh.vertexCount(); ++v)
  {
    const auto begin = static_cast<std::ptrdiff_t>(result.patchStart.back());
    for (const Index b : faces.at(static_cast<Index>(v)))
    {
      result.patchIds.push_back(mesh.boundaryFace(b).patch);
    }
    std::sort(result.patchIds.begin() + begin, result.patchIds.end());
    result.patchIds.erase(
      std::unique(result.patchIds.begin() + begin, result.patchIds.end()), result.patchIds.end());
    result.patchStart.push_back(result.patchIds.size());
  }
}

bool isInterface(const PatchTable& patches, int patch)
{
  return static_cast<std::size_t>(patch) < patches.size() && patches[patch].type == PatchType::Interface;
}
} // namespace

Classification classify(const TetMesh& mesh, const PatchTable& patches, double featureAngle)
{
  const double cosine = std::cos(featureAngle * std::numbers::pi / 180);
  const FacesAtVertices faces(mesh);
  Classification result;
  findRidges(mesh, sortedEdges(mesh), cosine, result.ridges);
  collectPatches(mesh, faces, result);
  result.kind.resize(mesh.vertexCount());
  result.frozen.resize(mesh.vertexCount());
  for (std::size_t i = 0; i < mesh.vertexCount(); ++i)
  {
    const auto v = static_cast<Index>(i);
    result.kind[i] = kindOf(mesh, result.ridges, faces.at(v), v, cosine);
    const auto own = result.patchesAt(v);
    result.frozen[i] = std::any_of(own.begin(), own.end(), [&](int p) { return isInterface(patches, p); });
  }
  return result;
}
} // namespace ransmesh
