#include "Insertion/FrontCrossings.h"

#include "Geometry/Predicates.h"
#include "Layers/ColumnLimits.h"
#include "Triangles/TriangleTree.h"

#include <algorithm>
#include <limits>

namespace ransmesh
{
namespace
{
// Lowered columns may still be in the way of others.
constexpr int MostRounds = 3;
// Fronts keep so much of the height at which they would touch.
constexpr double OfTouching = 0.8;
// That height is looked for by so many halvings.
constexpr int Halvings = 12;
// Above smooth walls whose columns have all their layers, and see no other wall, the front is as good as parallel to
// the wall and passes through nothing: below this cosine between the two it is turned.
constexpr double ParallelCosine = 0.9;
// Planes are told apart beyond this share of the lengths: a hundred times what rounding makes.
constexpr double SurelyBeside = 1e-13;

using Corners = std::array<Vector3, 3>;
using Triangle = std::array<Index, 3>;

bool passesThrough(const Vector3& p, const Vector3& q, const Corners& t)
{
  if (orientation(t[0], t[1], t[2], p) * orientation(t[0], t[1], t[2], q) >= 0)
  {
    return false;
  }
  const int side = orientation(p, q, t[0], t[1]);
  return side != 0 && orientation(p, q, t[1], t[2]) == side && orientation(p, q, t[2], t[0]) == side;
}

bool cross(const Corners& s, const Corners& t)
{
  for (int i = 0; i < 3; ++i)
  {
    const int j = (i + 1) % 3;
    if (passesThrough(s[i], s[j], t) || passesThrough(t[i], t[j], s))
    {
      return true;
    }
  }
  return false;
}

Extent boxOf(const Corners& t)
{
  Extent box{ t[0], t[0] };
  box.add(t[1]);
  box.add(t[2]);
  return box;
}

class PlannedFront
{
public:
  PlannedFront(const TetMesh& mesh, ColumnSet& set)
    : mesh_(mesh)
    , set_(set)
    , isOpen_(mesh.vertexCount(), 1)
    , cap_(mesh.vertexCount(), Beyond)
  {
    planned_.points = mesh.points();
    for (std::size_t c = 0; c < set.columns.size(); ++c)
    {
      place(static_cast<Index>(c));
    }
    planned_.triangles.reserve(mesh.boundarySlots());
    for (std::size_t i = 0; i < mesh.boundarySlots(); ++i)
    {
      const auto b = static_cast<Index>(i);
      if (mesh.boundaryFace(b).isAlive())
      {
        planned_.triangles.push_back(mesh.boundaryVertices(b));
      }
    }
  }

  std::size_t limit()
  {
    std::vector<Index> suspects = findSuspects();
    for (int round = 0; round < MostRounds && !suspects.empty(); ++round)
    {
      capCrossing(suspects);
      spreadCaps();
      suspects = lower();
    }
    return static_cast<std::size_t>(
      std::count_if(cap_.begin(), cap_.end(), [](double cap) { return cap < Beyond; }));
  }

private:
  static constexpr double Beyond = std::numeric_limits<double>::infinity();

  void place(Index column)
  {
    const Column& c = set_.columns[column];
    if (c.levels > 0)
    {
      planned_.points[c.vertex] = set_.pointAt(c, c.levels);
    }
  }

  Corners corners(const Triangle& t) const
  {
    return { planned_.points[t[0]], planned_.points[t[1]], planned_.points[t[2]] };
  }
  Corners cornersOf(Index triangle) const { return corners(planned_.triangles[triangle]); }

  // The triangles that may pass through others, and along the way the vertices whose triangles all face the same way.
  std::vector<Index> findSuspects()
  {
    std::vector<Index> suspects;
    for (std::size_t i = 0; i < planned_.triangles.size(); ++i)
    {
      const Triangle& t = planned_.triangles[i];
      Corners base = cornersOf(static_cast<Index>(i));
      const Vector3 normal = cross(base[1] - base[0], base[2] - base[0]);
      bool isLow = false;
      bool isCarried = false;
      for (int k = 0; k < 3; ++k)
      {
        const Index v = set_.ofVertex[t[k]];
        if (v == None)
        {
          isOpen_[t[k]] = 0;
          continue;
        }
        const Column& c = set_.columns[v];
        base[k] = c.base;
        isOpen_[t[k]] = isOpen_[t[k]] != 0 && dot(normal, c.direction) > 0;
        isLow = isLow || c.levels < c.asked || c.squeezed != None;
        isCarried = true;
      }
      const Vector3 below = cross(base[1] - base[0], base[2] - base[0]);
      const double along = dot(normal, below);
      const bool isParallel = along > 0 &&
        along * along > ParallelCosine * ParallelCosine * dot(normal, normal) * dot(below, below);
      if (isCarried && (isLow || !isParallel))
      {
        suspects.push_back(static_cast<Index>(i));
      }
    }
    return suspects;
  }

  void capCrossing(const std::vector<Index>& suspects)
  {
    std::vector<char> isSuspect(planned_.triangles.size(), 0);
    for (const Index s : suspects)
    {
      isSuspect[s] = 1;
    }
    const TriangleTree tree(planned_, suspects);
    for (std::size_t i = 0; i < planned_.triangles.size(); ++i)
    {
      const auto t = static_cast<Index>(i);
      tree.visitMeeting(boxOf(cornersOf(t)),
        [&](Index s)
        {
          if ((isSuspect[t] == 0 || s < t) && mayCross(s, t) && cross(cornersOf(s), cornersOf(t)))
          {
            capBoth(planned_.triangles[s], planned_.triangles[t]);
          }
        });
    }
  }

  // False for most: neighbours, and those beside each other's plane.
  bool mayCross(Index first, Index second) const
  {
    const Triangle& s = planned_.triangles[first];
    const Triangle& t = planned_.triangles[second];
    int shared = 0;
    Index common = None;
    for (const Index v : s)
    {
      if (std::find(t.begin(), t.end(), v) != t.end())
      {
        common = v;
        ++shared;
      }
    }
    const bool isOfOneStar = shared == 1 && isOpen_[common] != 0;
    return shared < 2 && !isOfOneStar && !isBeside(s, t) && !isBeside(t, s);
  }

  // Do all corners of t, but one in common, lie on one side of the plane of s?
  bool isBeside(const Triangle& s, const Triangle& t) const
  {
    const Corners c = corners(s);
    const Vector3 normal = cross(c[1] - c[0], c[2] - c[0]);
    double lowest = Beyond;
    double highest = -Beyond;
    double square = 0;
    for (const Index v : t)
    {
      if (std::find(s.begin(), s.end(), v) == s.end())
      {
        const Vector3 way = planned_.points[v] - c[0];
        const double height = dot(normal, way);
        lowest = std::min(lowest, height);
        highest = std::max(highest, height);
        square = std::max(square, dot(way, way));
      }
    }
    const double margin = SurelyBeside * std::sqrt(square * dot(normal, normal));
    return lowest > margin || highest < -margin;
  }

  // Caps the columns at two triangles that cross.
  void capBoth(const Triangle& s, const Triangle& t)
  {
    double low = 0;
    double high = std::max(highestAt(s), highestAt(t));
    for (int i = 0; i < Halvings; ++i)
    {
      const double middle = (low + high) / 2;
      (cross(cornersBelow(s, middle), cornersBelow(t, middle)) ? high : low) = middle;
    }
    for (const Triangle& triangle : { s, t })
    {
      for (const Index v : triangle)
      {
        const Index c = set_.standingAt(v);
        if (c != None && set_.thickness(set_.columns[c]) > OfTouching * low)
        {
          cap_[v] = std::min(cap_[v], OfTouching * low);
        }
      }
    }
  }

  double highestAt(const Triangle& t) const
  {
    double highest = 0;
    for (const Index v : t)
    {
      const Index c = set_.standingAt(v);
      highest = c == None ? highest : std::max(highest, set_.thickness(set_.columns[c]));
    }
    return highest;
  }

  // Where the triangle would be if no column were higher than this.
  Corners cornersBelow(const Triangle& t, double height) const
  {
    Corners result = corners(t);
    for (int k = 0; k < 3; ++k)
    {
      const Index c = set_.standingAt(t[k]);
      if (c != None && set_.thickness(set_.columns[c]) > height)
      {
        result[k] = set_.pointAtHeight(set_.columns[c], height);
      }
    }
    return result;
  }

  // From top to top, by the slope that is allowed between their columns.
  void spreadCaps()
  {
    for (bool more = true; more;)
    {
      more = false;
      for (const Triangle& t : planned_.triangles)
      {
        if (std::min({ cap_[t[0]], cap_[t[1]], cap_[t[2]] }) < Beyond)
        {
          for (int k = 0; k < 6; ++k)
          {
            more = spread(t[k % 3], t[(k + 1 + k / 3) % 3]) || more;
          }
        }
      }
    }
  }

  bool spread(Index from, Index to)
  {
    const Index lower = set_.standingAt(from);
    const Index higher = set_.standingAt(to);
    if (lower == None || higher == None)
    {
      return false;
    }
    const double apart = distance(set_.columns[lower].base, set_.columns[higher].base);
    const double allowed = cap_[from] + LargestSlope * apart;
    if (allowed >= std::min(cap_[to], set_.thickness(set_.columns[higher])))
    {
      return false;
    }
    cap_[to] = allowed;
    return true;
  }

  // Lowers the columns to their caps. Gives the triangles at those that have become lower.
  std::vector<Index> lower()
  {
    std::vector<char> isLowered(mesh_.vertexCount(), 0);
    for (std::size_t i = 0; i < set_.columns.size(); ++i)
    {
      Column& c = set_.columns[i];
      const double before = set_.thickness(c);
      if (before > cap_[c.vertex])
      {
        limitHeight(set_, c, cap_[c.vertex], StopReason::Gap);
        place(static_cast<Index>(i));
        isLowered[c.vertex] = set_.thickness(c) < before;
      }
    }
    std::vector<Index> concerned;
    for (std::size_t i = 0; i < planned_.triangles.size(); ++i)
    {
      const Triangle& t = planned_.triangles[i];
      if (std::any_of(t.begin(), t.end(), [&](Index v) { return isLowered[v] != 0; }))
      {
        concerned.push_back(static_cast<Index>(i));
      }
    }
    return concerned;
  }

  const TetMesh& mesh_;
  ColumnSet& set_;
  SurfaceMesh planned_;      // the whole boundary, with the tops where they are to be
  std::vector<char> isOpen_; // by vertex: do all triangles at it face the way that its column goes?
  std::vector<double> cap_;  // on heights, by vertex
};
} // namespace

std::size_t limitByCrossings(const TetMesh& mesh, ColumnSet& set)
{
  return PlannedFront(mesh, set).limit();
}
} // namespace ransmesh
