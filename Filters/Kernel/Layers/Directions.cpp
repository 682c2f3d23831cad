#include "Layers/Directions.h"

#include <algorithm>
#include <cmath>

namespace ransmesh
{
namespace
{
// Above this the direction is good enough as it is.
constexpr double GoodVisibility = 0.7;
// Into the tip of a cone of 7 degrees the step is so many times as long as it is high.
constexpr double LargestScale = 8;

const Vector3& leastVisible(const std::vector<Vector3>& normals, const Vector3& d)
{
  return *std::min_element(normals.begin(), normals.end(),
    [&d](const Vector3& a, const Vector3& b) { return dot(a, d) < dot(b, d); });
}

// The face above which the step's rise differs most from one.
const Vector3& mostMissed(std::span<const FaceAtVertex> walls, const Vector3& step)
{
  const auto miss = [&step](const FaceAtVertex& f) { return std::fabs(1 - dot(f.normal, step)); };
  return std::max_element(walls.begin(), walls.end(),
    [&](const FaceAtVertex& a, const FaceAtVertex& b) { return miss(a) < miss(b); })
    ->normal;
}

// By how much the step's rise differs from one above that face.
double largestMiss(std::span<const FaceAtVertex> walls, const Vector3& step)
{
  return std::fabs(1 - dot(mostMissed(walls, step), step));
}
} // namespace

SideProjection::SideProjection(const std::vector<Vector3>& normals)
{
  for (Vector3 n : normals)
  {
    for (const Vector3& u : axes_)
    {
      n = n - dot(n, u) * u;
    }
    if (norm(n) > 1e-6)
    {
      axes_.push_back(normalized(n));
    }
  }
}

Vector3 SideProjection::inPlanes(Vector3 d) const
{
  for (int pass = 0; pass < 2; ++pass) // twice: the first leaves rounding errors
  {
    for (const Vector3& u : axes_)
    {
      d = d - dot(d, u) * u;
    }
  }
  return withoutRounding(d);
}

Vector3 withoutRounding(Vector3 d)
{
  for (int i = 0; i < 3; ++i)
  {
    d[i] = std::fabs(d[i]) < 1e-14 ? 0 : d[i];
  }
  return d;
}

double visibility(const std::vector<Vector3>& normals, const Vector3& d)
{
  return normals.empty() ? 1 : dot(leastVisible(normals, d), d);
}

// Turns d towards the face that it sees worst, by smaller and smaller steps, and keeps the best.
Vector3 mostVisible(const std::vector<Vector3>& normals, const SideProjection& lay, Vector3 d)
{
  Vector3 best = d;
  double bestCosine = visibility(normals, d);
  double step = 0.5;
  for (int i = 0; i < 40 && bestCosine < GoodVisibility; ++i)
  {
    d = lay(d + step * leastVisible(normals, d));
    step *= 0.9;
    const double cosine = visibility(normals, d);
    if (cosine > bestCosine)
    {
      best = d;
      bestCosine = cosine;
    }
  }
  return best;
}

std::vector<Vector3> normalsOf(std::span<const FaceAtVertex> faces)
{
  std::vector<Vector3> normals;
  std::transform(
    faces.begin(), faces.end(), std::back_inserter(normals), [](const FaceAtVertex& f) { return f.normal; });
  return normals;
}

Vector3 scaledStep(std::span<const FaceAtVertex> walls, const Vector3& d)
{
  double rise = 0;
  double weight = 0;
  for (const FaceAtVertex& f : walls)
  {
    rise += f.angle * dot(f.normal, d);
    weight += f.angle;
  }
  const double mean = rise / weight;
  return (1 / std::max(mean, 1 / LargestScale)) * d;
}

// Goes again and again to where the step would rise as it should above the face that it misses most, and keeps the
// best.
Vector3 evenStep(std::span<const FaceAtVertex> walls, const SideProjection& lay, const Vector3& d)
{
  constexpr double even = 0.05; // of the height
  constexpr double near = 0.09; // else rather right above most than about right above all
  constexpr int rounds = 100;
  constexpr double markedly = 0.95;
  constexpr double longest = 3; // of what is high one: into narrower crooks the scaled step leads
  const Vector3 scaled = scaledStep(walls, d);
  double least = largestMiss(walls, scaled);
  if (least < even)
  {
    return scaled;
  }
  Vector3 best = scaled;
  Vector3 step = scaled;
  for (int i = 0; i < rounds; ++i)
  {
    const Vector3& normal = mostMissed(walls, step);
    step += (1 - i / static_cast<double>(rounds)) * (1 - dot(normal, step)) * lay.inPlanes(normal);
    if (const double miss = largestMiss(walls, step); miss < least)
    {
      least = miss;
      best = step;
    }
  }
  const std::vector<Vector3> normals = normalsOf(walls);
  const bool seesAll = visibility(normals, normalized(best)) > markedly * visibility(normals, d);
  return least < near && seesAll && norm(best) <= longest ? best : scaled;
}
} // namespace ransmesh
