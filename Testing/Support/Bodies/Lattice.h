// Bodies made of the cells of a rectangular lattice.
#pragma once

#include "Bodies/SurfaceBuilder.h"

#include <functional>

namespace bodies
{
// A coordinate axis: its key places, between which it is divided.
class Axis
{
public:
  Axis(std::vector<double> keys, double size);

  int cells() const { return static_cast<int>(places_.size()) - 1; }
  double at(int i) const { return places_[i]; }
  double middle(int cell) const { return (places_[cell] + places_[cell + 1]) / 2; }
  bool isKey(int i) const { return key_[i] != 0; }

private:
  std::vector<double> places_;
  std::vector<char> key_;
};

struct Lattice
{
  std::array<Axis, 3> axes;
  // Whether the body holds the cell with this centre; none: it holds all.
  std::function<bool(const Vector3&)> holds;
  // The patch of the face with this centre; 0 leaves it out.
  std::function<int(const Vector3&)> patchOf;
  std::function<Vector3(const Vector3&)> map; // none: as it is
};

// The faces between cells that the body holds and those that it does not, each cut in two.
void addLattice(SurfaceBuilder& builder, const Lattice& lattice);
} // namespace bodies
