// Fills a small polyhedron with tetrahedra between its own corners, in any way that there is.
//
// A search that takes back its steps (J. Liu, B. Chen, S. Sun, Small polyhedron reconnection, IMR 2006; C. Marot,
// K. Verhetsel, J.-F. Remacle, Reviving the search for optimal tetrahedralizations, IMR 2019): it finds what no
// sequence of collapses and swaps comes to, and where it has been through all without a find, there is no such filling.
#pragma once

#include "Geometry/Vector3.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace ransmesh
{
class CavityFilling
{
public:
  // More points would need too much memory.
  static constexpr int MostPoints = 64;

  enum class Verdict
  {
    Filled,
    Impossible, // there is no filling
    GivenUp     // after as many steps as were allowed
  };

  // Turns to a polyhedron: faces by the numbers of their points, turned inward. Points that are on no face lie inside,
  // and every filling has them.
  void turnTo(std::span<const Vector3> points, std::span<const std::array<int, 3>> faces);

  // Looks for a filling by exactly positive tetrahedra whose quality is above floor, in so many steps, each of
  // which sets one tetrahedron.
  Verdict fill(double floor, std::size_t steps);
  // How many of these it did not need.
  std::size_t stepsLeft() const { return steps_; }

  // After Filled.
  const std::vector<std::array<int, 4>>& tets() const { return tets_; }

private:
  using Side = std::array<int, 3>; // a triangle from one of its sides

  enum State : char
  {
    Free,
    Open, // a tetrahedron is wanted here
    Taken // one stands here, or the polyhedron ends
  };
  // An open side, and the points from which a tetrahedron may stand on it: bit i for point i.
  struct OpenSide
  {
    Side side;
    std::uint64_t apexes;
  };
  using OpenSides = std::vector<OpenSide>;
  struct Change
  {
    std::size_t slot;
    State before;
  };

  static constexpr signed char Unknown = 2;
  static constexpr float NotLooked = 2; // no quality

  int orientationOf(std::array<int, 4> corners);
  static std::size_t slotOf(Side side);
  static std::array<Side, 4> sidesOf(const Side& base, int apex);
  float usableQuality(const Side& base, int apex);
  bool holdsPoint(const Side& base, int apex);
  bool meets(const Side& base, int apex, const Side& side);
  bool isParted(const std::array<int, 4>& tet, const Side& side);
  bool isBehind(const Side& side, const Side& other);
  bool crosses(int from, int to, const Side& triangle);
  bool isFree(const Side& base, int apex) const;
  std::uint64_t apexesOn(const Side& base, const OpenSides& besides);
  bool search(const OpenSides& open);
  std::vector<int> apexesInOrder(const OpenSide& open);
  void set(const Side& base, int apex, std::vector<Side>& fresh);
  bool goOn(const OpenSides& open, const std::vector<Side>& fresh, OpenSides& next);
  void takeBack(std::size_t changes);
  void change(std::size_t slot, State state);

  std::vector<Vector3> points_;
  std::vector<Side> faces_;
  std::vector<signed char> orientation_; // by four points in order
  std::vector<float> quality_;           // of the tetrahedron of four points: 0 where it cannot be
  std::vector<State> state_;             // by slot
  std::vector<Change> changes_;          // of the states
  std::vector<std::array<int, 4>> tets_;
  double floor_ = 0;
  std::size_t steps_ = 0;
};
} // namespace ransmesh
