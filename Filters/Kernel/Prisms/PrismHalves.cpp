#include "Prisms/PrismHalves.h"

#include <set>

namespace ransmesh
{
namespace
{
constexpr std::size_t PrismTriangles = 8; // two ends, and the halves of three quadrilaterals

double perimeter(const OuterFace& face, const std::vector<Vector3>& p)
{
  const auto& v = face.corner;
  return distance(p[v[0]], p[v[1]]) + distance(p[v[1]], p[v[2]]) + distance(p[v[2]], p[v[0]]);
}

// Do three quadrilaterals go around, from one triangle to another?
bool goesAround(
  const JoinedGroups& groups, const std::vector<OuterFace>& faces, std::size_t low, std::size_t high)
{
  std::set<std::size_t> partners;
  for (std::size_t i = 0; i < faces.size(); ++i)
  {
    if (i == low || CommonPoints(faces[i], faces[low]).count != 2)
    {
      continue;
    }
    for (std::size_t j = 0; j < faces.size(); ++j)
    {
      const bool isUpper = j != high && CommonPoints(faces[j], faces[high]).count == 2;
      if (isUpper && !partners.contains(j) && groups.isQuadrilateral(faces[i], faces[j]))
      {
        partners.insert(j);
        break;
      }
    }
  }
  return partners.size() == 3;
}

// The perimeters of two triangles apart, if three quadrilaterals go around them; the smallest sum of all choices.
std::optional<double> sizeOfPrism(const JoinedGroups& groups, const std::vector<OuterFace>& faces)
{
  std::optional<double> smallest;
  for (std::size_t i = 0; i < faces.size(); ++i)
  {
    for (std::size_t j = i + 1; j < faces.size(); ++j)
    {
      if (CommonPoints(faces[i], faces[j]).count == 0 && goesAround(groups, faces, i, j))
      {
        const auto& points = groups.mesh().points;
        const double size = perimeter(faces[i], points) + perimeter(faces[j], points);
        smallest = std::min(smallest.value_or(size), size);
      }
    }
  }
  return smallest;
}

// Groups of two tetrahedra that make a prism with the one of a group.
void findPartners(const JoinedGroups& groups, Index one, std::vector<PrismHalves>& found)
{
  const Index single = groups[one].tet[0];
  for (int f = 0; f < 4; ++f)
  {
    const Index two = groups.beyond(halfFace(single, f));
    if (two == None || groups[two].count != 2)
    {
      continue;
    }
    GroupTets three = groups[two];
    three.add(single);
    const std::vector<OuterFace> faces = groups.outside(three);
    if (const auto size = faces.size() == PrismTriangles ? sizeOfPrism(groups, faces) : std::nullopt)
    {
      found.push_back({ *size, one, two });
    }
  }
}
} // namespace

std::vector<PrismHalves> findHalves(const JoinedGroups& groups)
{
  std::vector<PrismHalves> found;
  for (std::size_t g = 0; g < groups.size(); ++g)
  {
    if (groups[static_cast<Index>(g)].count == 1)
    {
      findPartners(groups, static_cast<Index>(g), found);
    }
  }
  std::stable_sort(
    found.begin(), found.end(), [](const PrismHalves& a, const PrismHalves& b) { return a.size < b.size; });
  return found;
}
} // namespace ransmesh
