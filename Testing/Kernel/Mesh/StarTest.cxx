#include "Mesh/Star.h"

#include "Mesh/Traversal.h"
#include "Support/GridMesh.h"
#include "Support/Invariants.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <set>

namespace
{
using namespace ransmesh;

// Random operations on a box; every one that the operator allows is done.
class RandomStars
{
public:
  explicit RandomStars(unsigned seed)
    : before_(grid_mesh::make({ 4, 4, 4, {}, 0.2, seed }))
    , mesh_(invariants::build(before_))
    , star_(mesh_)
    , traversal_(mesh_)
    , random_(seed)
  {
  }

  void runAndUndo(int count)
  {
    const TetMesh before = mesh_;
    mesh_.beginTrial();
    act(count);
    mesh_.undoTrial();
    expectSame(before);
  }
  void runInTrial(int count)
  {
    mesh_.beginTrial();
    act(count);
    mesh_.keepTrial();
  }
  void run(int count)
  {
    act(count);
    invariants::expectKept(before_, toMeshData(mesh_), 1e-10);
    invariants::expectValid(mesh_);
  }

  std::size_t done() const { return done_; }
  std::size_t refused() const { return refused_; }

private:
  void act(int count)
  {
    for (int i = 0; i < count; ++i)
    {
      const unsigned kind = pick(5);
      kind == 0     ? insertInVolume()
        : kind == 1 ? insertOnFace()
        : kind == 2 ? insertOnEdge()
        : kind == 3 ? collapse()
                    : restar();
      if (i % 50 == 0)
      {
        invariants::expectValid(mesh_);
      }
    }
  }
  // Slot by slot, and the next tetrahedron comes into the same one.
  void expectSame(const TetMesh& before)
  {
    ASSERT_EQ(mesh_.points(), before.points());
    ASSERT_EQ(mesh_.tetSlots(), before.tetSlots());
    ASSERT_EQ(mesh_.boundarySlots(), before.boundarySlots());
    for (std::size_t v = 0; v < before.vertexCount(); ++v)
    {
      EXPECT_EQ(mesh_.tetAt(static_cast<Index>(v)), before.tetAt(static_cast<Index>(v)));
    }
    for (std::size_t t = 0; t < before.tetSlots(); ++t)
    {
      EXPECT_EQ(mesh_.tet(static_cast<Index>(t)).vertex, before.tet(static_cast<Index>(t)).vertex);
      EXPECT_EQ(mesh_.tet(static_cast<Index>(t)).neighbour, before.tet(static_cast<Index>(t)).neighbour);
    }
    for (std::size_t b = 0; b < before.boundarySlots(); ++b)
    {
      EXPECT_EQ(
        mesh_.boundaryFace(static_cast<Index>(b)).inner, before.boundaryFace(static_cast<Index>(b)).inner);
      EXPECT_EQ(
        mesh_.boundaryFace(static_cast<Index>(b)).patch, before.boundaryFace(static_cast<Index>(b)).patch);
    }
    TetMesh one = mesh_;
    TetMesh other = before;
    EXPECT_EQ(one.addTet({ 0, 1, 2, 3 }), other.addTet({ 0, 1, 2, 3 }));
  }
  unsigned pick(std::size_t below) { return static_cast<unsigned>(random_() % below); }

  Index randomTet()
  {
    for (;;)
    {
      const auto t = static_cast<Index>(pick(mesh_.tetSlots()));
      if (mesh_.tet(t).isAlive())
      {
        return t;
      }
    }
  }
  Index randomBoundaryFace()
  {
    for (;;)
    {
      const auto b = static_cast<Index>(pick(mesh_.boundarySlots()));
      if (mesh_.boundaryFace(b).isAlive())
      {
        return b;
      }
    }
  }
  // Stars only where no vertex but the one named would be lost.
  bool starIf(const Cavity& cavity, Index apex, Index mayGo = None)
  {
    const bool possible = star_.check(cavity, apex) == StarVerdict::Possible &&
      std::all_of(
        star_.lostVertices().begin(), star_.lostVertices().end(), [&](Index v) { return v == mayGo; });
    if (possible)
    {
      star_.apply();
    }
    ++(possible ? done_ : refused_);
    return possible;
  }
  void insert(const Cavity& cavity, const Vector3& x)
  {
    const Index q = mesh_.addVertex(x);
    if (!starIf(cavity, q))
    {
      mesh_.removeLastVertices(1);
    }
  }

  void insertInVolume()
  {
    const Index t = randomTet();
    Vector3 middle;
    for (const Index v : mesh_.tet(t).vertex)
    {
      middle += 0.25 * mesh_.point(v);
    }
    insert({ { t }, {} }, middle);
  }
  // The points of a side have one coordinate in common, so that the middle lies in the side exactly.
  void insertOnFace()
  {
    const Index b = randomBoundaryFace();
    const auto v = mesh_.boundaryVertices(b);
    const Vector3 x = 0.5 * mesh_.point(v[0]) + 0.25 * mesh_.point(v[1]) + 0.25 * mesh_.point(v[2]);
    insert({ { tetOf(mesh_.boundaryFace(b).inner) }, { b } }, x);
  }
  // On a boundary edge, ridges among them.
  void insertOnEdge()
  {
    const Index b = randomBoundaryFace();
    const auto v = mesh_.boundaryVertices(b);
    Cavity cavity;
    traversal_.ring(tetOf(mesh_.boundaryFace(b).inner), v[0], v[1], cavity.tets);
    cavity.starredFaces = boundaryFacesWith(cavity.tets, { v[0], v[1] });
    EXPECT_EQ(cavity.starredFaces.size(), 2u);
    insert(cavity, 0.5 * (mesh_.point(v[0]) + mesh_.point(v[1])));
  }
  std::vector<Index> boundaryFacesWith(const std::vector<Index>& tets, const std::vector<Index>& vertices)
  {
    std::vector<Index> faces;
    for (const Index t : tets)
    {
      for (int f = 0; f < 4; ++f)
      {
        const auto face = mesh_.tet(t).face(f);
        const bool hasAll = std::all_of(vertices.begin(), vertices.end(),
          [&](Index v) { return std::find(face.begin(), face.end(), v) != face.end(); });
        if (isBoundary(mesh_.tet(t).neighbour[f]) && hasAll)
        {
          faces.push_back(boundaryFaceOf(mesh_.tet(t).neighbour[f]));
        }
      }
    }
    return faces;
  }
  // Inner vertices to any neighbour; those on the boundary stay.
  void collapse()
  {
    const Tetrahedron tet = mesh_.tet(randomTet());
    const Index v = tet.vertex[pick(4)];
    const Index w = tet.vertex[pick(4)];
    Cavity cavity;
    traversal_.ball(v, cavity.tets);
    if (v != w && boundaryFacesWith(cavity.tets, { v }).empty())
    {
      starIf(cavity, w, v);
    }
  }
  // Some neighbouring tetrahedra, one of them named twice, from some vertex nearby.
  void restar()
  {
    Cavity cavity{ { randomTet() }, {} };
    for (unsigned size = 1 + pick(6); size > 0; --size)
    {
      const HalfFace beyond = mesh_.tet(cavity.tets[pick(cavity.tets.size())]).neighbour[pick(4)];
      if (!isBoundary(beyond))
      {
        cavity.tets.push_back(tetOf(beyond));
      }
    }
    starIf(cavity, mesh_.tet(cavity.tets.back()).vertex[pick(4)]);
  }

  MeshData before_;
  TetMesh mesh_;
  Star star_;
  Traversal traversal_;
  std::mt19937 random_;
  std::size_t done_ = 0;
  std::size_t refused_ = 0;
};

TEST(Star, KeepsTheMeshValidWhateverIsAsked)
{
  for (unsigned seed = 1; seed <= 5; ++seed)
  {
    RandomStars stars(seed);
    stars.run(1500);
    EXPECT_GT(stars.done(), 300u) << "seed " << seed;
    EXPECT_GT(stars.refused(), 100u) << "seed " << seed;
  }
}

TEST(Star, InATrialCanBeUndoneExactly)
{
  for (unsigned seed = 1; seed <= 3; ++seed)
  {
    RandomStars stars(seed);
    stars.run(300); // so that slots are free
    stars.runAndUndo(300);
    stars.runInTrial(300);
    stars.runAndUndo(30);
    stars.run(30);
  }
}

// The verdicts on a cavity from every apex, with every choice of its boundary faces to be starred.
void collectVerdicts(
  const TetMesh& mesh, Star& star, const std::vector<Index>& tets, std::set<StarVerdict>& verdicts)
{
  std::vector<Index> boundary;
  for (const Index t : tets)
  {
    for (const HalfFace h : mesh.tet(t).neighbour)
    {
      if (isBoundary(h))
      {
        boundary.push_back(boundaryFaceOf(h));
      }
    }
  }
  for (Index apex = 0; apex < static_cast<Index>(mesh.vertexCount()); ++apex)
  {
    for (unsigned choice = 0; choice < 1u << boundary.size(); ++choice)
    {
      Cavity cavity{ tets, {} };
      for (std::size_t i = 0; i < boundary.size(); ++i)
      {
        if (choice >> i & 1)
        {
          cavity.starredFaces.push_back(boundary[i]);
        }
      }
      verdicts.insert(star.check(cavity, apex));
    }
  }
}

TEST(Star, RefusesWithAReasonAndWithoutAChange)
{
  TetMesh mesh = invariants::build(grid_mesh::make({ 2, 2, 2 }));
  const MeshData before = toMeshData(mesh);
  Star star(mesh);
  std::set<StarVerdict> verdicts = { star.check({}, 0) };
  for (Index t = 0; t < static_cast<Index>(mesh.tetSlots()); ++t)
  {
    collectVerdicts(mesh, star, { t }, verdicts);
    for (const HalfFace h : mesh.tet(t).neighbour)
    {
      if (!isBoundary(h))
      {
        collectVerdicts(mesh, star, { t, tetOf(h) }, verdicts);
      }
    }
  }
  // Two tetrahedra that meet in one edge or vertex only.
  for (Index t = 1; t < static_cast<Index>(mesh.tetSlots()); ++t)
  {
    for (const Index apex : mesh.tet(0).vertex)
    {
      verdicts.insert(star.check({ { 0, t }, {} }, apex));
    }
  }
  EXPECT_TRUE(verdicts.count(StarVerdict::Empty));
  EXPECT_TRUE(verdicts.count(StarVerdict::NotPositive));
  EXPECT_TRUE(verdicts.count(StarVerdict::GluedToNothing));
  EXPECT_EQ(toMeshData(mesh).tetrahedra, before.tetrahedra);
  for (int i = 0; i < static_cast<int>(StarVerdict::Count); ++i)
  {
    EXPECT_STRNE(nameOf(static_cast<StarVerdict>(i)), "unknown");
  }
}

TEST(Star, ReportsVerticesThatWouldBeLost)
{
  TetMesh mesh = invariants::build(grid_mesh::make({ 2, 2, 2 }));
  const Index centre = 13;
  ASSERT_EQ(mesh.point(centre), (Vector3{ 0.5, 0.5, 0.5 }));
  Cavity cavity;
  Traversal(mesh).ball(centre, cavity.tets);
  Star star(mesh);
  ASSERT_EQ(star.check(cavity, centre), StarVerdict::Possible);
  EXPECT_TRUE(star.lostVertices().empty());
  const Index outside = mesh.addVertex({ 0.52, 0.5, 0.5 });
  ASSERT_EQ(star.check(cavity, outside), StarVerdict::Possible);
  EXPECT_EQ(star.lostVertices(), std::vector<Index>{ centre });
  star.apply();
  EXPECT_EQ(mesh.tetAt(centre), None);
  invariants::expectKept(grid_mesh::make({ 2, 2, 2 }), toMeshData(mesh));
}
} // namespace
