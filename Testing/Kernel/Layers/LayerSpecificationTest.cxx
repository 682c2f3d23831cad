#include "Layers/LayerSpecification.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>

namespace
{
using namespace ransmesh;

LayerSpecification good()
{
  LayerSpecification s;
  s.firstHeight = 1e-5;
  s.growthRate = 1.2;
  s.numberOfLayers = 25;
  return s;
}

std::string messageWhen(const std::function<void(LayerSpecification&)>& change)
{
  LayerSpecification s = good();
  change(s);
  const Outcome outcome = checkSpecification(s, "hull");
  EXPECT_EQ(outcome.ok(), outcome.message.empty());
  return outcome.message;
}

bool contains(const std::string& text, const char* phrase)
{
  return text.find(phrase) != std::string::npos;
}

TEST(LayerSpecification, heightsFollowTheGeometricSeries)
{
  const LayerHeights heights(good());
  ASSERT_EQ(heights.count(), 25);
  EXPECT_EQ(heights.height(0), 0);
  EXPECT_EQ(heights.height(1), 1e-5);
  EXPECT_NEAR(heights.thickness(), 1e-5 * (std::pow(1.2, 25) - 1) / 0.2, 1e-15);
  for (int level = 2; level <= 25; ++level)
  {
    EXPECT_NEAR(heights.spacing(level) / heights.spacing(level - 1), 1.2, 1e-9) << level;
  }
}

TEST(LayerSpecification, constantLayersDoNotGrow)
{
  LayerSpecification s = good();
  s.constantLayers = 3;
  const LayerHeights heights(s);
  EXPECT_NEAR(heights.height(3), 3e-5, 1e-18);
  EXPECT_NEAR(heights.spacing(4), 1.2e-5, 1e-18);
  s.constantLayers = 1; // the first layer never grows
  EXPECT_NEAR(LayerHeights(s).spacing(2), 1.2e-5, 1e-18);
}

TEST(LayerSpecification, growthOfOneGivesEvenLayers)
{
  LayerSpecification s = good();
  s.growthRate = 1;
  EXPECT_NEAR(LayerHeights(s).thickness(), 25e-5, 1e-17);
}

TEST(LayerSpecification, squeezedLayersKeepTheFirstHeightAndAllButTheGrowth)
{
  const LayerHeights whole(good());
  const double least = whole.squeezedHeight(25);
  EXPECT_NEAR(least / whole.thickness(), 0.82, 0.001);
  for (const double height : { least, 0.9 * whole.thickness(), whole.thickness() })
  {
    const LayerHeights heights = whole.squeezed(25, height);
    ASSERT_EQ(heights.count(), 25);
    EXPECT_NEAR(heights.thickness(), height, 1e-12 * height);
    EXPECT_NEAR(heights.height(1), 1e-5, 1e-20);
    for (int level = 2; level <= 25; ++level)
    {
      EXPECT_GE(heights.spacing(level) / whole.spacing(level), 0.78 - 1e-9);
      const double growth = heights.spacing(level) / heights.spacing(level - 1);
      EXPECT_GE(growth, 1.2 * 0.989);
      EXPECT_LE(growth, 1.2 + 1e-9);
    }
  }
}

TEST(LayerSpecification, fewLayersAreSqueezedLess)
{
  const LayerHeights heights(good());
  EXPECT_EQ(heights.squeezedHeight(0), 0);
  EXPECT_EQ(heights.squeezedHeight(1), heights.height(1));
  EXPECT_NEAR(heights.squeezedHeight(2), (1 + 0.96 * 1.2) * 1e-5, 1e-15);
  EXPECT_NEAR(heights.squeezed(2, 2.2e-5).height(2), 2.2e-5, 1e-15);
}

TEST(LayerSpecification, noLayersHaveNoHeight)
{
  const LayerHeights none{ LayerSpecification{} };
  EXPECT_EQ(none.count(), 0);
  EXPECT_EQ(none.thickness(), 0);
  EXPECT_FALSE(LayerSpecification{}.hasLayers());
}

TEST(LayerSpecification, thicknessGivesTheClosestNumberOfLayers)
{
  LayerSpecification s = good();
  for (const int number : { 1, 2, 10, 25, 60 })
  {
    s.numberOfLayers = number;
    const LayerHeights heights(s);
    const double last = heights.spacing(number);
    EXPECT_EQ(layersForThickness(s, heights.thickness()), number);
    EXPECT_EQ(layersForThickness(s, heights.thickness() + 0.4 * last), number);
    EXPECT_EQ(layersForThickness(s, heights.thickness() - 0.4 * last), number);
  }
  EXPECT_EQ(layersForThickness(s, 1e-30), 1);
  EXPECT_EQ(layersForThickness(s, 1e300), MaximumNumberOfLayers);
}

TEST(LayerSpecification, goodOnesPass)
{
  EXPECT_EQ(messageWhen([](LayerSpecification&) {}), "");
  EXPECT_EQ(messageWhen([](LayerSpecification& s) { s.growthRate = 1; }), "");
  EXPECT_EQ(messageWhen([](LayerSpecification& s) { s.numberOfLayers = MaximumNumberOfLayers; }), "");
  EXPECT_EQ(messageWhen([](LayerSpecification& s) { s.firstHeight = 1e-12; }), "");
}

TEST(LayerSpecification, everyImpossibleOneSaysWhatToDo)
{
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  constexpr double infinity = std::numeric_limits<double>::infinity();
  for (const double bad : { 0.0, -1e-8, nan, infinity })
  {
    const std::string message = messageWhen([bad](LayerSpecification& s) { s.firstHeight = bad; });
    EXPECT_TRUE(contains(message, "hull")) << message;
    EXPECT_TRUE(contains(message, "first height")) << message;
    EXPECT_TRUE(contains(message, "set FirstHeight")) << message;
  }
  EXPECT_TRUE(contains(messageWhen([](LayerSpecification& s) { s.firstHeight = -1e-8; }), "-1e-08"));
  for (const double bad : { 0.99, 0.0, -2.0, 10.01, nan, infinity })
  {
    EXPECT_TRUE(
      contains(messageWhen([bad](LayerSpecification& s) { s.growthRate = bad; }), "set GrowthRate"));
  }
  for (const int bad : { 0, -1, MaximumNumberOfLayers + 1 })
  {
    EXPECT_TRUE(
      contains(messageWhen([bad](LayerSpecification& s) { s.numberOfLayers = bad; }), "set NumberOfLayers"));
  }
  EXPECT_TRUE(contains(messageWhen([](LayerSpecification& s) { s.constantLayers = -1; }), "ConstantLayers"));
  for (const double bad : { 0.0, -0.7, nan })
  {
    EXPECT_TRUE(contains(
      messageWhen([bad](LayerSpecification& s) { s.isotropicFraction = bad; }), "set IsotropicFraction"));
    EXPECT_TRUE(
      contains(messageWhen([bad](LayerSpecification& s) { s.normalAngle = bad; }), "set NormalAngle"));
    EXPECT_TRUE(contains(messageWhen([bad](LayerSpecification& s) { s.fanAngle = bad; }), "set FanAngle"));
  }
  EXPECT_TRUE(contains(messageWhen([](LayerSpecification& s) { s.normalAngle = 181; }), "set NormalAngle"));
  for (const double bad : { 4.9, 181.0 })
  {
    EXPECT_TRUE(contains(messageWhen([bad](LayerSpecification& s) { s.fanAngle = bad; }), "set FanAngle"));
  }
}
} // namespace
