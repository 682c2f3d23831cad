// Two triangles side by side, made ready to be seen from many places by vector units.
#pragma once

#include "Geometry/Vector3.h"

#include <algorithm>
#include <array>
#include <bit>
#include <limits>

namespace ransmesh
{
// Two numbers on which the processor works at once (vectors of GCC and Clang).
using Two = double __attribute__((vector_size(2 * sizeof(double))));
using TwoFlags = decltype(Two{} < Two{}); // 0 or -1 each

inline Two both(double a)
{
  return Two{ a, a };
}
inline Two absolute(Two a)
{
  constexpr long long allButSign = std::numeric_limits<long long>::max();
  return std::bit_cast<Two>(std::bit_cast<TwoFlags>(a) & TwoFlags{ allButSign, allButSign });
}
inline Two lesser(Two a, Two b)
{
  return b < a ? b : a;
}
inline double least(Two a)
{
  return std::min(a[0], a[1]);
}

struct TwoVectors
{
  TwoVectors() = default;
  TwoVectors(Two ofX, Two ofY, Two ofZ)
    : x(ofX)
    , y(ofY)
    , z(ofZ)
  {
  }
  TwoVectors(const Vector3& a, const Vector3& b)
    : x{ a.x, b.x }
    , y{ a.y, b.y }
    , z{ a.z, b.z }
  {
  }

  Two x = {};
  Two y = {};
  Two z = {};
};

inline TwoVectors operator+(const TwoVectors& a, const TwoVectors& b)
{
  return { a.x + b.x, a.y + b.y, a.z + b.z };
}
inline TwoVectors operator-(const TwoVectors& a, const TwoVectors& b)
{
  return { a.x - b.x, a.y - b.y, a.z - b.z };
}
inline Two dot(const TwoVectors& a, const TwoVectors& b)
{
  return a.x * b.x + a.y * b.y + a.z * b.z;
}
inline TwoVectors cross(const TwoVectors& a, const TwoVectors& b)
{
  return { a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x };
}

// A place from which pairs of faces are seen.
struct Viewpoint
{
  Viewpoint(int endOfEdge, const Vector3& where, double squareOfPlace)
    : end(both(endOfEdge))
    , place(where, where)
    , threeSquares(both(3 * squareOfPlace))
  {
  }

  Two end; // its number
  TwoVectors place;
  Two threeSquares;
};

// FaceView for two faces, with the numbers of their corners: faces that have the viewpoint for a corner are seen as
// infinitely good ones. The same in every bit.
class FacePair
{
public:
  using Corners = std::array<int, 3>;

  FacePair() = default;
  // places, squares: of all corners, by number.
  FacePair(const Corners& one, const Corners& other, const Vector3* places, const double* squares)
    : corner_{ Two{ double(one[0]), double(other[0]) }, Two{ double(one[1]), double(other[1]) },
      Two{ double(one[2]), double(other[2]) } }
  {
    const TwoVectors a(places[one[0]], places[other[0]]);
    const TwoVectors b(places[one[1]], places[other[1]]);
    const TwoVectors c(places[one[2]], places[other[2]]);
    const Two ofCorners = Two{ squares[one[0]], squares[other[0]] } +
      Two{ squares[one[1]], squares[other[1]] } + Two{ squares[one[2]], squares[other[2]] };
    normal_ = cross(b - a, c - a);
    offset_ = dot(normal_, a);
    sum_ = a + b + c;
    squares_ = both(4) * ofCorners - dot(sum_, sum_);
  }

  // The squares, with their signs, of the qualities (Geometry/TetrahedronMeasures.h) from there.
  Two signedSquares(const Viewpoint& from) const
  {
    const Two volume = sixVolumes(from);
    const Two squares = squaresOfEdges(from);
    const Two seen = both(Regular) * volume * absolute(volume) / (squares * squares * squares);
    return hasEnd(from) ? both(std::numeric_limits<double>::infinity()) : seen;
  }

  // Whether that is not above the limit.
  TwoFlags arePoor(const Viewpoint& from, double limit) const
  {
    return ~((excess(from, limit) > both(0)) | hasEnd(from));
  }

  // The same for either of them.
  bool somePoor(const Viewpoint& from, double limit) const
  {
    if (least(excess(from, limit)) > 0)
    {
      return false;
    }
    const TwoFlags poor = arePoor(from, limit);
    return (poor[0] | poor[1]) != 0;
  }

  // Whether six times the volume may be no more than that.
  TwoFlags mayBeFlat(const Viewpoint& from, double safe) const
  {
    return ~((sixVolumes(from) > both(safe)) | hasEnd(from));
  }

private:
  static constexpr double Regular = 432; // so that it is 1 for the regular tetrahedron

  // Above 0 where the quality is above the limit: without a division.
  Two excess(const Viewpoint& from, double limit) const
  {
    const Two volume = sixVolumes(from);
    const Two squares = squaresOfEdges(from);
    return both(Regular) * volume * absolute(volume) - both(limit) * (squares * squares * squares);
  }
  Two sixVolumes(const Viewpoint& from) const { return dot(normal_, from.place) - offset_; }
  Two squaresOfEdges(const Viewpoint& from) const
  {
    return squares_ + from.threeSquares - both(2) * dot(sum_, from.place);
  }
  TwoFlags hasEnd(const Viewpoint& from) const
  {
    return (corner_[0] == from.end) | (corner_[1] == from.end) | (corner_[2] == from.end);
  }

  Two corner_[3] = {};
  TwoVectors normal_; // twice the areas
  Two offset_ = {};
  TwoVectors sum_;   // of the corners' places
  Two squares_ = {}; // of the edges and of the corners' places
};
} // namespace ransmesh
