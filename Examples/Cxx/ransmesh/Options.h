// What the user asked for on the command line.
#pragma once

#include <array>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace commandline
{
// What the layers are for, in place of a first height.
struct FlowOptions
{
  double velocity = 0;       // m/s; 0: not given
  double reynoldsNumber = 0; // 0: not given
  double length = 0;         // in the unit of the surface; 0: not given
  double yPlus = 0;          // 0: not given
  double density = 0;        // kg/m3; 0: not given
  double viscosity = 0;      // Pa s; 0: not given
  double lengthUnit = 0;     // m; 0: not given
  std::string fluid;         // empty: not given
  std::string law;           // empty: not given
  bool givesThickness = false;

  bool isGiven() const { return velocity > 0 || reynoldsNumber > 0; }
};

// What is done to faulty surfaces; lengths in their unit.
struct RepairOptions
{
  bool repair = true;
  double weld = -1;         // negative: not given
  double shortestEdge = -1; // negative: not given
  double largestHole = 0;   // 0: holes are not filled
  double wrapAlpha = 0;     // 0: no wrap
  double wrapOffset = 0;    // 0: not given
};

// Sizes to which surfaces are remeshed; lengths in their unit; 0: not given.
struct RemeshOptions
{
  double length = 0;
  std::vector<std::pair<std::string, double>> ofPatch;
  double edgesPerCircle = 0;
  double edgesAcrossGap = 0;
  double smallest = 0;
  double deviation = 0;
  std::string array; // of the points; empty: none

  bool isGiven() const
  {
    return length > 0 || edgesPerCircle > 0 || edgesAcrossGap > 0 || !ofPatch.empty() || !array.empty();
  }
};

// Places with small edges, as the numbers that the mesher takes.
struct RefinementOptions
{
  std::vector<std::array<double, 7>> boxes;
  std::vector<std::array<double, 5>> spheres;
  std::vector<std::array<double, 8>> lines;

  bool isGiven() const { return !boxes.empty() || !spheres.empty() || !lines.empty(); }
};

struct PlaneOption
{
  int axis = 0; // 1, 2, 3: across x, y, z; 0: no plane
  double place = 0;
};

struct SideOption
{
  std::string side; // xmin, ...
  std::string name;
  std::string type; // empty: as the name suggests
};

struct MarginOption
{
  std::string side;  // xmin, ...
  double margin = 0; // body lengths
};

// Layers of their own for the patches that a pattern takes.
struct PatchLayersOption
{
  std::string pattern;
  double firstHeight = 0;
  double growth = 0; // 0: not given
  int layers = 0;    // 0: not given
};

// How layers stand at edges and where they end.
struct ColumnOptions
{
  int constantLayers = 0;       // 0: not given
  double isotropicFraction = 0; // 0: not given
  double gapFraction = 0;       // 0: not given
  double normalAngle = 0;       // degrees; 0: not given
  double fanAngle = 0;          // degrees; 0: not given
  double surfaceAngle = -1;     // degrees; negative: not given

  bool areGiven() const
  {
    return constantLayers > 0 || isotropicFraction > 0 || gapFraction > 0 || normalAngle > 0 ||
      fanAngle > 0 || surfaceAngle >= 0;
  }
};

struct Options
{
  std::vector<std::string> words;    // as they were given
  std::vector<std::string> surfaces; // or one mesh
  std::vector<std::string> wakes;    // files of sheets
  std::string output;
  bool leaveOutSheets = false; // where the output cannot hold them
  std::string report;          // empty: none
  std::string problems;        // empty: none
  bool prisms = false;         // layers of prisms instead of tetrahedra
  std::vector<std::string> walls;
  FlowOptions flow;
  RepairOptions repair;
  double farField = 0; // body lengths on each side; 0: no far field
  bool sphere = false; // the far field is a sphere
  PlaneOption symmetry;
  PlaneOption waterline;
  PlaneOption ground;
  std::vector<SideOption> sides;
  std::vector<MarginOption> margins;                                // in place of farField
  std::vector<std::pair<std::string, std::string>> typesOfPatterns; // of patches
  double featureAngle = -1;                                         // degrees; negative: not given
  std::vector<std::string> keptInsides;                             // patterns of patches
  double size = 0;                                                  // 0: no limit
  double sizeGrowth = 0;                                            // 0: not given
  double radiusEdgeRatio = 0;                                       // 0: not given
  double dihedralAngle = -1;                                        // degrees; negative: not given
  RemeshOptions remesh;
  RefinementOptions refine;
  double swapAngle = -1;  // degrees; 0: the surface triangles are kept; negative: not given
  double firstHeight = 0; // 0: not given
  double growth = 0;      // 0: not given
  double thickness = 0;   // 0: not given
  int layers = 0;         // 0: not given
  std::vector<PatchLayersOption> patchLayers;
  ColumnOptions columns;
  double nonOrthogonality = -1; // degrees; negative: not given
  double timeLimit = 0;         // seconds for each run of TetGen; 0: none
  double memoryLimit = 0;       // MB for each run of TetGen; 0: none
  int threads = 0;              // 0: not given
  bool isotropicOnly = false;
  bool quiet = false;
  bool help = false;
  bool version = false;

  // Whether the chain begins with a mesh from another program.
  bool isMesh() const;
};

// Wrong usage: what() says what is wrong and what to write instead.
struct UsageError : std::runtime_error
{
  using std::runtime_error::runtime_error;
};

// The names of the skin friction laws; places in the list and of the next two are the filters' numbers.
const std::vector<std::string>& frictionLaws();
int fluidOf(const FlowOptions& flow);
int frictionLawOf(const FlowOptions& flow);

// Throws UsageError.
Options parseOptions(const std::vector<std::string>& arguments);

// The text of --help.
std::string helpText();
} // namespace commandline
