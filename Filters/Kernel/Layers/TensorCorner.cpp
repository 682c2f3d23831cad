#include "Layers/TensorCorner.h"

#include "Layers/Directions.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace ransmesh
{
namespace
{
constexpr double Degree = std::numbers::pi / 180;
constexpr double LeastTurn = leastTensorTurn * Degree;
constexpr double LargestTurn = largestTensorTurn * Degree;
// Faces of one wall differ at most so much from its mean normal: more would change its shape.
constexpr double WallCosine = 0.985; // 10 degrees
// The walls' normals enclose at least so much volume.
constexpr double LeastDeterminant = 0.3;

// The walls between concave edges; none where some edge is convex and sharp, or too acute.
std::vector<FaceGroup> wallsOf(const Vector3& point, const TetMesh& mesh, FaceRing& ring)
{
  bool fits = true;
  std::vector<FaceGroup> walls = splitRing(ring,
    [&](std::size_t i)
    {
      const Turn turn = ring.turnAfter(point, mesh, i);
      fits = fits && turn.angle < (turn.isConvex ? LeastTurn : LargestTurn);
      return turn.angle > LeastTurn;
    });
  return fits ? walls : std::vector<FaceGroup>{};
}

bool isUprightOn(const std::vector<Vector3>& sideNormals, const Vector3& normal)
{
  return std::all_of(sideNormals.begin(), sideNormals.end(),
    [&normal](const Vector3& side)
    { return std::fabs(dot(side, normal)) < std::sin(largestLeanAtSide * Degree); });
}

// Do the columns between three walls stand well on each of them?
bool isUpright(const TensorCorner& corner)
{
  constexpr double rounding = 1e-6;
  for (int w = 0; w < corner.walls; ++w)
  {
    if (dot(normalized(corner.rise[w]), corner.normal[w]) <
      std::cos(largestLeanBetweenThree * Degree) - rounding)
    {
      return false;
    }
  }
  return true;
}

bool isPlane(const FaceRing& ring, const FaceGroup& wall, const Vector3& normal)
{
  const auto faces = wall.of(ring);
  return std::all_of(faces.begin(), faces.end(),
    [&normal](const FaceAtVertex& f) { return dot(f.normal, normal) > WallCosine; });
}
} // namespace

int TensorCorner::wallOf(const Vector3& faceNormal) const
{
  int best = 0;
  for (int w = 1; w < walls; ++w)
  {
    best = dot(faceNormal, normal[w]) > dot(faceNormal, normal[best]) ? w : best;
  }
  return best;
}

bool findTensorCorner(const Vector3& point, const TetMesh& mesh, FaceRing& ring,
  const std::vector<Vector3>& sideNormals, TensorCorner& corner)
{
  const std::vector<FaceGroup> walls = wallsOf(point, mesh, ring);
  const bool fits =
    ring.closed ? (walls.size() == 2 || walls.size() == 3) : (walls.size() == 2 && sideNormals.size() == 1);
  if (!fits)
  {
    return false;
  }
  corner.walls = static_cast<int>(walls.size());
  for (int w = 0; w < corner.walls; ++w)
  {
    corner.normal[w] = weightedNormal(walls[w].of(ring));
    if (!isPlane(ring, walls[w], corner.normal[w]) || !isUprightOn(sideNormals, corner.normal[w]))
    {
      return false;
    }
  }
  // Three planes to stay in: the third is a wall, the side, or the one across the ridge.
  std::array<Vector3, 3> planes = corner.normal;
  if (corner.walls == 2)
  {
    planes[2] = ring.closed ? normalized(cross(planes[0], planes[1])) : sideNormals[0];
  }
  const double determinant = dot(planes[0], cross(planes[1], planes[2]));
  if (std::fabs(determinant) < LeastDeterminant)
  {
    return false;
  }
  for (int w = 0; w < corner.walls; ++w)
  {
    const Vector3 along = cross(planes[(w + 1) % 3], planes[(w + 2) % 3]);
    corner.rise[w] = withoutRounding((1 / determinant) * along);
  }
  return corner.walls == 2 || isUpright(corner);
}
} // namespace ransmesh
