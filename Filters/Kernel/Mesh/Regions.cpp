#include "Mesh/Regions.h"

#include "Mesh/FaceMatching.h"

namespace ransmesh
{
std::vector<int> numberRegions(const MeshData& mesh)
{
  FaceMatching matching = matchFaces(mesh);
  for (const SheetFace& sheet : matching.sheets)
  {
    const Index other = matching.opposite[sheet.side];
    if (other >= 0)
    {
      matching.opposite[other] = FaceMatching::Unmatched;
    }
    matching.opposite[sheet.side] = FaceMatching::Unmatched;
  }
  std::vector<int> region(mesh.tetrahedra.size(), 0);
  int regions = 0;
  std::vector<Index> open;
  for (std::size_t seed = 0; seed < region.size(); ++seed)
  {
    if (region[seed] == 0)
    {
      region[seed] = ++regions;
      open.push_back(static_cast<Index>(seed));
    }
    while (!open.empty())
    {
      const Index tet = open.back();
      open.pop_back();
      for (int face = 0; face < 4; ++face)
      {
        const Index other = matching.opposite[4 * tet + face];
        if (other >= 0 && region[other / 4] == 0)
        {
          region[other / 4] = regions;
          open.push_back(other / 4);
        }
      }
    }
  }
  return region;
}
} // namespace ransmesh
