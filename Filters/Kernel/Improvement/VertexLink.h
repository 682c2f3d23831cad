// What is seen from a vertex: its ball with the outer faces in compact local numbers, so that many ways
// to star it can be judged quickly.
#pragma once

#include "Boundary/BoundaryRules.h"
#include "Improvement/FacePair.h"
#include "Improvement/FaceView.h"
#include "Mesh/LocalNumbers.h"
#include "Mesh/TetMesh.h"
#include "Support/Scratch.h"

#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

namespace ransmesh
{
class VertexLink
{
public:
  explicit VertexLink(const TetMesh& mesh)
    : mesh_(mesh)
  {
  }

  // Turns to vertex v, which must be used. What follows holds until the mesh changes there.
  void turnTo(Index v);

  // The tetrahedra at v.
  std::span<const Index> ball() const { return ball_.view(); }
  // The other ends of the edges at v, numbered locally.
  std::span<const Index> ends() const { return ends_.view().first(endsAtV_); }
  // By local number: the ends as seen from v.
  std::span<const Vector3> places() const { return places_.view().first(endsAtV_); }

  // The worst quality (Geometry/TetrahedronMeasures.h) in the ball as it is.
  double worst() const;
  // The worst quality if v were collapsed onto the end with this local number; gives up, with floor or
  // less, as soon as one tetrahedron is not better than floor. Rounded: exact positivity is for the
  // caller to check.
  double worstFrom(int apex, double floor);
  // Whether all tetrahedra of that collapse are positive in exact arithmetic.
  bool allPositiveFrom(int apex) const;
  // How many tetrahedra of that collapse would be no better than floor; gives up, with `most` or more, as soon as
  // there are so many.
  std::size_t countPoor(int apex, double floor, std::size_t most) const;

  // The ball grows beyond every face that sees the apex no better than floor, by at most budget
  // tetrahedra; boundary faces that see it so are starred where the rules allow it. Gives the worst
  // quality then, or floor where that does not help. What was grown holds until the next grow or turn.
  double grow(int apex, double floor, std::size_t budget, const BoundaryRules& rules);
  const std::vector<Index>& grownTets() const { return grown_; }
  const std::vector<Index>& grownStarred() const { return starred_; }

private:
  // An outer face of what is to be starred: first the faces opposite to v, one for each tetrahedron of the ball.
  struct Face
  {
    bool has(int end) const { return corner[0] == end || corner[1] == end || corner[2] == end; }

    FacePair::Corners corner; // local numbers
    HalfFace beyond;
  };
  // How the walk over the ball comes to a tetrahedron.
  struct Entry
  {
    int corner; // the one that the tetrahedron before does not have
    int next;   // local numbers of the two that follow it in the face opposite to v
    int last;
  };
  // A cavity that grows.
  struct Growth
  {
    int apex;
    double floorSquare;
    std::size_t budget;
    double worst; // square, with its sign
  };

  void collectBall(Index v);
  void enterBall(Index v);
  void leaveThrough(HalfFace face, int next, int last);
  void placeEnds();
  void pairFaces();
  double worstFrom(const Viewpoint& from) const;
  void undoGrowth();
  bool growAt(std::size_t face, double square, Growth& growth, const BoundaryRules& rules);
  void growBeyond(HalfFace face);
  void addGrownFace(const Tetrahedron& tet, int corner);
  bool isInside(HalfFace h) const
  {
    return !isBoundary(h) && (inBall_.test(tetOf(h)) || inGrown_.test(tetOf(h)));
  }
  Viewpoint viewFrom(int apex) const { return { apex, places_[apex], squares_[apex] }; }
  // There must be room for one more end.
  int localNumber(Index end)
  {
    const int number = numbers_.add(end);
    ends_.addIf(number == static_cast<int>(ends_.size()), end);
    mesh_.fetchPointAhead(end);
    return number;
  }

  const TetMesh& mesh_;
  Scratch<Index> ball_;
  Scratch<Entry> entries_; // of ball_
  Scratch<Index> ends_;
  Scratch<Vector3> places_; // as seen from v
  Scratch<double> squares_; // of places_
  Scratch<Face> faces_;
  Scratch<FacePair> pairs_;      // of the ball's faces; where their number is odd, the last one twice
  Scratch<FaceView> grownViews_; // of the other ones
  Scratch<std::uint32_t> asked_; // the pairs, those that refuse often first
  LocalMarks inBall_;
  LocalMarks inGrown_;
  LocalNumbers numbers_; // of ends_
  std::vector<Index> grown_;
  std::vector<Index> starred_;
  std::size_t endsAtV_ = 0;
  Vector3 centre_;
};
} // namespace ransmesh
