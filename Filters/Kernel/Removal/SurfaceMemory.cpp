#include "Removal/SurfaceMemory.h"

#include "Geometry/Distance.h"

#include <algorithm>
#include <iterator>
#include <limits>

namespace ransmesh
{
namespace
{
// Points that the surface runs through to this share of what is allowed need not be remembered: on planes none.
constexpr double Exact = 1e-3;
} // namespace

bool SurfaceMemory::allows(std::span<const Piece> old, std::span<const Piece> replacement,
  std::span<const Vector3> lost, double allowed, Index apex)
{
  apex_ = apex;
  taken_.clear();
  const bool lostAreNear = std::all_of(lost.begin(), lost.end(),
    [&](const Vector3& p) {
      return takeAlong(replacement, { p, allowed });
    });
  if (!lostAreNear)
  {
    return false;
  }
  collectHolders(old);
  left_.assign(holders_.size(), {});
  for (std::size_t i = 0; i < holders_.size(); ++i)
  {
    for (const LostPoint& point : held_.at(holders_[i]))
    {
      if (distanceTo(old, point.place) > point.allowed) // beside the pieces that go
      {
        left_[i].push_back(point);
      }
      else if (!takeAlong(replacement, point))
      {
        return false;
      }
    }
  }
  return true;
}

void SurfaceMemory::remember()
{
  for (std::size_t i = 0; i < holders_.size(); ++i)
  {
    if (left_[i].empty())
    {
      held_.erase(holders_[i]);
    }
    else
    {
      held_.at(holders_[i]).swap(left_[i]);
    }
  }
  if (!taken_.empty())
  {
    std::vector<LostPoint>& at = held_[apex_];
    at.insert(at.end(), taken_.begin(), taken_.end());
  }
}

// False if the point would be too far from the new pieces.
bool SurfaceMemory::takeAlong(std::span<const Piece> replacement, const LostPoint& point)
{
  const double away = distanceTo(replacement, point.place);
  if (away > Exact * point.allowed)
  {
    taken_.push_back(point);
  }
  return away <= point.allowed;
}

double SurfaceMemory::distanceTo(std::span<const Piece> pieces, const Vector3& p) const
{
  double least = std::numeric_limits<double>::infinity();
  for (const Piece& piece : pieces)
  {
    least = std::min(
      least, distanceToTriangle(p, mesh_.point(piece[0]), mesh_.point(piece[1]), mesh_.point(piece[2])));
  }
  return least;
}

// The pieces' vertices that hold points.
void SurfaceMemory::collectHolders(std::span<const Piece> old)
{
  holders_.clear();
  for (const Piece& piece : old)
  {
    std::copy_if(piece.begin(), piece.end(), std::back_inserter(holders_),
      [this](Index v) { return held_.count(v) > 0; });
  }
  std::sort(holders_.begin(), holders_.end());
  holders_.erase(std::unique(holders_.begin(), holders_.end()), holders_.end());
}
} // namespace ransmesh
