// The patches of a mesh, ticked as walls or not.
#ifndef WallSelection_h
#define WallSelection_h

#include "Layers/LayerPlanning.h"

#include "vtkNew.h"
#include "vtkType.h"

#include <map>
#include <string>
#include <utility>
#include <vector>

class vtkDataArraySelection;
class vtkUnstructuredGrid;

namespace ransmesh
{
// Which patches a plan gives layers, by number.
std::vector<char> wallsOf(const LayerPlan& plan);

// What the rules say is offered; what differs from the offer was chosen by the user.
class WallSelection
{
public:
  WallSelection();
  ~WallSelection();

  vtkDataArraySelection* selection() const { return selection_; }

  // Puts the patches into the selection, those ticked that are walls by number. What the user chose stays.
  void offer(const PatchTable& patches, const std::vector<char>& isWall);

  // The same for the grid's patches, where the walls are what the rules, or the plan that the grid brings,
  // make of them. Nothing happens for a grid without patches.
  void offer(vtkUnstructuredGrid* grid, const LayerRequest& rules, bool useRecorded);

  // What the user chose, by the patches' names.
  std::vector<std::pair<std::string, bool>> choices() const;

  // The choices, on a plan that was recorded: layers go where a patch is no wall, and a patch that became
  // one gets the layers of the first wall.
  void applyTo(const PatchTable& patches, LayerPlan& plan) const;

private:
  bool isOutdated(vtkUnstructuredGrid* grid, const LayerRequest& rules, bool useRecorded);

  vtkNew<vtkDataArraySelection> selection_;
  std::map<std::string, bool> offered_;
  // For what the offer was made: finding it again would read the whole grid each time.
  vtkUnstructuredGrid* grid_ = nullptr;
  vtkMTimeType gridTime_ = 0;
  std::vector<std::string> rules_;
};
} // namespace ransmesh

#endif
