// What the user wants of the mesher, as plain values.
#pragma once

#include "DomainMeshing.h"

#include "SurfaceSizing.h"

#include "Surface/Preparation.h"

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace ransmesh
{
struct MesherSettings
{
  PreparationOptions preparation; // check and repair of the surface
  bool patchFromFeatureAngle = false;
  double featureAngle = 30; // degrees
  SurfaceSizing sizing;     // of the remeshed surface
  bool improveTriangles = true;
  double surfaceAngle = 10; // degrees, how far swaps may turn the surface
  std::optional<FarFieldOptions> farField;
  std::vector<DomainPlane> planes;
  std::vector<std::string> keptInsides; // patches whose insides are meshed, too: patterns
  std::vector<std::pair<std::string, std::string>> typeOfPattern;
  MeshingOptions meshing;
};
} // namespace ransmesh
