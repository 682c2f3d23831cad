#include "Bodies/SurfaceBuilder.h"

#include "Triangles/SurfaceEdges.h"

#include <cmath>

namespace bodies
{
namespace
{
constexpr double resolution = 1e-9;

// The neighbours of each triangle, with whether both run the same way round.
using Neighbours = std::vector<std::vector<std::pair<Index, bool>>>;

Neighbours findNeighbours(const ransmesh::SurfaceMesh& surface)
{
  Neighbours neighbours(surface.triangles.size());
  ransmesh::forEachEdge(sortedEdges(surface),
    [&](const ransmesh::SurfaceEdge* first, const ransmesh::SurfaceEdge* last)
    {
      if (last - first == 2)
      {
        const bool alike = first[0].forward != first[1].forward;
        neighbours[first[0].triangle].push_back({ first[1].triangle, alike });
        neighbours[first[1].triangle].push_back({ first[0].triangle, alike });
      }
    });
  return neighbours;
}

void turnAlike(ransmesh::SurfaceMesh& surface)
{
  enum State : char
  {
    Unseen,
    Kept,
    Turned
  };
  const Neighbours neighbours = findNeighbours(surface);
  std::vector<State> state(surface.triangles.size(), Unseen);
  std::vector<Index> stack;
  for (std::size_t seed = 0; seed < state.size(); ++seed)
  {
    if (state[seed] != Unseen)
    {
      continue;
    }
    state[seed] = Kept;
    stack.push_back(static_cast<Index>(seed));
    while (!stack.empty())
    {
      const Index t = stack.back();
      stack.pop_back();
      for (const auto& [other, alike] : neighbours[t])
      {
        if (state[other] == Unseen)
        {
          state[other] = alike == (state[t] == Kept) ? Kept : Turned;
          stack.push_back(other);
        }
      }
    }
  }
  for (std::size_t t = 0; t < state.size(); ++t)
  {
    if (state[t] == Turned)
    {
      std::swap(surface.triangles[t][1], surface.triangles[t][2]);
    }
  }
}
} // namespace

SurfaceBuilder::SurfaceBuilder()
{
  body_.patches.push_back({ "fluid", PatchType::Patch });
}

int SurfaceBuilder::patch(const std::string& name, PatchType type)
{
  for (std::size_t i = 1; i < body_.patches.size(); ++i)
  {
    if (body_.patches[i].name == name)
    {
      return static_cast<int>(i);
    }
  }
  body_.patches.push_back({ name, type });
  return static_cast<int>(body_.patches.size()) - 1;
}

Index SurfaceBuilder::point(const Vector3& p)
{
  std::array<long, 3> cell;
  for (int i = 0; i < 3; ++i)
  {
    cell[i] = std::lround(p[i] / resolution);
  }
  for (int near = 0; near < 27; ++near)
  {
    const auto found =
      numbers_.find({ cell[0] + near % 3 - 1, cell[1] + near / 3 % 3 - 1, cell[2] + near / 9 - 1 });
    if (found != numbers_.end())
    {
      return found->second;
    }
  }
  const auto number = static_cast<Index>(body_.surface.points.size());
  body_.surface.points.push_back(p);
  numbers_[cell] = number;
  return number;
}

void SurfaceBuilder::triangle(const Vector3& a, const Vector3& b, const Vector3& c, int patch)
{
  const std::array<Index, 3> t = { point(a), point(b), point(c) };
  if (t[0] != t[1] && t[1] != t[2] && t[2] != t[0])
  {
    body_.surface.triangles.push_back(t);
    body_.surface.patch.push_back(patch);
  }
}

void SurfaceBuilder::strip(const Row& a, const Row& b, int patch)
{
  std::size_t i = 0;
  std::size_t j = 0;
  while (i + 1 < a.size() || j + 1 < b.size())
  {
    const bool canA = i + 1 < a.size();
    const bool canB = j + 1 < b.size();
    const bool alongA = canA && (!canB || distance(a[i + 1], b[j]) <= (1 + 1e-9) * distance(a[i], b[j + 1]));
    triangle(a[i], alongA ? a[i + 1] : b[j + 1], b[j], patch);
    ++(alongA ? i : j);
  }
}

void SurfaceBuilder::grid(const std::vector<Row>& rows, int patch)
{
  for (std::size_t i = 0; i + 1 < rows.size(); ++i)
  {
    strip(rows[i], rows[i + 1], patch);
  }
}

Body SurfaceBuilder::finish(bool farField)
{
  turnAlike(body_.surface);
  body_.farField = farField;
  return std::move(body_);
}

Row straightRow(const Vector3& a, const Vector3& b, int n)
{
  Row row;
  for (int i = 0; i <= n; ++i)
  {
    row.push_back(i == n ? b : a + (static_cast<double>(i) / n) * (b - a));
  }
  return row;
}

int divisions(double length, double size)
{
  return std::max(1, static_cast<int>(std::lround(length / size)));
}
} // namespace bodies
