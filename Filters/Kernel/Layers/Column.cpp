#include "Layers/Column.h"

namespace ransmesh
{
Vector3 ColumnSet::pointOnBend(const Column& c, double height) const
{
  const LayerHeights& own = heightsOf(c);
  const std::vector<Vector3>& places = bends[c.bend];
  const int last = static_cast<int>(places.size()) - 1;
  int above = 1;
  while (above < last && own.height(above) < height)
  {
    ++above;
  }
  const double part = (height - own.height(above - 1)) / own.spacing(above);
  return places[above - 1] + part * (places[above] - places[above - 1]);
}
} // namespace ransmesh
