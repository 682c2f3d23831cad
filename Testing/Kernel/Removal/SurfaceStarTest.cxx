// Which triangles of a surface may be replaced by a star.
#include "Removal/SurfaceStar.h"

#include "Geometry/Angles.h"
#include "Support/GridMesh.h"
#include "Support/Invariants.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace
{
using namespace ransmesh;
using grid_mesh::XLow;
using grid_mesh::YLow;
using grid_mesh::ZLow;

// A cube of cells of a quarter, whose point in the middle of the side z = 0 stands higher.
struct BumpyCube
{
  TetMesh mesh;
  PatchTable patches = grid_mesh::patches(PatchType::Symmetry);
  BoundaryRules rules;
  SurfaceMemory memory{ mesh };
  Index middle;

  explicit BumpyCube(double bump)
    : mesh(invariants::build(grid_mesh::make({ 4, 4, 4 })))
    , rules{ classify(mesh, patches), std::vector<char>(7, 1) }
    , middle(vertexAt({ 0.5, 0.5, 0 }))
  {
    mesh.movePoint(middle, { 0.5, 0.5, bump });
  }
  Index vertexAt(const Vector3& x) const
  {
    for (std::size_t v = 0; v < mesh.vertexCount(); ++v)
    {
      if (distance(mesh.point(static_cast<Index>(v)), x) < 1e-9)
      {
        return static_cast<Index>(v);
      }
    }
    throw std::logic_error("no vertex there");
  }
  // The boundary faces that have all of these vertices.
  std::vector<Index> facesWith(const std::vector<Index>& vertices) const
  {
    std::vector<Index> faces;
    for (std::size_t i = 0; i < mesh.boundarySlots(); ++i)
    {
      const auto v = mesh.boundaryVertices(static_cast<Index>(i));
      if (std::all_of(vertices.begin(), vertices.end(),
            [&v](Index w) { return std::find(v.begin(), v.end(), w) != v.end(); }))
      {
        faces.push_back(static_cast<Index>(i));
      }
    }
    return faces;
  }
  RemovalVerdict judge(const std::vector<Index>& faces, Index apex, Index vanishing, double angle)
  {
    return SurfaceStar(mesh, rules, cosineOfDegrees(angle), memory).judge(faces, apex, vanishing);
  }
  // The point in the middle collapsed onto its neighbour.
  RemovalVerdict judgeMiddle(double angle)
  {
    return judge(facesWith({ middle }), vertexAt({ 0.25, 0.5, 0 }), middle, angle);
  }
};
} // namespace

TEST(SurfaceStar, OnAPlanePointsMayGo)
{
  EXPECT_EQ(BumpyCube(0).judgeMiddle(1), RemovalVerdict::Collapsed);
}

TEST(SurfaceStar, NoTriangleMayTurnTooFar)
{
  EXPECT_EQ(BumpyCube(0.02).judgeMiddle(2), RemovalVerdict::SurfaceTurned);
  EXPECT_EQ(BumpyCube(0.02).judgeMiddle(20), RemovalVerdict::Collapsed);
}

TEST(SurfaceStar, NoPointMayGoThatLiesTooFarFromTheNewTriangles)
{
  EXPECT_EQ(BumpyCube(0.07).judgeMiddle(60), RemovalVerdict::SurfaceMoved); // a quarter of an edge
}

TEST(SurfaceStar, RidgesGoOnlyWithTheirVertex)
{
  BumpyCube cube(0);
  const Index low = cube.vertexAt({ 0, 0, 0.25 });
  const Index high = cube.vertexAt({ 0, 0, 0.5 });
  const Index next = cube.vertexAt({ 0, 0, 0.75 });
  const std::vector<Index> atEdge = cube.facesWith({ low, high });
  ASSERT_EQ(atEdge.size(), 2U);
  for (const Index face : atEdge)
  {
    const auto v = cube.mesh.boundaryVertices(face);
    const Index apex = *std::find_if(v.begin(), v.end(), [&](Index w) { return w != low && w != high; });
    EXPECT_EQ(cube.judge(atEdge, apex, None, 180), RemovalVerdict::RidgeLost);
  }
  EXPECT_EQ(cube.judge(cube.facesWith({ high }), next, high, 10), RemovalVerdict::Collapsed);
}
