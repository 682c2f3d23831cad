// Why a point went or stayed: every attempt to remove one ends with one of these, and they are counted.
#pragma once

#include <array>
#include <cstddef>

namespace ransmesh
{
enum class RemovalVerdict
{
  Collapsed,         // to a neighbour, its ball starred from there
  RemovedWithCavity, // the same with an enlarged cavity
  Absorbed,          // lay inside the enlarged cavity of another one
  LowQuality,        // a new tetrahedron would be worse than the limit, from every apex
  OverLarge,         // a new edge would be much longer than the elements that went
  SurfaceTurned,     // a boundary face would turn by more than the surface angle, or fold over
  SurfaceMoved,      // the surface would come too far from points that it has lost, now or before
  PoorTriangle,      // a wall's triangle would have too large an angle
  RidgeLost,         // an edge of a ridge or between patches would vanish
  VertexLost,        // a point that is to stay would vanish
  NotStarrable,      // the star operator refused: not exactly positive, or not manifold
  Count
};

const char* nameOf(RemovalVerdict verdict);

// Was it the shape of the surface that refused? Worse tetrahedra do not help then.
inline bool isOfSurface(RemovalVerdict verdict)
{
  return verdict == RemovalVerdict::SurfaceTurned || verdict == RemovalVerdict::SurfaceMoved ||
    verdict == RemovalVerdict::PoorTriangle;
}

// How often each verdict was given.
using RemovalTally = std::array<std::size_t, static_cast<std::size_t>(RemovalVerdict::Count)>;

inline std::size_t& countOf(RemovalTally& tally, RemovalVerdict verdict)
{
  return tally[static_cast<std::size_t>(verdict)];
}
inline std::size_t countOf(const RemovalTally& tally, RemovalVerdict verdict)
{
  return tally[static_cast<std::size_t>(verdict)];
}
} // namespace ransmesh
