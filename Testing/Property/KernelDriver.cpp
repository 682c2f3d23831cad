#include "KernelDriver.h"

#include "Choices.h"
#include "KeptDomain.h"
#include "RandomStar.h"

#include "Boundary/Classification.h"
#include "Improvement/LocalImprovement.h"
#include "Insertion/Enrichment.h"
#include "Layers/LayerPlanning.h"
#include "Mesh/Builder.h"
#include "Mesh/Collapse.h"
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
  std::string findChange(const MeshData& data) { return isFlat_ ? domain_.findChange(data) : std::string(); }
  Index someTet();
  void starSomewhere();
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
  KeptDomain domain_;
  bool isFlat_ = true; // every patch lies in planes
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
  domain_.remember(data, patches_);
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

void Driver::starSomewhere()
{
  RandomStar(mesh_, rules_.classification, isFlat_, choices_).tryAt(someTet());
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
