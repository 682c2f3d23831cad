// The blocks of composite data that make up a mesh.
#ifndef NamedBlocks_h
#define NamedBlocks_h

#include "Support/Outcome.h"
#include "Support/Patch.h"

#include <vector>

class vtkCompositeDataSet;
class vtkDataSet;

namespace ransmesh
{
struct NamedBlock
{
  vtkDataSet* data = nullptr;
  Patch patch; // name and type; of a volume, the name alone
};

struct NamedBlocks
{
  std::vector<NamedBlock> volumes;
  std::vector<NamedBlock> surfaces;
};

// Sorts the blocks that are not empty by what cells they hold. BadInput where there is no volume or no surface, or
// a block holds cells of both kinds or of others.
Outcome findBlocks(vtkCompositeDataSet* input, NamedBlocks& blocks);
} // namespace ransmesh

#endif
