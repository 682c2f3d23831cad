#include "Mesh/SpatialRenumbering.h"

#include "Geometry/SpatialOrder.h"
#include "Mesh/Tidying.h"

#include <algorithm>
#include <numeric>

namespace ransmesh
{
namespace
{
std::vector<Index> counting(std::size_t count)
{
  std::vector<Index> numbers(count);
  std::iota(numbers.begin(), numbers.end(), 0);
  return numbers;
}

template <class Value>
void reorder(const std::vector<Index>& order, std::vector<Value>& values)
{
  std::vector<Value> reordered;
  reordered.reserve(values.size());
  for (const Index i : order)
  {
    reordered.push_back(values[i]);
  }
  values.swap(reordered);
}

template <class Cell>
std::vector<Index> orderBySmallestPoint(const std::vector<Cell>& cells)
{
  std::vector<Index> order = counting(cells.size());
  std::vector<Index> smallest(cells.size());
  std::transform(cells.begin(), cells.end(), smallest.begin(),
    [](const Cell& cell) { return *std::min_element(cell.begin(), cell.end()); });
  std::stable_sort(
    order.begin(), order.end(), [&smallest](Index a, Index b) { return smallest[a] < smallest[b]; });
  return order;
}
} // namespace

void renumberSpatially(MeshData& mesh)
{
  std::vector<Index> order = counting(mesh.points.size());
  sortSpatially(mesh.points, order);
  std::vector<Index> number(order.size());
  for (std::size_t i = 0; i < order.size(); ++i)
  {
    number[order[i]] = static_cast<Index>(i);
  }
  reorder(order, mesh.points);
  renumberCorners(number, mesh);
  reorder(orderBySmallestPoint(mesh.tetrahedra), mesh.tetrahedra);
  const std::vector<Index> triangles = orderBySmallestPoint(mesh.triangles);
  reorder(triangles, mesh.triangles);
  reorder(triangles, mesh.trianglePatch);
}
} // namespace ransmesh
