#include "Layers/ColumnBuilder.h"

#include "Boundary/SurfaceNormals.h"

#include <algorithm>
#include <cmath>

namespace ransmesh
{
namespace
{
// A patch is a side where it rises from the wall at 30 to 150 degrees.
constexpr double SideRise = 0.5;
// Below this cosine between direction and a face's normal the layers would lie flat on the face.
constexpr double LeastVisibility = 0.1;
// Above it the weighted normal is good enough as it is.
constexpr double GoodVisibility = 0.7;
constexpr double LargestScale = 2;

// What stands around one wall vertex.
struct Surroundings
{
  std::vector<FaceAtVertex> walls;  // faces with layers
  std::vector<FaceAtVertex> others; // the rest
  int patch = 0;                    // the wall patch with the smallest first height
  double size = 0;                  // mean length of wall edges
};

Surroundings look(Index v, const TetMesh& mesh, const BoundaryStars& stars, const LayerPlan& plan)
{
  Surroundings s;
  double length = 0;
  for (const Index face : stars.facesAt(v))
  {
    const FaceAtVertex seen = stars.seenFrom(v, face);
    const bool isWall = plan[seen.patch].hasLayers();
    (isWall ? s.walls : s.others).push_back(seen);
    if (isWall)
    {
      length += distance(mesh.point(v), mesh.point(seen.vertex[1])) +
        distance(mesh.point(v), mesh.point(seen.vertex[2]));
      if (s.patch == 0 || plan[seen.patch].firstHeight < plan[s.patch].firstHeight)
      {
        s.patch = seen.patch;
      }
    }
  }
  s.size = s.walls.empty() ? 0 : length / (2 * static_cast<double>(s.walls.size()));
  return s;
}

// Faces of one adjoining patch without a ridge between them, seen as a plane.
struct Side
{
  int patch = 0;
  Vector3 normal;  // unit, into the fluid
  double rise = 0; // cosine between the wall's normal and the way into the side
};

std::vector<Side> findGroups(std::vector<FaceAtVertex> others, const Vector3& wallNormal)
{
  std::stable_sort(others.begin(), others.end(),
    [](const FaceAtVertex& a, const FaceAtVertex& b) { return a.patch < b.patch; });
  std::vector<Side> sides;
  for (auto begin = others.begin(); begin != others.end();)
  {
    const auto end =
      std::find_if(begin, others.end(), [&begin](const FaceAtVertex& f) { return f.patch != begin->patch; });
    for (const auto& group : smoothGroups({ begin, end }))
    {
      Vector3 middle;
      for (const FaceAtVertex& face : group)
      {
        middle += face.angle * face.middle;
      }
      sides.push_back({ begin->patch, weightedNormal(group), dot(normalized(middle), wallNormal) });
    }
    begin = end;
  }
  return sides;
}

// The groups that rise from the wall. Not to be told apart from there on: groups of one patch, of which
// only some rise; then false.
bool findSides(const std::vector<FaceAtVertex>& others, const Vector3& wallNormal, std::vector<Side>& sides)
{
  std::vector<Side> flat;
  for (const Side& group : findGroups(others, wallNormal))
  {
    (group.rise > SideRise ? sides : flat).push_back(group);
  }
  return std::none_of(flat.begin(), flat.end(),
    [&sides](const Side& f)
    { return std::any_of(sides.begin(), sides.end(), [&f](const Side& s) { return s.patch == f.patch; }); });
}

// Lays a vector into the planes of the sides; zero where nothing is left.
class SideProjection
{
public:
  explicit SideProjection(const std::vector<Side>& sides)
  {
    for (const Side& side : sides)
    {
      Vector3 n = side.normal;
      for (const Vector3& u : axes_)
      {
        n = n - dot(n, u) * u;
      }
      if (norm(n) > 1e-6)
      {
        axes_.push_back(normalized(n));
      }
    }
  }
  Vector3 operator()(Vector3 d) const
  {
    for (int pass = 0; pass < 2; ++pass) // twice: the first leaves rounding errors
    {
      for (const Vector3& u : axes_)
      {
        d = d - dot(d, u) * u;
      }
    }
    for (int i = 0; i < 3; ++i)
    {
      d[i] = std::fabs(d[i]) < 1e-14 ? 0 : d[i]; // keeps points in axis-aligned planes exactly
    }
    return normalized(d);
  }

private:
  std::vector<Vector3> axes_;
};

const FaceAtVertex& leastVisible(const std::vector<FaceAtVertex>& faces, const Vector3& d)
{
  return *std::min_element(faces.begin(), faces.end(),
    [&d](const FaceAtVertex& a, const FaceAtVertex& b) { return dot(a.normal, d) < dot(b.normal, d); });
}

// Turns d towards the face that it sees worst, by smaller and smaller steps, and keeps the best.
Vector3 mostVisible(const std::vector<FaceAtVertex>& faces, const SideProjection& lay, Vector3 d)
{
  Vector3 best = d;
  double bestCosine = dot(leastVisible(faces, d).normal, d);
  double step = 0.5;
  for (int i = 0; i < 40 && bestCosine < GoodVisibility; ++i)
  {
    d = lay(d + step * leastVisible(faces, d).normal);
    step *= 0.9;
    const double cosine = dot(leastVisible(faces, d).normal, d);
    if (cosine > bestCosine)
    {
      best = d;
      bestCosine = cosine;
    }
  }
  return best;
}

// The step that rises by one above the wall faces, on their average.
Vector3 scaledStep(const std::vector<FaceAtVertex>& walls, const Vector3& d)
{
  double rise = 0;
  double weight = 0;
  for (const FaceAtVertex& f : walls)
  {
    rise += f.angle * dot(f.normal, d);
    weight += f.angle;
  }
  const double mean = rise / weight;
  return std::min(LargestScale, 1 / std::max(mean, 1 / LargestScale)) * d;
}

bool touchesInterface(const std::vector<FaceAtVertex>& others, const PatchTable& patches)
{
  return std::any_of(others.begin(), others.end(),
    [&patches](const FaceAtVertex& f) { return patches[f.patch].type == PatchType::Interface; });
}

StopReason aim(const Surroundings& s, const PatchTable& patches, Column& column)
{
  if (touchesInterface(s.others, patches))
  {
    return StopReason::Frozen;
  }
  const Vector3 wallNormal = weightedNormal(s.walls);
  std::vector<Side> sides;
  if (!findSides(s.others, wallNormal, sides) || sides.size() > 2 || norm(wallNormal) == 0)
  {
    return StopReason::Corner;
  }
  std::vector<FaceAtVertex> carrying = s.walls;
  for (const FaceAtVertex& f : s.others)
  {
    const bool isSide =
      std::any_of(sides.begin(), sides.end(), [&f](const Side& side) { return side.patch == f.patch; });
    if (!isSide)
    {
      carrying.push_back(f);
    }
  }
  for (std::size_t i = 0; i < sides.size(); ++i)
  {
    column.sides[i] = sides[i].patch;
  }
  const SideProjection lay(sides);
  const Vector3 d = mostVisible(carrying, lay, lay(wallNormal));
  if (dot(leastVisible(carrying, d).normal, d) < LeastVisibility)
  {
    return StopReason::Corner;
  }
  column.direction = scaledStep(s.walls, d);
  return StopReason::Complete;
}
} // namespace

ColumnSet buildColumns(
  const TetMesh& mesh, const BoundaryStars& stars, const PatchTable& patches, const LayerPlan& plan)
{
  ColumnSet set;
  set.ofVertex.assign(mesh.vertexCount(), None);
  for (const LayerSpecification& specification : plan)
  {
    set.heights.emplace_back(specification);
  }
  for (std::size_t i = 0; i < mesh.vertexCount(); ++i)
  {
    const auto v = static_cast<Index>(i);
    if (!stars.isOnBoundary(v))
    {
      continue;
    }
    const Surroundings s = look(v, mesh, stars, plan);
    if (s.walls.empty())
    {
      continue;
    }
    Column column;
    column.vertex = v;
    column.base = mesh.point(v);
    column.patch = s.patch;
    column.size = s.size;
    column.asked = plan[s.patch].numberOfLayers;
    column.levels = column.asked;
    if (const StopReason reason = aim(s, patches, column); reason != StopReason::Complete)
    {
      column.limit(0, reason);
    }
    set.ofVertex[v] = static_cast<Index>(set.columns.size());
    set.columns.push_back(column);
  }
  return set;
}

void settleDisagreements(const TetMesh& mesh, ColumnSet& set)
{
  for (bool changed = true; changed;)
  {
    changed = false;
    for (std::size_t i = 0; i < mesh.boundarySlots(); ++i)
    {
      const auto b = static_cast<Index>(i);
      if (!mesh.boundaryFace(b).isAlive())
      {
        continue;
      }
      const int patch = mesh.boundaryFace(b).patch;
      int carry = 0;
      int slide = 0;
      const auto vertices = mesh.boundaryVertices(b);
      for (const Index v : vertices)
      {
        const Index c = set.standingAt(v);
        slide += c != None && set.columns[c].staysIn(patch);
        carry += c != None && !set.columns[c].staysIn(patch);
      }
      if (carry == 0 || slide == 0)
      {
        continue;
      }
      for (const Index v : vertices)
      {
        if (const Index c = set.standingAt(v); c != None)
        {
          set.columns[c].limit(0, StopReason::Corner);
        }
      }
      changed = true;
    }
  }
}
} // namespace ransmesh
