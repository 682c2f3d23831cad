#include "Boundary/Classification.h"

#include <algorithm>
#include <cmath>
#include <numbers>

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
// The boundary faces at one vertex of the boundary after the other, turned so that the vertex comes first.
class Fan
{
public:
  Fan(const TetMesh& mesh, const BoundaryStars& stars)
    : mesh_(mesh)
    , stars_(stars)
  {
  }

  void turnTo(Index v)
  {
    faces_.clear();
    for (const Index b : stars_.facesAt(v))
    {
      const auto w = stars_.verticesFrom(v, b);
      faces_.push_back({ b, w[1], w[2] });
    }
  }

  // The other ends of the edges at the vertex that are ridges, of those with higher numbers than the vertex.
  template <class Visit>
  void forEachRidge(Index v, double cosine, Visit visit) const
  {
    for (const Face& face : faces_)
    {
      if (face.first > v && isRidge(face.first, cosine))
      {
        visit(face.first);
      }
      // Where the surface is not closed around the edge, it may come second only.
      if (face.second > v && !startsAt(face.second))
      {
        visit(face.second);
      }
    }
  }

  // Whether the faces hang together through their edges at the vertex. Where they do not, surfaces only
  // touch there.
  bool isOne() const
  {
    const Index begin = faces_.front().first;
    Index at = faces_.front().second;
    std::size_t walked = 1;
    while (at != begin && walked <= faces_.size())
    {
      const Face* next = startsAt(at);
      if (!next)
      {
        return false;
      }
      at = next->second;
      ++walked;
    }
    return walked == faces_.size();
  }

  void collectPatches(std::vector<int>& patches) const
  {
    int last = 0; // of no face
    for (const Face& face : faces_)
    {
      const int patch = mesh_.boundaryFace(face.number).patch;
      if (patch != last)
      {
        patches.push_back(patch);
        last = patch;
      }
    }
  }

private:
  struct Face
  {
    Index number;
    Index first; // the vertices that follow the one turned to
    Index second;
  };

  const Face* startsAt(Index end) const
  {
    const auto found =
      std::find_if(faces_.begin(), faces_.end(), [end](const Face& f) { return f.first == end; });
    return found == faces_.end() ? nullptr : &*found;
  }

  bool isRidge(Index end, double cosine) const
  {
    const Face* one = nullptr;
    const Face* other = nullptr;
    int count = 0;
    for (const Face& face : faces_)
    {
      if (face.first == end || face.second == end)
      {
        (one ? other : one) = &face;
        ++count;
      }
    }
    return count != 2 || mesh_.boundaryFace(one->number).patch != mesh_.boundaryFace(other->number).patch ||
      dot(stars_.normalOf(one->number), stars_.normalOf(other->number)) < cosine;
  }

  const TetMesh& mesh_;
  const BoundaryStars& stars_;
  std::vector<Face> faces_;
};

// Of a vertex of the boundary whose faces hang together.
VertexKind kindOf(const TetMesh& mesh, const Ridges& ridges, Index v, double cosine)
{
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

bool isInterface(const PatchTable& patches, int patch)
{
  return static_cast<std::size_t>(patch) < patches.size() && patches[patch].type == PatchType::Interface;
}

// Adds the patches of the vertex that the fan is turned to.
void addPatches(const Fan& fan, Classification& result)
{
  const auto begin = static_cast<std::ptrdiff_t>(result.patchIds.size());
  fan.collectPatches(result.patchIds);
  std::sort(result.patchIds.begin() + begin, result.patchIds.end());
  result.patchIds.erase(
    std::unique(result.patchIds.begin() + begin, result.patchIds.end()), result.patchIds.end());
}
} // namespace

Classification classify(const TetMesh& mesh, const PatchTable& patches, double featureAngle)
{
  return classify(mesh, BoundaryStars(mesh), patches, featureAngle);
}

Classification classify(
  const TetMesh& mesh, const BoundaryStars& stars, const PatchTable& patches, double featureAngle)
{
  const double cosine = std::cos(featureAngle * std::numbers::pi / 180);
  const auto vertices = static_cast<Index>(mesh.vertexCount());
  Fan fan(mesh, stars);
  Classification result;
  result.patchStart.assign(mesh.vertexCount() + 1, 0);
  result.kind.assign(mesh.vertexCount(), VertexKind::Volume);
  for (Index v = 0; v < vertices; ++v)
  {
    if (stars.isOnBoundary(v))
    {
      fan.turnTo(v);
      fan.forEachRidge(v, cosine, [&](Index end) { result.ridges.add(v, end); });
      addPatches(fan, result);
      result.kind[v] = fan.isOne() ? VertexKind::Surface : VertexKind::Corner;
    }
    result.patchStart[v + 1] = result.patchIds.size();
  }
  result.frozen.resize(mesh.vertexCount());
  for (Index v = 0; v < vertices; ++v)
  {
    if (result.kind[v] == VertexKind::Surface) // as long as its ridges are not known
    {
      result.kind[v] = kindOf(mesh, result.ridges, v, cosine);
    }
    if (stars.isOnBoundary(v))
    {
      const auto own = result.patchesAt(v);
      result.frozen[v] = std::any_of(own.begin(), own.end(), [&](int p) { return isInterface(patches, p); });
    }
  }
  return result;
}
} // namespace ransmesh
