// Domains whose viscous walls run into curved patches. Lengths are about 1; size is the edge length.
#pragma once

#include "Bodies/SurfaceBuilder.h"

namespace bodies
{
// The inside of a pipe of radius 0.5 and length 1.5 between an inlet that bulges out and an outlet that
// bulges in, both parts of spheres of radius 1.6.
Body cappedPipe(double size);

// Half of a dome of radius 0.5 over a wall: its far field is a quarter of a sphere, which meets the plane of
// symmetry in a curved ridge.
Body halfDome(double size);
} // namespace bodies
