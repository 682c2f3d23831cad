// Where the surface was before points were taken from it.
//
// Every change turns the surface by no more than its angle, but changes add up: on a round wall each removal
// cuts off a little more. So the points that were lost are remembered, each at the vertex whose triangles
// cover it now, and whatever comes next must stay as near to all of them.
#pragma once

#include "Mesh/TetMesh.h"

#include <array>
#include <span>
#include <unordered_map>
#include <vector>

namespace ransmesh
{
// How far a surface may come away from a point that it loses, times the length of the edges there: walls with
// layers keep their shape, curved patches that adjoin them give way.
inline constexpr double largestWallDrift = 0.05;
inline constexpr double largestSideDrift = 0.1;

class SurfaceMemory
{
public:
  // A triangle; or an edge of a ridge, with its second end twice.
  using Piece = std::array<Index, 3>;

  explicit SurfaceMemory(const TetMesh& mesh)
    : mesh_(mesh)
  {
  }

  // May the old pieces be replaced by the new ones, all of which have the apex, so that these points of
  // them are lost? They may lie so far from what is there now, and from all that comes later.
  bool allows(std::span<const Piece> old, std::span<const Piece> replacement, std::span<const Vector3> lost,
    double allowed, Index apex);

  // The pieces that were asked for last have been replaced.
  void remember();

private:
  struct LostPoint
  {
    Vector3 place;
    double allowed = 0; // distance
  };

  double distanceTo(std::span<const Piece> pieces, const Vector3& p) const;
  bool takeAlong(std::span<const Piece> replacement, const LostPoint& point);
  void collectHolders(std::span<const Piece> old);

  const TetMesh& mesh_;
  std::unordered_map<Index, std::vector<LostPoint>> held_; // by vertex
  // Of the last question.
  Index apex_ = None;
  std::vector<Index> holders_;
  std::vector<LostPoint> taken_;             // come to the apex
  std::vector<std::vector<LostPoint>> left_; // stay at each holder
};
} // namespace ransmesh
