// How far from a surface its next part is.
#pragma once

#include "Remeshing/EditableSurface.h"
#include "Remeshing/SurfaceRemeshing.h"

#include <memory>

namespace ransmesh
{
class SurfaceGaps
{
public:
  SurfaceGaps(const SurfaceMesh& given, GapSide side);
  ~SurfaceGaps();
  SurfaceGaps(const SurfaceGaps&) = delete;
  SurfaceGaps& operator=(const SurfaceGaps&) = delete;

  // The distance from point v of a surface that lies on the given one, along its normal, to a part of the
  // given one that faces it (within 60 degrees); infinity where that is farther than reach, or there is none.
  double widthAt(const EditableSurface& surface, Index v, double reach) const;

private:
  class Tree;

  GapSide side_;
  std::unique_ptr<Tree> tree_;
};
} // namespace ransmesh
