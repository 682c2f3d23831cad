// From what the user asked for to a specification for each patch.
#pragma once

#include "Layers/LayerSpecification.h"
#include "Mesh/MeshData.h"
#include "Support/Patch.h"

#include <string>
#include <utility>
#include <vector>

namespace ransmesh
{
struct PatchLayers
{
  std::string pattern; // a name with the wildcards * and ?, or a number
  double firstHeight = 0;
  double growthRate = defaults::growthRate;
  int numberOfLayers = defaults::numberOfLayers;
};

struct LayerRequest
{
  LayerSpecification general;            // where no patch rule says otherwise
  double totalThickness = 0;             // > 0: the number of layers follows from it
  std::vector<std::string> wallPatterns; // empty: the walls are found by type
  std::vector<PatchLayers> patchLayers;  // later ones win; a patch named here is a wall
  // Patch by patch, after all the rest: is it a wall? Names that the mesh does not have mean nothing.
  std::vector<std::pair<std::string, bool>> choices;
};

// What holds for every wall that no patch rule speaks of.
LayerSpecification generalSpecification(const LayerRequest& request);

// Does name match the pattern (* any run, ? any one character)?
bool matchesPattern(std::string_view name, std::string_view pattern);

// The patches that a pattern takes, by number. A number takes that patch, a full name takes every patch
// so named; a pattern with wildcards never takes patches of type farfield, symmetry, inlet, outlet or
// interface. Row 0 is never taken.
std::vector<int> patchesOf(const PatchTable& patches, const std::string& pattern);

// Whether all triangles of the patch lie in one side of the mesh's bounding box; by patch number.
std::vector<char> findBoxSides(const MeshData& mesh, std::size_t patchCount);

// Which patches are walls, by number: see planLayers, whose errors it gives. With the error that no patch
// is a wall, isWall is complete nevertheless.
Outcome findWalls(
  const MeshData& mesh, const PatchTable& patches, const LayerRequest& request, std::vector<char>& isWall);

// The plan: walls are the patches named; if none is named, all of type wall or wake; if no types are known
// (all are `patch` or `wake`), every patch that is not a side of the bounding box.
// BadInput where no wall is left, a pattern takes nothing, or a specification is impossible
// (also: a first height not below the largest extent of the mesh, or too small to be told by the wall's coordinates).
Outcome planLayers(
  const MeshData& mesh, const PatchTable& patches, const LayerRequest& request, LayerPlan& plan);

// Which patches a removal may change the triangles of: those without layers that are not interfaces.
// By patch number.
std::vector<char> changeablePatches(const PatchTable& patches, const LayerPlan& plan);

// The patches of a mesh that is cut open along its sheets (Boundary/Sheets.h), as the removal is to see them:
// both sides of a sheet must stay alike, so it is an interface, where nothing changes.
PatchTable withFrozenSheets(const PatchTable& patches, const std::vector<int>& sheetPatches);

// The same for the enrichment: a sheet with layers is a wake, whatever its type was, without it is an interface.
PatchTable patchesOfOpened(
  const PatchTable& patches, const std::vector<int>& sheetPatches, const LayerPlan& plan);
} // namespace ransmesh
