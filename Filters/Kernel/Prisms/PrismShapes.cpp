#include "Prisms/PrismShapes.h"

#include "Geometry/Predicates.h"
#include "Geometry/TetrahedronMeasures.h"

#include <algorithm>
#include <iterator>

namespace ransmesh
{
namespace
{
// The point of a column that starts at v, along the edge of a quadrilateral, in the triangle top; or None.
Index above(Index v, const std::array<Index, 4>& quad, const std::array<Index, 3>& top)
{
  const auto at = std::find(quad.begin(), quad.end(), v) - quad.begin();
  if (at == 4)
  {
    return None;
  }
  for (const auto step : { 1, 3 })
  {
    const Index next = quad[(at + step) % 4];
    if (std::find(top.begin(), top.end(), next) != top.end())
    {
      return next;
    }
  }
  return None;
}

// The one corner of the tetrahedron that is not on the face.
Index cornerOff(const std::array<Index, 4>& tet, HalfFace h)
{
  return tet[faceOf(h)];
}
} // namespace

std::vector<Index> PrismShapes::keptQuads(Index group) const
{
  const PrismGroup& g = groups_.groups[group];
  std::vector<Index> kept;
  std::copy_if(g.quad.begin(), g.quad.begin() + g.quads, std::back_inserter(kept),
    [this](Index q) { return groups_.quads[q].isKept; });
  return kept;
}

std::array<Index, 4> PrismShapes::cornersOf(Index group, Index quad) const
{
  const LateralQuad& q = groups_.quads[quad];
  const auto& c = q.corner;
  return q.sideOf(group) == 0 ? c : std::array<Index, 4>{ c[0], c[3], c[2], c[1] };
}

bool PrismShapes::isPyramid(Index group, Index quad) const
{
  return pyramidOf(group, quad).has_value();
}

std::optional<Pyramid> PrismShapes::pyramidOf(Index group, Index quad) const
{
  const LateralQuad& q = groups_.quads[quad];
  const auto& half = q.half[q.sideOf(group)];
  const Index tip = cornerOff(mesh_.tetrahedra[tetOf(half[0])], half[0]);
  if (tip != cornerOff(mesh_.tetrahedra[tetOf(half[1])], half[1]))
  {
    return std::nullopt;
  }
  const auto c = cornersOf(group, quad);
  const Pyramid pyramid{ c[0], c[1], c[2], c[3], tip };
  return isSound(pyramid, mesh_.points) ? std::optional(pyramid) : std::nullopt;
}

// Is the face one between two tetrahedra of the group?
bool PrismShapes::isInside(Index group, const std::array<Index, 3>& face, Index tet) const
{
  const PrismGroup& g = groups_.groups[group];
  return std::any_of(g.tet.begin(), g.tet.begin() + g.size,
    [&](Index other)
    {
      const auto& v = mesh_.tetrahedra[other];
      return other != tet &&
        std::all_of(
          face.begin(), face.end(), [&v](Index p) { return std::find(v.begin(), v.end(), p) != v.end(); });
    });
}

std::vector<std::array<Index, 3>> PrismShapes::plainFaces(Index group) const
{
  const PrismGroup& g = groups_.groups[group];
  std::vector<HalfFace> covered;
  for (const Index quad : keptQuads(group))
  {
    const LateralQuad& q = groups_.quads[quad];
    const auto& half = q.half[q.sideOf(group)];
    covered.insert(covered.end(), half.begin(), half.end());
  }
  std::vector<std::array<Index, 3>> faces;
  for (int i = 0; i < g.size; ++i)
  {
    for (int f = 0; f < 4; ++f)
    {
      const auto& v = mesh_.tetrahedra[g.tet[i]];
      const std::array<Index, 3> face{ v[FaceCorners[f][0]], v[FaceCorners[f][1]], v[FaceCorners[f][2]] };
      const bool isCovered =
        std::find(covered.begin(), covered.end(), halfFace(g.tet[i], f)) != covered.end();
      if (!isCovered && !isInside(group, face, g.tet[i]))
      {
        faces.push_back(face);
      }
    }
  }
  return faces;
}

std::optional<Wedge> PrismShapes::wedgeOf(Index group) const
{
  const std::vector<Index> quads = keptQuads(group);
  const std::vector<std::array<Index, 3>> caps = plainFaces(group);
  if (quads.size() != 3 || caps.size() != 2)
  {
    return std::nullopt;
  }
  std::array<Index, 3> top{ None, None, None };
  for (int i = 0; i < 3; ++i)
  {
    for (const Index quad : quads)
    {
      const Index found = above(caps[0][i], cornersOf(group, quad), caps[1]);
      if (found != None && top[i] != None && top[i] != found)
      {
        return std::nullopt;
      }
      top[i] = found != None ? found : top[i];
    }
  }
  const auto& low = caps[0]; // turned inward; a wedge's first triangle is turned outward
  const Wedge wedge{ low[0], low[2], low[1], top[0], top[2], top[1] };
  Wedge sorted = wedge;
  std::sort(sorted.begin(), sorted.end());
  const bool areDifferent = std::adjacent_find(sorted.begin(), sorted.end()) == sorted.end();
  return areDifferent && sorted[0] != None && isSound(wedge, mesh_.points) ? std::optional(wedge)
                                                                           : std::nullopt;
}

// The one point that the quadrilaterals join to a corner of the base, beside those of the base; or None.
Index PrismShapes::beside(
  Index point, const std::vector<Index>& quads, const std::array<Index, 4>& base) const
{
  Index found = None;
  for (const Index quad : quads)
  {
    const auto& c = groups_.quads[quad].corner;
    const auto at = std::find(c.begin(), c.end(), point) - c.begin();
    for (const auto step : { 1, 3 })
    {
      const Index next = at < 4 ? c[(at + step) % 4] : None;
      const bool isNew =
        next != None && next != found && std::find(base.begin(), base.end(), next) == base.end();
      if (isNew && found != None)
      {
        return None;
      }
      found = isNew ? next : found;
    }
  }
  return found;
}

std::optional<Hexahedron> PrismShapes::hexahedronOf(Index group) const
{
  const std::vector<Index> quads = keptQuads(group);
  if (quads.size() != 6 || pointsOf(group).size() != 8)
  {
    return std::nullopt;
  }
  const std::array<Index, 4> base = cornersOf(group, quads[0]); // turned into the group
  Hexahedron cell;
  for (int i = 0; i < 4; ++i)
  {
    cell[i] = base[i];
    cell[i + 4] = beside(base[i], quads, base);
  }
  Hexahedron sorted = cell;
  std::sort(sorted.begin(), sorted.end());
  const bool areDifferent = std::adjacent_find(sorted.begin(), sorted.end()) == sorted.end();
  return areDifferent && sorted[0] != None && isSound(cell, mesh_.points) ? std::optional(cell)
                                                                          : std::nullopt;
}

std::vector<Index> PrismShapes::pointsOf(Index group) const
{
  const PrismGroup& g = groups_.groups[group];
  std::vector<Index> corners;
  for (int i = 0; i < g.size; ++i)
  {
    const auto& tet = mesh_.tetrahedra[g.tet[i]];
    corners.insert(corners.end(), tet.begin(), tet.end());
  }
  std::sort(corners.begin(), corners.end());
  corners.erase(std::unique(corners.begin(), corners.end()), corners.end());
  return corners;
}

// The middle of all corners; and beside each edge, half its length away: in a thin prism a point is best near a
// column, where the triangles above and below it see it under right angles.
std::vector<Vector3> PrismShapes::placesWithin(Index group) const
{
  const std::vector<Index> corners = pointsOf(group);
  Vector3 middle;
  for (const Index v : corners)
  {
    middle += (1.0 / static_cast<double>(corners.size())) * mesh_.points[v];
  }
  std::vector<Vector3> places{ middle };
  for (std::size_t i = 0; i < corners.size(); ++i)
  {
    for (std::size_t j = i + 1; j < corners.size(); ++j)
    {
      const Vector3& a = mesh_.points[corners[i]];
      const Vector3& b = mesh_.points[corners[j]];
      const Vector3 inward = middle - 0.5 * (a + b);
      const double way = norm(inward);
      places.push_back(0.5 * (a + b) + std::min(0.5, 0.5 * distance(a, b) / std::max(way, 1e-300)) * inward);
    }
  }
  return places;
}

std::optional<PrismCells> PrismShapes::fromNewPoint(Index group) const
{
  PrismCells cells;
  cells.hasNewPoint = true;
  std::vector<std::array<Index, 3>> seen = plainFaces(group);
  for (const auto& face : seen)
  {
    cells.tetrahedra.push_back({ face[0], face[1], face[2], PrismCells::NewPoint });
  }
  for (const Index quad : keptQuads(group))
  {
    const auto c = cornersOf(group, quad);
    cells.pyramids.push_back({ c[0], c[1], c[2], c[3], PrismCells::NewPoint });
    for (int i = 0; i < 4; ++i) // both ways to cut it
    {
      seen.push_back({ c[i], c[(i + 1) % 4], c[(i + 3) % 4] });
    }
  }
  double lowest = 180;
  for (const Vector3& place : placesWithin(group))
  {
    const double angle = largestAngleFrom(place, seen);
    if (angle < lowest)
    {
      lowest = angle;
      cells.newPoint = place;
    }
  }
  return lowest < 180 ? std::optional(cells) : std::nullopt;
}

// Of the tetrahedra upon the faces; 180 where one of them is not positive.
double PrismShapes::largestAngleFrom(
  const Vector3& place, const std::vector<std::array<Index, 3>>& faces) const
{
  double largest = 0;
  for (const auto& face : faces)
  {
    const Vector3& a = mesh_.points[face[0]];
    const Vector3& b = mesh_.points[face[1]];
    const Vector3& c = mesh_.points[face[2]];
    if (!isPositive(a, b, c, place))
    {
      return 180;
    }
    largest = std::max(largest, largestDihedral(a, b, c, place));
  }
  return largest;
}

std::optional<PrismCells> PrismShapes::make(Index group) const
{
  const PrismGroup& g = groups_.groups[group];
  const std::vector<Index> quads = keptQuads(group);
  PrismCells cells;
  if (quads.size() == 3)
  {
    if (const auto wedge = wedgeOf(group))
    {
      cells.wedges.push_back(*wedge);
      return cells;
    }
  }
  if (const auto hexahedron = hexahedronOf(group))
  {
    cells.hexahedra.push_back(*hexahedron);
    return cells;
  }
  if (quads.size() > 1 || (quads.size() == 1 && !isPyramid(group, quads[0])))
  {
    return fromNewPoint(group);
  }
  std::array<HalfFace, 2> half{ None, None };
  if (quads.size() == 1)
  {
    const LateralQuad& q = groups_.quads[quads[0]];
    half = q.half[q.sideOf(group)];
    cells.pyramids.push_back(*pyramidOf(group, quads[0]));
  }
  for (int i = 0; i < g.size; ++i)
  {
    const bool isTaken = half[0] != None && (g.tet[i] == tetOf(half[0]) || g.tet[i] == tetOf(half[1]));
    if (!isTaken)
    {
      cells.tetrahedra.push_back(mesh_.tetrahedra[g.tet[i]]);
    }
  }
  return cells;
}
} // namespace ransmesh
