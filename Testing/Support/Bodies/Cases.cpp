#include "Bodies/Cases.h"

#include "Bodies/Blocks.h"
#include "Bodies/CurvedEnds.h"
#include "Bodies/Junctions.h"
#include "Bodies/Rounds.h"
#include "Bodies/Sheets.h"
#include "Bodies/Transitions.h"
#include "Bodies/Wings.h"

#include <cmath>

namespace bodies
{
namespace
{
constexpr Goals smooth = { 1, 1, 2e-5, 0 };
constexpr Goals cavities = { 1, 0.9999, 1e-4, 0 };
constexpr Goals wings = { 0.99999, 0.999, 5e-4, 1e-4 };
constexpr Goals ridges = { 0.99999, 0.999, 1e-3, 2e-4 };
constexpr Goals junctions = { 0.9999, 0.995, 1e-3, 2e-4 };
constexpr Goals wakes = { 0.9999, 0.995, 1e-3, 2e-4 };
constexpr Goals gaps = { 0.99999, 0.995, 1e-3, 2e-4 };

// A case that does not depend on the layers.
Case plain(const char* name, std::function<Body(double)> make, const Goals& goals, double testSize = 0.12)
{
  Case result;
  result.name = name;
  result.make = [make = std::move(make)](double size, const Layers&) { return make(size); };
  result.goals = goals;
  result.testSize = testSize;
  return result;
}

// The same with layers of so many edge lengths.
Case thick(Case base, const char* suffix, double thickness)
{
  base.name += suffix;
  base.thickness = thickness;
  return base;
}

// The same with other layers on some patches.
Case withLayers(Case base, const char* suffix, const PatchLayers& layers)
{
  base.name += suffix;
  base.patchLayers.push_back(layers);
  return base;
}

void addSmooth(std::vector<Case>& cases)
{
  const Case shapes[] = { plain(
                            "plate", [](double size) { return plate(size, 0.5); }, smooth),
    plain(
      "plate-noise", [](double size) { return plate(size, 0.5, 0.025); }, smooth),
    plain("sphere", sphereOfSize, smooth), plain("pipe", pipe, smooth) };
  for (Case shape : shapes)
  {
    shape.copiesAtEachLevel = true;
    cases.push_back(shape);
    cases.push_back(thick(shape, "-thick0.3", 0.3));
    cases.push_back(thick(shape, "-thick1", 1));
    cases.push_back(thick(shape, "-thick2", 2));
  }
}

void addCavities(std::vector<Case>& cases)
{
  for (const bool six : { false, true })
  {
    const std::string walls = six ? "-six" : "-four";
    cases.push_back(
      plain(("cavity" + walls).c_str(), [six](double size) { return cavity(size, six); }, cavities));
    cases.push_back(
      plain(("rhomb" + walls).c_str(), [six](double size) { return cavity(size, six, 60); }, cavities));
  }
  cases.push_back(thick(plain(
                          "cavity-four", [](double size) { return cavity(size, false); }, cavities),
    "-thick1.5", 1.5));
  cases.push_back(thick(plain(
                          "rhomb-four", [](double size) { return cavity(size, false, 60); }, cavities),
    "-thick1.5", 1.5));
}

void addInsidesOfCones(std::vector<Case>& cases)
{
  for (const int halfAngle : { 10, 18, 30, 45, 60 })
  {
    const std::string name = "cone-inside" + (halfAngle == 18 ? "" : std::to_string(halfAngle));
    cases.push_back(plain(
      name.c_str(), [halfAngle](double size) { return insideOfCone(size, halfAngle); }, ridges));
    cases.back().volumeChange = 2e-5;
  }
}

void addSharp(std::vector<Case>& cases)
{
  cases.push_back(plain(
    "wing", [](double size) { return wing(size, TrailingEdge::Sharp, Tip::Flat); }, wings));
  cases.push_back(plain(
    "wing-blunt", [](double size) { return wing(size, TrailingEdge::Blunt, Tip::Flat); }, wings));
  cases.push_back(plain(
    "wing-round", [](double size) { return wing(size, TrailingEdge::Sharp, Tip::Round); }, wings));
  cases.push_back(plain(
    "wing-half", [](double size) { return halfWing(size, TrailingEdge::Sharp, Tip::Flat); }, wings));
  cases.push_back(plain("corner", corner, ridges));
  cases.push_back(plain("step", step, ridges));
  cases.push_back(plain("groove", groove, ridges));
  cases.push_back(plain("fins", fins, ridges, 0.1));
  cases.push_back(plain("cube", cube, ridges));
  cases.push_back(plain("cone", cone, ridges));
  addInsidesOfCones(cases);
  cases.push_back(plain("pipe-junction", pipeJunction, junctions));
  cases.back().volumeChange = 1e-6;
  cases.push_back(plain("wing-fuselage", wingOnFuselage, junctions));
}

// Walls that run into curved patches.
void addCurved(std::vector<Case>& cases)
{
  const Case shapes[] = { plain("capped-pipe", cappedPipe, junctions),
    plain("half-dome", halfDome, junctions, 0.1) };
  for (Case shape : shapes)
  {
    shape.volumeChange = 0.02;
    cases.push_back(shape);
    cases.push_back(thick(shape, "-thick1", 1));
  }
}

// Where layers of different walls meet, and where walls end.
void addTransitions(std::vector<Case>& cases)
{
  const PatchLayers higher{ "", 5, 1.2, 25 };
  const PatchLayers fewer{ "", 1, 1.2, 15 };
  const PatchLayers steeper{ "", 1, 1.3, 20 };
  for (const auto& [suffix, layers] :
    { std::pair("-higher", higher), std::pair("-fewer", fewer), std::pair("-steeper", steeper) })
  {
    for (const double thickness : { 0.0, 1.0 })
    {
      const auto add = [&](const char* body, Body (*make)(double), const char* patch)
      {
        PatchLayers other = layers;
        other.patch = patch;
        const Case base = plain(body, make, ridges);
        cases.push_back(withLayers(thickness > 0 ? thick(base, "-thick1", thickness) : base, suffix, other));
      };
      add("floors", twoFloors, "aft_wall");
      add("floor-back", floorAndBack, "back_wall");
    }
  }
  const Case end = plain("floor-end", endingFloor, ridges);
  cases.push_back(end);
  cases.push_back(thick(end, "-thick1", 1));
  Case duct = plain("bulging-duct", bulgingDuct, junctions);
  duct.volumeChange = 2e-4;
  cases.push_back(duct);
  cases.push_back(thick(duct, "-thick1", 1));
}

void addGaps(std::vector<Case>& cases)
{
  for (const char* share : { "2", "1", "0.5", "0.1" })
  {
    const double layersThick = std::atof(share);
    const auto add = [&](const char* name, Body (*make)(double, double))
    {
      Case result;
      result.name = std::string(name) + "-gap" + share;
      result.make = [make, layersThick](double size, const Layers& layers)
      { return make(size, layersThick * layers.thickness()); };
      result.goals = gaps;
      cases.push_back(result);
    };
    add("plates", twoPlates);
    add("spheres", twoSpheres);
    add("channel", channel);
    add("slot", slot);
    add("mirror", wallOverMirror);
  }
  cases.push_back(plain("wedge-mirror", wedgeOverMirror, gaps));
  for (const PatchType floor : { PatchType::Wall, PatchType::Symmetry })
  {
    cases.push_back(plain(
      floor == PatchType::Wall ? "cylinder-floor" : "cylinder-mirror",
      [floor](double size) { return cylinderOnFloor(size, floor); }, gaps));
  }
  cases.push_back(withLayers(cases[cases.size() - 2], "-two", { "cylinder_wall", 3, 1.3, 15 }));
  cases.push_back(plain("fin-thin", thinFin, ridges));
  cases.push_back(plain("wake-free", freeWake, wakes));
  cases.push_back(plain("wing-wake", wingWithWake, wakes));
}
} // namespace

double Layers::thickness() const
{
  return growth == 1 ? firstHeight * number : firstHeight * (std::pow(growth, number) - 1) / (growth - 1);
}

Layers layersOfThickness(double thickness)
{
  Layers layers;
  layers.firstHeight *= thickness / layers.thickness();
  return layers;
}

const std::vector<Case>& allCases()
{
  static const std::vector<Case> cases = []
  {
    std::vector<Case> result;
    addSmooth(result);
    addCavities(result);
    addSharp(result);
    addCurved(result);
    addTransitions(result);
    addGaps(result);
    return result;
  }();
  return cases;
}

const Case* findCase(const std::string& name)
{
  for (const Case& c : allCases())
  {
    if (c.name == name)
    {
      return &c;
    }
  }
  return nullptr;
}
} // namespace bodies
