#include "Removal/CavityFilling.h"

#include "Geometry/Predicates.h"
#include "Geometry/TetrahedronMeasures.h"

#include <algorithm>
#include <bit>
#include <utility>

namespace ransmesh
{
namespace
{
// How many sets of so many numbers there are below each number.
template <int Size>
constexpr auto setsBelow()
{
  std::array<std::uint32_t, CavityFilling::MostPoints + 1> sets{};
  for (std::uint32_t n = 0; n < sets.size(); ++n)
  {
    sets[n] = 1;
    for (std::uint32_t k = 0; k < Size; ++k)
    {
      sets[n] = n < Size ? 0 : sets[n] * (n - k) / (k + 1);
    }
  }
  return sets;
}
constexpr auto PairsBelow = setsBelow<2>();
constexpr auto TriplesBelow = setsBelow<3>();
constexpr auto QuadruplesBelow = setsBelow<4>();

// Puts the numbers in order; whether that was an odd permutation.
template <std::size_t N>
bool order(std::array<int, N>& numbers)
{
  bool odd = false;
  for (std::size_t i = 1; i < N; ++i)
  {
    for (std::size_t j = i; j > 0 && numbers[j] < numbers[j - 1]; --j)
    {
      std::swap(numbers[j], numbers[j - 1]);
      odd = !odd;
    }
  }
  return odd;
}

// Where four numbers in order stand among all such.
std::size_t placeOf(const std::array<int, 4>& v)
{
  return QuadruplesBelow[v[3]] + TriplesBelow[v[2]] + PairsBelow[v[1]] + v[0];
}

bool has(const std::array<int, 3>& side, int point)
{
  return side[0] == point || side[1] == point || side[2] == point;
}
} // namespace

void CavityFilling::turnTo(std::span<const Vector3> points, std::span<const std::array<int, 3>> faces)
{
  points_.assign(points.begin(), points.end());
  faces_.assign(faces.begin(), faces.end());
  const std::size_t tets = QuadruplesBelow[points.size()];
  orientation_.assign(tets, Unknown);
  quality_.assign(tets, NotLooked);
}

CavityFilling::Verdict CavityFilling::fill(double floor, std::size_t steps)
{
  floor_ = floor;
  steps_ = steps;
  state_.assign(2 * TriplesBelow[points_.size()], Free);
  tets_.clear();
  changes_.clear();
  for (const Side& face : faces_)
  {
    state_[slotOf(face)] = Open;
    state_[slotOf({ face[1], face[0], face[2] })] = Taken;
  }
  OpenSides open;
  if (!goOn({}, faces_, open))
  {
    return Verdict::Impossible;
  }
  return search(open) ? Verdict::Filled : steps_ == 0 ? Verdict::GivenUp : Verdict::Impossible;
}

// Two slots for each triangle, one for each of its sides.
std::size_t CavityFilling::slotOf(Side side)
{
  const bool odd = order(side);
  return 2 * (TriplesBelow[side[2]] + PairsBelow[side[1]] + side[0]) + static_cast<std::size_t>(odd);
}

// 1, 0 or -1, exactly.
int CavityFilling::orientationOf(std::array<int, 4> corners)
{
  const bool odd = order(corners);
  signed char& known = orientation_[placeOf(corners)];
  if (known == Unknown)
  {
    known = static_cast<signed char>(
      orientation(points_[corners[0]], points_[corners[1]], points_[corners[2]], points_[corners[3]]));
  }
  return odd ? -known : known;
}

// The four sides of a tetrahedron, as seen from inside.
std::array<CavityFilling::Side, 4> CavityFilling::sidesOf(const Side& base, int apex)
{
  return { base, Side{ base[1], base[0], apex }, Side{ base[2], base[1], apex },
    Side{ base[0], base[2], apex } };
}

// The quality of a tetrahedron, which must be positive; 0 if it is not above the floor, would have another point inside,
// or come through the polyhedron's faces.
float CavityFilling::usableQuality(const Side& base, int apex)
{
  std::array<int, 4> corners = { base[0], base[1], base[2], apex };
  order(corners);
  float& known = quality_[placeOf(corners)];
  if (known == NotLooked)
  {
    const double own = quality(points_[base[0]], points_[base[1]], points_[base[2]], points_[apex]);
    if (!(own > floor_))
    {
      return 0; // the next floor may be lower
    }
    const bool usable = !holdsPoint(base, apex) &&
      std::none_of(faces_.begin(), faces_.end(), [&](const Side& face) { return meets(base, apex, face); });
    known = usable ? static_cast<float>(own) : 0;
  }
  return known;
}

bool CavityFilling::holdsPoint(const Side& base, int apex)
{
  const auto sides = sidesOf(base, apex);
  for (int p = 0; p < static_cast<int>(points_.size()); ++p)
  {
    if (p != apex && !has(base, p) &&
      std::all_of(sides.begin(), sides.end(),
        [&](const Side& s) {
          return orientationOf({ s[0], s[1], s[2], p }) >= 0;
        }))
    {
      return true;
    }
  }
  return false;
}

// Whether an edge from the base to the apex crosses the side, or an edge of this one a side of the tetrahedron.
bool CavityFilling::meets(const Side& base, int apex, const Side& side)
{
  const auto own = sidesOf(base, apex);
  const bool apart = !isParted({ base[0], base[1], base[2], apex }, side) ||
    std::any_of(own.begin(), own.end(), [&](const Side& s) { return isBehind(side, s); });
  for (int i = 0; i < 3 && !apart; ++i)
  {
    const bool crossed = crosses(base[i], apex, side) ||
      std::any_of(
        own.begin() + 1, own.end(), [&](const Side& s) { return crosses(side[i], side[(i + 1) % 3], s); });
    if (crossed)
    {
      return true;
    }
  }
  return false;
}

// Whether the side's plane has corners of the tetrahedron before and behind it.
bool CavityFilling::isParted(const std::array<int, 4>& tet, const Side& side)
{
  bool before = false;
  bool behind = false;
  for (const int corner : tet)
  {
    const int where = has(side, corner) ? 0 : orientationOf({ side[0], side[1], side[2], corner });
    before = before || where > 0;
    behind = behind || where < 0;
  }
  return before && behind;
}

// Whether no corner of the side lies before the plane of the other one.
bool CavityFilling::isBehind(const Side& side, const Side& other)
{
  return std::none_of(side.begin(), side.end(),
    [&](int corner) {
      return !has(other, corner) && orientationOf({ other[0], other[1], other[2], corner }) > 0;
    });
}

// Whether an edge goes through a triangle's inside.
bool CavityFilling::crosses(int from, int to, const Side& triangle)
{
  const auto [a, b, c] = triangle;
  if (has(triangle, from) || has(triangle, to) ||
    orientationOf({ a, b, c, from }) * orientationOf({ a, b, c, to }) >= 0)
  {
    return false;
  }
  const int first = orientationOf({ from, to, a, b });
  return first != 0 && first == orientationOf({ from, to, b, c }) &&
    first == orientationOf({ from, to, c, a });
}

// Whether nothing stands where the tetrahedron would.
bool CavityFilling::isFree(const Side& base, int apex) const
{
  const auto sides = sidesOf(base, apex);
  return std::none_of(
    sides.begin(), sides.end(), [this](const Side& side) { return state_[slotOf(side)] == Taken; });
}

// The points from which a tetrahedron may stand on the base, without meeting the sides besides.
std::uint64_t CavityFilling::apexesOn(const Side& base, const OpenSides& besides)
{
  std::uint64_t apexes = 0;
  for (int p = 0; p < static_cast<int>(points_.size()); ++p)
  {
    const bool may = !has(base, p) && orientationOf({ base[0], base[1], base[2], p }) > 0 &&
      isFree(base, p) && usableQuality(base, p) > floor_ &&
      std::none_of(
        besides.begin(), besides.end(), [&](const OpenSide& other) { return meets(base, p, other.side); });
    apexes |= static_cast<std::uint64_t>(may) << p;
  }
  return apexes;
}

// The side with the fewest apexes gets a tetrahedron, the best one first, and so on.
bool CavityFilling::search(const OpenSides& open)
{
  if (open.empty())
  {
    return true;
  }
  const OpenSide& least = *std::min_element(open.begin(), open.end(),
    [](const OpenSide& a, const OpenSide& b) { return std::popcount(a.apexes) < std::popcount(b.apexes); });
  std::vector<Side> fresh;
  OpenSides next;
  for (const int apex : apexesInOrder(least))
  {
    if (steps_ == 0)
    {
      return false;
    }
    --steps_;
    const std::size_t changes = changes_.size();
    set(least.side, apex, fresh);
    if (goOn(open, fresh, next) && search(next))
    {
      return true;
    }
    takeBack(changes);
  }
  return false;
}

std::vector<int> CavityFilling::apexesInOrder(const OpenSide& open)
{
  std::vector<int> order;
  for (std::uint64_t left = open.apexes; left != 0; left &= left - 1)
  {
    order.push_back(std::countr_zero(left));
  }
  std::stable_sort(order.begin(), order.end(),
    [&](int a, int b) { return usableQuality(open.side, a) > usableQuality(open.side, b); });
  return order;
}

// Beyond each of its sides, a tetrahedron is wanted unless one stands there: the fresh open sides.
void CavityFilling::set(const Side& base, int apex, std::vector<Side>& fresh)
{
  fresh.clear();
  tets_.push_back({ base[0], base[1], base[2], apex });
  for (const Side& side : sidesOf(base, apex))
  {
    const Side beyond{ side[1], side[0], side[2] };
    const std::size_t slotBeyond = slotOf(beyond);
    change(slotOf(side), Taken);
    if (state_[slotBeyond] == Free)
    {
      change(slotBeyond, Open);
      fresh.push_back(beyond);
    }
  }
}

// What is open next; false if on some side nothing may stand any more.
bool CavityFilling::goOn(const OpenSides& open, const std::vector<Side>& fresh, OpenSides& next)
{
  next.clear();
  for (OpenSide still : open)
  {
    if (state_[slotOf(still.side)] != Open)
    {
      continue;
    }
    for (std::uint64_t left = still.apexes; left != 0; left &= left - 1)
    {
      const int apex = std::countr_zero(left);
      const bool may = isFree(still.side, apex) &&
        std::none_of(
          fresh.begin(), fresh.end(), [&](const Side& side) { return meets(still.side, apex, side); });
      still.apexes &= ~(static_cast<std::uint64_t>(!may) << apex);
    }
    if (still.apexes == 0)
    {
      return false;
    }
    next.push_back(still);
  }
  const OpenSides others = next;
  for (const Side& side : fresh)
  {
    next.push_back({ side, apexesOn(side, others) });
    if (next.back().apexes == 0)
    {
      return false;
    }
  }
  return true;
}

void CavityFilling::change(std::size_t slot, State state)
{
  changes_.push_back({ slot, state_[slot] });
  state_[slot] = state;
}

void CavityFilling::takeBack(std::size_t changes)
{
  for (; changes_.size() > changes; changes_.pop_back())
  {
    state_[changes_.back().slot] = changes_.back().before;
  }
  tets_.pop_back();
}
} // namespace ransmesh
