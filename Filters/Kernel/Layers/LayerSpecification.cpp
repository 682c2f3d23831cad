#include "Layers/LayerSpecification.h"

#include "Support/Numbers.h"

#include <algorithm>
#include <cmath>
#include <string>

namespace ransmesh
{
namespace
{
double spacingOf(const LayerSpecification& s, int level)
{
  const int withoutGrowth = std::max(1, s.constantLayers);
  return s.firstHeight * std::pow(s.growthRate, std::max(0, level - withoutGrowth));
}
} // namespace

Outcome checkSpecification(const LayerSpecification& s, const char* where)
{
  const auto bad = [where](const std::string& text)
  { return Outcome::badInput("layers on " + std::string(where) + ": " + text); };
  if (!(s.firstHeight > 0) || !std::isfinite(s.firstHeight))
  {
    return bad("the first height is " + textOf(s.firstHeight) +
      "; it must be positive: set FirstHeight, in the length unit of the surface");
  }
  if (!(s.growthRate >= 1) || !(s.growthRate <= 10))
  {
    return bad("the growth rate is " + textOf(s.growthRate) +
      "; it must lie between 1 and 10 (1.1 to 1.3 is usual): set GrowthRate");
  }
  if (s.numberOfLayers < 1 || s.numberOfLayers > MaximumNumberOfLayers)
  {
    return bad("the number of layers is " + std::to_string(s.numberOfLayers) +
      "; it must lie between 1 and " + std::to_string(MaximumNumberOfLayers) + ": set NumberOfLayers");
  }
  if (s.constantLayers < 0)
  {
    return bad("the number of constant layers is negative: set ConstantLayers to 0 or more");
  }
  if (!(s.isotropicFraction > 0))
  {
    return bad("the isotropic fraction is " + textOf(s.isotropicFraction) +
      "; it must be positive (0.7 is usual): set IsotropicFraction");
  }
  if (!(s.normalAngle > 0) || !(s.normalAngle <= 180))
  {
    return bad("the normal angle is " + textOf(s.normalAngle) +
      " degrees; it must lie above 0 and not exceed 180 (30 is usual): set NormalAngle");
  }
  if (!(s.fanAngle >= 5) || !(s.fanAngle <= 180))
  {
    return bad("the fan angle is " + textOf(s.fanAngle) +
      " degrees; it must lie between 5 and 180 (30 is usual): set FanAngle");
  }
  return Outcome::done();
}

int layersForThickness(const LayerSpecification& s, double thickness)
{
  double height = 0;
  for (int level = 1; level <= MaximumNumberOfLayers; ++level)
  {
    const double next = height + spacingOf(s, level);
    if (next >= thickness)
    {
      const bool nextIsCloser = next - thickness <= thickness - height;
      return std::max(1, nextIsCloser ? level : level - 1);
    }
    height = next;
  }
  return MaximumNumberOfLayers;
}

LayerHeights::LayerHeights(const LayerSpecification& s)
{
  for (int level = 1; level <= s.numberOfLayers; ++level)
  {
    height_.push_back(height_.back() + spacingOf(s, level));
  }
}

namespace
{
// The quality report takes spacings for a column's that are off by a factor of at most 1.3.
constexpr double LeastSqueezedSpacing = 0.78;
constexpr double LeastGrowth = 0.96;

double squeezeFactor(int levels)
{
  return levels < 2 ? 1 : std::max(LeastGrowth, std::pow(LeastSqueezedSpacing, 1.0 / (levels - 1)));
}
} // namespace

double LayerHeights::squeezedHeight(int levels) const
{
  const double factor = squeezeFactor(levels);
  double share = 1;
  double sum = 0;
  for (int level = 1; level <= levels; ++level, share *= factor)
  {
    sum += share * spacing(level);
  }
  return sum;
}

LayerHeights LayerHeights::squeezed(int levels, double height) const
{
  // Between the heights as they are and the lowest ones: what lies between two growths is between them everywhere.
  const double least = squeezedHeight(levels);
  const double whole = height_[levels];
  const double part = whole > least ? std::clamp((whole - height) / (whole - least), 0.0, 1.0) : 0;
  const double factor = squeezeFactor(levels);
  double share = 1;
  LayerHeights result;
  for (int level = 1; level <= levels; ++level, share *= factor)
  {
    result.height_.push_back(result.height_.back() + (1 - part + part * share) * spacing(level));
  }
  return result;
}

int levelsOfIsotropicSize(const LayerHeights& heights, double fraction, double size)
{
  const auto fits = [&](int level)
  { return heights.spacing(level) <= fraction * (size + IsotropicGrowth * heights.height(level)); };
  int level = 0;
  while (level < heights.count() && fits(level + 1))
  {
    ++level;
  }
  return level;
}
} // namespace ransmesh
