// One run of TetGen.
#pragma once

#include "Protocol.h"

namespace ransmesh::worker
{
// Ends the process when TetGen gives up: exit status ExitTetGen + its error number. TetGen's own way
// out of an error frees the mesh twice.
Result runTetGen(const Request& request);
} // namespace ransmesh::worker
