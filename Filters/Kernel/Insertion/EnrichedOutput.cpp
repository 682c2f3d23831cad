#include "Insertion/EnrichedOutput.h"

#include "Insertion/FanFaces.h"
#include "Insertion/LayerStacks.h"
#include "Insertion/TensorStacks.h"
#include "Support/LargeMemory.h"

#include <algorithm>
#include <numeric>

namespace ransmesh
{
namespace
{
// Wall vertices are their columns' tops in the mesh beyond: the wall itself keeps the numbers given, the tops get
// those of their columns' last levels.
std::vector<Index> numberFront(
  const ColumnSet& set, const ColumnPoints& numbers, const std::vector<Index>& baseNumber)
{
  std::vector<Index> number = baseNumber;
  for (std::size_t i = 0; i < set.columns.size(); ++i)
  {
    const Column& c = set.columns[i];
    number[c.vertex] = numbers.at(static_cast<Index>(i), c.levels);
  }
  return number;
}

// What stands on a boundary face; a grid brings other triangles in its place.
enum class OnFace : char
{
  Nothing,
  Stack,
  Grid
};

// Triangles that carry layers stay on the wall, all others go with the front.
void addTriangles(const TetMesh& mesh, const ColumnSet& set, const std::vector<Index>& baseNumber,
  const std::vector<Index>& frontNumber, const std::vector<OnFace>& onFace, MeshData& data)
{
  for (std::size_t i = 0; i < mesh.boundarySlots(); ++i)
  {
    const auto b = static_cast<Index>(i);
    if (!mesh.boundaryFace(b).isAlive() || mesh.boundaryFace(b).patch == FrontOnly ||
      onFace[i] == OnFace::Grid)
    {
      continue;
    }
    const bool onWall = onFace[i] == OnFace::Stack;
    const auto place = [&](Index v) { return onWall ? baseNumber[set.rootOf(v)] : frontNumber[v]; };
    const auto inward = mesh.boundaryVertices(b);
    data.triangles.push_back({ place(inward[0]), place(inward[2]), place(inward[1]) });
    data.trianglePatch.push_back(mesh.boundaryFace(b).patch);
  }
}

void addMeshPoints(const TetMesh& mesh, const std::vector<Index>& baseNumber, EnrichedMesh& result)
{
  for (std::size_t v = 0; v < baseNumber.size(); ++v)
  {
    if (baseNumber[v] != None)
    {
      result.mesh.points.push_back(mesh.point(static_cast<Index>(v)));
      result.column.push_back(None);
      result.origin.push_back(static_cast<Index>(v));
    }
  }
}

void addColumnPoints(
  const TetMesh& mesh, const ColumnSet& set, const std::vector<Index>& baseNumber, EnrichedMesh& result)
{
  auto& points = result.mesh.points;
  for (std::size_t i = 0; i < set.columns.size(); ++i)
  {
    const Column& c = set.columns[i];
    const auto number = static_cast<Index>(i);
    const Index vertex = baseNumber[c.vertex];
    result.column[vertex] = number;
    result.origin[vertex] = c.root;
    points[vertex] = c.ownsTop() ? mesh.point(c.vertex) : c.base;
    for (int level = 1; level <= (c.ownsTop() ? c.levels - 1 : c.levels); ++level)
    {
      points.push_back(level == c.levels ? mesh.point(c.vertex) : set.pointAt(c, level));
      result.column.push_back(number);
      result.origin.push_back(c.root);
    }
  }
}

void sortTrianglesByPatch(MeshData& data)
{
  std::vector<Index> order(data.triangles.size());
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(),
    [&data](Index a, Index b) { return data.trianglePatch[a] < data.trianglePatch[b]; });
  std::vector<std::array<Index, 3>> triangles;
  std::vector<int> patch;
  for (const Index i : order)
  {
    triangles.push_back(data.triangles[i]);
    patch.push_back(data.trianglePatch[i]);
  }
  data.triangles.swap(triangles);
  data.trianglePatch.swap(patch);
}

void reservePoints(std::size_t count, EnrichedMesh& result)
{
  reserveLarge(result.mesh.points, count);
  reserveLarge(result.column, count);
  reserveLarge(result.origin, count);
}

// By boundary face.
std::vector<OnFace> whatStands(
  const TetMesh& mesh, const std::vector<BaseFace>& faces, const TensorStacks& tensor)
{
  std::vector<OnFace> onFace(mesh.boundarySlots(), OnFace::Nothing);
  for (std::size_t i = 0; i < faces.size(); ++i)
  {
    onFace[faces[i].face] = tensor.replaced[i] ? OnFace::Grid : OnFace::Stack;
  }
  return onFace;
}

void addGridPoints(const ColumnSet& set, const TensorStacks& tensor, EnrichedMesh& result)
{
  reservePoints(result.mesh.points.size() + tensor.points.size(), result);
  result.report.grids = tensor.report;
  result.report.pointsRequested += tensor.points.size() + tensor.report.lostPoints;
  result.report.pointsInserted += tensor.points.size();
  MeshData& data = result.mesh;
  for (std::size_t i = 0; i < tensor.points.size(); ++i)
  {
    const GridPoint& origin = tensor.origin[i];
    const Column& column = set.columns[origin.column];
    if (origin.layers != None)
    {
      const double height = set.heights[origin.patch].height(1);
      const auto number = static_cast<Index>(data.points.size());
      result.wallPoints.push_back({ number, origin.patch, origin.layers, origin.layers, height,
        origin.layers > 0 ? height : 0, StopReason::Complete });
    }
    data.points.push_back(tensor.points[i]);
    result.column.push_back(origin.column);
    result.origin.push_back(column.root);
  }
}

std::size_t countStackTets(
  const ColumnSet& set, const std::vector<BaseFace>& faces, const TensorStacks& tensor)
{
  std::size_t count = 0;
  for (std::size_t i = 0; i < faces.size(); ++i)
  {
    count += tensor.replaced[i] ? 0 : countTets(stackOf(set, faces[i]));
  }
  for (const TensorStack& t : tensor.stacks)
  {
    count += countTets(t.stack);
  }
  return count;
}

// What lies beyond the front, with room for the stacks.
void addMeshTets(
  const TetMesh& mesh, const std::vector<Index>& frontNumber, std::size_t stackTets, EnrichedMesh& result)
{
  const std::size_t count = mesh.liveTets() + stackTets;
  reserveLarge(result.mesh.tetrahedra, count);
  reserveLarge(result.layer, count);
  appendLiveTets(mesh, frontNumber, result.mesh.tetrahedra);
  result.layer.assign(mesh.liveTets(), 0);
}

void appendStacks(const ColumnSet& set, const std::vector<BaseFace>& faces, const ColumnPoints& numbers,
  const std::vector<Index>& baseNumber, const TensorStacks& tensor, EnrichedMesh& result)
{
  MeshData& data = result.mesh;
  StackSink sink{ data.tetrahedra, result.layer, result.stacks, data.triangles, data.trianglePatch };
  StackWriter writer(sink);
  for (std::size_t i = 0; i < faces.size(); ++i)
  {
    const BaseFace& face = faces[i];
    if (!tensor.replaced[i])
    {
      writer.write(stackOf(set, face), face.sideOpposite,
        [&](int corner, int level)
        { return level == 0 ? baseNumber[face.root[corner]] : numbers.at(face.column[corner], level); });
    }
  }
  for (const TensorStack& t : tensor.stacks)
  {
    data.triangles.push_back({ t.at(0, 0), t.at(2, 0), t.at(1, 0) });
    data.trianglePatch.push_back(t.patch);
    writer.write(t.stack, t.sideOpposite, [&t](int corner, int level) { return t.at(corner, level); });
  }
}

WallPoint wallPointOf(const ColumnSet& set, const ColumnPoints& numbers, Index column, const MeshData& mesh)
{
  const Column& c = set.columns[column];
  const LayerHeights& heights = set.heightsOf(c);
  WallPoint point;
  point.point = numbers.at(column, 0);
  point.patch = c.patch;
  point.layersAsked = c.asked;
  point.layersAchieved = c.levels;
  point.firstHeightAsked = heights.count() > 0 ? heights.height(1) : 0;
  if (c.levels > 0)
  {
    // How much of the whole first step there is: a top that got stuck may stand lower.
    const Vector3 step = mesh.points[numbers.at(column, 1)] - c.base;
    const Vector3 whole = set.pointAt(c, 1) - c.base;
    point.firstHeightAchieved = point.firstHeightAsked * dot(step, whole) / dot(whole, whole);
  }
  point.reason = c.reason;
  return point;
}

// One entry a root: of the columns of a fan, the lowest one speaks for the point.
void reportColumns(const ColumnSet& set, const ColumnPoints& numbers, EnrichedMesh& result)
{
  for (std::size_t i = 0; i < set.columns.size(); ++i)
  {
    const Column& c = set.columns[i];
    const WallPoint point = wallPointOf(set, numbers, static_cast<Index>(i), result.mesh);
    if (!c.ownsTop())
    {
      result.wallPoints.push_back(point);
    }
    else if (WallPoint& main = result.wallPoints[set.mainOf(c)]; point.layersAchieved < main.layersAchieved)
    {
      main = point;
    }
    ++result.report.columnsByReason[static_cast<std::size_t>(c.reason)];
    result.report.pointsInserted += static_cast<std::size_t>(c.levels);
  }
}
} // namespace

std::vector<Index> numberPrisms(const EnrichedMesh& enriched)
{
  const std::vector<int>& layer = enriched.layer;
  std::vector<Index> prism;
  reserveLarge(prism, layer.size());
  prism.assign(
    enriched.stacks.empty() ? layer.size() : static_cast<std::size_t>(enriched.stacks.front()), None);
  Index number = None;
  for (std::size_t i = 0; i < enriched.stacks.size(); ++i)
  {
    const bool isLast = i + 1 == enriched.stacks.size();
    const std::size_t end = isLast ? layer.size() : static_cast<std::size_t>(enriched.stacks[i + 1]);
    int below = 0; // the layer of the tetrahedron before; 0 at the start of a stack
    for (std::size_t t = prism.size(); t < end; ++t)
    {
      number += layer[t] != below;
      below = layer[t];
      prism.push_back(number);
    }
  }
  return prism;
}

void writeEnriched(
  const TetMesh& mesh, const ColumnSet& set, double maximumSurfaceAngle, EnrichedMesh& result)
{
  Index meshPoints = 0;
  const std::vector<Index> baseNumber = numberUsedVertices(mesh, meshPoints);
  const ColumnPoints numbers(set, baseNumber, static_cast<std::size_t>(meshPoints));
  reservePoints(static_cast<std::size_t>(meshPoints) + numbers.count(), result);
  addMeshPoints(mesh, baseNumber, result);
  addColumnPoints(mesh, set, baseNumber, result);
  std::vector<BaseFace> faces = collectBaseFaces(mesh, set);
  findSides(mesh, set, faces);
  const TensorStacks tensor =
    makeTensorStacks(mesh, set, faces, numbers, baseNumber, result.mesh.points, maximumSurfaceAngle);
  reportColumns(set, numbers, result);
  addGridPoints(set, tensor, result);
  const std::vector<Index> frontNumber = numberFront(set, numbers, baseNumber);
  result.report.layerTets = countStackTets(set, faces, tensor);
  addMeshTets(mesh, frontNumber, result.report.layerTets, result);
  addTriangles(mesh, set, baseNumber, frontNumber, whatStands(mesh, faces, tensor), result.mesh);
  appendStacks(set, faces, numbers, baseNumber, tensor, result);
  sortTrianglesByPatch(result.mesh);
}
} // namespace ransmesh
