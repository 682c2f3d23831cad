// The one operator that changes a mesh: star(C, q, S).
//
// Take out the connected set of tetrahedra C, put in the tetrahedra that join its outer faces to the
// vertex q (new or existing); S are the boundary faces that go and are starred again from q. Insertion,
// edge collapse, removal of vertices and swaps are all of this form (NASA refine's ref_cavity does the
// same). Decide first, act after: a refusal changes nothing and has a name.
#pragma once

#include "Mesh/LocalNumbers.h"
#include "Mesh/TetMesh.h"

#include <array>
#include <cstdint>
#include <vector>

namespace ransmesh
{
struct Cavity
{
  std::vector<Index> tets;         // connected through faces; doubles are harmless
  std::vector<Index> starredFaces; // boundary faces of tets that go, chosen by topology and patch
};

enum class StarVerdict
{
  Possible,
  Empty,           // no tetrahedron would come
  NotPositive,     // a new tetrahedron would not be exactly positive
  EdgeNotManifold, // an edge of the cavity's boundary has not exactly two faces
  GluedToNothing,  // a boundary face would lose its tetrahedron
  Count
};

const char* nameOf(StarVerdict verdict);

class Star
{
public:
  explicit Star(TetMesh& mesh)
    : mesh_(mesh)
  {
  }

  // May the cavity be starred from the apex? After Possible, newTets, lostVertices and apply are valid
  // until the mesh is changed. Whether vertices may be lost is for the caller to judge.
  StarVerdict check(const Cavity& cavity, Index apex);

  // The tetrahedra that would come, apex last.
  const std::vector<std::array<Index, 4>>& newTets() const { return newTets_; }
  // The cavity's vertices that no face of the result would have, the apex apart.
  const std::vector<Index>& lostVertices() const { return lost_; }

  // Does what check found possible; gives the new tetrahedra's numbers.
  const std::vector<Index>& apply();

private:
  enum class Kind
  {
    New,     // gets a tetrahedron
    Starred, // boundary face that goes
    Glued    // has the apex already: its neighbour meets what stands beyond the opposite edge
  };
  struct OuterFace
  {
    HalfFace inside; // the cavity tetrahedron's face
    HalfFace beyond; // what lies on its other side
    std::array<Index, 3> vertex;
    Kind kind;
    Index created; // number in newTets_, or None
  };
  struct EdgeUse // an edge of an outer face, opposite to its corner
  {
    Index face;
    int corner;
  };
  struct Edge // of two outer faces
  {
    std::uint64_t ends; // the lower and the higher one in one number
    EdgeUse first;
    EdgeUse second;
    int uses;
  };

  void collectTets(const Cavity& cavity);
  void collectFaces(const Cavity& cavity, Index apex);
  bool allPositive(Index apex) const;
  bool pairEdges(Index apex);
  bool someGluedToNothing() const;
  void findLostVertices(Index apex);
  void sortBoundaryEdges();
  HalfFace createdSide(const EdgeUse& use) const;
  void join(const EdgeUse& first, const EdgeUse& second);

  TetMesh& mesh_;
  LocalMarks inCavity_;
  LocalMarks isStarred_;
  LocalMarks kept_;
  std::vector<Index> tets_;
  std::vector<OuterFace> faces_;
  LocalNumbersOf<std::uint64_t> edgeNumbers_; // by their ends
  std::vector<Edge> edges_;
  std::vector<std::array<Index, 4>> newTets_;
  std::vector<Index> lost_;
  std::vector<Index> created_;
};
} // namespace ransmesh
