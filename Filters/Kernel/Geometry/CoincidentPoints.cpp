#include "Geometry/CoincidentPoints.h"

#include <bit>

namespace ransmesh
{
namespace
{
constexpr std::uint64_t Golden = 0x9e3779b97f4a7c15ULL; // 2^64 over the golden ratio

std::uint64_t bitsOf(double x)
{
  return std::bit_cast<std::uint64_t>(x + 0.0); // the same for both zeros
}

std::uint64_t hashOf(const Vector3& p)
{
  std::uint64_t h = bitsOf(p.x) * Golden;
  h = (std::rotl(h, 29) ^ bitsOf(p.y)) * Golden;
  h = (std::rotl(h, 29) ^ bitsOf(p.z)) * Golden;
  return h ^ h >> 32;
}
} // namespace

std::vector<std::int32_t> findCoincident(const std::vector<Vector3>& points)
{
  constexpr std::int32_t free = -1;
  const std::size_t slots = std::bit_ceil(2 * points.size() + 1);
  std::vector<std::int32_t> table(slots, free);
  std::vector<std::int32_t> coincident;
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    std::size_t slot = hashOf(points[i]) & (slots - 1);
    while (table[slot] != free && !(points[table[slot]] == points[i]))
    {
      slot = (slot + 1) & (slots - 1);
    }
    if (table[slot] == free)
    {
      table[slot] = static_cast<std::int32_t>(i);
    }
    else
    {
      coincident.push_back(static_cast<std::int32_t>(i));
    }
  }
  return coincident;
}
} // namespace ransmesh
