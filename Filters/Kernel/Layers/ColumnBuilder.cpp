#include "Layers/ColumnBuilder.h"

#include "Boundary/SurfaceNormals.h"
#include "Geometry/Angles.h"
#include "Layers/AdjoiningSides.h"
#include "Layers/Directions.h"
#include "Layers/FanPlanning.h"

#include <algorithm>
#include <cmath>

namespace ransmesh
{
namespace
{
// Below this cosine between direction and a face's normal the layers would lie flat on the face.
constexpr double LeastVisibility = 0.1;

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

bool touchesInterface(const std::vector<FaceAtVertex>& others, const PatchTable& patches)
{
  return std::any_of(others.begin(), others.end(),
    [&patches](const FaceAtVertex& f) { return patches[f.patch].type == PatchType::Interface; });
}

// The wall's faces, and those of other patches that are no sides: the column stands on these too.
std::vector<FaceAtVertex> carryingFaces(const Surroundings& s, const std::vector<Side>& sides)
{
  std::vector<FaceAtVertex> carrying = s.walls;
  std::copy_if(s.others.begin(), s.others.end(), std::back_inserter(carrying),
    [&sides](const FaceAtVertex& f)
    {
      return std::none_of(
        sides.begin(), sides.end(), [&f](const Side& side) { return side.patch == f.patch; });
    });
  return carrying;
}

class ColumnMaker
{
public:
  ColumnMaker(const TetMesh& mesh, const BoundaryStars& stars, const PatchTable& patches,
    const LayerPlan& plan, bool gridsOnWakes)
    : mesh_(mesh)
    , stars_(stars)
    , patches_(patches)
    , plan_(plan)
    , gridsOnWakes_(gridsOnWakes)
  {
    for (const LayerSpecification& specification : plan)
    {
      set_.heights.emplace_back(specification);
    }
    set_.ofVertex.assign(mesh.vertexCount(), None);
  }

  ColumnSet run()
  {
    for (std::size_t i = 0; i < mesh_.vertexCount(); ++i)
    {
      const auto v = static_cast<Index>(i);
      if (!stars_.isOnBoundary(v))
      {
        continue;
      }
      const Surroundings s = look(v, mesh_, stars_, plan_);
      if (!s.walls.empty())
      {
        add(v, s);
      }
    }
    return std::move(set_);
  }

private:
  void add(Index v, const Surroundings& s)
  {
    Column column;
    column.root = v;
    column.vertex = v;
    column.base = mesh_.point(v);
    column.patch = s.patch;
    column.size = s.size;
    column.asked = plan_[s.patch].numberOfLayers;
    column.levels = column.asked;
    if (const StopReason reason = aim(s, column); reason != StopReason::Complete)
    {
      column.limit(0, reason);
    }
    set_.ofVertex[v] = static_cast<Index>(set_.columns.size());
    set_.columns.push_back(column);
  }

  StopReason aim(const Surroundings& s, Column& column)
  {
    if (touchesInterface(s.others, patches_))
    {
      return StopReason::Frozen;
    }
    const Vector3 wallNormal = weightedNormal(s.walls);
    std::vector<Side> sides;
    if (!findSides(mesh_, s.others, s.walls, sides) || sides.size() > 2)
    {
      return StopReason::Corner;
    }
    for (std::size_t i = 0; i < sides.size(); ++i)
    {
      column.sides[i] = sides[i].patch;
    }
    const std::vector<FaceAtVertex> carrying = carryingFaces(s, sides);
    const SideProjection lay(normalsOf(sides));
    const std::vector<Vector3> normals = normalsOf(std::span(carrying));
    const Vector3 seeing = mostVisible(normals, lay, lay(wallNormal));
    const bool wallsOnly = carrying.size() == s.walls.size();
    column.direction = wallsOnly ? evenStep(s.walls, lay, seeing) : scaledStep(s.walls, seeing);
    const double least = visibility(normals, normalized(column.direction));
    if (isSmooth(least, s.patch))
    {
      return StopReason::Complete;
    }
    const bool seesAll = least > LeastVisibility;
    FaceRing ring;
    if (wallsOnly && makeRing(s.walls, ring) &&
      (aimFan(s, ring, lay, seesAll, column) || aimTensor(s, ring, sides, column)))
    {
      return StopReason::Complete;
    }
    return seesAll ? StopReason::Complete : whyUnseen(carrying, column.base);
  }

  // No direction sees all faces that the column would stand on. In a wedge these are each other's opposite surface, and
  // the gap between them closes here.
  StopReason whyUnseen(const std::vector<FaceAtVertex>& carrying, const Vector3& point) const
  {
    FaceRing ring;
    bool isWedge = false;
    const std::size_t edges = makeRing(carrying, ring) ? ring.edgeCount() : 0;
    for (std::size_t i = 0; i < edges && !isWedge; ++i)
    {
      isWedge = ring.turnAfter(point, mesh_, i).isWedge();
    }
    return isWedge ? StopReason::Gap : StopReason::Corner;
  }

  // All faces differ so little from the column's direction that no two of them make a ridge: there is neither
  // fan nor tensor corner, and most points of a wall are so.
  bool isSmooth(double leastVisible, int patch) const
  {
    const double turn = std::min(plan_[patch].normalAngle, leastTensorTurn);
    return leastVisible > std::cos(turn / 2 / DegreesOfRadian);
  }

  // Where the two sides of a wake would not come out alike, no tensor corner is at a wake: a grid brings points to
  // its walls. Its columns stay in planes: there is none where a side is curved.
  bool aimTensor(const Surroundings& s, FaceRing& ring, const std::vector<Side>& sides, Column& column)
  {
    const bool allowed = gridsOnWakes_ ||
      std::none_of(s.walls.begin(), s.walls.end(),
        [this](const FaceAtVertex& f) { return patches_[f.patch].type == PatchType::Wake; });
    TensorCorner corner;
    if (!allowed || !arePlane(s.others, sides) ||
      !findTensorCorner(column.base, mesh_, ring, normalsOf(sides), corner) || !assignPatches(s, corner))
    {
      return false;
    }
    corner.column = static_cast<Index>(set_.columns.size());
    column.direction = corner.diagonal();
    column.hasGrid = true;
    bend(corner, column);
    set_.corners.push_back(corner);
    return true;
  }

  // Finds each wall's patch; false where a wall has patches of different layers.
  bool assignPatches(const Surroundings& s, TensorCorner& corner) const
  {
    return std::all_of(s.walls.begin(), s.walls.end(),
      [&](const FaceAtVertex& f)
      {
        int& patch = corner.patch[corner.wallOf(f.normal)];
        patch = patch == 0 ? f.patch : patch;
        return plan_[patch] == plan_[f.patch];
      });
  }

  // Between walls of different layers the column rises to each level of both, up to the smaller number of them.
  void bend(const TensorCorner& corner, Column& column)
  {
    bool alike = true;
    for (int w = 0; w < corner.walls; ++w)
    {
      alike = alike && plan_[corner.patch[w]] == plan_[column.patch];
      column.asked = std::min(column.asked, plan_[corner.patch[w]].numberOfLayers);
    }
    column.levels = column.asked;
    if (alike)
    {
      return;
    }
    std::vector<Vector3> places;
    for (int level = 0; level <= column.asked; ++level)
    {
      places.push_back(column.base);
      for (int w = 0; w < corner.walls; ++w)
      {
        places.back() += set_.heights[corner.patch[w]].height(level) * corner.rise[w];
      }
    }
    column.direction = (1 / set_.thickness(column)) * (places.back() - column.base);
    column.bend = static_cast<Index>(set_.bends.size());
    set_.bends.push_back(std::move(places));
  }

  bool aimFan(
    const Surroundings& s, FaceRing& ring, const SideProjection& lay, bool singleSeesAll, Column& column)
  {
    Fan fan;
    fan.single = singleSeesAll ? column.direction : Vector3{};
    const FanAngles angles{ plan_[s.patch].normalAngle / DegreesOfRadian,
      plan_[s.patch].fanAngle / DegreesOfRadian };
    if (!planFan(column.base, mesh_, ring, lay, angles, fan, column.direction))
    {
      return false;
    }
    fan.column = static_cast<Index>(set_.columns.size());
    set_.fans.push_back(std::move(fan));
    return true;
  }

  const TetMesh& mesh_;
  const BoundaryStars& stars_;
  const PatchTable& patches_;
  const LayerPlan& plan_;
  bool gridsOnWakes_;
  ColumnSet set_;
};
} // namespace

ColumnSet buildColumns(const TetMesh& mesh, const BoundaryStars& stars, const PatchTable& patches,
  const LayerPlan& plan, bool gridsOnWakes)
{
  return ColumnMaker(mesh, stars, patches, plan, gridsOnWakes).run();
}

bool settleDisagreements(const TetMesh& mesh, ColumnSet& set)
{
  bool dropped = false;
  for (std::size_t i = 0; i < mesh.boundarySlots(); ++i)
  {
    const auto b = static_cast<Index>(i);
    if (!mesh.boundaryFace(b).isAlive())
    {
      continue;
    }
    const int patch = mesh.boundaryFace(b).patch;
    const auto vertices = mesh.boundaryVertices(b);
    const auto isSideAt = [&](Index v)
    { return set.standingAt(v) != None && set.columns[set.standingAt(v)].staysIn(patch); };
    const bool isSide = std::any_of(vertices.begin(), vertices.end(), isSideAt);
    for (const Index v : vertices)
    {
      if (isSide && set.standingAt(v) != None && !isSideAt(v))
      {
        set.columns[set.standingAt(v)].limit(0, StopReason::Corner);
        dropped = true;
      }
    }
  }
  return dropped;
}
} // namespace ransmesh
