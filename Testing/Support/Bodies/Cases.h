// The cases that the layers are judged by: a body each, with the layers asked for on it.
#pragma once

#include "Bodies/Body.h"

#include <functional>
#include <string>
#include <vector>

namespace bodies
{
// What the layers of a case must reach.
struct Goals
{
  double inserted = 1;    // share of the points asked for, after the limits
  double fullColumns = 1; // share of the columns at smooth wall points
  double over175 = 0;     // share of the layers' tetrahedra with a larger dihedral angle, degrees
  double over179 = 0;
};

struct Layers
{
  double firstHeight = 1e-5; // the body's length is about 1
  double growth = 1.2;
  int number = 25;

  double thickness() const;
};

// Layers of the usual number and growth that are so thick.
Layers layersOfThickness(double thickness);

// Other layers on a patch. The first height is a multiple of the case's.
struct PatchLayers
{
  std::string patch;
  double firstHeight = 1;
  double growth = 1.2;
  int number = 25;
};

struct Case
{
  std::string name;
  std::function<Body(double size, const Layers& layers)> make;
  double size = 0.05;     // edge length of the surface's triangles
  double testSize = 0.12; // the same for a quick run
  double thickness = 0;   // of the layers, in edge lengths; 0: Layers as they are
  Goals goals;
  std::vector<PatchLayers> patchLayers;
  bool copiesAtEachLevel = false; // are copies of all wall triangles to be faces at all levels?
  double volumeChange = 1e-9;     // how much of the fluid's volume may come or go: new chords of curved sides

  Layers layers(double edge) const { return thickness > 0 ? layersOfThickness(thickness * edge) : Layers{}; }
};

const std::vector<Case>& allCases();
// nullptr if there is none of that name.
const Case* findCase(const std::string& name);
} // namespace bodies
