#include "Boundary/SheetSides.h"

#include <algorithm>
#include <numeric>
#include <set>
#include <tuple>

namespace ransmesh
{
namespace
{
template <class Cells>
bool inRange(const Cells& cells, std::size_t points)
{
  return std::all_of(cells.begin(), cells.end(),
    [points](const auto& cell)
    {
      return std::all_of(cell.begin(), cell.end(),
        [points](Index v) { return v >= 0 && static_cast<std::size_t>(v) < points; });
    });
}

std::array<Index, 3> faceOfTet(const MeshData& mesh, HalfFace h)
{
  const auto& tet = mesh.tetrahedra[tetOf(h)];
  const int* corner = FaceCorners[faceOf(h)];
  return { tet[corner[0]], tet[corner[1]], tet[corner[2]] };
}

std::array<Index, 3> sorted(std::array<Index, 3> f)
{
  std::sort(f.begin(), f.end());
  return f;
}

// The triangles, found by their points.
class TriangleTable
{
public:
  explicit TriangleTable(const MeshData& mesh)
    : mesh_(mesh)
    , start_(mesh.points.size() + 1, 0)
    , isUsed_(mesh.points.size(), 0)
    , triangle_(mesh.triangles.size())
  {
    for (const auto& t : mesh.triangles)
    {
      ++start_[*std::min_element(t.begin(), t.end()) + 1];
      for (const Index v : t)
      {
        isUsed_[v] = 1;
      }
    }
    std::partial_sum(start_.begin(), start_.end(), start_.begin());
    std::vector<std::size_t> next(start_.begin(), start_.end() - 1);
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i)
    {
      const auto& t = mesh.triangles[i];
      triangle_[next[*std::min_element(t.begin(), t.end())]++] = static_cast<Index>(i);
    }
  }

  // The first triangle on these three points, or None.
  Index at(const std::array<Index, 3>& face) const
  {
    if (!isUsed_[face[0]] || !isUsed_[face[1]] || !isUsed_[face[2]])
    {
      return None;
    }
    const std::array<Index, 3> f = sorted(face);
    for (std::size_t i = start_[f[0]]; i < start_[f[0] + 1]; ++i)
    {
      if (sorted(mesh_.triangles[triangle_[i]]) == f)
      {
        return triangle_[i];
      }
    }
    return None;
  }

private:
  const MeshData& mesh_;
  std::vector<std::size_t> start_; // of each point: the triangles of which it is the smallest
  std::vector<char> isUsed_;
  std::vector<Index> triangle_;
};

// Is the triangle an even permutation of the face?
bool isTurnedLike(const std::array<Index, 3>& triangle, const std::array<Index, 3>& face)
{
  const auto at = std::find(triangle.begin(), triangle.end(), face[0]) - triangle.begin();
  return triangle[(at + 1) % 3] == face[1];
}

// Of each triangle the faces of tetrahedra on it, at most two.
std::vector<std::array<HalfFace, 2>> facesOnTriangles(const MeshData& mesh)
{
  std::vector<std::array<HalfFace, 2>> faces(mesh.triangles.size(), { None, None });
  const TriangleTable table(mesh);
  for (std::size_t t = 0; t < mesh.tetrahedra.size(); ++t)
  {
    for (int f = 0; f < 4; ++f)
    {
      const HalfFace h = halfFace(static_cast<Index>(t), f);
      if (const Index i = table.at(faceOfTet(mesh, h)); i != None)
      {
        faces[i][faces[i][0] == None ? 0 : 1] = h;
      }
    }
  }
  return faces;
}
} // namespace

std::vector<SheetTriangle> findSheets(const MeshData& mesh)
{
  std::vector<SheetTriangle> sheets;
  if (!inRange(mesh.tetrahedra, mesh.points.size()) || !inRange(mesh.triangles, mesh.points.size()))
  {
    return sheets;
  }
  const auto faces = facesOnTriangles(mesh);
  std::set<int> boundaryPatches;
  for (std::size_t i = 0; i < faces.size(); ++i)
  {
    if (faces[i][1] == None)
    {
      boundaryPatches.insert(mesh.trianglePatch[i]);
    }
  }
  for (std::size_t i = 0; i < faces.size(); ++i)
  {
    if (boundaryPatches.contains(mesh.trianglePatch[i]))
    {
      continue;
    }
    SheetTriangle sheet{ static_cast<Index>(i), faces[i] };
    if (isTurnedLike(mesh.triangles[i], faceOfTet(mesh, faces[i][0]))) // turned inward
    {
      std::swap(sheet.face[0], sheet.face[1]);
    }
    sheets.push_back(sheet);
  }
  return sheets;
}

SheetSides::SheetSides(const MeshData& mesh, const std::vector<SheetTriangle>& sheets)
  : row_(mesh.points.size(), None)
{
  std::vector<HalfFace> sheetFaces;
  for (const SheetTriangle& sheet : sheets)
  {
    sheetFaces.insert(sheetFaces.end(), sheet.face.begin(), sheet.face.end());
    for (const Index v : mesh.triangles[sheet.triangle])
    {
      row_[v] = 0;
    }
  }
  std::sort(sheetFaces.begin(), sheetFaces.end());
  for (std::size_t v = 0; v < row_.size(); ++v)
  {
    if (row_[v] != None)
    {
      row_[v] = static_cast<Index>(points_.size());
      points_.push_back(static_cast<Index>(v));
    }
  }
  collectTets(mesh);
  part_.resize(tets_.size());
  parts_.resize(points_.size());
  for (const Index v : points_)
  {
    partTets(mesh, v, sheetFaces);
  }
}

void SheetSides::collectTets(const MeshData& mesh)
{
  start_.assign(points_.size() + 1, 0);
  const auto forEach = [&](auto visit)
  {
    for (std::size_t t = 0; t < mesh.tetrahedra.size(); ++t)
    {
      for (const Index v : mesh.tetrahedra[t])
      {
        if (row_[v] != None)
        {
          visit(row_[v], static_cast<Index>(t));
        }
      }
    }
  };
  forEach([this](Index row, Index) { ++start_[row + 1]; });
  std::partial_sum(start_.begin(), start_.end(), start_.begin());
  tets_.resize(start_.back());
  std::vector<std::size_t> next(start_.begin(), start_.end() - 1);
  forEach([&](Index row, Index t) { tets_[next[row]++] = t; });
}

void SheetSides::partTets(const MeshData& mesh, Index v, const std::vector<HalfFace>& sheetFaces)
{
  struct FaceAt
  {
    Index low; // the face's other points
    Index high;
    std::size_t tet; // in the list of tets at v
  };
  const auto tets = tetsAt(v);
  std::vector<std::size_t> root(tets.size());
  std::iota(root.begin(), root.end(), 0);
  const auto rootOf = [&root](std::size_t i)
  {
    while (root[i] != i)
    {
      i = root[i] = root[root[i]];
    }
    return i;
  };
  std::vector<FaceAt> faces;
  for (std::size_t i = 0; i < tets.size(); ++i)
  {
    for (int f = 0; f < 4; ++f)
    {
      const HalfFace h = halfFace(tets[i], f);
      const auto face = sorted(faceOfTet(mesh, h));
      if (mesh.tetrahedra[tets[i]][f] != v && !std::binary_search(sheetFaces.begin(), sheetFaces.end(), h))
      {
        faces.push_back({ face[0] == v ? face[1] : face[0], face[2] == v ? face[1] : face[2], i });
      }
    }
  }
  std::sort(faces.begin(), faces.end(),
    [](const FaceAt& a, const FaceAt& b)
    { return std::tie(a.low, a.high, a.tet) < std::tie(b.low, b.high, b.tet); });
  for (std::size_t i = 0; i + 1 < faces.size(); ++i)
  {
    if (faces[i].low == faces[i + 1].low && faces[i].high == faces[i + 1].high)
    {
      const std::size_t a = rootOf(faces[i].tet);
      const std::size_t b = rootOf(faces[i + 1].tet);
      root[std::max(a, b)] = std::min(a, b);
    }
  }
  // The root of a part is its first tetrahedron, so parts are numbered in the order of these.
  int* part = part_.data() + start_[row_[v]];
  int count = 0;
  for (std::size_t i = 0; i < tets.size(); ++i)
  {
    part[i] = rootOf(i) == i ? count++ : part[rootOf(i)];
  }
  parts_[row_[v]] = count;
}

int SheetSides::partOf(Index v, Index tet) const
{
  const auto tets = tetsAt(v);
  const auto at = std::lower_bound(tets.begin(), tets.end(), tet) - tets.begin();
  return part_[start_[row_[v]] + static_cast<std::size_t>(at)];
}
} // namespace ransmesh
