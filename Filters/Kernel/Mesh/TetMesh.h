// A tetrahedral mesh with neighbours and boundary faces, made to be changed locally.
#pragma once

#include "Mesh/MeshData.h"
#include "Support/Prefetch.h"

#include <array>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace ransmesh
{
// The corners of face f (opposite to corner f), turned inward: (corners of f, vertex f) is positive.
inline constexpr int FaceCorners[4][3] = { { 1, 3, 2 }, { 0, 2, 3 }, { 0, 3, 1 }, { 0, 1, 2 } };

// One side of a face: a face of a tetrahedron (4 * tetrahedron + face), or, negative, a boundary
// face (-(number + 1)).
using HalfFace = Index;
inline constexpr HalfFace halfFace(Index tet, int face)
{
  return 4 * tet + face;
}
inline constexpr Index tetOf(HalfFace h)
{
  return h >> 2;
}
inline constexpr int faceOf(HalfFace h)
{
  return h & 3;
}
inline constexpr bool isBoundary(HalfFace h)
{
  return h < 0;
}
// The boundary face that a negative half-face names, and back.
inline constexpr Index boundaryFaceOf(HalfFace h)
{
  return -h - 1;
}
inline constexpr HalfFace boundaryHalfFace(Index b)
{
  return -b - 1;
}

struct Tetrahedron
{
  std::array<Index, 4> vertex;
  std::array<HalfFace, 4> neighbour;

  bool isAlive() const { return vertex[0] != None; }
  // The corner at which vertex v stands, or -1.
  int cornerOf(Index v) const
  {
    return vertex[0] == v ? 0 : vertex[1] == v ? 1 : vertex[2] == v ? 2 : vertex[3] == v ? 3 : -1;
  }
  bool has(Index v) const { return cornerOf(v) >= 0; }
  // The same for a vertex that it has, without branches, which nobody could guess.
  int cornerOfOwn(Index v) const
  {
    return static_cast<int>(vertex[1] == v) + 2 * static_cast<int>(vertex[2] == v) +
      3 * static_cast<int>(vertex[3] == v);
  }
  // The three vertices of face f, turned inward.
  std::array<Index, 3> face(int f) const
  {
    return { vertex[FaceCorners[f][0]], vertex[FaceCorners[f][1]], vertex[FaceCorners[f][2]] };
  }
};

struct BoundaryFace
{
  HalfFace inner = None; // the tetrahedron's face that it covers; None when free
  int patch = 0;

  bool isAlive() const { return inner != None; }
};

// What was in a mesh's slots before each of its changes, in order, and how many there were before all of them.
struct MeshChanges
{
  std::vector<std::pair<Index, Vector3>> points;
  std::vector<std::pair<Index, Index>> vertexTets;
  std::vector<std::pair<Index, Tetrahedron>> tets;
  std::vector<std::pair<Index, BoundaryFace>> boundary;
  std::vector<Index> freeTets;
  std::vector<Index> freeBoundary;
  std::size_t vertexCount = 0;
  std::size_t tetSlots = 0;
  std::size_t boundarySlots = 0;
};

// Vertices, tetrahedra and boundary faces with stable numbers; dead slots are used again.
class TetMesh
{
public:
  TetMesh() = default;
  // A valid mesh as it is, with the neighbours that matchFaces gives (Mesh/FaceMatching.h): numbers are kept,
  // boundary face i is triangle i.
  TetMesh(const MeshData& data, const std::vector<HalfFace>& opposite);

  const std::vector<Vector3>& points() const { return points_; }
  const Vector3& point(Index v) const { return points_[v]; }
  void movePoint(Index v, const Vector3& x)
  {
    notePoint(v);
    points_[v] = x;
  }
  // Some tetrahedron at v, or None if v is unused.
  Index tetAt(Index v) const { return vertexTet_[v]; }

  std::size_t vertexCount() const { return points_.size(); }
  std::size_t tetSlots() const { return tets_.size(); }
  std::size_t boundarySlots() const { return boundary_.size(); }
  std::size_t liveTets() const { return tets_.size() - freeTets_.size(); }

  const Tetrahedron& tet(Index t) const { return tets_[t]; }
  // Bring a tetrahedron, or a point, into the cache for one who will look at it soon. Walks wait for memory more than
  // for anything else: with this, removal from a sphere and a plate took 6 to 9 % less time.
  void fetchAhead(Index t) const { prefetch(&tets_[t]); }
  void fetchPointAhead(Index v) const { prefetch(&points_[v]); }
  const BoundaryFace& boundaryFace(Index b) const { return boundary_[b]; }
  int patchOf(HalfFace h) const { return boundary_[boundaryFaceOf(h)].patch; }
  // The vertices of boundary face b, turned into the fluid.
  std::array<Index, 3> boundaryVertices(Index b) const
  {
    const HalfFace inner = boundary_[b].inner;
    return tets_[tetOf(inner)].face(faceOf(inner));
  }

  // Raw changes, for the operators of this folder and for bulk writing; they keep no invariants.
  Index addVertex(const Vector3& x);
  void removeLastVertices(std::size_t count);
  Index addTet(const std::array<Index, 4>& vertices);
  void freeTet(Index t);
  Index addBoundaryFace(HalfFace inner, int patch);
  void freeBoundaryFace(Index b);
  void setPatch(Index b, int patch)
  {
    noteBoundaryFace(b);
    boundary_[b].patch = patch;
  }
  void setVertex(Index t, int corner, Index v)
  {
    noteTet(t);
    tets_[t].vertex[corner] = v;
  }
  void setVertexTet(Index v, Index t)
  {
    noteVertexTet(v);
    vertexTet_[v] = t;
  }
  // Makes the two half-faces each other's neighbours; at most one may be a boundary face.
  void link(HalfFace a, HalfFace b);
  // Appends count dead tetrahedra in one piece, to be filled by fillTet; gives the first number.
  Index appendTets(std::size_t count);
  void fillTet(Index t, const Tetrahedron& content)
  {
    noteTet(t);
    tets_[t] = content;
  }

  // A trial: from begin on, until it is kept or undone, the mesh notes what is changed. Undone, it is exactly what it
  // was, numbers of slots and all; what it costs depends on the changes alone. Vertices may come but not go, and
  // one trial ends before the next begins.
  void beginTrial();
  void keepTrial() { trial_.reset(); }
  void undoTrial();

private:
  // Before slot i of these changes.
  template <class Content>
  void note(
    std::vector<std::pair<Index, Content>> MeshChanges::*log, const std::vector<Content>& slots, Index i)
  {
    if (trial_)
    {
      ((*trial_).*log).emplace_back(i, slots[i]);
    }
  }
  void notePoint(Index v) { note(&MeshChanges::points, points_, v); }
  void noteVertexTet(Index v) { note(&MeshChanges::vertexTets, vertexTet_, v); }
  void noteTet(Index t) { note(&MeshChanges::tets, tets_, t); }
  void noteBoundaryFace(Index b) { note(&MeshChanges::boundary, boundary_, b); }

  std::vector<Vector3> points_;
  std::vector<Index> vertexTet_;
  std::vector<Tetrahedron> tets_;
  std::vector<Index> freeTets_;
  std::vector<BoundaryFace> boundary_;
  std::vector<Index> freeBoundary_;
  std::optional<MeshChanges> trial_;
};

// Numbers for the vertices that tetrahedra use, from 0 to count - 1, in order; None for the others.
std::vector<Index> numberUsedVertices(const TetMesh& mesh, Index& count);

// Appends the live tetrahedra, in order, with their vertices' new numbers.
void appendLiveTets(
  const TetMesh& mesh, const std::vector<Index>& newNumber, std::vector<std::array<Index, 4>>& tets);

// The mesh as plain arrays: unused vertices and dead slots dropped, everything else in order of number,
// triangles sorted by patch. newNumber, if given, receives each vertex's number in the result, or None.
MeshData toMeshData(const TetMesh& mesh, std::vector<Index>* newNumber = nullptr);
} // namespace ransmesh
