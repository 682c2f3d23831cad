#include "WallSelection.h"

#include "MeshConversion.h"
#include "PatchFieldData.h"

#include "vtkDataArraySelection.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>

namespace ransmesh
{
namespace
{
// The walls without any choice of the user's; empty if the grid cannot be read.
std::vector<char> wallsOf(vtkUnstructuredGrid* grid, const LayerRequest& rules, bool useRecorded)
{
  std::vector<char> isWall;
  if (const LayerPlan plan = readPlan(grid->GetFieldData()); useRecorded && !plan.empty())
  {
    return wallsOf(plan);
  }
  MeshData mesh;
  PatchTable patches;
  if (readMesh(grid, mesh, patches).ok())
  {
    findWalls(mesh, patches, rules, isWall); // that there is no wall is no error yet
  }
  return isWall;
}
} // namespace

std::vector<char> wallsOf(const LayerPlan& plan)
{
  std::vector<char> isWall;
  for (const LayerSpecification& specification : plan)
  {
    isWall.push_back(specification.hasLayers());
  }
  return isWall;
}

WallSelection::WallSelection() = default;

WallSelection::~WallSelection() = default;

bool WallSelection::isOutdated(vtkUnstructuredGrid* grid, const LayerRequest& rules, bool useRecorded)
{
  std::vector<std::string> now = rules.wallPatterns;
  for (const PatchLayers& layers : rules.patchLayers)
  {
    now.push_back("layers " + layers.pattern);
  }
  now.emplace_back(useRecorded ? "recorded" : "own");
  const bool isWhole = selection_->GetNumberOfArrays() >= static_cast<int>(offered_.size());
  if (isWhole && grid == grid_ && grid->GetMTime() == gridTime_ && now == rules_)
  {
    return false;
  }
  grid_ = grid;
  gridTime_ = grid->GetMTime();
  rules_ = std::move(now);
  return true;
}

void WallSelection::offer(vtkUnstructuredGrid* grid, const LayerRequest& rules, bool useRecorded)
{
  const PatchTable patches = readPatches(grid->GetFieldData());
  if (!patches.empty() && this->isOutdated(grid, rules, useRecorded))
  {
    this->offer(patches, wallsOf(grid, rules, useRecorded));
  }
}

void WallSelection::offer(const PatchTable& patches, const std::vector<char>& isWall)
{
  const auto chosen = this->choices();
  // None of this is the user's doing: it must not make the filter run again.
  while (selection_->GetNumberOfArrays() > 0)
  {
    selection_->RemoveArrayByIndex(0);
  }
  offered_.clear();
  for (std::size_t i = 1; i < patches.size(); ++i)
  {
    const std::string& name = patches[i].name;
    const bool wall = i < isWall.size() && isWall[i] != 0;
    const auto choice =
      std::find_if(chosen.begin(), chosen.end(), [&name](const auto& c) { return c.first == name; });
    offered_[name] = wall;
    selection_->AddArray(name.c_str(), choice == chosen.end() ? wall : choice->second);
  }
}

std::vector<std::pair<std::string, bool>> WallSelection::choices() const
{
  std::vector<std::pair<std::string, bool>> chosen;
  for (int i = 0; i < selection_->GetNumberOfArrays(); ++i)
  {
    const std::string name = selection_->GetArrayName(i);
    const bool state = selection_->GetArraySetting(i) != 0;
    const auto offer = offered_.find(name);
    if (offer == offered_.end() || offer->second != state)
    {
      chosen.emplace_back(name, state);
    }
  }
  return chosen;
}

void WallSelection::applyTo(const PatchTable& patches, LayerPlan& plan) const
{
  const auto first =
    std::find_if(plan.begin(), plan.end(), [](const LayerSpecification& s) { return s.hasLayers(); });
  const LayerSpecification ofFirst = first == plan.end() ? LayerSpecification{} : *first;
  for (const auto& [name, isWall] : this->choices())
  {
    for (std::size_t i = 1; i < patches.size(); ++i)
    {
      if (patches[i].name == name && plan[i].hasLayers() != isWall)
      {
        plan[i] = isWall ? ofFirst : LayerSpecification{};
      }
    }
  }
}
} // namespace ransmesh
