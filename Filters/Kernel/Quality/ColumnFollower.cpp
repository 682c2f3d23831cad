#include "Quality/ColumnFollower.h"

#include "Geometry/Angles.h"

#include <limits>

namespace ransmesh
{
ColumnFollower::ColumnFollower(const MeshData& mesh, const ColumnRules& rules)
  : mesh_(mesh)
  , rules_(rules)
  , firstTet_(mesh.points.size() + 1, 0)
  , tetOfPoint_(4 * mesh.tetrahedra.size())
{
  for (const auto& tet : mesh.tetrahedra)
  {
    for (const Index v : tet)
    {
      ++firstTet_[v + 1];
    }
  }
  for (std::size_t v = 1; v < firstTet_.size(); ++v)
  {
    firstTet_[v] += firstTet_[v - 1];
  }
  std::vector<std::size_t> next(firstTet_.begin(), firstTet_.end() - 1);
  for (std::size_t t = 0; t < mesh.tetrahedra.size(); ++t)
  {
    for (const Index v : mesh.tetrahedra[t])
    {
      tetOfPoint_[next[v]++] = static_cast<Index>(t);
    }
  }
}

ColumnFollower::Step ColumnFollower::closestToNormal(
  Index from, const Vector3& normal, double leastCosine, double shortest, double longest) const
{
  Step best;
  best.cosine = leastCosine;
  for (std::size_t i = firstTet_[from]; i < firstTet_[from + 1]; ++i)
  {
    for (const Index v : mesh_.tetrahedra[tetOfPoint_[i]])
    {
      const Vector3 edge = mesh_.points[v] - mesh_.points[from];
      const double along = dot(edge, normal);
      if (!(along > 0)) // also the point itself
      {
        continue;
      }
      const double length = norm(edge);
      const double cosine = along / length;
      if (cosine > best.cosine && length > shortest && length < longest)
      {
        best = { v, length, cosine };
      }
    }
  }
  return best;
}

void ColumnFollower::follow(const ColumnFoot& from, const LayerHeights& asked, FoundColumn& column) const
{
  column.points.assign(1, from.point);
  column.spacings.clear();
  column.leans.clear();
  const double inCone = cosineOfDegrees(rules_.cone);
  for (int level = 1; level <= asked.count(); ++level)
  {
    const double spacing = asked.spacing(level);
    const Index here = column.points.back();
    const Step step =
      closestToNormal(here, from.normal, inCone, spacing / rules_.tolerance, spacing * rules_.tolerance);
    if (step.to == None)
    {
      break;
    }
    column.points.push_back(step.to);
    column.spacings.push_back(step.length);
    column.leans.push_back(degreesBetween(mesh_.points[step.to] - mesh_.points[here], from.normal));
  }
  constexpr double any = std::numeric_limits<double>::infinity();
  column.edgeBeyond =
    closestToNormal(column.points.back(), from.normal, cosineOfDegrees(rules_.outward), 0, any).length;
}
} // namespace ransmesh
