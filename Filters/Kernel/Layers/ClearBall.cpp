#include "Layers/ClearBall.h"

#include "Geometry/Distance.h"

#include <algorithm>
#include <numeric>

namespace ransmesh
{
namespace
{
// A ball that would shrink by less stays as it is.
constexpr double Markedly = 0.999;
// Up to so many steps bring it to touch one triangle.
constexpr int MostSteps = 10;
// Walls are joined where a way between two of their places keeps within so many times the distance of these.
constexpr double Joined = 2;
// The way across is free if a ray can go so much of it: where it ends is on the boundary.
constexpr double AllButEnd = 0.98;
} // namespace

ClearBall::ClearBall(const TetMesh& mesh, const BoundaryStars& stars, const ColumnSet& set)
  : mesh_(mesh)
  , stars_(stars)
  , set_(set)
  , walk_(mesh)
  , way_(mesh, stars)
{
}

void ClearBall::collectWalls()
{
  surface_.points = mesh_.points();
  std::vector<Index> faces;
  for (std::size_t i = 0; i < mesh_.boundarySlots(); ++i)
  {
    const auto face = static_cast<Index>(i);
    if (!mesh_.boundaryFace(face).isAlive())
    {
      continue;
    }
    const int patch = mesh_.boundaryFace(face).patch;
    const auto v = mesh_.boundaryVertices(face);
    const auto carries = [&](Index w)
    { return set_.ofVertex[w] != None && !set_.columns[set_.ofVertex[w]].staysIn(patch); };
    if (std::all_of(v.begin(), v.end(), carries))
    {
      surface_.triangles.push_back(v);
      faces.push_back(face);
    }
  }
  std::vector<Index> all(faces.size());
  std::iota(all.begin(), all.end(), Index{ 0 });
  tree_.emplace(surface_, std::move(all));
  walls_.reserve(faces.size());
  for (const Index t : tree_->inOrder())
  {
    const auto& v = surface_.triangles[t];
    walls_.push_back({ stars_.normalOf(faces[t]), mesh_.point(v[0]), v, faces[t] });
  }
}

double ClearBall::diameter(Index root, const Vector3& direction, double widest)
{
  if (!tree_)
  {
    collectWalls();
  }
  root_ = root;
  from_ = mesh_.point(root);
  direction_ = direction;
  setDiameter(widest);
  faceTouched_ = None;
  way_.beginAt(root);
  tree_->visitWithin(ball_,
    [this](Index place)
    {
      if (reaches(walls_[place]))
      {
        shrink(walls_[place]);
      }
    });
  return diameter_;
}

void ClearBall::setDiameter(double diameter)
{
  diameter_ = diameter;
  const double radius = diameter / 2;
  ball_ = { from_ + radius * direction_, radius * radius };
}

// Does the ball cut the plane, and the root see the plane's front? Most triangles end here, at little cost: those of a
// wall that is flat or convex.
bool ClearBall::reaches(const Wall& wall) const
{
  const double height = dot(wall.normal, from_ - wall.origin);
  return height > 0 && height < (diameter_ / 2) * (1 - dot(wall.normal, direction_));
}

// Lets the ball shrink until it touches the triangle, if it reaches that at all.
void ClearBall::shrink(const Wall& wall)
{
  const auto& v = wall.vertex;
  if (std::find(v.begin(), v.end(), root_) != v.end())
  {
    return;
  }
  for (int step = 0; step < MostSteps; ++step)
  {
    const Vector3 place =
      closestPointOnTriangle(ball_.centre, mesh_.point(v[0]), mesh_.point(v[1]), mesh_.point(v[2]));
    const Vector3 way = place - from_;
    const double ahead = dot(way, direction_);
    const bool isInside = ahead > 0 && dot(way, way) < Markedly * diameter_ * ahead;
    if (!isInside || (faceTouched_ != wall.face && !isOther(wall.face, way)))
    {
      return;
    }
    setDiameter(dot(way, way) / ahead);
    faceTouched_ = wall.face;
    placeTouched_ = place;
  }
}

// Does the face, whose front the root sees, belong to another wall, and is the given way to it free?
bool ClearBall::isOther(Index face, const Vector3& way)
{
  const double length = norm(way);
  if (!(length > 0) || way_.leadsTo(face, Joined * length))
  {
    return false;
  }
  const double most = AllButEnd * length;
  return walk_.freeDistance(root_, (1 / length) * way, most) >= most;
}
} // namespace ransmesh
