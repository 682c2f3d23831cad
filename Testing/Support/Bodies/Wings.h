// Wings of the section NACA 0012 and chord 1, with the span along y. size is the edge length along the span; along
// the chord and at the tips triangles are smaller.
#pragma once

#include "Bodies/SurfaceBuilder.h"

#include <functional>

namespace bodies
{
enum class TrailingEdge
{
  Sharp,
  Blunt // cut off at 0.97 chord
};
enum class Tip
{
  Flat,
  Round
};

// A wing of span 1 in a far field, with two tips.
Body wing(double size, TrailingEdge edge, Tip tip);

// Half of a wing, of half span 1, on the symmetry plane y = 0 of a box of 9 x 5 x 8.
Body halfWing(double size, TrailingEdge edge, Tip tip);

// The section as a loop in x and z, from the trailing edge along the upper side, the nose, the lower side.
std::vector<Vector3> sectionOf(double size, TrailingEdge edge);

// The wing's side from the root, whose y each of the section's points has, to the tip at y = end.
void addWing(SurfaceBuilder& builder, const std::vector<Vector3>& section, const std::vector<double>& root,
  double end, double size, int patch);
void addTip(SurfaceBuilder& builder, const std::vector<Vector3>& section, double end, Tip tip, double outward,
  int patch);
} // namespace bodies
