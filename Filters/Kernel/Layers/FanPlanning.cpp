#include "Layers/FanPlanning.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace ransmesh
{
namespace
{
// A group's column sees its faces at least so well.
constexpr double LeastVisibility = 0.1;
// Faces around a tip, without a sharp edge among them, are parted where one column would see them worse.
constexpr double TipVisibility = 0.35;
constexpr double TipTurn = std::numbers::pi / 3;
// The main column amid the others lies so far inside their cone.
constexpr double LeastInside = 0.05;
// Neighbouring columns turn about the edge between their faces by at least so much (the sine).
constexpr double LeastOpening = 0.05;
// Directions that are nearly opposite do not say which way to turn from one to the other.
constexpr double Opposite = -0.985;

struct Group
{
  FaceGroup faces;
  Vector3 step;      // rises by one above these
  Vector3 direction; // of it, unit
};

Vector3 rotated(const Vector3& d, const Vector3& axis, double angle)
{
  const double c = std::cos(angle);
  return c * d + std::sin(angle) * cross(axis, d) + ((1 - c) * dot(axis, d)) * axis;
}

class Planner
{
public:
  Planner(const Vector3& point, const TetMesh& mesh, FaceRing& ring, const SideProjection& lay,
    const FanAngles& angles)
    : point_(point)
    , mesh_(mesh)
    , ring_(ring)
    , lay_(lay)
    , angles_(angles)
  {
  }

  bool run(Fan& fan, Vector3& main)
  {
    groups_ = aimed(sharpGroups());
    if (groups_.size() == 1 && visibilityOf(groups_[0]) < TipVisibility)
    {
      groups_ = aimed(tipGroups());
    }
    if (plan(fan, main))
    {
      return true;
    }
    const bool oneColumnDoes = norm(fan.single) > 0 &&
      visibility(normalsOf(std::span(ring_.faces)), normalized(fan.single)) >= TipVisibility;
    return !oneColumnDoes && planHalves(fan, main);
  }

private:
  // A fan of the groups. False, and all as it was, where none opens.
  bool plan(Fan& fan, Vector3& main) const
  {
    if (groups_.size() < 2 || leastVisibility(groups_) < LeastVisibility)
    {
      return false;
    }
    Fan planned;
    planned.column = fan.column;
    planned.single = fan.single;
    planned.closed = ring_.closed;
    planned.anchor = { ring_.faces[0].vertex[1], ring_.faces[0].vertex[2] };
    planned.aroundMain = groups_.size() > 2;
    Vector3 own = main;
    if (!(planned.aroundMain ? planAround(planned, own) : planRow(planned, own)) ||
      !opensOverEdges(planned, own))
    {
      return false;
    }
    fan = std::move(planned);
    main = own;
    return true;
  }

  std::vector<FaceGroup> sharpGroups()
  {
    return splitRing(ring_,
      [this](std::size_t i)
      {
        const Turn turn = ring_.turnAfter(point_, mesh_, i);
        return turn.isConvex && turn.angle > angles_.normalAngle;
      });
  }

  // Parts the faces around a tip into groups that turn by about the same.
  std::vector<FaceGroup> tipGroups()
  {
    std::vector<double> turned(ring_.edgeCount() + 1, 0);
    for (std::size_t i = 0; i < ring_.edgeCount(); ++i)
    {
      const Turn turn = ring_.turnAfter(point_, mesh_, i);
      turned[i + 1] = turned[i] + (turn.isConvex ? turn.angle : 0);
    }
    const double total = turned.back();
    if (total == 0) // into a tip, not around it
    {
      return { { 0, ring_.faces.size() } };
    }
    const double parts = std::max(ring_.closed ? 3.0 : 2.0, std::ceil(total / TipTurn));
    return splitRing(ring_,
      [&](std::size_t i)
      { return std::floor(parts * turned[i] / total) != std::floor(parts * turned[i + 1] / total); });
  }

  // Parts the faces in two where a fan opens and both columns see theirs best: for the end of an edge that is too sharp
  // for one column, in a wall that has no second edge there. Fans open over borders, so none is concave, and they run
  // across the way from one column to the other.
  bool planHalves(Fan& fan, Vector3& main)
  {
    halved_ = true;
    double highest = 0;
    const Vector3 single = main;
    const FaceRing ring = ring_;
    const std::vector<std::size_t> borders = possibleBorders();
    for (std::size_t i = 0; i < borders.size(); ++i)
    {
      for (std::size_t j = ring.closed ? i + 1 : i; j < (ring.closed ? borders.size() : i + 1); ++j)
      {
        ring_ = ring;
        groups_ =
          aimed(splitRing(ring_, [&](std::size_t edge) { return edge == borders[i] || edge == borders[j]; }));
        const double score = groups_.size() == 2 ? scoreOf(groups_) : 0;
        Vector3 own = single;
        if (score > highest && plan(fan, own))
        {
          highest = score;
          main = own;
        }
      }
    }
    return highest > 0;
  }

  std::vector<std::size_t> possibleBorders() const
  {
    std::vector<std::size_t> borders;
    for (std::size_t i = 0; i < ring_.edgeCount(); ++i)
    {
      const Turn turn = ring_.turnAfter(point_, mesh_, i);
      if (turn.isConvex || turn.angle < angles_.normalAngle)
      {
        borders.push_back(i);
      }
    }
    return borders;
  }

  // How well two halves see their faces; of those that see alike, which have borders across.
  double scoreOf(const std::vector<Group>& halves) const
  {
    constexpr double weight = 0.05;
    const Vector3 way = normalized(halves[1].direction - halves[0].direction);
    const double along = std::fabs(dot(way, edgeAfter(halves[0]))) +
      (ring_.closed ? std::fabs(dot(way, edgeAfter(halves[1]))) : 0);
    return leastVisibility(halves) - weight * along;
  }

  std::vector<Group> aimed(const std::vector<FaceGroup>& parts) const
  {
    std::vector<Group> groups;
    for (const FaceGroup& part : parts)
    {
      const auto faces = part.of(ring_);
      const Vector3 seeing = mostVisible(normalsOf(faces), lay_, lay_(weightedNormal(faces)));
      const Vector3 step = evenStep(faces, lay_, seeing);
      groups.push_back({ part, step, normalized(step) });
    }
    return groups;
  }

  double visibilityOf(const Group& g) const { return visibility(normalsOf(g.faces.of(ring_)), g.direction); }
  double leastVisibility(const std::vector<Group>& groups) const
  {
    double least = 1;
    for (const Group& g : groups)
    {
      least = std::min(least, visibilityOf(g));
    }
    return least;
  }

  // The edge behind a group, from the point on.
  Vector3 edgeAfter(const Group& g) const
  {
    return normalized(mesh_.point(ring_.faces[g.faces.first + g.faces.count - 1].vertex[2]) - point_);
  }

  // Directions between a and b, both left out, turning about the axis that leads from one to the other,
  // or, where they are opposite, about the one given.
  std::vector<Vector3> between(const Vector3& a, const Vector3& b, const Vector3& axisOfOpposite) const
  {
    const double cosine = dot(a, b);
    Vector3 axis = cosine > Opposite ? cross(a, b) : axisOfOpposite - dot(axisOfOpposite, a) * a;
    axis = normalized(axis);
    const double angle = std::atan2(norm(cross(a, b)), cosine);
    const int intervals = std::max(1, static_cast<int>(std::ceil(angle / angles_.fanAngle - 0.01)));
    std::vector<Vector3> directions;
    for (int s = 1; s < intervals; ++s)
    {
      directions.push_back(lay_(rotated(a, axis, angle * s / intervals)));
    }
    return directions;
  }

  // Where a sharp edge ends in a wall, the way straight from one column to the other would lead along the edge.
  bool bordersFold(const Group& first, const Group& last) const
  {
    constexpr double least = 0.5; // of two edges that enclose 150 degrees
    const Vector3 edges = edgeAfter(first) + edgeAfter(last);
    const Vector3 straight = first.direction + last.direction;
    return norm(edges) > least && dot(edges, straight) > 0;
  }

  // Directions from a over the middle to b, the ends left out.
  std::vector<Vector3> through(const Vector3& a, const Vector3& middle, const Vector3& b) const
  {
    std::vector<Vector3> directions = between(a, middle, {});
    directions.push_back(lay_(middle));
    const std::vector<Vector3> rest = between(middle, b, {});
    directions.insert(directions.end(), rest.begin(), rest.end());
    return directions;
  }

  // Two groups: their columns and those between make one row, walked there and back.
  bool planRow(Fan& fan, Vector3& main) const
  {
    const Group& first = groups_[0];
    const Group& last = groups_[1];
    Vector3 axis = -1.0 * edgeAfter(first);
    axis = ring_.closed ? axis + edgeAfter(last) : axis;
    fan.directions = { first.step };
    const std::vector<Vector3> inner = halved_ && ring_.closed && bordersFold(first, last)
      ? through(first.direction, normalized(edgeAfter(first) + edgeAfter(last)), last.direction)
      : between(first.direction, last.direction, axis);
    fan.directions.insert(fan.directions.end(), inner.begin(), inner.end());
    main = last.step;
    const int mainNumber = static_cast<int>(fan.directions.size());
    for (int i = 0; i <= mainNumber; ++i)
    {
      const std::size_t faces = i == 0 ? first.faces.count : i == mainNumber ? last.faces.count : 0;
      fan.walk.push_back({ i, static_cast<int>(faces) });
    }
    for (int i = mainNumber - 1; ring_.closed && i > 0; --i)
    {
      fan.walk.push_back({ i, 0 });
    }
    return true;
  }

  // More groups: the main column stands amid the others.
  bool planAround(Fan& fan, Vector3& main) const
  {
    std::vector<Vector3> units;
    const auto add = [&](const Vector3& step, std::size_t faces)
    {
      fan.walk.push_back({ static_cast<int>(fan.directions.size()), static_cast<int>(faces) });
      fan.directions.push_back(step);
      units.push_back(normalized(step));
    };
    for (std::size_t i = 0; i < groups_.size(); ++i)
    {
      const Group& g = groups_[i];
      add(g.step, g.faces.count);
      if (ring_.closed || i + 1 < groups_.size())
      {
        const Group& next = groups_[(i + 1) % groups_.size()];
        for (const Vector3& d : between(g.direction, next.direction, -1.0 * edgeAfter(g)))
        {
          add(d, 0);
        }
      }
    }
    std::vector<Vector3> cone;
    Vector3 middle;
    for (std::size_t i = 0; i < units.size(); ++i)
    {
      middle += units[i];
      if (ring_.closed || i + 1 < units.size())
      {
        cone.push_back(normalized(cross(units[i], units[(i + 1) % units.size()])));
      }
    }
    const Vector3 amid = mostVisible(cone, lay_, lay_(middle));
    const bool isInside = visibility(cone, amid) > LeastInside;
    main = isInside ? amid : main;
    return isInside;
  }

  // Do the columns turn about the edges between the faces that they lift? Where the wall has folds beside an edge, its
  // faces' columns may lean so that they turn the other way: no tetrahedron between them would be positive, however low
  // the layers are.
  bool opensOverEdges(const Fan& fan, const Vector3& main) const
  {
    const auto directionOf = [&](const FanStep& step)
    {
      return normalized(
        step.column < static_cast<int>(fan.directions.size()) ? fan.directions[step.column] : main);
    };
    const std::size_t pairs = fan.closed ? fan.walk.size() : fan.walk.size() - 1;
    std::size_t lifted = 0;
    for (std::size_t i = 0; i < pairs; ++i)
    {
      lifted += static_cast<std::size_t>(fan.walk[i].faces);
      const Vector3 edge = normalized(mesh_.point(ring_.faces[lifted - 1].vertex[2]) - point_);
      const Vector3 turn = cross(directionOf(fan.walk[i]), directionOf(fan.walk[(i + 1) % fan.walk.size()]));
      if (dot(turn, edge) > -LeastOpening)
      {
        return false;
      }
    }
    return true;
  }

  const Vector3& point_;
  const TetMesh& mesh_;
  FaceRing& ring_;
  const SideProjection& lay_;
  const FanAngles& angles_;
  std::vector<Group> groups_;
  bool halved_ = false; // not all borders of the groups are sharp edges
};
} // namespace

bool planFan(const Vector3& point, const TetMesh& mesh, FaceRing& ring, const SideProjection& lay,
  const FanAngles& angles, Fan& fan, Vector3& main)
{
  return Planner(point, mesh, ring, lay, angles).run(fan, main);
}
} // namespace ransmesh
