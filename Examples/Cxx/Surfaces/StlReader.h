// STL, text or binary: each solid is a patch of that name.
#pragma once

#include "PatchedSurface.h"

#include <string>

namespace surfaces
{
// VTK's own STL reader gives no names of solids. Throws std::runtime_error for what is no STL file.
void readStl(const std::string& content, PatchedSurface& surface);
} // namespace surfaces
