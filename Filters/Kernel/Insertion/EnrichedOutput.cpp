#include "Insertion/EnrichedOutput.h"

#include "Insertion/FanOpening.h"
#include "Insertion/LayerStacks.h"
#include "Insertion/TensorStacks.h"

#include <algorithm>
#include <numeric>

namespace ransmesh
{
namespace
{
// Wall vertices are their columns' tops in the mesh beyond: the wall itself keeps the old numbers, the
// tops get those of their columns' last levels.
void separateWallFromFront(const TetMesh& mesh, const ColumnSet& set, const ColumnPoints& numbers,
  const std::vector<Index>& baseNumber, const std::vector<char>& isReplaced, MeshData& data)
{
  std::vector<Index> topOf(data.points.size());
  std::iota(topOf.begin(), topOf.end(), 0);
  for (std::size_t i = 0; i < set.columns.size(); ++i)
  {
    const Column& c = set.columns[i];
    topOf[baseNumber[c.vertex]] = numbers.at(static_cast<Index>(i), c.levels);
  }
  for (auto& tet : data.tetrahedra)
  {
    for (Index& v : tet)
    {
      v = topOf[v];
    }
  }
  // Triangles that carry layers stay on the wall, all others go with the front.
  std::vector<Index> order;
  for (std::size_t b = 0; b < mesh.boundarySlots(); ++b)
  {
    if (mesh.boundaryFace(static_cast<Index>(b)).isAlive())
    {
      order.push_back(static_cast<Index>(b));
    }
  }
  data.triangles.clear();
  data.trianglePatch.clear();
  for (const Index b : order)
  {
    if (mesh.boundaryFace(b).patch == FrontOnly || isReplaced[b])
    {
      continue;
    }
    const bool onWall = carriesLayers(mesh, set, b);
    const auto place = [&](Index v) { return onWall ? baseNumber[set.rootOf(v)] : topOf[baseNumber[v]]; };
    const auto inward = mesh.boundaryVertices(b);
    data.triangles.push_back({ place(inward[0]), place(inward[2]), place(inward[1]) });
    data.trianglePatch.push_back(mesh.boundaryFace(b).patch);
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

// By boundary face: does a tensor grid bring other triangles in its place?
std::vector<char> replacedTriangles(
  const TetMesh& mesh, const std::vector<BaseFace>& faces, const TensorStacks& tensor)
{
  std::vector<char> isReplaced(mesh.boundarySlots(), 0);
  for (std::size_t i = 0; i < faces.size(); ++i)
  {
    isReplaced[faces[i].face] = tensor.replaced[i];
  }
  return isReplaced;
}

void addGridPoints(const ColumnSet& set, const TensorStacks& tensor, EnrichedMesh& result)
{
  result.report.pointsRequested += tensor.planned;
  result.report.pointsInserted += tensor.points.size();
  MeshData& data = result.mesh;
  for (std::size_t i = 0; i < tensor.points.size(); ++i)
  {
    const GridPoint& origin = tensor.origin[i];
    const Column& column = set.columns[origin.column];
    if (origin.layers != None)
    {
      const double height = set.heightsOf(column).height(1);
      const auto number = static_cast<Index>(data.points.size());
      result.wallPoints.push_back({ number, origin.patch, origin.layers, origin.layers, height,
        origin.layers > 0 ? height : 0, StopReason::Complete });
    }
    data.points.push_back(tensor.points[i]);
    result.column.push_back(origin.column);
    result.origin.push_back(column.root);
  }
}

void appendStacks(const ColumnSet& set, const std::vector<BaseFace>& faces, const ColumnPoints& numbers,
  const std::vector<Index>& baseNumber, const TensorStacks& tensor, EnrichedMesh& result)
{
  MeshData& data = result.mesh;
  const std::size_t beyond = data.tetrahedra.size();
  std::size_t count = beyond;
  for (const BaseFace& face : faces)
  {
    count += countTets(stackOf(set, face));
  }
  for (const TensorStack& t : tensor.stacks)
  {
    count += countTets(t.stack);
  }
  data.tetrahedra.reserve(count);
  result.layer.reserve(count);
  result.prism.reserve(count);
  result.layer.assign(beyond, 0);
  result.prism.assign(beyond, None);
  StackSink sink{ data.tetrahedra, result.layer, result.prism, data.triangles, data.trianglePatch };
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
  result.report.layerTets = data.tetrahedra.size() - beyond;
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
    // The direction is scaled to rise by one, so the step's share of it is the height.
    const Vector3 step = mesh.points[numbers.at(column, 1)] - c.base;
    point.firstHeightAchieved = dot(step, c.direction) / dot(c.direction, c.direction);
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

void writeEnriched(
  const TetMesh& mesh, const ColumnSet& set, double maximumSurfaceAngle, EnrichedMesh& result)
{
  std::vector<Index> baseNumber;
  result.mesh = toMeshData(mesh, &baseNumber);
  const std::size_t oldPoints = result.mesh.points.size();
  result.column.assign(oldPoints, None);
  result.origin.assign(oldPoints, None);
  for (std::size_t v = 0; v < baseNumber.size(); ++v)
  {
    if (baseNumber[v] != None)
    {
      result.origin[baseNumber[v]] = static_cast<Index>(v);
    }
  }
  const ColumnPoints numbers(set, baseNumber, oldPoints);
  addColumnPoints(mesh, set, baseNumber, result);
  std::vector<BaseFace> faces = collectBaseFaces(mesh, set);
  findSides(mesh, set, faces);
  const TensorStacks tensor =
    makeTensorStacks(mesh, set, faces, numbers, baseNumber, result.mesh.points, maximumSurfaceAngle);
  reportColumns(set, numbers, result);
  addGridPoints(set, tensor, result);
  separateWallFromFront(mesh, set, numbers, baseNumber, replacedTriangles(mesh, faces, tensor), result.mesh);
  appendStacks(set, faces, numbers, baseNumber, tensor, result);
  sortTrianglesByPatch(result.mesh);
}
} // namespace ransmesh
