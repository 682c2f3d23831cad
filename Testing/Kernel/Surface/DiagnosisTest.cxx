#include "Surface/Diagnosis.h"
#include "Surface/DiagnosisText.h"
#include "Surface/Preparation.h"

#include "Support/RoundCube.h"

#include <gtest/gtest.h>

namespace
{
using namespace ransmesh;
using namespace ransmesh::test;

Diagnosis diagnosisOf(const SurfaceMesh& surface)
{
  return diagnose(surface, {}, {});
}
} // namespace

TEST(Diagnosis, FindsNothingWrongWithASoundSurface)
{
  const Diagnosis diagnosis = diagnosisOf(ball(4));
  EXPECT_TRUE(diagnosis.faults.empty());
  EXPECT_TRUE(diagnosis.isSound());
  EXPECT_EQ(diagnosis.triangles, 192u);
  EXPECT_EQ(diagnosis.points, 98u);
  EXPECT_EQ(describe(diagnosis, ball(4), sixPatches()), "");
}

TEST(Diagnosis, CountsASoupAsOnePiece)
{
  const SurfaceMesh whole = ball(3);
  SurfaceMesh soup;
  for (std::size_t t = 0; t < whole.triangles.size(); ++t)
  {
    const auto first = static_cast<Index>(soup.points.size());
    for (const Index v : whole.triangles[t])
    {
      soup.points.push_back(whole.points[v]);
    }
    soup.triangles.push_back({ first, first + 1, first + 2 });
    soup.patch.push_back(whole.patch[t]);
  }
  const Diagnosis diagnosis = diagnosisOf(soup);
  EXPECT_TRUE(diagnosis.isSound());
  EXPECT_EQ(diagnosis.pieces.size(), 1u);
}

TEST(Diagnosis, LeavesBordersInClosingPlanesOpen)
{
  SurfaceMesh half = cube(2);
  std::vector<char> stays;
  for (const int patch : half.patch)
  {
    stays.push_back(patch != 1);
  }
  keepTriangles(half, stays); // open at x = -1
  EXPECT_EQ(diagnosisOf(half).count(SurfaceFault::OpenEdge), 8u);
  DiagnosisOptions options;
  options.closedBy = { { 0, -1, true } };
  EXPECT_TRUE(diagnose(half, options, {}).isSound());
  options.closedBy = { { 1, -1, true } };
  EXPECT_FALSE(diagnose(half, options, {}).isSound());
}

TEST(Diagnosis, NamesWhatCrossesAndWhere)
{
  SurfaceMesh two = cube(1);
  SurfaceMesh bar = cube(1); // passes through the side x = 1
  for (std::size_t t = 0; t < bar.triangles.size(); ++t)
  {
    bar.patch[t] = 7;
  }
  for (Vector3& p : bar.points)
  {
    p = { 1.02 + 0.5 * p.x, 0.3 + 0.1 * p.y, 0.05 * p.z };
  }
  append(two, bar);
  PatchTable patches = sixPatches();
  patches[2].name = "hull";
  patches.push_back({ "fin", PatchType::Wall });
  const Diagnosis diagnosis = diagnosisOf(two);
  ASSERT_EQ(diagnosis.faults.size(), 1u);
  EXPECT_NEAR(diagnosis.faults[0].where.x, 1, 1e-12);
  const std::string text = describe(diagnosis, two, patches);
  EXPECT_NE(text.find("triangles of 'hull' and 'fin' cross near (1, "), std::string::npos) << text;
  const auto rows = faultRows(diagnosis, two, patches);
  ASSERT_EQ(rows.size(), 1u);
  EXPECT_EQ(rows[0].count, diagnosis.count(SurfaceFault::Intersection));
  EXPECT_EQ(rows[0].triangles, diagnosis.faults[0].findings.size());
  EXPECT_EQ(rows[0].patches, "'hull' and 'fin'");
}

TEST(Diagnosis, TellsWhatLiesInWhat)
{
  SurfaceMesh nested = ball(3);
  append(nested, moved(ball(3), { 0, 0, 0 }, 0.5));
  append(nested, moved(ball(3), { 0.1, 0, 0 }, 0.2));
  append(nested, moved(ball(3), { 5, 0, 0 }));
  const auto pieces = findPieces(nested);
  ASSERT_EQ(pieces.size(), 4u);
  EXPECT_EQ(pieces[0].enclosedBy, -1);
  EXPECT_EQ(pieces[1].enclosedBy, 0);
  EXPECT_EQ(pieces[2].enclosedBy, 1);
  EXPECT_EQ(pieces[3].enclosedBy, -1);
  EXPECT_NEAR(pieces[1].volume, pieces[0].volume / 8, 1e-12);
  EXPECT_EQ(pieces[3].patch, (std::vector<int>{ 1, 2, 3, 4, 5, 6 }));
}

TEST(Preparation, LeavesARefusedSurfaceAsItWasGiven)
{
  SurfaceMesh open = ball(4);
  open.triangles.pop_back();
  open.patch.pop_back();
  open.triangles.push_back(open.triangles[0]);
  open.patch.push_back(open.patch[0]);
  const SurfaceMesh given = open;
  PatchTable patches = sixPatches();
  const SurfaceVerdict verdict = prepareSurface(open, patches, {}, {});
  EXPECT_EQ(verdict.outcome.kind, Outcome::Kind::BadInput);
  EXPECT_NE(verdict.outcome.message.find("3 open edges"), std::string::npos) << verdict.outcome.message;
  EXPECT_NE(verdict.outcome.message.find("1 duplicate triangle"), std::string::npos);
  EXPECT_EQ(open.triangles, given.triangles);
  EXPECT_EQ(patches.size(), 7u);
}

TEST(Preparation, WithoutRepairSaysThatRepairHelps)
{
  SurfaceMesh doubled = ball(4);
  doubled.triangles.push_back(doubled.triangles[0]);
  doubled.patch.push_back(1);
  PatchTable patches = sixPatches();
  PreparationOptions options;
  options.repair = false;
  const SurfaceVerdict verdict = prepareSurface(doubled, patches, options, {});
  EXPECT_NE(verdict.outcome.message.find("leave Repair on"), std::string::npos) << verdict.outcome.message;
  EXPECT_TRUE(prepareSurface(doubled, patches, {}, {}).outcome.ok());
}
