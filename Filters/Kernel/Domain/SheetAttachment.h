// Joins sheets to the closed surfaces of a domain before it is meshed.
#pragma once

#include "Triangles/SurfaceCheck.h"

#include <optional>

namespace ransmesh
{
// What a sheet's point may be off the point of a surface that it stands for, times the largest extent of
// the surfaces.
inline constexpr double SheetTolerance = 1e-6;

// Adds the sheets (open surfaces) to a closed surface that prepareSurface (Surface/Preparation.h) has passed.
// Points of sheets within SheetTolerance of a point of the surface, or of another sheet, become that point;
// what reaches out of the box, if there is one, is cut off (SheetCutting.h). Collapsed, flat and repeated
// triangles of sheets are mended as those of surfaces are. BadInput, with findings about the surface as it is
// then, where a sheet
// - has coordinates that are not finite, or triangles without area;
// - lies outside the box;
// - cuts or touches a surface or a sheet elsewhere than in common points and edges.
SurfaceVerdict attachSheets(
  SurfaceMesh& surface, SurfaceMesh sheets, const PatchTable& patches, const std::optional<Extent>& box);

// The part of a surface whose patches are not sheets, by patch number, without the points of the rest.
SurfaceMesh withoutSheets(const SurfaceMesh& surface, const std::vector<char>& isSheet);
} // namespace ransmesh
