#include "Layers/GapLimits.h"

#include "Layers/ClearBall.h"
#include "Layers/ColumnLimits.h"
#include "Layers/FaceGaps.h"
#include "Layers/RayWalk.h"

#include <algorithm>
#include <limits>

namespace ransmesh
{
namespace
{
// Rays lean by a thousandth, so that they do not run along the mesh's own edges.
constexpr double Lean = 1e-3;
constexpr Vector3 OddDirection{ 0.53, -0.31, 0.79 };
constexpr double OddShare = 0.618;
// Faces whose normals differ by less than this cosine (15 degrees) need no rays of their own.
constexpr double SameNormal = 0.966;
// Columns may come so near to a side that their neighbours stay in, as a share of the way: these lean with it.
constexpr double ShareToSide = 0.6;
// A face that the column hardly rises above does not limit it.
constexpr double LeastRise = 0.3;

struct Ray
{
  Vector3 direction; // unit
  double rise;       // way along it, or height above its face, for one unit of the column's height
};

// The distance from each column's foot to the nearest plane of a face opposite to it: nothing is nearer.
std::vector<double> nearestPlanes(const TetMesh& mesh, const ColumnSet& set)
{
  std::vector<double> nearest(set.columns.size(), std::numeric_limits<double>::infinity());
  std::vector<Index> standing(mesh.vertexCount()); // small, so that it stays in the cache
  for (std::size_t v = 0; v < standing.size(); ++v)
  {
    standing[v] = set.standingAt(static_cast<Index>(v));
  }
  for (std::size_t i = 0; i < mesh.tetSlots(); ++i)
  {
    const Tetrahedron& tet = mesh.tet(static_cast<Index>(i));
    for (int corner = 0; tet.isAlive() && corner < 4; ++corner)
    {
      const Index c = standing[tet.vertex[corner]];
      if (c == None)
      {
        continue;
      }
      const auto face = tet.face(corner);
      const Vector3& a = mesh.point(face[0]);
      const Vector3 normal = cross(mesh.point(face[1]) - a, mesh.point(face[2]) - a);
      const double volume = dot(normal, mesh.point(tet.vertex[corner]) - a);
      // Squares first: most are not nearer, and a root takes longer than all the rest.
      if (volume * volume < nearest[c] * nearest[c] * dot(normal, normal))
      {
        nearest[c] = volume / norm(normal);
      }
    }
  }
  return nearest;
}

class GapFinder
{
public:
  GapFinder(const TetMesh& mesh, const BoundaryStars& stars, double gapFraction, ColumnSet& set)
    : mesh_(mesh)
    , stars_(stars)
    , gapFraction_(gapFraction)
    , set_(set)
    , nearest_(nearestPlanes(mesh, set))
    , fanOf_(set.columns.size(), None)
    , walk_(mesh)
    , balls_(mesh, stars, set)
  {
    for (std::size_t i = 0; i < set.fans.size(); ++i)
    {
      fanOf_[set.fans[i].column] = static_cast<Index>(i);
    }
    for (const Column& c : set.columns)
    {
      highest_ = std::max(highest_, set.thickness(c));
    }
  }

  void limit(Index column)
  {
    Column& c = set_.columns[column];
    // The sides' own triangles tell the gap along them (followSides); a straight column can see more.
    if (c.levels == 0 || c.path != None)
    {
      return;
    }
    collectSteps(column);
    const double longest = norm(*std::max_element(steps_.begin(), steps_.end(),
      [](const Vector3& a, const Vector3& b) { return dot(a, a) < dot(b, b); }));
    if (nearest_[column] <= set_.thickness(c) * longest / gapFraction_)
    {
      limitAhead(c);
    }
    if (nearest_[column] <= highest_ * longest / gapFraction_)
    {
      limitBeside(c);
    }
  }

  const std::vector<FaceMeeting>& meetings() const { return meetings_; }

private:
  // At the column's root, which comes first of its vertices.
  struct Face
  {
    std::array<Index, 3> vertex;
    Vector3 normal;
    int patch;
  };

  // Limits a column by what rays from its root meet.
  void limitAhead(Column& c)
  {
    collectRays(c);
    for (const Ray& ray : rays_)
    {
      const double reach = set_.thickness(c) * ray.rise / gapFraction_;
      const double free = walk_.freeDistance(c.root, ray.direction, reach);
      if (free < reach)
      {
        const double share = isSideOfNeighbour(walk_.patchHit()) ? ShareToSide : gapFraction_;
        limitHeight(set_, c, share * free / ray.rise, StopReason::Gap);
      }
    }
  }

  // Limits a column by the balls between it and other walls. Of these a face may be met that is to have layers where
  // the column is low for another reason, or has none.
  void limitBeside(Column& c)
  {
    for (const Vector3& step : steps_)
    {
      const double length = norm(step);
      const double room = balls_.diameter(c.root, (1 / length) * step, highest_ * length / gapFraction_);
      if (balls_.faceTouched() != None)
      {
        limitHeight(set_, c, gapFraction_ * room / length, StopReason::Gap);
        meetings_.push_back({ balls_.faceTouched(), balls_.placeTouched(), room });
      }
    }
  }

  // Of the column, or of all those of its fan.
  void collectSteps(Index column)
  {
    steps_.assign(1, set_.columns[column].direction);
    if (fanOf_[column] != None)
    {
      const std::vector<Vector3>& others = set_.fans[fanOf_[column]].directions;
      steps_.insert(steps_.end(), others.begin(), others.end());
    }
  }

  // One along each step, one over each face that turns. In planes that the column stays in they lean away
  // from these.
  void collectRays(const Column& c)
  {
    faces_.clear();
    Vector3 inward;
    for (const Index face : stars_.facesAt(c.root))
    {
      faces_.push_back(
        { stars_.verticesFrom(c.root, face), stars_.normalOf(face), mesh_.boundaryFace(face).patch });
      inward += c.staysIn(faces_.back().patch) ? faces_.back().normal : Vector3{};
    }
    const Vector3 lean = c.sides[0] == 0 ? OddDirection : normalized(inward);
    rays_.clear();
    for (const Vector3& step : steps_)
    {
      rays_.push_back({ normalized(normalized(step) + Lean * lean), norm(step) });
    }
    normals_.clear();
    if (steps_.size() == 1)
    {
      normals_.push_back(normalized(c.direction));
    }
    for (const Face& face : faces_)
    {
      addRayOf(face, c, lean);
    }
  }

  void addRayOf(const Face& face, const Column& c, const Vector3& lean)
  {
    double rise = 0;
    for (const Vector3& step : steps_)
    {
      rise = std::max(rise, dot(face.normal, step));
    }
    const bool isKnown = std::any_of(normals_.begin(), normals_.end(),
      [&face](const Vector3& n) { return dot(n, face.normal) > SameNormal; });
    if (isKnown || c.staysIn(face.patch) || rise < LeastRise)
    {
      return;
    }
    normals_.push_back(face.normal);
    // Over the face, not past the edge that it ends at, and not along its bisector, where meshes like to
    // have edges.
    const Vector3 over = normalized(mesh_.point(face.vertex[1]) - c.base) +
      OddShare * normalized(mesh_.point(face.vertex[2]) - c.base) + (c.sides[0] == 0 ? Vector3{} : lean);
    rays_.push_back({ normalized(face.normal + Lean * over), rise });
  }

  bool isSideOfNeighbour(int patch) const
  {
    return std::any_of(faces_.begin(), faces_.end(),
      [&](const Face& face)
      {
        return std::any_of(face.vertex.begin() + 1, face.vertex.end(),
          [&](Index v)
          {
            const Index c = set_.standingAt(v);
            return c != None && set_.columns[c].staysIn(patch);
          });
      });
  }

  const TetMesh& mesh_;
  const BoundaryStars& stars_;
  double gapFraction_;
  ColumnSet& set_;
  std::vector<double> nearest_;
  std::vector<Index> fanOf_; // by column
  RayWalk walk_;
  ClearBall balls_;
  double highest_ = 0; // of all columns
  std::vector<FaceMeeting> meetings_;
  std::vector<Vector3> steps_;
  std::vector<Face> faces_;
  std::vector<Ray> rays_;
  std::vector<Vector3> normals_; // of faces that need no more rays
};
} // namespace

void limitByGap(const TetMesh& mesh, const BoundaryStars& stars, double gapFraction, ColumnSet& set)
{
  GapFinder finder(mesh, stars, gapFraction, set);
  for (std::size_t i = 0; i < set.columns.size(); ++i)
  {
    finder.limit(static_cast<Index>(i));
  }
  limitFacesMet(mesh, finder.meetings(), gapFraction, set);
  limitInWedges(mesh, stars, gapFraction, set);
}
} // namespace ransmesh
