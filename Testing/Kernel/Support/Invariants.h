// What no operation on a mesh of plane-sided domains may change.
#pragma once

#include "Mesh/TetMesh.h"

#include <map>

namespace invariants
{
std::map<int, double> patchAreas(const ransmesh::MeshData& mesh);

// Expects after to be valid, with the volume and the patch areas of before.
void expectKept(const ransmesh::MeshData& before, const ransmesh::MeshData& after, double tolerance = 1e-12);

// Expects the mesh to be valid, its links included.
void expectValid(const ransmesh::TetMesh& mesh);

// Builds a mesh that must be valid.
ransmesh::TetMesh build(const ransmesh::MeshData& data);
} // namespace invariants
