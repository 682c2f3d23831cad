// What the layers on a wall are to be, and the heights that follow.
#pragma once

#include "Support/Outcome.h"

#include <vector>

namespace ransmesh
{
// The defaults of the parameters, in one place.
namespace defaults
{
inline constexpr double growthRate = 1.2;
inline constexpr int numberOfLayers = 25;
inline constexpr int constantLayers = 0;
inline constexpr double isotropicFraction = 0.7;
inline constexpr double normalAngle = 30; // degrees
inline constexpr double fanAngle = 30;    // degrees
inline constexpr double gapFraction = 0.3;
inline constexpr double maximumSurfaceAngle = 10; // degrees
} // namespace defaults

struct LayerSpecification
{
  double firstHeight = 0;                        // h0 > 0, length units
  double growthRate = defaults::growthRate;      // g >= 1
  int numberOfLayers = 0;                        // 0: no layers here
  int constantLayers = defaults::constantLayers; // the first layers, all of the first height; 0 and 1 alike
  double isotropicFraction = defaults::isotropicFraction; // f of the paper's section 3, > 0
  double normalAngle = defaults::normalAngle; // degrees, (0, 180]: convex edges that turn more open a fan
  double fanAngle = defaults::fanAngle;       // degrees, [5, 180]: largest angle between a fan's columns

  bool hasLayers() const { return numberOfLayers > 0; }
  bool operator==(const LayerSpecification&) const = default;
};

// Bounds that keep every computation finite; beyond them a specification is an error.
inline constexpr int MaximumNumberOfLayers = 1000;

// What is wrong with the specification, if anything. where names the patch in the message.
Outcome checkSpecification(const LayerSpecification& specification, const char* where);

// The number of layers whose thickness comes closest to the one given; at least 1.
int layersForThickness(const LayerSpecification& specification, double thickness);

// The levels above the wall: height(0) = 0 at the wall, height(count()) = the thickness.
class LayerHeights
{
public:
  LayerHeights() = default;
  explicit LayerHeights(const LayerSpecification& specification);

  int count() const { return static_cast<int>(height_.size()) - 1; }
  double height(int level) const { return height_[level]; }
  // The distance from level - 1 to level, level >= 1.
  double spacing(int level) const { return height_[level] - height_[level - 1]; }
  double thickness() const { return height_.back(); }

  // The least height that so many levels can be squeezed into: the first spacing stays, the growth is lowered until
  // the last spacing is 0.78 of what it was (by the default growth: 1.187 for 1.2), or the growth 0.96 of it.
  double squeezedHeight(int levels) const;
  // So many levels that end at the height, which lies between squeezedHeight(levels) and height(levels).
  LayerHeights squeezed(int levels, double height) const;

private:
  std::vector<double> height_{ 0.0 };
};

// How fast the edges of an isotropic mesh grow with the distance from a wall: what the mesher does unless told
// otherwise, and other meshers do.
inline constexpr double IsotropicGrowth = 0.3;

// The number of the lowest levels of which none has a spacing greater than `fraction` of the isotropic size at
// its height (section 3 of Loehner's paper), where `size` is that at the wall. The wall's edges alone would stop
// layers over its narrow parts, such as blunt trailing edges, below those around.
int levelsOfIsotropicSize(const LayerHeights& heights, double fraction, double size);

// Specifications by patch number; row 0, the fluid, has no layers.
using LayerPlan = std::vector<LayerSpecification>;
} // namespace ransmesh
