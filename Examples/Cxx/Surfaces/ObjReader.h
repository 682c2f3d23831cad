// Wavefront OBJ: each group (or object) is a patch of that name.
#pragma once

#include "PatchedSurface.h"

#include <string>

namespace surfaces
{
// VTK's own OBJ reader keeps points in single precision and no group names. Throws
// std::runtime_error, with the line, for what is no OBJ file.
void readObj(const std::string& content, PatchedSurface& surface);
} // namespace surfaces
