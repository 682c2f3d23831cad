#include "Geometry/SpatialOrder.h"

#include <algorithm>
#include <limits>
#include <utility>

namespace ransmesh
{
namespace
{
// Spreads the lowest 21 bits so that two empty ones follow each.
std::uint64_t spread(std::uint64_t x)
{
  x = (x | x << 32) & 0x1f00000000ffffULL;
  x = (x | x << 16) & 0x1f0000ff0000ffULL;
  x = (x | x << 8) & 0x100f00f00f00f00fULL;
  x = (x | x << 4) & 0x10c30c30c30c30c3ULL;
  x = (x | x << 2) & 0x1249249249249249ULL;
  return x;
}
} // namespace

void sortSpatially(const std::vector<Vector3>& points, std::vector<std::int32_t>& numbers)
{
  constexpr double infinity = std::numeric_limits<double>::infinity();
  Vector3 low{ infinity, infinity, infinity };
  Vector3 high{ -infinity, -infinity, -infinity };
  for (const std::int32_t n : numbers)
  {
    for (int i = 0; i < 3; ++i)
    {
      low[i] = std::min(low[i], points[n][i]);
      high[i] = std::max(high[i], points[n][i]);
    }
  }
  const double extent = std::max({ high.x - low.x, high.y - low.y, high.z - low.z });
  const double scale = extent > 0 ? 2097151 / extent : 0; // 2^21 - 1 cells a side
  std::vector<std::pair<std::uint64_t, std::int32_t>> coded;
  coded.reserve(numbers.size());
  for (const std::int32_t n : numbers)
  {
    const Vector3 cell = scale * (points[n] - low);
    const auto code = spread(static_cast<std::uint64_t>(cell.x)) |
      spread(static_cast<std::uint64_t>(cell.y)) << 1 | spread(static_cast<std::uint64_t>(cell.z)) << 2;
    coded.emplace_back(code, n);
  }
  std::sort(coded.begin(), coded.end());
  std::transform(coded.begin(), coded.end(), numbers.begin(), [](const auto& c) { return c.second; });
}
} // namespace ransmesh
