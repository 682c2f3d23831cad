#include "Surface/Pieces.h"

#include "Triangles/SurfaceEdges.h"
#include "Triangles/SurfaceRepair.h"
#include "Triangles/SurfaceTriangles.h"

#include <cmath>
#include <numeric>
#include <set>

namespace ransmesh
{
namespace
{
// Beyond this many pieces what encloses what is not asked for: the answer would be of no use.
constexpr std::size_t MostPieces = 1000;

class PieceFinder
{
public:
  explicit PieceFinder(const SurfaceMesh& surface)
    : surface_(surface)
    , isTurned_(turnedTriangles(surface))
  {
  }

  std::vector<SurfacePiece> run()
  {
    join();
    for (std::size_t t = 0; t < surface_.triangles.size(); ++t)
    {
      add(static_cast<Index>(t));
    }
    countOpenEdges();
    for (SurfacePiece& piece : pieces_)
    {
      piece.volume = piece.isClosed() ? piece.volume : 0;
    }
    nest();
    return std::move(pieces_);
  }

private:
  Index root(Index v)
  {
    while (parent_[v] != v)
    {
      v = parent_[v] = parent_[parent_[v]];
    }
    return v;
  }

  void join()
  {
    parent_.resize(surface_.points.size());
    std::iota(parent_.begin(), parent_.end(), 0);
    for (const auto& t : surface_.triangles)
    {
      parent_[root(t[1])] = root(t[0]);
      parent_[root(t[2])] = root(t[0]);
    }
  }

  void add(Index t)
  {
    const auto& v = surface_.triangles[t];
    const Index r = root(v[0]);
    if (static_cast<std::size_t>(r) >= pieceOf_.size())
    {
      pieceOf_.resize(surface_.points.size(), -1);
    }
    if (pieceOf_[r] < 0)
    {
      pieceOf_[r] = static_cast<int>(pieces_.size());
      pieces_.emplace_back();
      pieces_.back().extent = { surface_.points[v[0]], surface_.points[v[0]] };
      members_.emplace_back();
    }
    SurfacePiece& piece = pieces_[pieceOf_[r]];
    members_[pieceOf_[r]].push_back(t);
    ++piece.triangles;
    piece.area += 0.5 * norm(areaVector(surface_, v));
    // About a point of the piece: far from the origin the sum would cancel.
    const Vector3& o = surface_.points[surface_.triangles[members_[pieceOf_[r]][0]][0]];
    piece.volume += sign(t) * dot(areaVector(surface_, v), surface_.points[v[0]] - o) / 6;
    for (const Index corner : v)
    {
      for (int k = 0; k < 3; ++k)
      {
        piece.extent.low[k] = std::fmin(piece.extent.low[k], surface_.points[corner][k]);
        piece.extent.high[k] = std::fmax(piece.extent.high[k], surface_.points[corner][k]);
      }
    }
    const auto place = std::lower_bound(piece.patch.begin(), piece.patch.end(), surface_.patch[t]);
    if (place == piece.patch.end() || *place != surface_.patch[t])
    {
      piece.patch.insert(place, surface_.patch[t]);
    }
  }

  double sign(Index t) const { return isTurned_[t] ? -1 : 1; }

  void countOpenEdges()
  {
    forEachEdge(sortedEdges(surface_),
      [&](const SurfaceEdge* first, const SurfaceEdge* last)
      { pieces_[pieceOf_[root(first->a)]].openEdges += last - first == 1; });
  }

  void nest()
  {
    for (std::size_t inner = 0; inner < pieces_.size() && pieces_.size() <= MostPieces; ++inner)
    {
      for (std::size_t outer = 0; outer < pieces_.size(); ++outer)
      {
        const int best = pieces_[inner].enclosedBy;
        const bool smaller = best < 0 || std::fabs(pieces_[outer].volume) < std::fabs(pieces_[best].volume);
        if (outer != inner && smaller && mayHold(pieces_[outer], pieces_[inner]) && holds(outer, inner))
        {
          pieces_[inner].enclosedBy = static_cast<int>(outer);
        }
      }
    }
  }

  static bool mayHold(const SurfacePiece& outer, const SurfacePiece& inner)
  {
    bool may = outer.isClosed() && outer.volume != 0;
    for (int k = 0; k < 3; ++k)
    {
      may = may && outer.extent.low[k] < inner.extent.low[k] && inner.extent.high[k] < outer.extent.high[k];
    }
    return may;
  }

  // By the solid angle under which a point of the inner piece sees the outer one (Van Oosterom & Strackee 1983).
  bool holds(std::size_t outer, std::size_t inner) const
  {
    const Vector3& p = surface_.points[surface_.triangles[members_[inner][0]][0]];
    double angle = 0;
    for (const Index t : members_[outer])
    {
      const auto& v = surface_.triangles[t];
      const Vector3 a = surface_.points[v[0]] - p;
      const Vector3 b = surface_.points[v[1]] - p;
      const Vector3 c = surface_.points[v[2]] - p;
      const double na = norm(a);
      const double nb = norm(b);
      const double nc = norm(c);
      const double above = dot(a, cross(b, c));
      const double below = na * nb * nc + dot(a, b) * nc + dot(b, c) * na + dot(c, a) * nb;
      angle += sign(t) * 2 * std::atan2(above, below);
    }
    return std::fabs(angle) > 2 * std::acos(-1.0); // 4 pi inside, 0 outside
  }

  const SurfaceMesh& surface_;
  std::vector<char> isTurned_;
  std::vector<Index> parent_;
  std::vector<int> pieceOf_; // of a root
  std::vector<SurfacePiece> pieces_;
  std::vector<std::vector<Index>> members_;
};
} // namespace

std::vector<SurfacePiece> findPieces(const SurfaceMesh& surface)
{
  return PieceFinder(surface).run();
}
} // namespace ransmesh
