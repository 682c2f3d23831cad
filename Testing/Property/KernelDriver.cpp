#include "KernelDriver.h"

#include "Boundary/Classification.h"
#include "Geometry/TetrahedronMeasures.h"
#include "Improvement/LocalImprovement.h"
#include "Insertion/Enrichment.h"
#include "Layers/LayerPlanning.h"
#include "Mesh/Builder.h"
#include "Mesh/Collapse.h"
#include "Mesh/Star.h"
#include "Mesh/Traversal.h"
#include "Mesh/Validation.h"
#include "Removal/PointRemoval.h"
#include "Support/GridMesh.h"

#include <algorithm>
#include <cmath>

namespace kernel_driver
{
namespace
{
using namespace ransmesh;

// The choices that the bytes make; zeros when they are used up.
class Choices
{
public:
  explicit Choices(std::span<const std::uint8_t> bytes)
    : bytes_(bytes)
  {
  }
  bool isOver() const { return at_ >= bytes_.size(); }
  unsigned next() { return isOver() ? 0U : bytes_[at_++]; }
  std::size_t upTo(std::size_t count) { return count == 0 ? 0 : (256 * next() + next()) % count; }
  double between(double low, double high) { return low + (high - low) * next() / 255.0; }

private:
  std::span<const std::uint8_t> bytes_;
  std::size_t at_ = 0;
};

std::vector<double> areasOf(const MeshData& data, std::size_t patches)
{
  std::vector<double> areas(patches);
  for (std::size_t t = 0; t < data.triangles.size(); ++t)
  {
    const auto& v = data.triangles[t];
    const Vector3& a = data.points[v[0]];
    areas[static_cast<std::size_t>(data.trianglePatch[t])] +=
      norm(cross(data.points[v[1]] - a, data.points[v[2]] - a)) / 2;
  }
  return areas;
}

// Whether a tetrahedron has no volume but that of rounding.
bool anyIsFlat(const MeshData& data)
{
  const auto& p = data.points;
  return std::any_of(data.tetrahedra.begin(), data.tetrahedra.end(),
    [&](const auto& v) { return quality(p[v[0]], p[v[1]], p[v[2]], p[v[3]]) < 1e-12; });
}

class Driver
{
public:
  Driver(Choices& choices, std::size_t shares)
    : choices_(choices)
    , shares_(shares)
  {
  }

  std::string run()
  {
    if (!begin())
    {
      return {}; // such a grid is no domain
    }
    for (int step = 0; !choices_.isOver() && step < mostSteps; ++step)
    {
      const char* name = perform();
      if (const std::string fault = findFault(); !fault.empty())
      {
        return std::string(name) + " (operation " + std::to_string(step) + "): " + fault;
      }
    }
    return {};
  }

private:
  static constexpr int mostSteps = 60;
  static constexpr std::size_t mostTets = 30000;

  bool begin();
  const char* perform();
  std::string findFault();
  bool adopt(const MeshData& data);
  void rebuildRules();
  std::string findChange(const MeshData& data);
  Index someTet();
  void starSomewhere();
  bool chooseApex(Cavity& cavity, Index& apex);
  void growCavity(Cavity& cavity, std::size_t count);
  void starFacesInPlane(Cavity& cavity, Index apex, int patch) const;
  bool losesOnlyInnerPoints(const Star& star) const;
  void collapseSomewhere();
  bool collapseIsPositive(const std::vector<Index>& ball, Index v, Index end) const;
  void improveSomewhere();
  void removeSome();
  void enrichIt();
  LayerPlan somePlan();

  Choices& choices_;
  std::size_t shares_; // of operators, by which they are chosen
  TetMesh mesh_;
  PatchTable patches_;
  BoundaryRules rules_;
  double volume_ = 0;
  std::vector<double> areas_; // by patch
  bool hadFlat_ = false;      // some tetrahedron since then has been flat but for rounding
  bool isFlat_ = true;        // every patch lies in planes
  std::string problem_;
};

bool Driver::begin()
{
  grid_mesh::Grid grid;
  grid.nx = 2 + static_cast<int>(choices_.upTo(3));
  grid.ny = 2 + static_cast<int>(choices_.upTo(3));
  grid.nz = 2 + static_cast<int>(choices_.upTo(3));
  grid.jitter = choices_.upTo(2) == 0 ? 0 : choices_.between(0, 0.3);
  grid.seed = choices_.next();
  if (choices_.upTo(2) == 0)
  {
    grid.map = grid_mesh::turned;
  }
  MeshData data = grid_mesh::make(grid);
  if (!grid.map && choices_.upTo(2) == 0)
  {
    const Vector3 end = { choices_.between(0.2, 0.8), choices_.between(0.2, 0.8), choices_.between(0.2, 1) };
    grid_mesh::carve(data, [&](const Vector3& p) { return p.x < end.x && p.y < end.y && p.z < end.z; });
    isFlat_ = false; // the cut follows the tetrahedra
  }
  patches_ = grid_mesh::patches(PatchType::Symmetry, 7);
  for (std::size_t i = 1; i < patches_.size(); ++i)
  {
    patches_[i].type = choices_.upTo(3) == 0 ? PatchType::Wall : PatchType::Symmetry;
  }
  return findFaults(data).none() && adopt(data);
}

bool Driver::adopt(const MeshData& data)
{
  TetMesh mesh;
  if (!buildTetMesh(data, mesh).ok())
  {
    return false;
  }
  mesh_ = std::move(mesh);
  volume_ = totalVolume(data);
  areas_ = areasOf(data, patches_.size());
  hadFlat_ = anyIsFlat(data);
  rebuildRules();
  return true;
}

void Driver::rebuildRules()
{
  rules_.classification = classify(mesh_, patches_);
  rules_.changeable.assign(patches_.size(), 1);
}

const char* Driver::perform()
{
  problem_.clear();
  switch (choices_.upTo(shares_))
  {
    case 0:
      removeSome();
      return "removal";
    case 1:
      enrichIt();
      return "enrichment";
    case 2:
    case 3:
    case 4:
    case 5:
    case 6:
    case 7:
      improveSomewhere();
      return "improvement";
    case 16:
    case 17:
      collapseSomewhere();
      return "collapse";
    default:
      starSomewhere();
      return "star";
  }
}

std::string Driver::findFault()
{
  if (!problem_.empty())
  {
    return problem_;
  }
  if (const MeshFaults faults = findFaults(mesh_); !faults.none())
  {
    return faults.text();
  }
  return findChange(toMeshData(mesh_));
}

// Where all patches lie in planes, the domain and its patches stay what they are. Beside tetrahedra that are flat but
// for rounding, which stars may make in a plane, a triangle of it may be turned over.
std::string Driver::findChange(const MeshData& data)
{
  const auto differs = [](double now, double before) { return std::fabs(now - before) > 1e-9 * before; };
  if (!isFlat_)
  {
    return {};
  }
  if (const double volume = totalVolume(data); differs(volume, volume_))
  {
    return "the volume has changed from " + std::to_string(volume_) + " to " + std::to_string(volume);
  }
  const std::vector<double> areas = areasOf(data, patches_.size());
  hadFlat_ = hadFlat_ || anyIsFlat(data);
  for (std::size_t i = 1; i < areas.size() && !hadFlat_; ++i)
  {
    if (differs(areas[i], areas_[i]))
    {
      return "the area of " + patches_[i].name + " has changed by " +
        std::to_string(1e6 * (areas[i] / areas_[i] - 1)) + " millionths";
    }
  }
  return {};
}

Index Driver::someTet()
{
  const std::size_t slots = mesh_.tetSlots();
  auto t = static_cast<Index>(choices_.upTo(slots));
  while (!mesh_.tet(t).isAlive())
  {
    t = static_cast<Index>((static_cast<std::size_t>(t) + 1) % slots);
  }
  return t;
}

void Driver::growCavity(Cavity& cavity, std::size_t count)
{
  for (std::size_t i = 0; i < count; ++i)
  {
    const Index from = cavity.tets[choices_.upTo(cavity.tets.size())];
    const HalfFace beyond = mesh_.tet(from).neighbour[choices_.upTo(4)];
    if (!isBoundary(beyond))
    {
      cavity.tets.push_back(tetOf(beyond)); // doubles, too
    }
  }
}

// A corner of the cavity, a new point in it, or one on its boundary.
bool Driver::chooseApex(Cavity& cavity, Index& apex)
{
  const Tetrahedron tet = mesh_.tet(cavity.tets[choices_.upTo(cavity.tets.size())]);
  const std::size_t kind = choices_.upTo(3);
  if (kind == 0)
  {
    apex = tet.vertex[choices_.upTo(4)];
    for (const int patch : rules_.classification.patchesAt(apex))
    {
      if (choices_.upTo(2) == 0)
      {
        starFacesInPlane(cavity, apex, patch);
      }
    }
    return true;
  }
  const std::size_t f = choices_.upTo(4);
  const bool onFace = kind == 1 && isBoundary(tet.neighbour[f]);
  Vector3 place;
  double sum = 0;
  for (std::size_t i = 0; i < 4; ++i)
  {
    const double weight = onFace && i == f ? 0 : choices_.between(0.05, 1);
    place += weight * mesh_.point(tet.vertex[i]);
    sum += weight;
  }
  apex = mesh_.addVertex((1 / sum) * place);
  if (onFace)
  {
    starFacesInPlane(cavity, apex, mesh_.patchOf(tet.neighbour[f]));
  }
  return false;
}

void Driver::starFacesInPlane(Cavity& cavity, Index apex, int patch) const
{
  for (const Index t : cavity.tets)
  {
    for (const HalfFace beyond : mesh_.tet(t).neighbour)
    {
      if (!isBoundary(beyond) || mesh_.patchOf(beyond) != patch)
      {
        continue;
      }
      const auto v = mesh_.boundaryVertices(boundaryFaceOf(beyond));
      const Vector3& a = mesh_.point(v[0]);
      const Vector3 n = normalized(cross(mesh_.point(v[1]) - a, mesh_.point(v[2]) - a));
      if (std::fabs(dot(n, mesh_.point(apex) - a)) < 1e-12)
      {
        cavity.starredFaces.push_back(boundaryFaceOf(beyond));
      }
    }
  }
}

// Points of ridges and corners hold the domain's shape.
bool Driver::losesOnlyInnerPoints(const Star& star) const
{
  return std::all_of(star.lostVertices().begin(), star.lostVertices().end(),
    [this](Index v)
    {
      const VertexKind kind = rules_.classification.kind[v];
      return kind == VertexKind::Volume || (kind == VertexKind::Surface && isFlat_);
    });
}

void Driver::starSomewhere()
{
  Cavity cavity;
  cavity.tets.push_back(someTet());
  growCavity(cavity, choices_.upTo(24));
  Index apex = None;
  const bool isOld = chooseApex(cavity, apex);
  Star star(mesh_);
  const bool isDone = star.check(cavity, apex) == StarVerdict::Possible && losesOnlyInnerPoints(star);
  if (isDone)
  {
    star.apply();
  }
  else if (!isOld)
  {
    mesh_.removeLastVertices(1);
  }
  rebuildRules();
}

// A vertex of the volume goes to a neighbour, wherever that is.
void Driver::collapseSomewhere()
{
  const Tetrahedron tet = mesh_.tet(someTet());
  const std::size_t first = choices_.upTo(4);
  const Index v = tet.vertex[first];
  const Index end = tet.vertex[(first + 1 + choices_.upTo(3)) % 4];
  Traversal traversal(mesh_);
  std::vector<Index> ball;
  traversal.ball(v, ball);
  if (rules_.classification.kind[v] == VertexKind::Volume && canCollapse(mesh_, ball, v, end) &&
    collapseIsPositive(ball, v, end))
  {
    collapse(mesh_, ball, v, end);
    rebuildRules();
  }
}

bool Driver::collapseIsPositive(const std::vector<Index>& ball, Index v, Index end) const
{
  return std::all_of(ball.begin(), ball.end(),
    [&](Index t)
    {
      std::array<Index, 4> corner = mesh_.tet(t).vertex;
      if (std::find(corner.begin(), corner.end(), end) != corner.end())
      {
        return true; // goes
      }
      std::replace(corner.begin(), corner.end(), v, end);
      return isPositive(
        mesh_.point(corner[0]), mesh_.point(corner[1]), mesh_.point(corner[2]), mesh_.point(corner[3]));
    });
}

void Driver::improveSomewhere()
{
  LocalImprovement improvement(mesh_, rules_);
  const Index tet = someTet();
  const Index v = mesh_.tet(tet).vertex[choices_.upTo(4)];
  if (choices_.upTo(2) == 0)
  {
    improvement.swap(tet);
  }
  else if (rules_.classification.kind[v] == VertexKind::Volume)
  {
    improvement.move(v, choices_.between(0, 1));
  }
  rebuildRules();
}

LayerPlan Driver::somePlan()
{
  LayerPlan plan(patches_.size());
  for (std::size_t i = 1; i < patches_.size(); ++i)
  {
    if (patches_[i].type == PatchType::Wall)
    {
      plan[i].numberOfLayers = 1 + static_cast<int>(choices_.upTo(8));
      plan[i].growthRate = choices_.between(1, 1.5);
      plan[i].firstHeight = std::pow(10, choices_.between(-6, -1.5));
    }
  }
  return plan;
}

// Stopped at any moment, or not at all.
void Driver::removeSome()
{
  const LayerPlan plan = somePlan();
  const std::size_t questions = choices_.upTo(300);
  std::size_t asked = 0;
  Context context;
  context.cancelled = [&] { return ++asked > questions; };
  const RemovalResult result = removePoints(mesh_, patches_, plan, {}, context);
  if (!result.outcome.ok() && asked <= questions)
  {
    problem_ = result.outcome.message;
  }
  rebuildRules();
}

void Driver::enrichIt()
{
  EnrichedMesh result;
  const MeshData before = toMeshData(mesh_);
  if (const Outcome outcome = enrich(before, patches_, somePlan(), {}, {}, result); !outcome.ok())
  {
    problem_ = outcome.message;
    return;
  }
  if (const MeshFaults faults = findFaults(result.mesh); !faults.none())
  {
    problem_ = faults.text();
    return;
  }
  problem_ = findChange(result.mesh);
  if (problem_.empty() && result.mesh.tetrahedra.size() < mostTets && !adopt(result.mesh))
  {
    problem_ = "the enriched mesh cannot be built again";
  }
}
} // namespace

std::string drive(std::span<const std::uint8_t> bytes, Operators operators)
{
  Choices choices(bytes);
  return Driver(choices, operators == Operators::All ? 18 : 16).run();
}
} // namespace kernel_driver
