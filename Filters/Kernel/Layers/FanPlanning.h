// Where fans stand, and which columns they have.
#pragma once

#include "Layers/Directions.h"
#include "Layers/FaceRing.h"
#include "Layers/Fan.h"

namespace ransmesh
{
struct FanAngles
{
  double normalAngle = 0; // radians: convex edges that turn more separate groups of faces
  double fanAngle = 0;    // radians: largest angle between neighbouring columns
};

// Plans a fan at the point for its wall faces, within the sides' planes. False where one column does, or
// where no directions were found that see their faces. main receives the main column's step. The ring may be rotated.
bool planFan(const Vector3& point, const TetMesh& mesh, FaceRing& ring, const SideProjection& lay,
  const FanAngles& angles, Fan& fan, Vector3& main);
} // namespace ransmesh
