// Ends the worker when TetGen does not get on with the surface.
//
// Where facets lie in a plane but for rounding, its walk to a point can go round for ever (seen in 1.5.0, in
// finddirection, on sound surfaces of 300 triangles). The walk asks nobody: a timer looks after it.
#pragma once

#include <cstddef>

namespace ransmesh::worker
{
// From now on so much processor time may pass as recovering a surface of so many points never takes: 2 s, and 2 ms
// more a point, a hundred times the usual. Then the process ends with ExitStalled.
void watchRecovery(std::size_t points);

// The surface is recovered: there is no limit any more.
void endRecovery();
} // namespace ransmesh::worker
