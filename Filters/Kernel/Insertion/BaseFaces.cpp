#include "Insertion/BaseFaces.h"

#include "Mesh/FaceAhead.h"

#include <algorithm>
#include <tuple>

namespace ransmesh
{
std::array<Vector3, 3> basePoints(const TetMesh& mesh, const ColumnSet& set, const BaseFace& face)
{
  std::array<Vector3, 3> points;
  for (int j = 0; j < 3; ++j)
  {
    points[j] = face.column[j] == None ? mesh.point(face.vertex[j]) : set.columns[face.column[j]].base;
  }
  return points;
}

bool risesLater(const ColumnSet& set, Index column)
{
  return column == None || set.columns[column].bend == None;
}

int firstRankOf(const ColumnSet& set, Index column)
{
  return column == None ? 0 : set.columns[column].firstRank;
}

namespace
{
// What faces need of the column at a vertex, in a small list that stays in the cache.
struct Foot
{
  Index column = None; // that stands there
  Index root = None;
};

std::vector<Foot> feetOf(const TetMesh& mesh, const ColumnSet& set)
{
  std::vector<Foot> feet(mesh.vertexCount());
  for (std::size_t c = 0; c < set.columns.size(); ++c)
  {
    if (set.columns[c].levels > 0)
    {
      feet[set.columns[c].vertex] = { static_cast<Index>(c), set.columns[c].root };
    }
  }
  return feet;
}

template <class Key>
std::array<int, 3> cornersInOrder(Key key)
{
  std::array<int, 3> rise{ 0, 1, 2 };
  const auto order = [&](int& j, int& k)
  {
    if (key(k) < key(j))
    {
      std::swap(j, k);
    }
  };
  order(rise[0], rise[1]);
  order(rise[1], rise[2]);
  order(rise[0], rise[1]);
  return rise;
}

void sortRise(const ColumnSet& set, BaseFace& face)
{
  face.rise = cornersInOrder(
    [&](int j) { return std::tuple(risesLater(set, face.column[j]), face.root[j], face.column[j]); });
}
} // namespace

void sortFirstRise(const ColumnSet& set, BaseFace& face)
{
  const bool isUnranked =
    std::all_of(face.column.begin(), face.column.end(), [&set](Index c) { return firstRankOf(set, c) == 0; });
  face.firstRise = isUnranked
    ? face.rise
    : cornersInOrder(
        [&](int j)
        {
          const Index c = face.column[j];
          return std::tuple(risesLater(set, c), firstRankOf(set, c), face.root[j], c);
        });
}

std::vector<BaseFace> collectBaseFaces(const TetMesh& mesh, const ColumnSet& set)
{
  std::vector<BaseFace> faces;
  faces.reserve(mesh.boundarySlots());
  const std::vector<Foot> feet = feetOf(mesh, set);
  for (std::size_t i = 0; i < mesh.boundarySlots(); ++i)
  {
    fetchAheadOfFace(mesh, i);
    BaseFace face;
    face.face = static_cast<Index>(i);
    if (!mesh.boundaryFace(face.face).isAlive())
    {
      continue;
    }
    face.patch = mesh.boundaryFace(face.face).patch;
    face.vertex = mesh.boundaryVertices(face.face);
    bool carries = false; // has it a standing column for which its patch is not a side?
    for (int j = 0; j < 3; ++j)
    {
      const Foot& foot = feet[face.vertex[j]];
      face.column[j] = foot.column;
      face.root[j] = foot.column == None ? face.vertex[j] : foot.root;
      carries = carries || (foot.column != None && !set.columns[foot.column].staysIn(face.patch));
    }
    if (carries)
    {
      sortRise(set, face);
      sortFirstRise(set, face);
      faces.push_back(face);
    }
  }
  return faces;
}

namespace
{
struct EdgeOfFace
{
  Index low;
  Index high;
  Index base; // number in the list of base faces, or None for a face beside them
  int corner; // opposite to the edge
  int patch;
};

void addEdges(const std::array<Index, 3>& vertex, Index base, int patch, std::vector<EdgeOfFace>& edges)
{
  for (int j = 0; j < 3; ++j)
  {
    const Index a = vertex[(j + 1) % 3];
    const Index b = vertex[(j + 2) % 3];
    edges.push_back({ std::min(a, b), std::max(a, b), base, j, patch });
  }
}
} // namespace

void findSides(const TetMesh& mesh, const ColumnSet& set, std::vector<BaseFace>& faces)
{
  // Only faces at columns that stay in a side can meet a side face.
  const auto atSide = [&set](const std::array<Index, 3>& vertex)
  {
    return std::any_of(vertex.begin(), vertex.end(),
      [&set](Index v)
      {
        const Index c = set.standingAt(v);
        return c != None && set.columns[c].sides[0] != 0;
      });
  };
  if (std::none_of(set.columns.begin(), set.columns.end(), [](const Column& c) { return c.sides[0] != 0; }))
  {
    return;
  }
  std::vector<EdgeOfFace> edges;
  std::vector<char> isBase(mesh.boundarySlots(), 0);
  for (std::size_t i = 0; i < faces.size(); ++i)
  {
    isBase[faces[i].face] = 1;
    if (atSide(faces[i].vertex))
    {
      addEdges(faces[i].vertex, static_cast<Index>(i), faces[i].patch, edges);
    }
  }
  for (std::size_t i = 0; i < mesh.boundarySlots(); ++i)
  {
    const auto b = static_cast<Index>(i);
    if (mesh.boundaryFace(b).isAlive() && !isBase[i] && atSide(mesh.boundaryVertices(b)))
    {
      addEdges(mesh.boundaryVertices(b), None, mesh.boundaryFace(b).patch, edges);
    }
  }
  std::sort(edges.begin(), edges.end(),
    [](const EdgeOfFace& a, const EdgeOfFace& b)
    { return std::tie(a.low, a.high, a.base) < std::tie(b.low, b.high, b.base); });
  const auto same = [&edges](std::size_t i, std::size_t j)
  { return j < edges.size() && edges[i].low == edges[j].low && edges[i].high == edges[j].high; };
  for (std::size_t i = 0; i + 1 < edges.size(); ++i)
  {
    // Where two tops in one side have become neighbours across it, their edge has two base faces and two of the side:
    // the stacks meet there.
    const bool meetsSide = edges[i].base == None && edges[i + 1].base != None && same(i, i + 1);
    if (meetsSide && !(same(i, i + 2) && edges[i + 2].base != None))
    {
      faces[edges[i + 1].base].sideOpposite[edges[i + 1].corner] = edges[i].patch;
    }
  }
}
} // namespace ransmesh
