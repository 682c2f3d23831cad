#include "Removal/CornerRegion.h"

#include "Boundary/BoundaryStars.h"
#include "Geometry/Angles.h"
#include "Geometry/Distance.h"
#include "Layers/TensorCorner.h"
#include "Mesh/Marks.h"
#include "Removal/WallReach.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <tuple>
#include <utility>

namespace ransmesh
{
namespace
{
// Where walls turn less into each other (degrees), columns hardly lean over the points beside the ridge.
constexpr double LeastTurn = 45;

// How far over the wall the layers of one that turns so much into it (radians) reach, for each unit of their height:
// the corner's column leans by half the turn, and a grid is as wide as its other wall's step.
double wayAlongWall(double turn)
{
  const double ofColumn = std::tan(turn / 2);
  return turn * DegreesOfRadian < leastTensorTurn ? ofColumn : std::max(ofColumn, 1 / std::sin(turn));
}

// An edge between two walls, as the triangle on one of its sides has it.
struct RidgeSide
{
  Index low;
  Index high;
  Index face;
};

struct Triangle
{
  Vector3 normal; // unit
  Vector3 middle;
  double size; // mean edge
};

class CornerSearch
{
public:
  CornerSearch(const TetMesh& mesh, const BoundaryStars& stars, const Classification& classification,
    const std::vector<char>& changeable, const LayerPlan& plan, double margin)
    : mesh_(mesh)
    , stars_(stars)
    , classification_(classification)
    , changeable_(changeable)
    , plan_(plan)
    , margin_(margin)
  {
    for (const LayerSpecification& s : plan)
    {
      heights_.emplace_back(s);
    }
  }

  std::vector<CornerPoint> run()
  {
    collectRidges();
    if (!ridges_.empty())
    {
      found_.clear(mesh_.vertexCount());
      for (std::size_t i = 0; i + 1 < ridges_.size(); ++i)
      {
        const bool pair = ridges_[i].low == ridges_[i + 1].low && ridges_[i].high == ridges_[i + 1].high;
        if (pair)
        {
          lookFrom(ridges_[i], ridges_[i + 1]);
          lookFrom(ridges_[i + 1], ridges_[i]);
        }
      }
    }
    return points_;
  }

private:
  bool isLayered(int patch) const
  {
    return static_cast<std::size_t>(patch) < plan_.size() && plan_[patch].hasLayers();
  }

  // The ridge edges of the walls' triangles, those of one edge side by side.
  void collectRidges()
  {
    for (std::size_t i = 0; i < mesh_.vertexCount(); ++i)
    {
      const auto low = static_cast<Index>(i);
      const auto ends = classification_.ridges.at(low);
      if (ends.empty())
      {
        continue;
      }
      for (const Index b : stars_.facesAt(low))
      {
        const auto v = stars_.verticesFrom(low, b);
        for (const Index high : { v[1], v[2] })
        {
          if (high > low && isLayered(mesh_.boundaryFace(b).patch) &&
            std::find(ends.begin(), ends.end(), high) != ends.end())
          {
            ridges_.push_back({ low, high, b });
          }
        }
      }
    }
    std::sort(ridges_.begin(), ridges_.end(),
      [](const RidgeSide& a, const RidgeSide& b)
      { return std::tie(a.low, a.high, a.face) < std::tie(b.low, b.high, b.face); });
  }

  Triangle triangle(Index face) const
  {
    const auto v = mesh_.boundaryVertices(face);
    const Vector3& a = mesh_.point(v[0]);
    const Vector3& b = mesh_.point(v[1]);
    const Vector3& c = mesh_.point(v[2]);
    return { normalized(cross(b - a, c - a)), (1.0 / 3) * (a + b + c),
      (distance(a, b) + distance(b, c) + distance(c, a)) / 3 };
  }

  // Looks over the wall of here, from the ridge outward, as far as the layers of there reach.
  void lookFrom(const RidgeSide& here, const RidgeSide& there)
  {
    const Triangle on = triangle(here.face);
    const Triangle other = triangle(there.face);
    const double turn = degreesBetween(on.normal, other.normal);
    const bool concave = dot(other.normal, on.middle - mesh_.point(here.low)) > 0;
    if (!concave || turn < LeastTurn || turn > largestTensorTurn)
    {
      return;
    }
    const int patch = mesh_.boundaryFace(there.face).patch;
    const double size = std::max(on.size, other.size);
    const double thickness = limitedThickness(heights_[patch], plan_[patch].isotropicFraction, size);
    if (thickness > 0)
    {
      const double beyond = margin_ * std::min(1.0, thickness * thickness / (size * size)) * size;
      reach_ = (thickness + beyond) * wayAlongWall(turn / DegreesOfRadian);
      followRidge(here);
      flood(here);
    }
  }

  // The vertices of the ridge itself, both ways from the edge, as far as its next corners.
  void followRidge(const RidgeSide& edge)
  {
    ofRidge_ = { edge.low, edge.high };
    for (auto [from, at] : { std::array{ edge.low, edge.high }, std::array{ edge.high, edge.low } })
    {
      while (classification_.kind[at] == VertexKind::Ridge && distanceTo(edge, at) <= reach_)
      {
        const auto ends = classification_.ridges.at(at);
        const Index next = ends[0] == from ? ends[1] : ends[0];
        from = std::exchange(at, next);
        if (at == edge.low || at == edge.high)
        {
          break;
        }
        ofRidge_.push_back(at);
      }
    }
  }

  double distanceTo(const RidgeSide& edge, Index v) const
  {
    const Vector3& a = mesh_.point(edge.low);
    return distanceToTriangle(mesh_.point(v), a, mesh_.point(edge.high), a);
  }

  // Over the triangles of the wall that have a point within reach, not beyond its ridges.
  void flood(const RidgeSide& edge)
  {
    seen_.clear(mesh_.boundarySlots());
    seen_.set(edge.face);
    faces_.assign(1, edge.face);
    // They become more as the loop goes.
    for (std::size_t i = 0; i < faces_.size(); ++i) // NOLINT(modernize-loop-convert)
    {
      const auto v = mesh_.boundaryVertices(faces_[i]);
      for (int j = 0; j < 3; ++j)
      {
        const Index from = v[j];
        const Index to = v[(j + 1) % 3];
        const bool near = offer(from, edge, faces_[i]);
        if ((near || distanceTo(edge, to) <= reach_) && !classification_.ridges.has(from, to))
        {
          goBeyond(from, to);
        }
      }
    }
  }

  void goBeyond(Index from, Index to)
  {
    for (const Index b : stars_.facesAt(from))
    {
      const auto v = mesh_.boundaryVertices(b);
      if ((v[0] == to || v[1] == to || v[2] == to) && seen_.set(b))
      {
        faces_.push_back(b);
      }
    }
  }

  // Whether v is within reach of the edge; notes it if it may go.
  bool offer(Index v, const RidgeSide& edge, Index face)
  {
    if (distanceTo(edge, v) > reach_)
    {
      return false;
    }
    if (mayGo(v) && std::find(ofRidge_.begin(), ofRidge_.end(), v) == ofRidge_.end() && found_.set(v))
    {
      const bool onSurface = classification_.kind[v] == VertexKind::Surface;
      points_.push_back({ v, reach_, onSurface ? triangle(face).normal : Vector3{} });
    }
    return true;
  }

  bool mayGo(Index v) const
  {
    const auto patches = classification_.patchesAt(v);
    return classification_.kind[v] != VertexKind::Corner && !classification_.frozen[v] &&
      std::all_of(
        patches.begin(), patches.end(), [this](int p) { return isLayered(p) || changeable_[p] != 0; });
  }

  const TetMesh& mesh_;
  const BoundaryStars& stars_;
  const Classification& classification_;
  const std::vector<char>& changeable_;
  const LayerPlan& plan_;
  double margin_;
  std::vector<LayerHeights> heights_;
  std::vector<RidgeSide> ridges_;
  std::vector<CornerPoint> points_;
  double reach_ = 0; // of the layers over the wall looked at
  std::vector<Index> ofRidge_;
  std::vector<Index> faces_;
  Marks seen_;
  Marks found_;
};
} // namespace

std::vector<CornerPoint> findCornerPoints(const TetMesh& mesh, const BoundaryStars& stars,
  const Classification& classification, const std::vector<char>& changeable, const LayerPlan& plan,
  double margin)
{
  return CornerSearch(mesh, stars, classification, changeable, plan, margin).run();
}
} // namespace ransmesh
