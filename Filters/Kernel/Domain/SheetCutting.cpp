#include "Domain/SheetCutting.h"

#include "Triangles/PlaneCutting.h"

namespace ransmesh
{
std::size_t cutByBox(SurfaceMesh& sheets, const Extent& box, double tolerance)
{
  std::size_t out = 0;
  for (int axis = 0; axis < 3; ++axis)
  {
    out += cutByPlane(sheets, { axis, box.low[axis], true }, tolerance);
    out += cutByPlane(sheets, { axis, box.high[axis], false }, tolerance);
  }
  return out;
}
} // namespace ransmesh
