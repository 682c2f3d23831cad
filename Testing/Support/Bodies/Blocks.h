// Bodies with plane sides. Lengths are about 1; size is the edge length of the triangles.
#pragma once

#include "Bodies/Body.h"

namespace bodies
{
// A box 1 x 1 x height whose floor is the wall, with symmetry around and a far field above. The floor's points
// are moved up and down so that its triangles lean by about this angle in radians.
Body plate(double size, double height = 0.25, double noise = 0);

// A box 1 x 1 x 0.1 whose four sides are walls; the large faces are walls too, or of symmetry. The angle between
// the sides at the origin is given in degrees.
Body cavity(double size, bool sixWalls, double angle = 90);

// A cube of 1 in a far field.
Body cube(double size);

// A block of 0.5 in the corner of a room of 1: three concave edges at its foot, three convex ones at its head.
Body corner(double size);

// A channel with a step down of a third of its height.
Body step(double size);

// A floor with a groove of 0.2 whose bottom is a strip narrower than an edge, between two concave edges: no point of
// its own lies on it (the paper's figure 6).
Body groove(double size);

// Two crossed fins on a floor, below a far field. Thickness 0.05.
Body fins(double size);

// Two plates of 1 x 1 x 0.2 that face each other, in a far field.
Body twoPlates(double size, double gap);

// A channel 1 x 1 x gap between two walls, with symmetry around.
Body channel(double size, double gap);
} // namespace bodies
