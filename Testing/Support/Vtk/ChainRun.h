// A surface put through the filters one after the other, and what the layers became.
#pragma once

#include <vtkSmartPointer.h>

#include <array>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace bodies
{
struct Body;
struct Case;
struct Layers;
} // namespace bodies
class vtkPolyData;
class vtkUnstructuredGrid;

namespace chain_run
{
struct PatchLayers
{
  std::string pattern;
  double firstHeight = 0;
  double growth = 1.2;
  int layers = 25;
};

struct ChainOptions
{
  bool farField = false;
  std::vector<std::string> walls; // patterns; none: all patches of type wall
  double firstHeight = 1e-5;
  double growth = 1.2;
  int layers = 25;
  std::vector<PatchLayers> patchLayers;
  double surfaceSize = 0; // to which the surface is remeshed; 0: kept
  double swapAngle = 10;  // how far swaps of the surface's diagonals may turn it, degrees; 0: all are kept
  std::optional<double> symmetryPlace; // the fluid ends in a plane of symmetry across z there
};

// The layers of a case on its body.
ChainOptions optionsFor(const bodies::Case& c, const bodies::Layers& layers, const bodies::Body& body);

struct ChainResult
{
  vtkSmartPointer<vtkUnstructuredGrid> mesh;
  std::array<double, 3> seconds{}; // mesher, removal, enrichment
  vtkIdType marked = 0;            // points that removal was to take out
  vtkIdType removed = 0;
  vtkIdType ofShape = 0;   // points that stay because the surface's shape needs them
  vtkIdType requested = 0; // points of layers, after the limits
  vtkIdType inserted = 0;
  vtkIdType asked = 0; // the same before the limits
  vtkIdType columns = 0;
  vtkIdType fullColumns = 0;
  std::map<std::string, int> stopReasons; // columns by reason
  std::vector<int> walls;                 // patch numbers
  std::vector<int> sheets;                // patch numbers of those that lie in the fluid
  vtkIdType tetrahedra = 0;
  vtkIdType layerTetrahedra = 0;
  vtkIdType over175 = 0; // of these, by their largest dihedral angle
  vtkIdType over179 = 0;
  double largestAngle = 0;        // in the layers, degrees
  double largestAngleOutside = 0; // in the other tetrahedra
  double copiesOfWallFaces =
    0; // share of the copies of wall triangles, at all levels asked for, that are faces
  double areaWithFirstHeight = 0;    // share of the walls' area, within a tenth of the height asked for
  double areaAwayFromGaps = 0;       // the same of the triangles that no gap touches
  double columnsWithTheirLayers = 0; // share, at smooth points, that are full or have what a gap leaves
  double growthOff = 0;              // of the growth rate between levels, as a share, at the 99th percentile
  double volume = 0;                 // of the fluid as the mesher left it
  // How much of the fluid's volume came or went in each stage, as a share: nothing where sides are plane.
  double volumeChangeByRemoval = 0;
  double volumeChange = 0; // by the enrichment
  std::string faults;      // what is not valid; empty: nothing
};

// Throws std::runtime_error with the message of the stage that fails.
ChainResult runChain(vtkPolyData* surface, const ChainOptions& options);
// The same with the body's sheets and far field.
ChainResult runChain(const bodies::Body& body, ChainOptions options);
} // namespace chain_run
