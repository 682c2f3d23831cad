#include "FarField.h"

namespace ransmesh
{
FarFieldBox makeFarField(const Extent& bodies, const std::array<double, 6>& margins, PatchTable& patches)
{
  FarFieldBox box;
  const double length = bodies.largestLength();
  for (int i = 0; i < 8; ++i)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      box.corners[i][axis] = (i >> axis & 1) ? bodies.high[axis] + margins[2 * axis + 1] * length
                                             : bodies.low[axis] - margins[2 * axis] * length;
    }
  }
  box.sides = { { { 0, 2, 6, 4 }, { 1, 3, 7, 5 }, { 0, 1, 5, 4 }, { 2, 3, 7, 6 }, { 0, 1, 3, 2 },
    { 4, 5, 7, 6 } } };
  constexpr const char* names[] = { "xmin", "xmax", "ymin", "ymax", "zmin", "zmax" };
  for (int side = 0; side < 6; ++side)
  {
    box.patches[side] = static_cast<int>(patches.size());
    patches.push_back({ std::string("farfield_") + names[side], PatchType::FarField });
  }
  return box;
}
} // namespace ransmesh
