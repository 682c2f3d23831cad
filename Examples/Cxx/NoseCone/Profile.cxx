#include "Profile.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

namespace nosecone
{
namespace
{
constexpr double degree = std::numbers::pi / 180;

// The pieces of the profile: nose, cone, shoulder, base; a distance along it gives a point.
struct Profile
{
  double nose, cone, shoulder, base; // lengths of the pieces
  double coneX, coneR;               // where the cone starts
  double shoulderX, shoulderR;       // the centre of the shoulder's arc
  double angle;                      // of the cone, radians
  Shape shape;

  ProfilePoint at(double s) const
  {
    if (s <= nose)
    {
      const double turned = s / shape.noseRadius;
      return { shape.noseRadius * (1 - std::cos(turned)), shape.noseRadius * std::sin(turned), false };
    }
    s -= nose;
    if (s <= cone)
    {
      return { coneX + s * std::cos(angle), coneR + s * std::sin(angle), false };
    }
    s -= cone;
    if (s < shoulder)
    {
      const double normal = std::numbers::pi / 2 + angle - s / shape.shoulderRadius;
      return { shoulderX + shape.shoulderRadius * std::cos(normal),
        shoulderR + shape.shoulderRadius * std::sin(normal), false };
    }
    s -= shoulder;
    return { shape.length, base - s, true };
  }
};

Profile profileOf(const Shape& shape)
{
  Profile p{};
  p.shape = shape;
  p.angle = shape.halfAngle * degree;
  p.nose = shape.noseRadius * (std::numbers::pi / 2 - p.angle);
  p.coneX = shape.noseRadius * (1 - std::sin(p.angle));
  p.coneR = shape.noseRadius * std::cos(p.angle);
  p.shoulderX = shape.length - shape.shoulderRadius;
  const double coneEndX = p.shoulderX - shape.shoulderRadius * std::sin(p.angle);
  p.cone = (coneEndX - p.coneX) / std::cos(p.angle);
  const double coneEndR = p.coneR + p.cone * std::sin(p.angle);
  p.shoulderR = coneEndR - shape.shoulderRadius * std::cos(p.angle);
  p.shoulder = shape.shoulderRadius * (std::numbers::pi / 2 + p.angle);
  p.base = p.shoulderR;
  const bool possible = shape.noseRadius > 0 && shape.edgeLength > 0 && shape.shoulderRadius >= 0 &&
    p.angle >= 0 && p.angle < std::numbers::pi / 2 && p.cone > 0 && p.base > 0;
  if (!possible)
  {
    throw std::invalid_argument("no nose-cone has these sizes: length, radii and edges must be above 0 and "
                                "nose and shoulder must fit into the length");
  }
  return p;
}

// The points after `from` up to `to`, in equal steps.
void sample(const Profile& profile, double from, double to, double step, std::vector<ProfilePoint>& points)
{
  const int count = std::max(1, static_cast<int>(std::lround((to - from) / step)));
  for (int i = 1; i <= count; ++i)
  {
    points.push_back(profile.at(from + (to - from) * i / count));
  }
}
} // namespace

std::vector<ProfilePoint> sampleProfile(const Shape& shape)
{
  const Profile profile = profileOf(shape);
  const double step = shape.edgeLength * std::sqrt(3.0) / 2;
  const double toBase = profile.nose + profile.cone + profile.shoulder;
  std::vector<ProfilePoint> points = { { 0, 0, false } };
  sample(profile, 0, toBase, step, points); // so that where the base begins there is a row
  points.back().onBase = false;
  sample(profile, toBase, toBase + profile.base, step, points);
  points.back().r = 0;
  return points;
}
} // namespace nosecone
