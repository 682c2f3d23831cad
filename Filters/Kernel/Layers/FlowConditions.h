// The first height of the layers and their thickness, estimated from the flow they are for, as on a flat plate.
#pragma once

#include "Support/Outcome.h"

namespace ransmesh
{
// The local skin friction coefficient of a flat plate at the distance x from its leading edge, by Re_x.
enum class SkinFrictionLaw
{
  Schlichting,   // (2 log10 Re - 0.65)^-2.3; Re up to 1e9 (Schlichting, Boundary-Layer Theory, chapter 21)
  PowerLaw,      // 0.0592 Re^-1/5; Re 5e5 to 1e7 (the same, equation 21.12)
  SchultzGrunow, // 0.370 (log10 Re)^-2.584; Re 1e6 to 1e9 (the same, equation 21.19a)
  Laminar        // 0.664 Re^-1/2; Re up to 5e5 (Blasius)
};

struct Fluid
{
  double density;   // kg/m3
  double viscosity; // dynamic, Pa s
};

namespace fluids
{
inline constexpr Fluid air{ 1.225, 1.7894e-5 };   // 15 degrees C, 101 325 Pa (ISO 2533)
inline constexpr Fluid water{ 998.2, 1.0016e-3 }; // fresh, 20 degrees C, 101 325 Pa (IAPWS)
} // namespace fluids

namespace defaults
{
inline constexpr double yPlus = 1;
} // namespace defaults

struct FlowConditions
{
  double velocity = 0;            // m/s; not needed where the Reynolds number is given
  Fluid fluid = fluids::air;      // not used where the Reynolds number is given
  double reynoldsNumber = 0;      // of the reference length; 0: follows from velocity and fluid
  double referenceLength = 0;     // distance from the leading edge, in the length unit of the surface
  double lengthUnit = 1;          // of the surface, in m
  double yPlus = defaults::yPlus; // of the first point above the wall
  SkinFrictionLaw law = SkinFrictionLaw::Schlichting;

  bool areGiven() const { return velocity != 0 || reynoldsNumber != 0; }
};

struct FlowEstimate
{
  double reynoldsNumber = 0;
  double skinFriction = 0;     // Cf = 2 (u_tau / U)^2, at the reference length
  double frictionVelocity = 0; // u_tau in m/s; as a fraction of U where no velocity is given
  double firstHeight = 0;      // y+ nu / u_tau, in the length unit of the surface
  double thickness = 0;        // of the boundary layer (to 99 % of U) at the reference length, same unit
  bool isWithinRange = true;   // whether the law was made for this Reynolds number
};

const char* nameOf(SkinFrictionLaw law);

// BadInput where a quantity is missing or impossible; says which, and what to set.
Outcome estimateFlow(const FlowConditions& conditions, FlowEstimate& estimate);
} // namespace ransmesh
