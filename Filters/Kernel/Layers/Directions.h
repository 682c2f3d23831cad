// Directions that see the faces around a point of the wall.
#pragma once

#include "Boundary/SurfaceNormals.h"

#include <span>
#include <vector>

namespace ransmesh
{
// Lays vectors into the planes with the given unit normals.
class SideProjection
{
public:
  explicit SideProjection(const std::vector<Vector3>& normals);
  // Unit length; zero where nothing is left.
  Vector3 operator()(const Vector3& d) const { return normalized(inPlanes(d)); }
  // Of the length that is left.
  Vector3 inPlanes(Vector3 d) const;

private:
  std::vector<Vector3> axes_;
};

// Components that rounding left are set to zero: keeps points in axis-aligned planes exactly.
Vector3 withoutRounding(Vector3 d);

// The smallest scalar product of d with one of the normals: above zero, d sees all faces.
double visibility(const std::vector<Vector3>& normals, const Vector3& d);

// The unit direction with the largest smallest scalar product (the most-visible normal), searched from d on
// within what the projection leaves. A direction that sees all well is taken as it is.
Vector3 mostVisible(const std::vector<Vector3>& normals, const SideProjection& lay, Vector3 d);

std::vector<Vector3> normalsOf(std::span<const FaceAtVertex> faces);

// The step that rises by one above the faces, as nearly as it can above each of them, within what the projection
// leaves. scaledStep of d where that does so already; where no step comes near to one above all; and where the step
// found would see some face markedly worse: at tips.
Vector3 evenStep(std::span<const FaceAtVertex> walls, const SideProjection& lay, const Vector3& d);

// The step along the unit direction d that rises by one above the faces, on their average; at most 8 long.
Vector3 scaledStep(std::span<const FaceAtVertex> walls, const Vector3& d);
} // namespace ransmesh
