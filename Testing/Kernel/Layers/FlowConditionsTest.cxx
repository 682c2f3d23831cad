#include "Layers/FlowConditions.h"

#include <gtest/gtest.h>

#include <cctype>
#include <cmath>
#include <limits>

namespace
{
using namespace ransmesh;

// Turbulent flat plate at x = 0.970084071, Re = 5e6 per unit length: Cf = 2.729090163e-3 (NASA Turbulence
// Modeling Resource, FUN3D incompressible with the Spalart-Allmaras model, finest grid).
constexpr double PlateStation = 0.970084071;
constexpr double PlateReynoldsNumber = 5e6 * PlateStation;
constexpr double PlateFriction = 2.729090163e-3;

FlowConditions plate(SkinFrictionLaw law)
{
  FlowConditions conditions;
  conditions.reynoldsNumber = PlateReynoldsNumber;
  conditions.referenceLength = PlateStation;
  conditions.law = law;
  return conditions;
}

FlowEstimate estimated(const FlowConditions& conditions)
{
  FlowEstimate estimate;
  const Outcome outcome = estimateFlow(conditions, estimate);
  EXPECT_TRUE(outcome.ok()) << outcome.message;
  return estimate;
}

std::string messageOf(const FlowConditions& conditions)
{
  FlowEstimate estimate;
  const Outcome outcome = estimateFlow(conditions, estimate);
  EXPECT_FALSE(outcome.ok());
  return outcome.message;
}

class TurbulentLaws : public testing::TestWithParam<SkinFrictionLaw>
{
};

TEST_P(TurbulentLaws, GiveTheFirstHeightOfThePublishedPlateWithinFivePerCent)
{
  const FlowEstimate estimate = estimated(plate(GetParam()));
  const double published = 1 / (5e6 * std::sqrt(PlateFriction / 2));
  EXPECT_NEAR(estimate.firstHeight / published, 1, 0.05);
  EXPECT_TRUE(estimate.isWithinRange);
}

INSTANTIATE_TEST_SUITE_P(FlowConditions, TurbulentLaws,
  testing::Values(SkinFrictionLaw::Schlichting, SkinFrictionLaw::PowerLaw, SkinFrictionLaw::SchultzGrunow),
  [](const auto& law)
  {
    std::string name = nameOf(law.param);
    std::erase_if(name, [](char c) { return !std::isalpha(static_cast<unsigned char>(c)); });
    return name;
  });

TEST(FlowConditions, TheLaminarLawIsThatOfBlasius)
{
  FlowConditions conditions = plate(SkinFrictionLaw::Laminar);
  conditions.reynoldsNumber = 1e4;
  const FlowEstimate estimate = estimated(conditions);
  EXPECT_DOUBLE_EQ(estimate.skinFriction, 0.00664);
  EXPECT_DOUBLE_EQ(estimate.thickness, PlateStation * 0.05);
}

TEST(FlowConditions, VelocityAndFluidGiveTheReynoldsNumber)
{
  FlowConditions conditions;
  conditions.velocity = 50;
  conditions.referenceLength = 2;
  const FlowEstimate estimate = estimated(conditions);
  EXPECT_NEAR(estimate.reynoldsNumber, 1.225 * 50 * 2 / 1.7894e-5, 1);
  EXPECT_DOUBLE_EQ(estimate.frictionVelocity, 50 * std::sqrt(estimate.skinFriction / 2));
  // y+ of the first point is what was asked for
  const double viscosity = 1.7894e-5 / 1.225;
  EXPECT_NEAR(estimate.firstHeight * estimate.frictionVelocity / viscosity, 1, 1e-12);
}

TEST(FlowConditions, LengthsAreInTheUnitOfTheSurface)
{
  FlowConditions metres;
  metres.velocity = 10;
  metres.fluid = fluids::water;
  metres.referenceLength = 3;
  FlowConditions millimetres = metres;
  millimetres.referenceLength = 3000;
  millimetres.lengthUnit = 1e-3;
  EXPECT_NEAR(estimated(millimetres).reynoldsNumber / estimated(metres).reynoldsNumber, 1, 1e-14);
  EXPECT_NEAR(estimated(millimetres).firstHeight / estimated(metres).firstHeight, 1000, 1e-9);
  EXPECT_NEAR(estimated(millimetres).thickness / estimated(metres).thickness, 1000, 1e-9);
}

TEST(FlowConditions, TheFirstHeightIsProportionalToYPlus)
{
  FlowConditions conditions = plate(SkinFrictionLaw::Schlichting);
  const double one = estimated(conditions).firstHeight;
  conditions.yPlus = 30;
  EXPECT_DOUBLE_EQ(estimated(conditions).firstHeight, 30 * one);
}

TEST(FlowConditions, OutsideTheRangeOfALawIsTold)
{
  FlowConditions conditions = plate(SkinFrictionLaw::PowerLaw);
  conditions.reynoldsNumber = 1e9;
  EXPECT_FALSE(estimated(conditions).isWithinRange);
  conditions.law = SkinFrictionLaw::Schlichting;
  EXPECT_TRUE(estimated(conditions).isWithinRange);
}

TEST(FlowConditions, MissingAndImpossibleQuantitiesAreNamed)
{
  const FlowConditions good = plate(SkinFrictionLaw::Schlichting);
  FlowConditions bad = good;
  bad.referenceLength = 0;
  EXPECT_NE(messageOf(bad).find("set ReferenceLength"), std::string::npos);
  bad = good;
  bad.yPlus = std::numeric_limits<double>::quiet_NaN();
  EXPECT_NE(messageOf(bad).find("set YPlus"), std::string::npos);
  bad = good;
  bad.reynoldsNumber = -1;
  EXPECT_NE(messageOf(bad).find("set ReynoldsNumber"), std::string::npos);
  bad = good;
  bad.reynoldsNumber = 0;
  EXPECT_NE(messageOf(bad).find("set Velocity"), std::string::npos);
  bad.velocity = 10;
  bad.fluid = { 1, 0 };
  EXPECT_NE(messageOf(bad).find("set Viscosity"), std::string::npos);
  bad.fluid = { 0, 1 };
  EXPECT_NE(messageOf(bad).find("set Density"), std::string::npos);
  bad = good;
  bad.reynoldsNumber = 100;
  EXPECT_NE(messageOf(bad).find("laminar"), std::string::npos);
}
} // namespace
