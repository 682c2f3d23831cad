// Bodies whose layers must become lower: towards symmetry planes, towards themselves, towards other walls and where
// walls end. Lengths are about 1; size is the edge length of the triangles.
#pragma once

#include "Bodies/Body.h"

namespace bodies
{
// A block of 1 with a slot of this width from one side to 0.7 of it, in a far field: the wall is folded on itself.
Body slot(double size, double gap);

// A channel 1 x 1 x gap between a wall and a symmetry plane, open around.
Body wallOverMirror(double size, double gap);

// The room between a symmetry plane and a wall that leans by 15 degrees and meets it in an edge.
Body wedgeOverMirror(double size);

// The floor of a room of 1 x 0.5 x 0.5, of two walls, fore_wall and aft_wall, that meet at half its length.
Body twoFloors(double size);

// The same with a wall, fore_wall, that ends at 0.4 of the length: what follows is a patch without layers.
Body endingFloor(double size);

// Two walls, floor_wall and back_wall, that meet in a room of 1 x 0.5 x 1.
Body floorAndBack(double size);

// A duct of 0.6 x 0.6 and length 1 between an inlet that bulges out and an outlet: concave edges between its four
// walls run into a curved patch.
Body bulgingDuct(double size);
} // namespace bodies
