// The triangles of a domain's surface made fit for meshing, and the mesh that follows from them.
#pragma once

#include "DomainMeshing.h"
#include "MesherReport.h"
#include "MesherSettings.h"

#include "Remeshing/FlatTriangles.h"

namespace ransmesh
{
struct DomainMesh
{
  MeshData mesh;
  std::string switches;         // of the TetGen run that made it
  FlatTriangleReport triangles; // what was changed of the surface
};

// Betters very obtuse triangles where that is wanted, halves what is longer than the sizes, and meshes. Where
// TetGen does not mesh the bettered surface, or makes tetrahedra of it that are too flat to be told from inverted
// ones, it gets the surface with swaps alone, then the triangles as they were given.
Outcome refineAndMesh(const MesherSettings& settings, const Domain& domain, const TetGenWorker& worker,
  const Context& context, DomainMesh& result, MesherReport& report);
} // namespace ransmesh
