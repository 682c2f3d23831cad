#include "Bodies/Lattice.h"

#include <cmath>

namespace bodies
{
namespace
{
using Node = std::array<int, 3>;

class Shell
{
public:
  Shell(SurfaceBuilder& builder, const Lattice& lattice)
    : builder_(builder)
    , lattice_(lattice)
  {
  }

  void run()
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      const int u = (axis + 1) % 3;
      const int v = (axis + 2) % 3;
      for (int level = 0; level <= lattice_.axes[axis].cells(); ++level)
      {
        for (int i = 0; i < lattice_.axes[u].cells(); ++i)
        {
          for (int j = 0; j < lattice_.axes[v].cells(); ++j)
          {
            Node cell{};
            cell[axis] = level;
            cell[u] = i;
            cell[v] = j;
            addFace(cell, axis);
          }
        }
      }
    }
  }

private:
  bool holds(const Node& cell) const
  {
    Vector3 middle;
    for (int i = 0; i < 3; ++i)
    {
      if (cell[i] < 0 || cell[i] >= lattice_.axes[i].cells())
      {
        return false;
      }
      middle[i] = lattice_.axes[i].middle(cell[i]);
    }
    return !lattice_.holds || lattice_.holds(middle);
  }

  // The face below the cell along the axis.
  void addFace(const Node& cell, int axis)
  {
    Node below = cell;
    --below[axis];
    if (holds(cell) == holds(below))
    {
      return;
    }
    const int u = (axis + 1) % 3;
    const int v = (axis + 2) % 3;
    Vector3 middle;
    middle[axis] = lattice_.axes[axis].at(cell[axis]);
    middle[u] = lattice_.axes[u].middle(cell[u]);
    middle[v] = lattice_.axes[v].middle(cell[v]);
    const int patch = lattice_.patchOf(middle);
    if (patch == 0)
    {
      return;
    }
    std::array<Node, 4> corner = { cell, cell, cell, cell };
    ++corner[1][u];
    ++corner[2][u];
    ++corner[2][v];
    ++corner[3][v];
    addSquare(corner, u, v, patch);
  }

  bool isCorner(const Node& n, int u, int v) const
  {
    return lattice_.axes[u].isKey(n[u]) && lattice_.axes[v].isKey(n[v]);
  }

  int preferredDiagonal(const std::array<Node, 4>& n, int u, int v) const
  {
    const bool even = isCorner(n[0], u, v) || isCorner(n[2], u, v);
    const bool odd = isCorner(n[1], u, v) || isCorner(n[3], u, v);
    return even != odd ? (odd ? 1 : 0) : (n[0][u] + n[0][v]) % 2;
  }

  // Diagonals are the shorter ones; where they are equal, they go to the body's corners and alternate elsewhere, so
  // that no direction is preferred.
  void addSquare(const std::array<Node, 4>& n, int u, int v, int patch)
  {
    const double even = distance(place(n[0]), place(n[2]));
    const double odd = distance(place(n[1]), place(n[3]));
    const int first = std::fabs(even - odd) > 1e-6 * even ? (odd < even ? 1 : 0) : preferredDiagonal(n, u, v);
    const Vector3 a = place(n[first]);
    const Vector3 c = place(n[first + 2]);
    builder_.triangle(a, place(n[first + 1]), c, patch);
    builder_.triangle(a, c, place(n[(first + 3) % 4]), patch);
  }

  Vector3 place(const Node& n) const
  {
    const Vector3 p = { lattice_.axes[0].at(n[0]), lattice_.axes[1].at(n[1]), lattice_.axes[2].at(n[2]) };
    return lattice_.map ? lattice_.map(p) : p;
  }

  SurfaceBuilder& builder_;
  const Lattice& lattice_;
};
} // namespace

Axis::Axis(std::vector<double> keys, double size)
  : places_{ keys.front() }
  , key_{ 1 }
{
  for (std::size_t k = 0; k + 1 < keys.size(); ++k)
  {
    const int n = divisions(keys[k + 1] - keys[k], size);
    for (int i = 1; i <= n; ++i)
    {
      places_.push_back(i == n ? keys[k + 1] : keys[k] + (keys[k + 1] - keys[k]) * i / n);
      key_.push_back(i == n ? 1 : 0);
    }
  }
}

void addLattice(SurfaceBuilder& builder, const Lattice& lattice)
{
  Shell(builder, lattice).run();
}
} // namespace bodies
