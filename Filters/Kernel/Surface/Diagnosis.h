// What is wrong with a surface as it was given, kind by kind, with the triangles concerned.
#pragma once

#include "Support/Context.h"
#include "Surface/Pieces.h"
#include "Triangles/PlaneCutting.h"
#include "Triangles/SurfaceCheck.h"

#include <utility>
#include <vector>

namespace ransmesh
{
// All faults of one kind.
struct Fault
{
  SurfaceFault kind = SurfaceFault::Degenerate;
  // Of what the kind's name says: points, triangles, edges or pairs of triangles. Of duplicates: the triangles
  // beyond the first of each set.
  std::size_t count = 0;
  Vector3 where;                              // the first
  std::vector<SurfaceFinding> findings;       // each triangle once, in the order of the triangles
  std::vector<std::pair<Index, Index>> pairs; // of crossing or near triangles
};

struct DiagnosisOptions
{
  // Sheets that come nearer to each other than this times the largest extent, without touching, and nearer
  // than a tenth of the edges there, are reported. 0: not looked for.
  double nearTolerance = 1e-6;
  bool intersections = true; // the only test that takes time
  // In these planes edges may be open: the planes close the surface there.
  std::vector<AxisPlane> closedBy;
};

struct Diagnosis
{
  std::vector<Fault> faults; // of the kinds that occur, in the order of SurfaceFault
  std::vector<SurfacePiece> pieces;
  Extent extent;
  std::size_t points = 0; // that triangles use, equal ones counted once
  std::size_t triangles = 0;

  const Fault* find(SurfaceFault kind) const;
  std::size_t count(SurfaceFault kind) const;
  // Whether the surface is closed, without degenerate or crossing triangles: fit to bound a mesh.
  bool isSound() const;
};

// Points of equal coordinates count as one; nothing else is mended. Triangles that name a point twice count as
// degenerate and for nothing else. Where coordinates are not finite, nothing else is looked for.
Diagnosis diagnose(const SurfaceMesh& surface, const DiagnosisOptions& options, const Context& context);
} // namespace ransmesh
