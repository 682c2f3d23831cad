#include "Insertion/FanFaces.h"

#include <algorithm>

namespace ransmesh
{
namespace
{
// The last step that faces beside the walk may go to; a closed walk ends where it began.
std::size_t lastStep(const Fan& fan)
{
  return fan.closed ? fan.walk.size() : fan.walk.size() - 1;
}
} // namespace

// The front's faces at the root in order, beginning with the one whose corners stand on the anchor.
std::vector<FanFaces::FrontFace> FanFaces::facesAround(const Fan& fan)
{
  const Column& column = set_.columns[fan.column];
  std::vector<FrontFace> found;
  traversal_.ball(column.vertex, ball_);
  forEachFrontFaceAt(mesh_, column, ball_,
    [&found](Index face, const std::array<Index, 3>& v) {
      found.push_back({ face, v[1], v[2] });
    });
  std::vector<FrontFace> ordered;
  auto at = std::find_if(found.begin(), found.end(),
    [&](const FrontFace& f)
    {
      return mesh_.boundaryFace(f.face).patch != FrontOnly && set_.rootOf(f.second) == fan.anchor[0] &&
        set_.rootOf(f.third) == fan.anchor[1];
    });
  while (at != found.end() && ordered.size() < found.size())
  {
    ordered.push_back(*at);
    const Index end = at->third;
    at = std::find_if(found.begin(), found.end(), [end](const FrontFace& f) { return f.second == end; });
  }
  return ordered.size() == found.size() ? ordered : std::vector<FrontFace>{};
}

bool FanFaces::assign(const Fan& fan, std::vector<std::vector<Index>>& lifted)
{
  const std::vector<FrontFace> faces = facesAround(fan);
  std::size_t at = 0;
  for (std::size_t step = 0; step < fan.walk.size();)
  {
    for (int i = 0; i < fan.walk[step].faces; ++i, ++at)
    {
      if (at >= faces.size() || mesh_.boundaryFace(faces[at].face).patch == FrontOnly)
      {
        return false;
      }
      lifted[fan.walk[step].column].push_back(faces[at].face);
    }
    std::size_t last = step + 1;
    while (last < fan.walk.size() && fan.walk[last].faces == 0)
    {
      ++last;
    }
    std::size_t current = step;
    for (; at < faces.size() && mesh_.boundaryFace(faces[at].face).patch == FrontOnly; ++at)
    {
      current = nearestStep(fan, current, std::min(last, lastStep(fan)), faces[at]);
      lifted[fan.walk[current % fan.walk.size()].column].push_back(faces[at].face);
    }
    step = last;
  }
  return at == faces.size() && !faces.empty();
}

// Of the steps from first to last, the one whose column points most like the columns of a neighbour's face, as seen
// along the edge to it: where the edge ends between other walls, the columns at its two ends lean towards each other.
std::size_t FanFaces::nearestStep(
  const Fan& fan, std::size_t first, std::size_t last, const FrontFace& face) const
{
  const Column& column = set_.columns[fan.column];
  const Vector3 along = normalized(baseAt(face.second) - column.base);
  const auto across = [&along](const Vector3& d) { return normalized(d - dot(d, along) * along); };
  const Vector3 middle = across(directionAt(face.second)) + across(directionAt(face.third));
  const auto agreement = [&](std::size_t step)
  { return dot(middle, across(directionOf(fan, fan.walk[step % fan.walk.size()].column))); };
  std::size_t best = first;
  for (std::size_t step = first + 1; step <= last; ++step)
  {
    best = agreement(step) > agreement(best) + 1e-9 ? step : best;
  }
  return best;
}
Vector3 FanFaces::directionOf(const Fan& fan, int number) const
{
  return static_cast<std::size_t>(number) < fan.directions.size() ? fan.directions[number]
                                                                  : set_.columns[fan.column].direction;
}
Vector3 FanFaces::directionAt(Index vertex) const
{
  const Index c = set_.ofVertex[vertex];
  return c == None ? Vector3{} : normalized(set_.columns[c].direction);
}

Vector3 FanFaces::baseAt(Index vertex) const
{
  const Index c = set_.ofVertex[vertex];
  return c == None ? mesh_.point(vertex) : set_.columns[c].base;
}
} // namespace ransmesh
