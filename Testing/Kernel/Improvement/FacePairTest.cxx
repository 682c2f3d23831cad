#include "Improvement/FacePair.h"
#include "Improvement/FaceView.h"

#include <gtest/gtest.h>

#include <array>
#include <limits>
#include <random>

namespace
{
using namespace ransmesh;

TEST(FacePairs, SeeWhatTwoSingleFacesSee)
{
  constexpr int count = 7;
  std::mt19937 random(1); // NOLINT: the same places each time
  std::uniform_real_distribution<double> coordinate(-1, 1);
  std::array<Vector3, count> places;
  std::array<double, count> squares{};
  for (int i = 0; i < count; ++i)
  {
    places[i] = { coordinate(random), coordinate(random), coordinate(random) };
    squares[i] = dot(places[i], places[i]);
  }
  const FacePair::Corners corners[] = { { 0, 1, 2 }, { 2, 3, 4 } };
  const FacePair pair(corners[0], corners[1], places.data(), squares.data());
  for (int end = 0; end < count; ++end)
  {
    const Viewpoint from(end, places[end], squares[end]);
    bool somePoor = false;
    for (int i = 0; i < 2; ++i)
    {
      const auto& [a, b, c] = corners[i];
      const FaceView single(places[a], places[b], places[c], squares[a] + squares[b] + squares[c]);
      const bool has = end == a || end == b || end == c;
      const double expected =
        has ? std::numeric_limits<double>::infinity() : single.signedSquare(places[end], squares[end]);
      EXPECT_EQ(pair.signedSquares(from)[i], expected);
      constexpr double limit = 0.01;
      const bool poor = !(expected > limit);
      EXPECT_EQ(pair.arePoor(from, limit)[i] != 0, poor);
      EXPECT_EQ(pair.mayBeFlat(from, limit)[i] != 0, !has && !(single.sixVolume(places[end]) > limit));
      somePoor |= poor;
    }
    EXPECT_EQ(pair.somePoor(from, 0.01), somePoor);
  }
}
} // namespace
