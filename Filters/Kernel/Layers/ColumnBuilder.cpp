#include "Layers/ColumnBuilder.h"

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
// Normals of a side's faces that differ by more than this make it curved.
constexpr double PlaneCosine = 0.99985; // 1 degree

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

Vector3 weightedNormal(const std::vector<FaceAtVertex>& faces)
{
  Vector3 n;
  for (const FaceAtVertex& f : faces)
  {
    n += f.angle * f.normal;
  }
  return normalized(n);
}

// The faces of one adjoining patch, seen as a plane.
struct Side
{
  int patch = 0;
  Vector3 normal; // unit, into the fluid
  bool isPlane = true;
  double rise = 0; // cosine between the wall's normal and the way into the side
};

std::vector<Side> findSides(const std::vector<FaceAtVertex>& others, const Vector3& wallNormal)
{
  std::vector<Side> sides;
  std::vector<int> seen;
  for (const FaceAtVertex& f : others)
  {
    if (std::find(seen.begin(), seen.end(), f.patch) != seen.end())
    {
      continue;
    }
    seen.push_back(f.patch);
    std::vector<FaceAtVertex> faces;
    std::copy_if(others.begin(), others.end(), std::back_inserter(faces),
      [&f](const FaceAtVertex& g) { return g.patch == f.patch; });
    Side side;
    side.patch = f.patch;
    side.normal = weightedNormal(faces);
    Vector3 middle;
    for (const FaceAtVertex& g : faces)
    {
      middle += g.angle * g.middle;
      side.isPlane = side.isPlane && dot(g.normal, side.normal) > PlaneCosine;
    }
    side.rise = dot(normalized(middle), wallNormal);
    if (side.rise > SideRise)
    {
      sides.push_back(side);
    }
  }
  return sides;
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
  const std::vector<Side> sides = findSides(s.others, wallNormal);
  if (sides.size() > 2 || norm(wallNormal) == 0)
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
    if (!sides[i].isPlane)
    {
      return StopReason::CurvedSide;
    }
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
