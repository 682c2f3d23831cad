// What each vertex is for the geometry of the domain: free in the volume, on a smooth surface, on a
// ridge, or a corner; and the edges that make up the ridges.
#pragma once

#include "Boundary/BoundaryStars.h"
#include "Mesh/TetMesh.h"
#include "Support/Patch.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace ransmesh
{
namespace defaults
{
// Surface edges where the normals turn more than this are ridges even within a patch (degrees).
inline constexpr double featureAngle = 30;
} // namespace defaults

enum class VertexKind : std::uint8_t
{
  Volume,  // no boundary face has it
  Surface, // on the boundary, on no ridge edge
  Ridge,   // exactly two ridge edges meet here, turning by no more than the feature angle
  Corner   // anything else: ends, junctions and kinks of ridges, points where surfaces only touch
};

// The ridge edges, by vertex; changes as edges come and go.
class Ridges
{
public:
  // The other ends of the ridge edges at v, in the order in which they came.
  std::span<const Index> at(Index v) const;
  bool has(Index a, Index b) const;
  // Adding an edge that is there, and removing one that is not, does nothing.
  void add(Index a, Index b);
  void remove(Index a, Index b);
  // Number of vertices that have or had a ridge edge.
  std::size_t vertexCount() const { return ends_.size(); }

private:
  std::vector<Index>& endsOf(Index v);

  std::vector<Index> slot_; // by vertex: its row in ends_, or None
  std::vector<std::vector<Index>> ends_;
};

struct Classification
{
  std::vector<VertexKind> kind; // by vertex
  Ridges ridges;
  std::vector<char> frozen; // by vertex: on a patch of type interface, so it must not go or move
  // The patches at each vertex, each once, ascending: those of vertex v are
  // patchIds[patchStart[v]] to patchIds[patchStart[v + 1] - 1].
  std::vector<std::size_t> patchStart;
  std::vector<int> patchIds;

  std::span<const int> patchesAt(Index v) const
  {
    return { patchIds.data() + patchStart[v], patchIds.data() + patchStart[v + 1] };
  }
};

// Classifies all vertices of a valid mesh from its boundary faces. Ridge edges are those between two
// patches, those where the normals turn more than featureAngle (degrees, 0 to 180), and those that have
// not exactly two boundary faces. Time is linear in the size of the mesh.
Classification classify(
  const TetMesh& mesh, const PatchTable& patches, double featureAngle = defaults::featureAngle);
// The same for those who need the boundary's stars for more than this.
Classification classify(const TetMesh& mesh, const BoundaryStars& stars, const PatchTable& patches,
  double featureAngle = defaults::featureAngle);
} // namespace ransmesh
