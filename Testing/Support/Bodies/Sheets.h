// Bodies with sheets in the fluid. Lengths are about 1; size is the edge length of the triangles.
#pragma once

#include "Bodies/Body.h"

namespace bodies
{
// A wake of 0.5 x 0.5 in the middle of a room of 1 with symmetry around.
Body freeWake(double size);

// A wing of span 1 with a wake from its trailing edge to 1.5 chords behind it, in a far field.
Body wingWithWake(double size);

// A fin without thickness of 0.5 x 0.5 on a floor, below a far field.
Body thinFin(double size);
} // namespace bodies
