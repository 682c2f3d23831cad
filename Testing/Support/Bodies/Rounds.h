// Bodies turned around an axis. Lengths are about 1; size is the edge length of the triangles.
#pragma once

#include "Bodies/SurfaceBuilder.h"

namespace bodies
{
// A sphere of radius 0.5: an icosahedron with each edge cut in n.
Body sphere(int n);
Body sphereOfSize(double size);

// Two such spheres in a far field.
Body twoSpheres(double size, double gap);

// The inside of a pipe of radius 0.5 and length 2; its ends are of symmetry.
Body pipe(double size);

// A cone of half angle 20 degrees and length 1 in a far field, with a flat base.
Body cone(double size);
// The inside of a cone of that length, of this half angle in degrees; its base is an outlet, in which columns lean
// by as much.
Body insideOfCone(double size, double halfAngle);

// A ring of n edges around the x axis, closed: the last point is the first. One point, if the radius is 0.
Row ring(double x, double radius, int n);
// As many edges as a ring of this radius has, of this size; at least six.
int ringDivisions(double radius, double size);
// The disc in the plane of this x whose rim is a ring of n.
void addDisc(SurfaceBuilder& builder, double x, double radius, int n, int patch);
} // namespace bodies
