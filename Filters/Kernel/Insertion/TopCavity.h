// The cavity that a top's ball, or a part of it, becomes where it is starred from one of its vertices.
#pragma once

#include "Improvement/FaceView.h"
#include "Layers/Column.h"
#include "Mesh/Star.h"

#include <span>
#include <vector>

namespace ransmesh
{
class TopCavity
{
public:
  explicit TopCavity(const TetMesh& mesh)
    : mesh_(mesh)
  {
  }

  // Begins with these tetrahedra. What follows holds until the mesh changes there; near is a point close by.
  void begin(std::span<const Index> seed, const Vector3& near);

  // Lets the cavity grow through all faces from which the apex would make a quality not above wanted, to at most
  // largest tetrahedra; boundary faces in the sides of the column, if one is given, go with it. False where that does
  // not help. Rounded: exact positivity is for the caller to check.
  bool grow(Index apex, double wanted, std::size_t largest, const Column* ofSides);

  const Cavity& cavity() const { return cavity_; }
  // The worst quality that starring the cavity would make.
  double worst() const { return worst_; }

private:
  struct Face
  {
    bool has(Index v) const { return vertex[0] == v || vertex[1] == v || vertex[2] == v; }

    std::array<Index, 3> vertex;
    HalfFace beyond;
    bool isReady; // has it a view?
  };

  void addFaces(Index tet);
  const FaceView& viewOf(std::size_t face);
  void undoGrowth();
  bool hasGrown() const { return cavity_.tets.size() > seedTets_; }
  // Of what no seed has taken.
  bool isGrown(HalfFace h) const { return hasGrown() && !isBoundary(h) && inGrown_.test(tetOf(h)); }
  bool goes(const Face& face, const Column* ofSides) const;

  const TetMesh& mesh_;
  Vector3 near_;
  LocalMarks inSeed_;
  LocalMarks inGrown_;
  std::vector<Face>
    faces_; // those on the boundary first: beyond them nothing grows, so that they refuse most often
  std::vector<FaceView> views_; // of faces that were asked from some apex
  std::vector<double> square_;  // of the quality from the apex, by face
  std::size_t seedFaces_ = 0;
  std::size_t seedTets_ = 0;
  Cavity cavity_;
  double worst_ = 0;
};
} // namespace ransmesh
