#include "Layers/WayOverWalls.h"

#include <algorithm>
#include <functional>

namespace ransmesh
{
namespace
{
constexpr int MostFaces = 100;

bool hasVertex(const std::array<Index, 3>& face, Index v)
{
  return std::find(face.begin(), face.end(), v) != face.end();
}
} // namespace

void WayOverWalls::beginAt(Index root)
{
  from_ = mesh_.point(root);
  reached_.clear();
  farthest_.clear();
  open_.clear();
  for (const Index face : stars_.facesAt(root))
  {
    open_.emplace_back(0.0, face);
  }
}

bool WayOverWalls::leadsTo(Index face, double within)
{
  const auto isOpenWithin = [&] { return !open_.empty() && open_.front().first <= within; };
  while (!reached_.has(face) && isOpenWithin() && reached_.count() < MostFaces)
  {
    std::pop_heap(open_.begin(), open_.end(), std::greater<>());
    const auto [farthest, next] = open_.back();
    open_.pop_back();
    if (!reached_.has(next))
    {
      reached_.add(next);
      farthest_.push_back(farthest);
      goOn(next, farthest);
    }
  }
  return reached_.has(face) ? farthest_[reached_.add(face)] <= within : isOpenWithin();
}

// Opens the faces beyond the edges.
void WayOverWalls::goOn(Index face, double farthest)
{
  const auto v = mesh_.boundaryVertices(face);
  for (int i = 0; i < 3; ++i)
  {
    const Index a = v[i];
    const Index b = v[(i + 1) % 3];
    const double far = std::max(farthest, distanceTo(a, b));
    for (const Index beyond : stars_.facesAt(a))
    {
      if (!reached_.has(beyond) && hasVertex(mesh_.boundaryVertices(beyond), b))
      {
        open_.emplace_back(far, beyond);
        std::push_heap(open_.begin(), open_.end(), std::greater<>());
      }
    }
  }
}

// Of the edge from where the ways begin.
double WayOverWalls::distanceTo(Index a, Index b) const
{
  const Vector3& start = mesh_.point(a);
  const Vector3 along = mesh_.point(b) - start;
  const double square = dot(along, along);
  const double share = square > 0 ? std::clamp(dot(from_ - start, along) / square, 0.0, 1.0) : 0;
  return distance(from_, start + share * along);
}
} // namespace ransmesh
