// Numbers of patches: those that arrays tell, and those that a mesh gets.
#ifndef PatchNumbering_h
#define PatchNumbering_h

#include "Support/Outcome.h"
#include "Support/Patch.h"

#include "RANSMeshingCoreModule.h"

#include "vtkType.h"

#include <map>
#include <optional>
#include <string>
#include <vector>

class vtkDataArray;
class vtkDataSet;

namespace ransmesh
{
// The number of each cell, if the cell array is there and holds whole numbers.
RANSMESHINGCORE_EXPORT std::optional<std::vector<int>> numbersIn(vtkDataSet* data, const char* name);

// The same by an array that another tool has left, if it tells several numbers apart.
RANSMESHINGCORE_EXPORT std::optional<std::vector<int>> foreignNumbersIn(vtkDataSet* data);

// The PatchId that the cell of a mesh's boundary has, a whole number from 1 to PatchNumbering::LargestKept.
Outcome readPatchId(vtkDataArray* patchIds, vtkIdType cell, int& patch);

// Gives patches their numbers in the mesh.
class RANSMESHINGCORE_EXPORT PatchNumbering
{
public:
  // No patch has a larger number: the table has a row for each.
  static constexpr int LargestKept = 100000;

  explicit PatchNumbering(PatchTable& patches);

  // The patch of that name; wanted > 0 is its number if that is free, else it gets the next one.
  int patchNamed(const std::string& name, PatchType type, int wanted);

  // Names the numbers that no patch took.
  void nameGaps();

private:
  PatchTable& patches_;
  std::map<std::string, int> numberOf_;
};
} // namespace ransmesh

#endif
