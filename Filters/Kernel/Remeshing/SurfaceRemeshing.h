// A new triangulation of a surface, with triangles of wanted sizes.
#pragma once

#include "Support/Context.h"
#include "Support/Outcome.h"
#include "Triangles/SurfaceMesh.h"

#include <cstddef>
#include <functional>
#include <vector>

namespace ransmesh
{
// On which side of the surface gaps are looked for; the surface must be closed for one alone.
enum class GapSide
{
  Both,
  Outside, // away from what it encloses: bodies in a flow
  Inside   // the domain that it encloses
};

// Lengths in the unit of the surface.
struct RemeshingOptions
{
  double length = 0;                // largest edge; 0: a tenth of the patch's extent
  std::vector<double> patchLengths; // by patch number, in place of `length` where above 0
  double edgesPerCircle = 0; // edges of a full circle where the surface or a line is curved; 0: no matter
  double edgesAcrossGap = 0; // how often an edge is to fit in a gap; 0: no matter
  GapSide gapSide = GapSide::Both;
  double smallest = 0;      // curvature and gaps ask for no smaller edges; 0: a hundredth of the largest
  double slope = 0.3;       // edges grow by this times the distance along the surface, at most
  double featureAngle = 30; // degrees: where the surface turns by more, edges are kept as lines
  // How far a new triangle may lie from the given surface; 0: a twentieth of the wanted edge.
  double deviation = 0;
  std::function<double(const Vector3&)> limit; // a largest edge by place; may be empty
  std::vector<double> pointLengths;            // a largest edge at each given point; may be empty
  std::vector<char> keptPatches;               // by patch number: these stay as they are; may be empty

  // Whether any size is asked for.
  bool isWanted() const
  {
    return length > 0 || edgesPerCircle > 0 || edgesAcrossGap > 0 || !patchLengths.empty() ||
      !pointLengths.empty();
  }
};

struct RemeshingReport
{
  std::size_t trianglesBefore = 0;
  std::size_t trianglesAfter = 0;
  double smallestAngle = 0; // of a new triangle, degrees
  double lowAngle = 0;      // a hundredth of the new triangles has a smaller one; degrees
  // Between the given surface and the new one, either way, at points and middles of triangles and edges.
  double largestDeviation = 0;
  Vector3 deviationPlace;
  double meanDeviation = 0;
};

// Replaces the triangles by nearly equilateral ones of the wanted sizes: splits and collapses of edges, swaps
// of diagonals and movement along the surface in turn (M. Botsch, L. Kobbelt, A remeshing approach to
// multiresolution modeling, SGP 2004), by a field of sizes (as M. Dunyach et al., Adaptive remeshing for
// real-time mesh deformation, Eurographics 2013) that is found anew in each round.
// Points lie on the given surface, within their patch. Edges where the surface turns by more than the feature
// angle, borders of patches and of the surface, and edges where more than two triangles meet, are kept as
// lines, on which points lie too; where two lines run side by side nearer than the wanted edges, edges follow the
// width of the strip between them, down to a tenth of what is wanted. Where lines end, meet or bend by more than the
// angle, points stay. No triangle turns from the given surface by more than 30 degrees, or lies farther from it than
// the options say, unless it did so before. Where the surface cuts itself afterwards, or nearly touches itself and did
// not before, it is done again with a quarter of the deviation allowed, four times at most; whether it cuts itself
// then is to be checked.
// BadInput, with the surface unchanged, where it would have more than 20 million triangles.
Outcome remeshSurface(SurfaceMesh& surface, const RemeshingOptions& options, RemeshingReport& report,
  const Context& context = {});
} // namespace ransmesh
