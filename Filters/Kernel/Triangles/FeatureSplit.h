// Patches by the shape of a surface, where nothing else tells them apart.
#pragma once

#include "Support/Patch.h"
#include "Triangles/SurfaceMesh.h"

namespace ransmesh
{
// Splits one patch into its parts that are separated by edges where the surface turns by more than
// `angle` degrees, or where more or fewer than two triangles meet. The first part keeps the number and
// gets the name "<name>_1"; the others are added to the table, named "<name>_2" and so on, of the
// same type. A patch of one part is left as it is.
void splitByAngle(SurfaceMesh& surface, PatchTable& patches, int patch, double angle);
} // namespace ransmesh
