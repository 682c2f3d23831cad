#include "Layers/GapLimits.h"

#include "Layers/ColumnLimits.h"
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
// Faces whose normals differ by less than this cosine (15 degrees) need no rays of their own.
constexpr double SameNormal = 0.966;
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
  for (std::size_t i = 0; i < mesh.tetSlots(); ++i)
  {
    const Tetrahedron& tet = mesh.tet(static_cast<Index>(i));
    for (int corner = 0; tet.isAlive() && corner < 4; ++corner)
    {
      const Index c = set.standingAt(tet.vertex[corner]);
      if (c == None)
      {
        continue;
      }
      const auto face = tet.face(corner);
      const Vector3& a = mesh.point(face[0]);
      const Vector3 normal = normalized(cross(mesh.point(face[1]) - a, mesh.point(face[2]) - a));
      nearest[c] = std::min(nearest[c], dot(normal, mesh.point(tet.vertex[corner]) - a));
    }
  }
  return nearest;
}

class GapFinder
{
public:
  GapFinder(const TetMesh& mesh, const BoundaryStars& stars, double gapFraction, ColumnSet& set)
    : stars_(stars)
    , gapFraction_(gapFraction)
    , set_(set)
    , nearest_(nearestPlanes(mesh, set))
    , fanOf_(set.columns.size(), None)
    , walk_(mesh)
  {
    for (std::size_t i = 0; i < set.fans.size(); ++i)
    {
      fanOf_[set.fans[i].column] = static_cast<Index>(i);
    }
  }

  void limit(Index column)
  {
    Column& c = set_.columns[column];
    if (c.levels == 0)
    {
      return;
    }
    look(column);
    for (const Ray& ray : rays_)
    {
      const double reach = set_.thickness(c) * ray.rise / gapFraction_;
      const double free = nearest_[column] > reach ? reach : walk_.freeDistance(c.root, ray.direction, reach);
      if (free < reach)
      {
        c.limit(levelBelow(set_, c, gapFraction_ * free / ray.rise), StopReason::Gap);
      }
    }
  }

private:
  // Finds the column's rays. In planes that the column stays in they lean away from these.
  void look(Index column)
  {
    const Column& c = set_.columns[column];
    rays_.clear();
    normals_.clear();
    // The sides' own triangles tell the gap along them (followSides); a straight column can see more.
    if (c.path != None)
    {
      return;
    }
    faces_.clear();
    Vector3 inward;
    for (const Index face : stars_.facesAt(c.root))
    {
      faces_.push_back(stars_.seenFrom(c.root, face));
      inward += c.staysIn(faces_.back().patch) ? faces_.back().normal : Vector3{};
    }
    const Vector3 lean = c.sides[0] == 0 ? OddDirection : normalized(inward);
    addRayAlong(c.direction, lean);
    if (fanOf_[column] != None)
    {
      for (const Vector3& direction : set_.fans[fanOf_[column]].directions)
      {
        addRayAlong(direction, lean);
      }
    }
    for (const FaceAtVertex& face : faces_)
    {
      addRayOf(face, c, lean);
    }
  }

  void addRayAlong(const Vector3& direction, const Vector3& lean)
  {
    normals_.push_back(normalized(direction));
    rays_.push_back({ normalized(normals_.back() + Lean * lean), norm(direction) });
  }

  void addRayOf(const FaceAtVertex& face, const Column& c, const Vector3& lean)
  {
    const double rise = dot(face.normal, c.direction);
    const bool isKnown = std::any_of(normals_.begin(), normals_.end(),
      [&face](const Vector3& n) { return dot(n, face.normal) > SameNormal; });
    if (isKnown || c.staysIn(face.patch) || rise < LeastRise)
    {
      return;
    }
    normals_.push_back(face.normal);
    // Over the face, and not past the edge that it ends at.
    const Vector3 over = c.sides[0] == 0 ? face.middle : face.middle + lean;
    rays_.push_back({ normalized(face.normal + Lean * over), rise });
  }

  const BoundaryStars& stars_;
  double gapFraction_;
  ColumnSet& set_;
  std::vector<double> nearest_;
  std::vector<Index> fanOf_; // by column
  RayWalk walk_;
  std::vector<FaceAtVertex> faces_;
  std::vector<Ray> rays_;
  std::vector<Vector3> normals_;
};
} // namespace

void limitByGap(const TetMesh& mesh, const BoundaryStars& stars, double gapFraction, ColumnSet& set)
{
  GapFinder finder(mesh, stars, gapFraction, set);
  for (std::size_t i = 0; i < set.columns.size(); ++i)
  {
    finder.limit(static_cast<Index>(i));
  }
}
} // namespace ransmesh
