#include "Prisms/Orthogonality.h"

#include "Geometry/Angles.h"
#include "Geometry/Predicates.h"
#include "Geometry/TetrahedronMeasures.h"
#include "Mesh/TetMesh.h"

#include <algorithm>
#include <limits>
#include <unordered_map>

namespace ransmesh
{
namespace
{
constexpr int Passes = 6;
constexpr int Steps = 40;          // of one point in a pass
constexpr double FirstStep = 0.25; // in shortest edges
constexpr double LastStep = 0.002;
constexpr double Margin = 1;         // degrees below the limit at which a point is left alone
constexpr double FairQuality = 0.05; // tetrahedra may become worse down to this

// Six directions along the axes and eight between them.
const std::vector<Vector3>& directions()
{
  static const std::vector<Vector3> all = []
  {
    std::vector<Vector3> list;
    for (const double s : { -1.0, 1.0 })
    {
      list.insert(list.end(), { { s, 0, 0 }, { 0, s, 0 }, { 0, 0, s } });
      for (const double t : { -1.0, 1.0 })
      {
        list.insert(list.end(), { { s * 0.577, t * 0.577, 0.577 }, { s * 0.577, t * 0.577, -0.577 } });
      }
    }
    return list;
  }();
  return all;
}

class OrthogonalityMover
{
public:
  OrthogonalityMover(
    MeshData& mesh, const FaceMatching& matching, const std::vector<Index>& prism, double limit)
    : mesh_(mesh)
    , matching_(matching)
    , prism_(prism)
    , limit_(limit)
  {
    findPrismCentres();
    findFreePoints();
  }

  OrthogonalityReport run()
  {
    for (int pass = 0; pass < Passes; ++pass)
    {
      const std::vector<Index> points = pointsOfPoorFaces();
      gatherStars(points);
      std::size_t moved = 0;
      for (const Index v : points)
      {
        moved += improve(v) ? 1 : 0;
      }
      report_.movedPoints += moved;
      if (moved == 0)
      {
        break;
      }
    }
    return report_;
  }

private:
  // Each prism's tetrahedra become one cell.
  void findPrismCentres()
  {
    const Index most = prism_.empty() ? None : *std::max_element(prism_.begin(), prism_.end());
    prismCentre_.assign(static_cast<std::size_t>(most) + 1, {});
    std::vector<double> volume(prismCentre_.size(), 0);
    for (std::size_t t = 0; t < prism_.size(); ++t)
    {
      if (prism_[t] >= 0)
      {
        const auto& v = mesh_.tetrahedra[t];
        const auto& p = mesh_.points;
        const double own = sixVolumes(p[v[0]], p[v[1]], p[v[2]], p[v[3]]);
        prismCentre_[prism_[t]] += own * middleOf(v);
        volume[prism_[t]] += own;
      }
    }
    for (std::size_t i = 0; i < volume.size(); ++i)
    {
      prismCentre_[i] = volume[i] > 0 ? (1 / volume[i]) * prismCentre_[i] : Vector3{};
    }
  }

  void findFreePoints()
  {
    isFree_.assign(mesh_.points.size(), 1);
    for (std::size_t t = 0; t < prism_.size(); ++t)
    {
      for (const Index v : mesh_.tetrahedra[t])
      {
        isFree_[v] = prism_[t] >= 0 ? 0 : isFree_[v];
      }
    }
    for (const auto& triangle : mesh_.triangles)
    {
      for (const Index v : triangle)
      {
        isFree_[v] = 0;
      }
    }
  }

  Vector3 middleOf(const std::array<Index, 4>& v) const
  {
    const auto& p = mesh_.points;
    return 0.25 * (p[v[0]] + p[v[1]] + p[v[2]] + p[v[3]]);
  }

  Vector3 centreOf(Index t) const
  {
    return prism_[t] >= 0 ? prismCentre_[prism_[t]] : middleOf(mesh_.tetrahedra[t]);
  }

  // In degrees; 0 for faces on the boundary and within a prism.
  double angleAt(HalfFace h) const
  {
    const HalfFace other = matching_.opposite[h];
    const Index t = tetOf(h);
    if (isBoundary(other) || (prism_[t] >= 0 && prism_[t] == prism_[tetOf(other)]))
    {
      return 0;
    }
    const auto& v = mesh_.tetrahedra[t];
    const int* c = FaceCorners[faceOf(h)];
    const Vector3& a = mesh_.points[v[c[0]]];
    const Vector3 normal = cross(mesh_.points[v[c[1]]] - a, mesh_.points[v[c[2]]] - a); // into t
    const Vector3 way = centreOf(t) - centreOf(tetOf(other));
    return degreesBetween(normal, way);
  }

  // Points that may move, of faces above the limit; counts these.
  std::vector<Index> pointsOfPoorFaces()
  {
    report_.facesOver = 0;
    report_.largest = 0;
    std::vector<Index> points;
    for (std::size_t t = 0; t < mesh_.tetrahedra.size(); ++t)
    {
      for (int f = 0; f < 4 && prism_[t] < 0; ++f)
      {
        const HalfFace h = halfFace(static_cast<Index>(t), f);
        const HalfFace other = matching_.opposite[h];
        const double angle = angleAt(h);
        report_.largest = std::max(report_.largest, angle);
        if (angle > limit_ - Margin / 2)
        {
          const bool isSecond = prism_[tetOf(other)] < 0 && other < h;
          report_.facesOver += angle > limit_ && !isSecond ? 1 : 0;
          const auto& v = mesh_.tetrahedra[t];
          points.insert(points.end(), v.begin(), v.end()); // the other side adds its own
        }
      }
    }
    std::sort(points.begin(), points.end());
    points.erase(std::unique(points.begin(), points.end()), points.end());
    std::erase_if(points, [this](Index v) { return !isFree_[v]; });
    return points;
  }

  void gatherStars(const std::vector<Index>& points)
  {
    star_.clear();
    std::vector<char> isWanted(mesh_.points.size(), 0);
    for (const Index v : points)
    {
      isWanted[v] = 1;
    }
    for (std::size_t t = 0; t < mesh_.tetrahedra.size(); ++t)
    {
      for (const Index v : mesh_.tetrahedra[t])
      {
        if (isWanted[v])
        {
          star_[v].push_back(static_cast<Index>(t));
        }
      }
    }
  }

  double worstAt(const std::vector<Index>& star) const
  {
    double worst = 0;
    for (const Index t : star)
    {
      for (int f = 0; f < 4; ++f)
      {
        worst = std::max(worst, angleAt(halfFace(t, f)));
      }
    }
    return worst;
  }

  // The lowest quality in the star; above 0 where all of it is positive.
  double qualityAt(const std::vector<Index>& star) const
  {
    double lowest = 1;
    for (const Index t : star)
    {
      const auto& v = mesh_.tetrahedra[t];
      const auto& p = mesh_.points;
      lowest = std::min(lowest, quality(p[v[0]], p[v[1]], p[v[2]], p[v[3]]));
    }
    return lowest;
  }

  double shortestEdge(Index v) const
  {
    double shortest = std::numeric_limits<double>::max();
    for (const Index t : star_.at(v))
    {
      for (const Index w : mesh_.tetrahedra[t])
      {
        shortest = w == v ? shortest : std::min(shortest, distance(mesh_.points[v], mesh_.points[w]));
      }
    }
    return shortest;
  }

  // Goes in the direction that helps most, in shorter and shorter steps.
  bool improve(Index v)
  {
    const std::vector<Index>& star = star_.at(v);
    const double least = std::min(qualityAt(star), FairQuality);
    const double edge = shortestEdge(v);
    const Vector3 start = mesh_.points[v];
    double worst = worstAt(star);
    double step = FirstStep * edge;
    for (int i = 0; i < Steps && step > LastStep * edge && worst > limit_ - Margin; ++i)
    {
      const Vector3 from = mesh_.points[v];
      Vector3 best = from;
      double bestAngle = worst;
      for (const Vector3& direction : directions())
      {
        mesh_.points[v] = from + step * direction;
        const double angle = worstAt(star);
        if (angle < bestAngle - 1e-3 && qualityAt(star) >= least)
        {
          bestAngle = angle;
          best = mesh_.points[v];
        }
      }
      mesh_.points[v] = best;
      step = best == from ? step / 2 : step;
      worst = bestAngle;
    }
    return !(mesh_.points[v] == start);
  }

  MeshData& mesh_;
  const FaceMatching& matching_;
  const std::vector<Index>& prism_;
  double limit_;
  std::vector<Vector3> prismCentre_;
  std::vector<char> isFree_;
  std::unordered_map<Index, std::vector<Index>> star_;
  OrthogonalityReport report_;
};
} // namespace

OrthogonalityReport improveOrthogonality(
  MeshData& mesh, const FaceMatching& matching, const std::vector<Index>& prism, double limit)
{
  return OrthogonalityMover(mesh, matching, prism, limit).run();
}
} // namespace ransmesh
