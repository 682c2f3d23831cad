// Curved bodies that meet in curved edges. Lengths are about 1; size is the edge length of the triangles.
#pragma once

#include "Bodies/Body.h"

namespace bodies
{
// The inside of a pipe of radius 0.5 with a branch of radius 0.3, with three open ends.
Body pipeJunction(double size);

// A wing of chord 1 on a round fuselage of radius 0.3, in a far field.
Body wingOnFuselage(double size);

// The room above a floor on which a cylinder of diameter 1 lies, between two symmetry planes: it touches the floor
// in a strip one edge wide, beside which the gap closes to nothing. The floor is a wall or a plane of symmetry.
Body cylinderOnFloor(double size, ransmesh::PatchType floor);
} // namespace bodies
