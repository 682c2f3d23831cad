// The curve that, turned around the x axis, is the body.
#pragma once

#include "NoseCone.h"

#include <vector>

namespace nosecone
{
struct ProfilePoint
{
  double x;
  double r;
  bool onBase; // of the piece that leads here
};

// From the tip to the centre of the base, at about the distance that rows of equilateral triangles have.
std::vector<ProfilePoint> sampleProfile(const Shape& shape);
} // namespace nosecone
