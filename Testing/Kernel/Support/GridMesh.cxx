#include "Support/GridMesh.h"

#include "Mesh/TetMesh.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <set>

namespace grid_mesh
{
namespace
{
class Builder
{
public:
  Builder(const Grid& grid, const PatchOf& patchOf)
    : grid_(grid)
    , patchOf_(patchOf)
    , size_{ grid.nx, grid.ny, grid.nz }
  {
  }

  MeshData run()
  {
    addPoints();
    forEachCell([this](const std::array<int, 3>& cell) { addCell(cell); });
    sortByPatch();
    return std::move(mesh_);
  }

private:
  using Node = std::array<int, 3>;

  Index number(const Node& n) const { return (n[2] * (size_[1] + 1) + n[1]) * (size_[0] + 1) + n[0]; }

  void addPoints()
  {
    std::mt19937 random(grid_.seed);
    std::uniform_real_distribution<double> shift(-grid_.jitter, grid_.jitter);
    for (int k = 0; k <= size_[2]; ++k)
    {
      for (int j = 0; j <= size_[1]; ++j)
      {
        for (int i = 0; i <= size_[0]; ++i)
        {
          const Node n = { i, j, k };
          Vector3 p;
          for (int axis = 0; axis < 3; ++axis)
          {
            const bool inside = n[axis] > 0 && n[axis] < size_[axis];
            p[axis] = (n[axis] + (inside ? shift(random) : 0)) / size_[axis];
          }
          unit_.push_back(p);
          mesh_.points.push_back(grid_.map ? grid_.map(p) : p);
        }
      }
    }
  }

  template <class Visit>
  void forEachCell(Visit visit)
  {
    for (int k = 0; k < size_[2]; ++k)
    {
      for (int j = 0; j < size_[1]; ++j)
      {
        for (int i = 0; i < size_[0]; ++i)
        {
          visit(Node{ i, j, k });
        }
      }
    }
  }

  // A tetrahedron for each order in which the three steps from corner to corner can be taken.
  void addCell(const Node& cell)
  {
    std::array<int, 3> axes = { 0, 1, 2 };
    do
    {
      std::array<Node, 4> node = { cell, cell, cell, cell };
      for (int step = 0; step < 3; ++step)
      {
        for (int later = step + 1; later < 4; ++later)
        {
          ++node[later][axes[step]];
        }
      }
      const bool even = axes[1] == (axes[0] + 1) % 3;
      if (!even)
      {
        std::swap(node[2], node[3]);
      }
      mesh_.tetrahedra.push_back({ number(node[0]), number(node[1]), number(node[2]), number(node[3]) });
      addBoundary(node);
    } while (std::next_permutation(axes.begin(), axes.end()));
  }

  void addBoundary(const std::array<Node, 4>& node)
  {
    constexpr int outward[4][3] = { { 1, 2, 3 }, { 0, 3, 2 }, { 0, 1, 3 }, { 0, 2, 1 } };
    for (const auto& f : outward)
    {
      for (int axis = 0; axis < 3; ++axis)
      {
        for (const int end : { 0, size_[axis] })
        {
          if (std::all_of(f, f + 3, [&](int c) { return node[c][axis] == end; }))
          {
            addTriangle({ number(node[f[0]]), number(node[f[1]]), number(node[f[2]]) },
              static_cast<Side>(2 * axis + (end == 0 ? 1 : 2)));
          }
        }
      }
    }
  }

  void addTriangle(const std::array<Index, 3>& t, Side side)
  {
    const Vector3 middle = (1.0 / 3) * (unit_[t[0]] + unit_[t[1]] + unit_[t[2]]);
    mesh_.triangles.push_back(t);
    mesh_.trianglePatch.push_back(patchOf_ ? patchOf_(side, middle) : side);
  }

  void sortByPatch()
  {
    std::vector<std::size_t> order(mesh_.triangles.size());
    std::iota(order.begin(), order.end(), 0);
    std::stable_sort(order.begin(), order.end(),
      [this](std::size_t a, std::size_t b) { return mesh_.trianglePatch[a] < mesh_.trianglePatch[b]; });
    MeshData sorted;
    for (const std::size_t i : order)
    {
      sorted.triangles.push_back(mesh_.triangles[i]);
      sorted.trianglePatch.push_back(mesh_.trianglePatch[i]);
    }
    mesh_.triangles.swap(sorted.triangles);
    mesh_.trianglePatch.swap(sorted.trianglePatch);
  }

  const Grid& grid_;
  const PatchOf& patchOf_;
  std::array<int, 3> size_;
  std::vector<Vector3> unit_;
  MeshData mesh_;
};
} // namespace

MeshData make(const Grid& grid, const PatchOf& patchOf)
{
  return Builder(grid, patchOf).run();
}

ransmesh::PatchTable patches(ransmesh::PatchType type, int count)
{
  ransmesh::PatchTable table(static_cast<std::size_t>(count) + 1, { "side", type });
  const char* names[] = { "fluid", "x_low", "x_high", "y_low", "y_high", "z_low", "z_high" };
  for (std::size_t i = 0; i < table.size(); ++i)
  {
    table[i].name = i < 7 ? names[i] : "patch_" + std::to_string(i);
  }
  return table;
}

int addSheet(MeshData& mesh, const std::function<bool(const Vector3& middle)>& choice)
{
  const int patch = *std::max_element(mesh.trianglePatch.begin(), mesh.trianglePatch.end()) + 1;
  std::set<std::array<Index, 3>> seen;
  for (const auto& tet : mesh.tetrahedra)
  {
    for (const auto& corner : ransmesh::FaceCorners)
    {
      const std::array<Index, 3> face = { tet[corner[0]], tet[corner[1]], tet[corner[2]] };
      const Vector3 middle = (1.0 / 3) * (mesh.points[face[0]] + mesh.points[face[1]] + mesh.points[face[2]]);
      std::array<Index, 3> key = face;
      std::sort(key.begin(), key.end());
      if (choice(middle) && seen.insert(key).second)
      {
        mesh.triangles.push_back(face);
        mesh.trianglePatch.push_back(patch);
      }
    }
  }
  return patch;
}

namespace
{
// Drops the points that nothing uses.
void dropUnused(MeshData& mesh)
{
  std::vector<Index> number(mesh.points.size(), ransmesh::None);
  std::vector<Vector3> points;
  const auto renumber = [&](auto& cells)
  {
    for (auto& cell : cells)
    {
      for (Index& v : cell)
      {
        if (number[v] == ransmesh::None)
        {
          number[v] = static_cast<Index>(points.size());
          points.push_back(mesh.points[v]);
        }
        v = number[v];
      }
    }
  };
  renumber(mesh.tetrahedra);
  renumber(mesh.triangles);
  mesh.points.swap(points);
}
} // namespace

int carve(MeshData& mesh, const std::function<bool(const Vector3& middle)>& choice)
{
  const int patch = *std::max_element(mesh.trianglePatch.begin(), mesh.trianglePatch.end()) + 1;
  MeshData kept;
  kept.points = mesh.points;
  std::set<std::array<Index, 3>> gone; // faces of what was taken out
  std::set<std::array<Index, 3>> left;
  const auto keyOf = [](std::array<Index, 3> face)
  {
    std::sort(face.begin(), face.end());
    return face;
  };
  for (const auto& t : mesh.tetrahedra)
  {
    const Vector3 middle =
      0.25 * (mesh.points[t[0]] + mesh.points[t[1]] + mesh.points[t[2]] + mesh.points[t[3]]);
    const bool isGone = choice(middle);
    for (const auto& corner : ransmesh::FaceCorners)
    {
      (isGone ? gone : left).insert(keyOf({ t[corner[0]], t[corner[1]], t[corner[2]] }));
    }
    if (!isGone)
    {
      kept.tetrahedra.push_back(t);
    }
  }
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i)
  {
    if (left.count(keyOf(mesh.triangles[i])))
    {
      kept.triangles.push_back(mesh.triangles[i]);
      kept.trianglePatch.push_back(mesh.trianglePatch[i]);
    }
  }
  for (const auto& t : kept.tetrahedra)
  {
    for (const auto& corner : ransmesh::FaceCorners)
    {
      const std::array<Index, 3> inward = { t[corner[0]], t[corner[1]], t[corner[2]] };
      if (gone.count(keyOf(inward)))
      {
        kept.triangles.push_back({ inward[0], inward[2], inward[1] });
        kept.trianglePatch.push_back(patch);
      }
    }
  }
  dropUnused(kept);
  mesh = std::move(kept);
  return patch;
}

Vector3 turned(const Vector3& p)
{
  const auto turn = [](double& a, double& b, double angle)
  {
    const double x = a;
    a = std::cos(angle) * x - std::sin(angle) * b;
    b = std::sin(angle) * x + std::cos(angle) * b;
  };
  Vector3 q = p;
  turn(q.x, q.y, 0.7);
  turn(q.y, q.z, 0.4);
  turn(q.x, q.z, 1.1);
  return q;
}
} // namespace grid_mesh
