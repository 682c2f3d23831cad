#include "Layers/FaceRing.h"

#include <algorithm>
#include <cmath>

namespace ransmesh
{
Turn FaceRing::turnAfter(const Vector3& point, const TetMesh& mesh, std::size_t i) const
{
  const FaceAtVertex& here = faces[i];
  const FaceAtVertex& next = faces[(i + 1) % faces.size()];
  const Vector3 across = cross(here.normal, next.normal);
  const double cosine = dot(here.normal, next.normal);
  Turn turn;
  turn.angle = std::atan2(norm(across), cosine);
  // Faces folded onto each other enclose no fluid only if the fluid is all around them.
  const bool folded = cosine < -0.99999;
  turn.isConvex = folded || dot(across, mesh.point(here.vertex[2]) - point) < 0;
  return turn;
}

void FaceRing::beginWith(std::size_t i)
{
  std::rotate(faces.begin(), faces.begin() + static_cast<std::ptrdiff_t>(i), faces.end());
}

bool makeRing(const std::vector<FaceAtVertex>& faces, FaceRing& ring)
{
  if (faces.empty())
  {
    return false;
  }
  const auto findFace = [&faces](auto matches) { return std::find_if(faces.begin(), faces.end(), matches); };
  // Begin with the face that has none before it, if there is one.
  auto at = findFace(
    [&](const FaceAtVertex& f)
    {
      return std::none_of(
        faces.begin(), faces.end(), [&f](const FaceAtVertex& g) { return g.vertex[2] == f.vertex[1]; });
    });
  ring.closed = at == faces.end();
  at = ring.closed ? faces.begin() : at;
  ring.faces.clear();
  while (at != faces.end() && ring.faces.size() < faces.size())
  {
    ring.faces.push_back(*at);
    const Index end = at->vertex[2];
    at = findFace([end](const FaceAtVertex& g) { return g.vertex[1] == end; });
  }
  const bool complete = ring.faces.size() == faces.size();
  return complete && (!ring.closed || ring.faces.back().vertex[2] == ring.faces.front().vertex[1]);
}
} // namespace ransmesh
