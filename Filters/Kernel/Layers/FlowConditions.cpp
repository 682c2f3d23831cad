#include "Layers/FlowConditions.h"

#include "Support/Numbers.h"

#include <cmath>
#include <string>

namespace ransmesh
{
namespace
{
struct Range
{
  double least, most;
};

// Where the law is good to a few per cent.
Range rangeOf(SkinFrictionLaw law)
{
  switch (law)
  {
    case SkinFrictionLaw::PowerLaw:
      return { 5e5, 1e7 };
    case SkinFrictionLaw::SchultzGrunow:
      return { 1e6, 1e9 };
    case SkinFrictionLaw::Laminar:
      return { 1e3, 5e5 };
    case SkinFrictionLaw::Schlichting:
      break;
  }
  return { 5e5, 1e9 };
}

// Below it the turbulent laws have no meaning at all.
constexpr double LeastTurbulentReynoldsNumber = 1000;

double skinFrictionOf(SkinFrictionLaw law, double reynoldsNumber)
{
  switch (law)
  {
    case SkinFrictionLaw::PowerLaw:
      return 0.0592 * std::pow(reynoldsNumber, -0.2);
    case SkinFrictionLaw::SchultzGrunow:
      return 0.370 * std::pow(std::log10(reynoldsNumber), -2.584);
    case SkinFrictionLaw::Laminar:
      return 0.664 / std::sqrt(reynoldsNumber);
    case SkinFrictionLaw::Schlichting:
      break;
  }
  return std::pow(2 * std::log10(reynoldsNumber) - 0.65, -2.3);
}

// To 99 % of the outer velocity, over the distance from the leading edge (Schlichting, chapters 2 and 21).
double relativeThickness(SkinFrictionLaw law, double reynoldsNumber)
{
  return law == SkinFrictionLaw::Laminar ? 5.0 / std::sqrt(reynoldsNumber)
                                         : 0.37 * std::pow(reynoldsNumber, -0.2);
}

bool isPositive(double value)
{
  return value > 0 && std::isfinite(value);
}

Outcome checkPositive(double value, const char* quantity, const char* whatToDo)
{
  return isPositive(value) ? Outcome::done()
                           : Outcome::badInput(std::string("flow conditions: the ") + quantity + " is " +
                               textOf(value) + "; it must be positive: " + whatToDo);
}

Outcome checkConditions(const FlowConditions& c)
{
  struct Quantity
  {
    bool isNeeded;
    double value;
    const char* name;
    const char* whatToDo;
  };
  const bool byVelocity = c.reynoldsNumber == 0;
  const Quantity quantities[] = {
    { !byVelocity, c.reynoldsNumber, "Reynolds number", "set ReynoldsNumber, or Velocity in m/s" },
    { byVelocity || c.velocity != 0, c.velocity, "velocity", "set Velocity in m/s, or ReynoldsNumber" },
    { true, c.referenceLength, "reference length",
      "set ReferenceLength to the distance from the leading edge, in the length unit of the surface" },
    { byVelocity, c.fluid.density, "density", "set Density in kg/m3" },
    { byVelocity, c.fluid.viscosity, "dynamic viscosity", "set Viscosity in Pa s" },
    { byVelocity, c.lengthUnit, "length unit", "set LengthUnit to the metres in one unit of the surface" },
    { true, c.yPlus, "y+", "set YPlus (1 is usual)" },
  };
  for (const Quantity& q : quantities)
  {
    if (auto outcome = checkPositive(q.value, q.name, q.whatToDo); q.isNeeded && !outcome.ok())
    {
      return outcome;
    }
  }
  return Outcome::done();
}

double reynoldsNumberOf(const FlowConditions& c)
{
  return c.reynoldsNumber > 0
    ? c.reynoldsNumber
    : c.fluid.density * c.velocity * c.referenceLength * c.lengthUnit / c.fluid.viscosity;
}
} // namespace

const char* nameOf(SkinFrictionLaw law)
{
  switch (law)
  {
    case SkinFrictionLaw::PowerLaw:
      return "power law";
    case SkinFrictionLaw::SchultzGrunow:
      return "Schultz-Grunow";
    case SkinFrictionLaw::Laminar:
      return "laminar (Blasius)";
    case SkinFrictionLaw::Schlichting:
      break;
  }
  return "Schlichting";
}

Outcome estimateFlow(const FlowConditions& conditions, FlowEstimate& estimate)
{
  if (auto outcome = checkConditions(conditions); !outcome.ok())
  {
    return outcome;
  }
  const double reynoldsNumber = reynoldsNumberOf(conditions);
  const bool isTurbulent = conditions.law != SkinFrictionLaw::Laminar;
  if (!isPositive(reynoldsNumber) || (isTurbulent && reynoldsNumber < LeastTurbulentReynoldsNumber))
  {
    return Outcome::badInput("flow conditions: the Reynolds number is " + textOf(reynoldsNumber) +
      ", too small for a turbulent boundary layer: check the units of Velocity, ReferenceLength and "
      "LengthUnit, "
      "or choose the laminar law");
  }
  const Range range = rangeOf(conditions.law);
  const double friction = skinFrictionOf(conditions.law, reynoldsNumber);
  const double relativeVelocity = std::sqrt(friction / 2); // u_tau / U
  estimate.reynoldsNumber = reynoldsNumber;
  estimate.skinFriction = friction;
  estimate.frictionVelocity = relativeVelocity * (conditions.velocity > 0 ? conditions.velocity : 1);
  estimate.firstHeight = conditions.yPlus * conditions.referenceLength / (reynoldsNumber * relativeVelocity);
  estimate.thickness = conditions.referenceLength * relativeThickness(conditions.law, reynoldsNumber);
  estimate.isWithinRange = reynoldsNumber >= range.least && reynoldsNumber <= range.most;
  return Outcome::done();
}
} // namespace ransmesh
