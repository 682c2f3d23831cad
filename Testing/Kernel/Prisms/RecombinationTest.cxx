#include "Prisms/Recombination.h"

#include "Geometry/TetrahedronMeasures.h"
#include "Mesh/MixedValidation.h"
#include "Mesh/Validation.h"
#include "Support/GridMesh.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <random>

namespace
{
using namespace ransmesh;
using grid_mesh::Side;

constexpr int Cells = 5;

struct Subject
{
  MeshData mesh;
  std::vector<Index> prism;
};

// Kuhn's grid: the six tetrahedra of a cube are two prisms along z, cut by the diagonal of its floor.
Subject makeSubject(const std::function<Vector3(const Vector3&)>& map = {})
{
  Subject subject;
  subject.mesh = grid_mesh::make({ Cells, Cells, Cells });
  const auto& p = subject.mesh.points;
  for (const auto& tet : subject.mesh.tetrahedra)
  {
    const Vector3 middle = 0.25 * (p[tet[0]] + p[tet[1]] + p[tet[2]] + p[tet[3]]);
    const auto cell = [](double x) { return static_cast<Index>(x * Cells); };
    const bool isUpper = middle.y * Cells - cell(middle.y) > middle.x * Cells - cell(middle.x);
    subject.prism.push_back(
      2 * ((cell(middle.z) * Cells + cell(middle.y)) * Cells + cell(middle.x)) + (isUpper ? 1 : 0));
  }
  if (map)
  {
    for (Vector3& x : subject.mesh.points)
    {
      x = map(x);
    }
  }
  return subject;
}

RecombinedMesh recombine(const Subject& subject)
{
  RecombinedMesh result;
  EXPECT_TRUE(recombinePrisms(subject.mesh, subject.prism, 90, {}, result).ok());
  const MixedFaults faults = findFaults(result.mesh);
  EXPECT_TRUE(faults.none()) << faults.text();
  return result;
}

// In the uppermost layer of cubes, prisms along x instead, cut by the diagonal of the cubes' sides; the lower ones have
// two numbers.
Subject withPrismsLyingAbove()
{
  Subject subject = makeSubject();
  const auto& p = subject.mesh.points;
  std::map<Index, int> tetsOf;
  for (std::size_t t = 0; t < subject.prism.size(); ++t)
  {
    const auto& tet = subject.mesh.tetrahedra[t];
    const Vector3 middle = (static_cast<double>(Cells) / 4) * (p[tet[0]] + p[tet[1]] + p[tet[2]] + p[tet[3]]);
    if (middle.z > Cells - 1)
    {
      const Index cube = static_cast<Index>(middle.y) * Cells + static_cast<Index>(middle.x);
      const bool isLower = middle.y - std::floor(middle.y) > middle.z - std::floor(middle.z);
      const bool isFirst = isLower && tetsOf[cube]++ == 0;
      subject.prism[t] = 1000 + 3 * cube + (isLower ? isFirst ? 2 : 1 : 0);
    }
  }
  return subject;
}

double volumeOf(const RecombinedMesh& result)
{
  const SplitMesh split = splitIntoTets(result.mesh);
  const MeshFaults faults = findFaults(split.mesh);
  EXPECT_TRUE(faults.none()) << faults.text();
  return totalVolume(split.mesh);
}

std::size_t countQuads(const MixedMesh& mesh)
{
  return static_cast<std::size_t>(std::count_if(
    mesh.boundary.begin(), mesh.boundary.end(), [](const Polygon& polygon) { return !isTriangle(polygon); }));
}
} // namespace

TEST(Recombination, PrismsBelowLyingOnesBecomeHexahedra)
{
  const RecombinedMesh result = recombine(withPrismsLyingAbove());
  EXPECT_EQ(result.mesh.hexahedra.size(), 1U * Cells * Cells * (Cells - 1));
  EXPECT_EQ(result.mesh.wedges.size(), 2U * Cells * Cells);
  EXPECT_TRUE(result.mesh.tetrahedra.empty());
  EXPECT_TRUE(result.mesh.pyramids.empty());
  EXPECT_EQ(result.report.shareInWedges(), 1);
  EXPECT_NEAR(volumeOf(result), 1, 1e-12);
}

TEST(Recombination, HalvesStayWhereThePairsBelowCannotAllBeHexahedra)
{
  Subject subject = withPrismsLyingAbove();
  for (std::size_t t = 0; t < subject.prism.size(); ++t)
  {
    const auto& tet = subject.mesh.tetrahedra[t];
    const bool isLowest =
      std::any_of(tet.begin(), tet.end(), [&](Index v) { return subject.mesh.points[v].z == 0; });
    subject.prism[t] = isLowest ? None : subject.prism[t];
  }
  const RecombinedMesh result = recombine(subject);
  EXPECT_TRUE(result.mesh.hexahedra.empty());
  EXPECT_GE(result.mesh.wedges.size(), 2U * Cells * Cells * (Cells - 3));
  EXPECT_NEAR(volumeOf(result), 1, 1e-12);
}

TEST(Recombination, AllOfAGridBecomesWedges)
{
  const RecombinedMesh result = recombine(makeSubject());
  EXPECT_EQ(result.mesh.wedges.size(), 2U * Cells * Cells * Cells);
  EXPECT_TRUE(result.mesh.tetrahedra.empty());
  EXPECT_TRUE(result.mesh.pyramids.empty());
  EXPECT_EQ(result.report.shareInWedges(), 1);
  EXPECT_EQ(countQuads(result.mesh), 4U * Cells * Cells); // its four sides; top and bottom are triangles
  EXPECT_EQ(result.cellOrigin.size(), result.mesh.cellCount());
  EXPECT_EQ(result.boundaryOrigin.size(), result.mesh.boundary.size());
  EXPECT_TRUE(std::is_sorted(result.mesh.boundaryPatch.begin(), result.mesh.boundaryPatch.end()));
  EXPECT_NEAR(volumeOf(result), 1, 1e-12);
}

TEST(Recombination, ThinAndLeaningPrismsToo)
{
  const Subject subject = makeSubject(
    [](const Vector3& p) {
      return Vector3{ p.x + 0.3 * p.z, p.y, 1e-6 * p.z * (1 + p.x * p.y) };
    });
  EXPECT_EQ(recombine(subject).report.shareInWedges(), 1);
}

TEST(Recombination, WithoutPrismsNothingChanges)
{
  Subject subject = makeSubject();
  std::fill(subject.prism.begin(), subject.prism.end(), None);
  const RecombinedMesh result = recombine(subject);
  EXPECT_EQ(result.mesh.tetrahedra, subject.mesh.tetrahedra);
  EXPECT_EQ(result.mesh.boundary.size(), subject.mesh.triangles.size());
  EXPECT_EQ(result.report.shareInWedges(), 1);
}

// The neighbour of what stays in tetrahedra loses one of its three quadrilaterals: it takes a point of its own.
TEST(Recombination, OnePrismInTetrahedraCostsItsNeighboursOnly)
{
  Subject subject = makeSubject();
  const Index middle = 2 * ((2 * Cells + 2) * Cells + 2);
  std::replace(subject.prism.begin(), subject.prism.end(), middle, None);
  const RecombinedMesh result = recombine(subject);
  EXPECT_EQ(result.report.newPoints, 3U);
  EXPECT_EQ(result.newPointOrigin.size(), 3U);
  EXPECT_EQ(result.mesh.wedges.size(), 2U * Cells * Cells * Cells - 4);
  EXPECT_EQ(result.mesh.pyramids.size(), 6U);
  EXPECT_NEAR(volumeOf(result), 1, 1e-12);
}

// In prisms a hundred times thinner than wide, a point amid would give tetrahedra of almost 180 degrees.
TEST(Recombination, APointWithinAThinPrismStandsNearAColumn)
{
  Subject subject = makeSubject([](const Vector3& p) { return Vector3{ p.x, p.y, 0.01 * p.z }; });
  const Index middle = 2 * ((2 * Cells + 2) * Cells + 2);
  std::replace(subject.prism.begin(), subject.prism.end(), middle, None);
  const RecombinedMesh result = recombine(subject);
  ASSERT_EQ(result.report.newPoints, 3U);
  const auto& p = result.mesh.points;
  for (const auto& v : result.mesh.tetrahedra)
  {
    EXPECT_LT(largestDihedral(p[v[0]], p[v[1]], p[v[2]], p[v[3]]), 165);
  }
}

TEST(Recombination, ColumnsThatEndEarlierEndInPyramidsAndTetrahedra)
{
  Subject subject = makeSubject();
  for (std::size_t t = 0; t < subject.prism.size(); ++t) // one point of the top is cut off its prisms
  {
    const auto& v = subject.mesh.tetrahedra[t];
    const bool atCorner = std::any_of(v.begin(), v.end(),
      [&](Index i) {
        return subject.mesh.points[i] == Vector3{ 0.6, 0.6, 1 };
      });
    subject.prism[t] = atCorner ? None : subject.prism[t];
  }
  const RecombinedMesh result = recombine(subject);
  EXPECT_GT(result.mesh.pyramids.size(), 0U);
  EXPECT_GT(result.report.shareInWedges(), 0.9);
  EXPECT_NEAR(volumeOf(result), 1, 1e-12);
}

TEST(Recombination, ATwistedPrismStaysInPieces)
{
  Subject subject = makeSubject();
  for (Vector3& x : subject.mesh.points)
  {
    if (x == Vector3{ 0.4, 0.4, 0.4 })
    {
      x = { 0.55, 0.53, 0.53 }; // the tetrahedra stay positive; not every way to cut the prisms does
    }
  }
  ASSERT_TRUE(findFaults(subject.mesh).none());
  const RecombinedMesh result = recombine(subject);
  EXPECT_LT(result.mesh.wedges.size(), 2U * Cells * Cells * Cells);
  EXPECT_LT(result.report.shareInWedges(), 1);
  EXPECT_NEAR(volumeOf(result), 1, 1e-12);
}

// Whatever the numbers say, the result is a valid mesh of the same domain.
TEST(Recombination, WrongPrismNumbersDoNoHarm)
{
  std::mt19937 random(7);
  for (int round = 0; round < 20; ++round)
  {
    Subject subject = makeSubject();
    for (Index& number : subject.prism)
    {
      if (random() % 5 == 0)
      {
        number = static_cast<Index>(random() % (2 * Cells * Cells * Cells));
      }
    }
    EXPECT_NEAR(volumeOf(recombine(subject)), 1, 1e-12);
  }
}

TEST(Recombination, ASideOfTwoPatchesKeepsItsTriangles)
{
  Subject subject = makeSubject();
  std::vector<Index> west;
  for (std::size_t i = 0; i < subject.mesh.triangles.size(); ++i)
  {
    if (subject.mesh.trianglePatch[i] == Side::XLow)
    {
      west.push_back(static_cast<Index>(i));
    }
  }
  for (std::size_t i = 0; i < west.size(); i += 2) // each quadrilateral of it lies in two patches
  {
    subject.mesh.trianglePatch[west[i]] = 7;
  }
  const RecombinedMesh result = recombine(subject);
  EXPECT_EQ(countQuads(result.mesh), 3U * Cells * Cells);
  EXPECT_NEAR(volumeOf(result), 1, 1e-12);
}

TEST(Recombination, ASheetBetweenPrismsBecomesQuadrilaterals)
{
  Subject subject = makeSubject();
  const int sheet = grid_mesh::addSheet(
    subject.mesh, [](const Vector3& middle) { return std::abs(middle.x - 0.4) < 1e-9 && middle.z < 0.39; });
  const RecombinedMesh result = recombine(subject);
  EXPECT_EQ(result.report.shareInWedges(), 1);
  EXPECT_EQ(std::count(result.mesh.boundaryPatch.begin(), result.mesh.boundaryPatch.end(), sheet), 2 * Cells);
  EXPECT_EQ(countQuads(result.mesh), 4U * Cells * Cells + 2 * Cells);
}

TEST(Recombination, RefusesAMeshThatIsNotClosed)
{
  Subject subject = makeSubject();
  subject.mesh.triangles.pop_back();
  subject.mesh.trianglePatch.pop_back();
  RecombinedMesh result;
  EXPECT_EQ(recombinePrisms(subject.mesh, subject.prism, 90, {}, result).kind, Outcome::Kind::BadInput);
}

TEST(Recombination, StopsOnRequest)
{
  const Subject subject = makeSubject();
  Context context;
  context.cancelled = [] { return true; };
  RecombinedMesh result;
  EXPECT_EQ(recombinePrisms(subject.mesh, subject.prism, 90, context, result).kind, Outcome::Kind::Cancelled);
}
