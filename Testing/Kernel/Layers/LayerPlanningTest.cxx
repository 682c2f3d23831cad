#include "Layers/LayerPlanning.h"

#include "Support/LayeredBox.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

namespace
{
using namespace ransmesh;

MeshData box()
{
  return layered_box::make(2, 2, 0.5, { 0, 0.5, 1 });
}

LayerRequest request()
{
  LayerRequest r;
  r.general.firstHeight = 1e-3;
  r.general.numberOfLayers = 25;
  return r;
}

// The numbers of the patches that got layers.
std::vector<int> wallsOf(const PatchTable& patches, const LayerRequest& r)
{
  LayerPlan plan;
  const Outcome outcome = planLayers(box(), patches, r, plan);
  EXPECT_TRUE(outcome.ok()) << outcome.message;
  std::vector<int> walls;
  for (std::size_t i = 0; i < plan.size(); ++i)
  {
    if (plan[i].hasLayers())
    {
      walls.push_back(static_cast<int>(i));
    }
  }
  return walls;
}

std::string messageOf(const PatchTable& patches, const LayerRequest& r)
{
  LayerPlan plan;
  const Outcome outcome = planLayers(box(), patches, r, plan);
  EXPECT_EQ(outcome.kind, Outcome::Kind::BadInput);
  return outcome.message;
}

bool contains(const std::string& text, const std::string& phrase)
{
  return text.find(phrase) != std::string::npos;
}

using Numbers = std::vector<int>;

TEST(LayerPatterns, wildcards)
{
  EXPECT_TRUE(matchesPattern("wing", "wing"));
  EXPECT_TRUE(matchesPattern("wing", "*"));
  EXPECT_TRUE(matchesPattern("wing", "w*g"));
  EXPECT_TRUE(matchesPattern("wing", "wi??"));
  EXPECT_TRUE(matchesPattern("wing", "*ing*"));
  EXPECT_TRUE(matchesPattern("wing_upper_left", "wing*left"));
  EXPECT_TRUE(matchesPattern("aab", "*ab"));
  EXPECT_TRUE(matchesPattern("", "*"));
  EXPECT_TRUE(matchesPattern("a*b", "a*b"));
  EXPECT_FALSE(matchesPattern("wing", "win"));
  EXPECT_FALSE(matchesPattern("wing", "wing?"));
  EXPECT_FALSE(matchesPattern("wing", "Wing"));
  EXPECT_FALSE(matchesPattern("wing_upper", "wing*left"));
  EXPECT_FALSE(matchesPattern("", "?"));
}

TEST(LayerPatterns, numbersAndNamesTakeAnyPatchWildcardsDoNot)
{
  const PatchTable patches = { { "fluid", PatchType::Patch }, { "body", PatchType::Wall },
    { "body_far", PatchType::FarField }, { "body_sym", PatchType::Symmetry }, { "body_in", PatchType::Inlet },
    { "body_out", PatchType::Outlet }, { "body_cut", PatchType::Interface },
    { "body_sheet", PatchType::Wake }, { "body_other", PatchType::Patch }, { "3", PatchType::Wall } };
  EXPECT_EQ(patchesOf(patches, "body*"), (Numbers{ 1, 7, 8 }));
  EXPECT_EQ(patchesOf(patches, "*"), (Numbers{ 1, 7, 8, 9 }));
  EXPECT_EQ(patchesOf(patches, "body_far"), (Numbers{ 2 }));
  EXPECT_EQ(patchesOf(patches, "body_cut"), (Numbers{ 6 }));
  EXPECT_EQ(patchesOf(patches, "4"), (Numbers{ 4 }));
  EXPECT_EQ(patchesOf(patches, "3"), (Numbers{ 3, 9 })); // by number, and by name
  EXPECT_EQ(patchesOf(patches, "0"), (Numbers{}));
  EXPECT_EQ(patchesOf(patches, "fluid"), (Numbers{}));
  EXPECT_EQ(patchesOf(patches, "nothing"), (Numbers{}));
}

TEST(LayerPatterns, equalNamesAreTakenTogether)
{
  const PatchTable patches = { { "fluid" }, { "a" }, { "b" }, { "a" } };
  EXPECT_EQ(patchesOf(patches, "a"), (Numbers{ 1, 3 }));
}

TEST(LayerPlanning, wallsByTypeWithoutPatterns)
{
  EXPECT_EQ(wallsOf(layered_box::patches(), request()), (Numbers{ layered_box::Floor }));
}

TEST(LayerPlanning, withoutTypesTheBoxSidesAreNoWalls)
{
  MeshData mesh = box();
  PatchTable patches(8, Patch{ "some", PatchType::Patch });
  mesh.trianglePatch[0] = mesh.trianglePatch.back() = 7; // on two sides of the box: a body
  LayerPlan plan;
  ASSERT_TRUE(planLayers(mesh, patches, request(), plan).ok());
  for (int i = 1; i <= 6; ++i)
  {
    EXPECT_FALSE(plan[i].hasLayers()) << i;
  }
  EXPECT_TRUE(plan[7].hasLayers());
}

TEST(LayerPlanning, aPatchThatBendsALittleIsNoSideOfTheBox)
{
  MeshData mesh = box();
  const std::vector<char> before = findBoxSides(mesh, 7);
  EXPECT_EQ(std::count(before.begin() + 1, before.end(), 1), 6);
  const std::size_t inMiddle = 4; // of the three by three points of the floor
  ASSERT_EQ(mesh.points[inMiddle].z, 0);
  mesh.points[inMiddle].z = 1e-6;
  const std::vector<char> after = findBoxSides(mesh, 7);
  EXPECT_EQ(std::count(after.begin() + 1, after.end(), 1), 5);
}

TEST(LayerPlanning, namedWallsReplaceThoseByType)
{
  LayerRequest r = request();
  r.wallPatterns = { "lid", "3" };
  EXPECT_EQ(wallsOf(layered_box::patches(), r), (Numbers{ layered_box::Lid, layered_box::West }));
}

TEST(LayerPlanning, aWildcardNeverTakesTheFarField)
{
  LayerRequest r = request();
  r.wallPatterns = { "*" };
  EXPECT_EQ(wallsOf(layered_box::patches(), r), (Numbers{ layered_box::Floor }));
  r.wallPatterns = { "l*" };
  EXPECT_TRUE(contains(messageOf(layered_box::patches(), r), "\"l*\""));
}

TEST(LayerPlanning, patchRulesMakeWallsAndTheLastOneWins)
{
  LayerRequest r = request();
  r.wallPatterns = { "floor" };
  r.patchLayers = { { "lid", 2e-3, 1.3, 7 }, { "floor", 3e-3, 1.1, 5 }, { "1", 4e-3, 1.4, 6 } };
  LayerPlan plan;
  ASSERT_TRUE(planLayers(box(), layered_box::patches(), r, plan).ok());
  EXPECT_EQ(plan[layered_box::Lid].firstHeight, 2e-3);
  EXPECT_EQ(plan[layered_box::Lid].growthRate, 1.3);
  EXPECT_EQ(plan[layered_box::Lid].numberOfLayers, 7);
  EXPECT_EQ(plan[layered_box::Floor].firstHeight, 4e-3);
  EXPECT_EQ(plan[layered_box::Floor].numberOfLayers, 6);
  EXPECT_FALSE(plan[0].hasLayers());
  EXPECT_FALSE(plan[layered_box::West].hasLayers());
}

TEST(LayerPlanning, choicesComeLastAndForeignNamesMeanNothing)
{
  LayerRequest r = request();
  r.choices = { { "west", true }, { "floor", false }, { "of another mesh", true } };
  EXPECT_EQ(wallsOf(layered_box::patches(), r), (Numbers{ layered_box::West }));
}

TEST(LayerPlanning, thicknessDecidesTheNumberOfLayers)
{
  LayerRequest r = request();
  r.totalThickness = 0.1;
  LayerPlan plan;
  ASSERT_TRUE(planLayers(box(), layered_box::patches(), r, plan).ok());
  EXPECT_EQ(plan[layered_box::Floor].numberOfLayers, layersForThickness(r.general, 0.1));
}

TEST(LayerPlanning, patternsThatTakeNothingNameThePatchesThereAre)
{
  LayerRequest r = request();
  r.wallPatterns = { "hull" };
  const std::string message = messageOf(layered_box::patches(), r);
  EXPECT_TRUE(contains(message, "\"hull\"")) << message;
  EXPECT_TRUE(contains(message, "floor (wall), lid (farfield)")) << message;
  r.wallPatterns.clear();
  r.patchLayers = { { "keel", 1e-3, 1.2, 5 } };
  EXPECT_TRUE(contains(messageOf(layered_box::patches(), r), "\"keel\""));
}

TEST(LayerPlanning, noWallIsAnError)
{
  PatchTable patches = layered_box::patches();
  patches[layered_box::Floor].type = PatchType::Inlet;
  const std::string message = messageOf(patches, request());
  EXPECT_TRUE(contains(message, "no patch is a viscous wall")) << message;
  EXPECT_TRUE(contains(message, "AddWallPatch")) << message;
}

TEST(LayerPlanning, impossibleSpecificationsNameThePatch)
{
  LayerRequest r = request();
  r.general.firstHeight = 0;
  EXPECT_TRUE(contains(messageOf(layered_box::patches(), r), "layers on floor: the first height is 0"));
  r.general.firstHeight = 2;
  const std::string message = messageOf(layered_box::patches(), r);
  EXPECT_TRUE(contains(message, "the first height 2 is not below the largest extent of the mesh, 1"))
    << message;
}

// At 1 neighbouring doubles are 2.2e-16 apart: heights of four times that would be off by an eighth.
TEST(LayerPlanning, aHeightThatCoordinatesCannotTellIsAnError)
{
  LayerRequest r = request();
  r.general.firstHeight = 4 * std::numeric_limits<double>::epsilon();
  const std::string message = messageOf(layered_box::patches(), r);
  EXPECT_TRUE(contains(message, "layers on floor: the first height 8.8")) << message;
  EXPECT_TRUE(contains(message, "coordinates, which go up to 1:")) << message;
  r.general.firstHeight = 6 * std::numeric_limits<double>::epsilon();
  LayerPlan plan;
  EXPECT_TRUE(planLayers(box(), layered_box::patches(), r, plan).ok());
}

TEST(LayerPlanning, longListsOfPatchesAreCut)
{
  PatchTable patches(100, Patch{ "side", PatchType::Symmetry });
  const std::string message = messageOf(patches, request());
  EXPECT_LT(message.size(), 1000u);
  EXPECT_TRUE(contains(message, "...")) << message;
}
} // namespace
