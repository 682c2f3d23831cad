// A diagnosis in words and rows.
#pragma once

#include "Support/Patch.h"
#include "Surface/Diagnosis.h"

#include <string>
#include <vector>

namespace ransmesh
{
// One kind of fault, or, of crossings and near sheets, one pair of patches.
struct FaultRow
{
  std::string kind;
  std::size_t count = 0;     // as Fault::count
  std::size_t triangles = 0; // concerned
  std::string patches;       // their names
  Vector3 where;             // the first
};

std::vector<FaultRow> faultRows(
  const Diagnosis& diagnosis, const SurfaceMesh& surface, const PatchTable& patches);

// What is wrong, most grave first, as one sentence without its end: "the surface is not closed: 3 open edges ...".
// Empty where nothing is wrong.
std::string describe(const Diagnosis& diagnosis, const SurfaceMesh& surface, const PatchTable& patches);
} // namespace ransmesh
