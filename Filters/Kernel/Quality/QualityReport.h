// What is to be known about a mesh: a plain value, and the function that finds it.
//
// Nothing is taken on trust: layers are measured along the edges of the mesh, not read from what the
// enrichment says that it did.
#pragma once

#include "Layers/LayerSpecification.h"
#include "Mesh/Validation.h"
#include "Quality/CellMeasures.h"
#include "Quality/ColumnFollower.h"
#include "Quality/Distribution.h"
#include "Support/Context.h"
#include "Support/Patch.h"

#include <array>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace ransmesh
{
struct ReportOptions
{
  ColumnRules columns;
  double smoothAngle = 20; // degrees; see columnFeetOf
};

struct PatchSummary
{
  int number = 0;
  std::string name;
  PatchType type = PatchType::Patch;
  bool isSheet = false; // inside the mesh; then triangles and area are those of one side
  std::size_t triangles = 0;
  double area = 0;
};

// A part of the mesh that others have a number of their own beside.
struct RegionSummary
{
  int number = 0;
  std::string name;
  std::size_t tetrahedra = 0;
  double volume = 0;
};

// Shapes of all tetrahedra, or of those in the layers. Angles in degrees.
struct ShapeSummary
{
  static constexpr std::array<double, 5> Limits = { 150, 165, 175, 179, 179.9 };

  std::size_t count = 0;
  Quantiles largestDihedral;
  Quantiles smallestDihedral;
  std::array<double, Limits.size()> shareOver{}; // of tetrahedra whose largest dihedral exceeds the limit
  Quantiles stretching;
  Quantiles quality;
};

// Layers on one wall patch, or on all. Columns are those of smooth wall points. A sheet counts with both
// sides: its faces, its area and its points twice.
struct WallSummary
{
  int patch = 0; // 0: all walls together
  std::string name;
  LayerSpecification asked; // of a patch; means nothing for all walls
  std::size_t faces = 0;
  double area = 0;
  Quantiles firstHeight;               // heights of the cells on the wall, length units
  Quantiles firstHeightRatio;          // the same over the height asked for
  double areaShareWithFirstHeight = 0; // of the wall: the height is within the tolerance of the one asked for
  std::size_t points = 0;
  std::size_t smoothPoints = 0;
  double meanLayers = 0;
  double shareFull = 0;                     // of columns: all layers asked for
  double shareEmpty = 0;                    // of columns: none
  std::vector<std::size_t> columnsByLayers; // how many columns have 0, 1, ... layers
  Quantiles growth;                         // ratios of successive spacings of columns
  Quantiles lean;                           // of column edges from the wall's normal, degrees
  Quantiles transition;                     // edge beyond a column's top over the column's last spacing
  Quantiles topToWallEdge; // a column's last spacing over the wall's mean edge at its foot: 1 is isotropic
};

// How many columns the enrichment says that it stopped for one reason.
struct StopCount
{
  std::string reason;
  std::size_t columns = 0;
};

// A mesh with prisms is measured as the tetrahedra that its cells are cut into (Mesh/MixedMesh.h); this is what
// it was before.
struct PrismSummary
{
  std::size_t tetrahedra = 0;
  std::size_t pyramids = 0;
  std::size_t wedges = 0;
  std::size_t hexahedra = 0;
  std::size_t quadrilaterals = 0; // of the boundary
  double shareOfLayers = 0;       // of the layers' tetrahedra: cut from wedges and hexahedra
  std::string faults;             // what the cut hides; empty: nothing
};

struct QualityReport
{
  bool isValid = false;
  MeshFaults faults;
  std::optional<PrismSummary> prisms; // none: the mesh is of tetrahedra
  // Measured only where point numbers are in range and points finite.
  bool isMeasured = false;

  std::size_t points = 0;
  std::size_t tetrahedra = 0;
  std::size_t triangles = 0;
  std::vector<PatchSummary> patches;  // those with triangles
  std::vector<RegionSummary> regions; // by number; empty where there are not several

  double volume = 0;
  Quantiles cellVolume;
  Quantiles longestEdge;  // of each tetrahedron
  Quantiles shortestEdge; // of each tetrahedron
  ShapeSummary all;
  ShapeSummary layers; // tetrahedra with a LayerId; without LayerId those with all points on columns

  std::vector<WallSummary> walls; // all walls together first, then each; empty without a plan
  std::vector<StopCount> stops;   // not measured, but told by whoever knows; may be empty
  ReportOptions options;
  std::vector<Histogram> histograms;
};

struct ReportSubject
{
  const MeshData& mesh;
  const PatchTable& patches;
  const LayerPlan& plan;                     // may be empty
  const std::vector<int>* layerId = nullptr; // of each tetrahedron, 0 none; may be left out
  const PrismSummary* prisms = nullptr;      // where the mesh was cut from one with prisms
  const std::vector<int>* region = nullptr;  // the number of each tetrahedron's; may be left out
  std::map<int, std::string> regionNames{};  // of all those numbers
};

// Linear in the size of the mesh. cells, if given, receives the measures of each tetrahedron and what lies behind
// each triangle (empty where the report is not measured). If the context is stopped, the report is incomplete.
QualityReport reportQuality(const ReportSubject& subject, const ReportOptions& options,
  const Context& context, CellMeasures* cells = nullptr);
} // namespace ransmesh
