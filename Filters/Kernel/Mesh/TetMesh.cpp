#include "Mesh/TetMesh.h"

#include "Support/LargeMemory.h"

#include <algorithm>

namespace ransmesh
{
TetMesh::TetMesh(const MeshData& data, const std::vector<HalfFace>& opposite)
  : points_(data.points)
  , vertexTet_(data.points.size(), None)
  , boundary_(data.triangles.size())
{
  reserveLarge(tets_, data.tetrahedra.size());
  for (std::size_t i = 0; i < data.tetrahedra.size(); ++i)
  {
    const auto t = static_cast<Index>(i);
    const HalfFace* beyond = opposite.data() + 4 * i;
    tets_.push_back({ data.tetrahedra[i], { beyond[0], beyond[1], beyond[2], beyond[3] } });
    for (int f = 0; f < 4; ++f)
    {
      vertexTet_[data.tetrahedra[i][f]] = t;
      if (isBoundary(beyond[f]))
      {
        boundary_[boundaryFaceOf(beyond[f])].inner = halfFace(t, f);
      }
    }
  }
  for (std::size_t b = 0; b < boundary_.size(); ++b)
  {
    boundary_[b].patch = data.trianglePatch[b];
  }
}

Index TetMesh::addVertex(const Vector3& x)
{
  points_.push_back(x);
  vertexTet_.push_back(None);
  return static_cast<Index>(points_.size() - 1);
}

void TetMesh::removeLastVertices(std::size_t count)
{
  points_.resize(points_.size() - count);
  vertexTet_.resize(vertexTet_.size() - count);
}

Index TetMesh::addTet(const std::array<Index, 4>& vertices)
{
  Index t = None;
  if (freeTets_.empty())
  {
    t = static_cast<Index>(tets_.size());
    tets_.emplace_back();
  }
  else
  {
    t = freeTets_.back();
    freeTets_.pop_back();
  }
  noteTet(t);
  tets_[t].vertex = vertices;
  for (const Index v : vertices)
  {
    setVertexTet(v, t);
  }
  return t;
}

void TetMesh::freeTet(Index t)
{
  noteTet(t);
  tets_[t].vertex[0] = None;
  freeTets_.push_back(t);
}

Index TetMesh::addBoundaryFace(HalfFace inner, int patch)
{
  Index b = None;
  if (freeBoundary_.empty())
  {
    b = static_cast<Index>(boundary_.size());
    boundary_.emplace_back();
  }
  else
  {
    b = freeBoundary_.back();
    freeBoundary_.pop_back();
  }
  setPatch(b, patch);
  link(inner, boundaryHalfFace(b));
  return b;
}

void TetMesh::freeBoundaryFace(Index b)
{
  noteBoundaryFace(b);
  boundary_[b].inner = None;
  freeBoundary_.push_back(b);
}

void TetMesh::link(HalfFace a, HalfFace b)
{
  const auto point = [this](HalfFace from, HalfFace to)
  {
    if (isBoundary(from))
    {
      noteBoundaryFace(boundaryFaceOf(from));
      boundary_[boundaryFaceOf(from)].inner = to;
    }
    else
    {
      noteTet(tetOf(from));
      tets_[tetOf(from)].neighbour[faceOf(from)] = to;
    }
  };
  point(a, b);
  point(b, a);
}

Index TetMesh::appendTets(std::size_t count)
{
  const auto first = static_cast<Index>(tets_.size());
  tets_.resize(tets_.size() + count, Tetrahedron{ { None, None, None, None }, {} });
  return first;
}

void TetMesh::beginTrial()
{
  trial_.emplace();
  trial_->freeTets = freeTets_;
  trial_->freeBoundary = freeBoundary_;
  trial_->vertexCount = points_.size();
  trial_->tetSlots = tets_.size();
  trial_->boundarySlots = boundary_.size();
}

void TetMesh::undoTrial()
{
  const auto restore = [](auto& slots, const auto& changes, std::size_t count)
  {
    slots.resize(count);
    for (auto change = changes.rbegin(); change != changes.rend(); ++change)
    {
      if (static_cast<std::size_t>(change->first) < count)
      {
        slots[change->first] = change->second;
      }
    }
  };
  restore(points_, trial_->points, trial_->vertexCount);
  restore(vertexTet_, trial_->vertexTets, trial_->vertexCount);
  restore(tets_, trial_->tets, trial_->tetSlots);
  restore(boundary_, trial_->boundary, trial_->boundarySlots);
  freeTets_ = std::move(trial_->freeTets);
  freeBoundary_ = std::move(trial_->freeBoundary);
  trial_.reset();
}

std::vector<Index> numberUsedVertices(const TetMesh& mesh, Index& count)
{
  std::vector<Index> number(mesh.vertexCount(), None);
  for (std::size_t t = 0; t < mesh.tetSlots(); ++t)
  {
    const Tetrahedron& tet = mesh.tet(static_cast<Index>(t));
    if (tet.isAlive())
    {
      for (const Index v : tet.vertex)
      {
        number[v] = 0;
      }
    }
  }
  count = 0;
  for (Index& n : number)
  {
    n = n == None ? None : count++;
  }
  return number;
}

void appendLiveTets(
  const TetMesh& mesh, const std::vector<Index>& newNumber, std::vector<std::array<Index, 4>>& tets)
{
  for (std::size_t t = 0; t < mesh.tetSlots(); ++t)
  {
    const Tetrahedron& tet = mesh.tet(static_cast<Index>(t));
    if (tet.isAlive())
    {
      const auto& v = tet.vertex;
      tets.push_back({ newNumber[v[0]], newNumber[v[1]], newNumber[v[2]], newNumber[v[3]] });
    }
  }
}

MeshData toMeshData(const TetMesh& mesh, std::vector<Index>* newNumber)
{
  Index count = 0;
  std::vector<Index> number = numberUsedVertices(mesh, count);
  MeshData data;
  data.points.resize(count);
  for (std::size_t v = 0; v < number.size(); ++v)
  {
    if (number[v] != None)
    {
      data.points[number[v]] = mesh.point(static_cast<Index>(v));
    }
  }
  reserveLarge(data.tetrahedra, mesh.liveTets());
  appendLiveTets(mesh, number, data.tetrahedra);
  std::vector<Index> faces;
  for (std::size_t b = 0; b < mesh.boundarySlots(); ++b)
  {
    if (mesh.boundaryFace(static_cast<Index>(b)).isAlive())
    {
      faces.push_back(static_cast<Index>(b));
    }
  }
  std::stable_sort(faces.begin(), faces.end(),
    [&](Index a, Index b) { return mesh.boundaryFace(a).patch < mesh.boundaryFace(b).patch; });
  for (const Index b : faces)
  {
    const auto inward = mesh.boundaryVertices(b);
    data.triangles.push_back({ number[inward[0]], number[inward[2]], number[inward[1]] });
    data.trianglePatch.push_back(mesh.boundaryFace(b).patch);
  }
  if (newNumber)
  {
    newNumber->swap(number);
  }
  return data;
}
} // namespace ransmesh
