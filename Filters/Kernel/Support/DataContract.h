// The names of all arrays that pass between the filters, in one place.
// The meaning of each is the data contract of Filters/README.md.
#pragma once

namespace ransmesh::contract
{
// Cell data of the mesh.
inline constexpr const char* PatchId = "PatchId";   // int; 0 on tetrahedra, >= 1 on boundary triangles
inline constexpr const char* LayerId = "LayerId";   // int; 0 none, else 1 at the wall, counting outward
inline constexpr const char* PrismId = "PrismId";   // id; tetrahedra of one prism share a number, -1 none
inline constexpr const char* RegionId = "RegionId"; // int; 0 on triangles, else from 1
// Point data of the mesh.
inline constexpr const char* ColumnId = "ColumnId"; // id; points of one column share a number, -1 none
// Point data of a mesh's boundary blocks (vtkMeshToNamedBlocks), and field data of each.
inline constexpr const char* MeshPointId = "MeshPointId";  // id; the point of the mesh that this one is
inline constexpr const char* BlockPatchType = "PatchType"; // string; the patch's type
// Field data of the mesh, indexed by patch number; row 0 is the fluid.
inline constexpr const char* PatchNames = "PatchNames"; // string
inline constexpr const char* PatchTypes = "PatchTypes"; // string
// Field data, indexed by region number; row 0 is empty. May be missing.
inline constexpr const char* RegionNames = "RegionNames"; // string
// Field data: what the layers were asked to be, a row per patch (0 rows where a patch has no layers).
inline constexpr const char* LayersFirstHeight = "LayersFirstHeight";             // double, length units
inline constexpr const char* LayersGrowthRate = "LayersGrowthRate";               // double
inline constexpr const char* LayersNumber = "LayersNumber";                       // int, 0: no layers here
inline constexpr const char* LayersConstant = "LayersConstant";                   // int
inline constexpr const char* LayersIsotropicFraction = "LayersIsotropicFraction"; // double
inline constexpr const char* LayersNormalAngle = "LayersNormalAngle";             // double, degrees
inline constexpr const char* LayersFanAngle = "LayersFanAngle";                   // double, degrees
// Cell data that the quality report adds, all double; boundary triangles show the tetrahedron behind them,
// but have no volume.
inline constexpr const char* Volume = "Volume";                     // cube of the length unit, signed
inline constexpr const char* LargestDihedral = "LargestDihedral";   // degrees
inline constexpr const char* SmallestDihedral = "SmallestDihedral"; // degrees
inline constexpr const char* Stretching = "Stretching";             // longest edge over smallest height
inline constexpr const char* Quality = "Quality";                   // volume over rms edge cubed, 1 regular
// Field data of the mesher's output.
inline constexpr const char* MesherSwitches =
  "MesherSwitches";                                         // string: the switches that TetGen was run with
inline constexpr const char* SurfaceSwaps = "SurfaceSwaps"; // vtkIdType: diagonals swapped in the surface
inline constexpr const char* SurfaceSplits =
  "SurfaceSplits"; // vtkIdType: edges split there at a corner's foot
// Point data of the boundary output of the enrichment, at wall points.
inline constexpr const char* LayersAsked = "LayersAsked";                 // int
inline constexpr const char* LayersAchieved = "LayersAchieved";           // int
inline constexpr const char* FirstHeightAsked = "FirstHeightAsked";       // double
inline constexpr const char* FirstHeightAchieved = "FirstHeightAchieved"; // double
inline constexpr const char* StopReason = "StopReason";           // int, an index into StopReasonNames
inline constexpr const char* StopReasonNames = "StopReasonNames"; // field data, string
// Field data of a wrapped surface.
inline constexpr const char* WrapAlpha = "WrapAlpha";   // double, length unit: what is narrower is bridged
inline constexpr const char* WrapOffset = "WrapOffset"; // double, length unit: how far outside it lies
// Cell data of the check's output and the mesher's second output.
inline constexpr const char* Reason = "Reason";           // int, an index into ReasonNames
inline constexpr const char* ReasonNames = "ReasonNames"; // field data, string
inline constexpr const char* PartnerId = "PartnerId";     // id of the other triangle of a pair, or -1
} // namespace ransmesh::contract
