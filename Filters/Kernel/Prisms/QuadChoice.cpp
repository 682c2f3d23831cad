#include "Prisms/QuadChoice.h"

namespace ransmesh
{
namespace
{
class QuadChooser
{
public:
  QuadChooser(const MeshData& mesh, PrismGroups& groups)
    : groups_(groups)
    , shapes_(mesh, groups)
  {
  }

  void run()
  {
    for (std::size_t g = 0; g < groups_.groups.size(); ++g)
    {
      partBetweenPairs(static_cast<Index>(g));
    }
    for (std::size_t g = 0; g < groups_.groups.size(); ++g)
    {
      waiting_.push_back(static_cast<Index>(g));
      while (!waiting_.empty())
      {
        const Index next = waiting_.back();
        waiting_.pop_back();
        settle(next);
      }
    }
  }

private:
  int countKept(Index g) const
  {
    const PrismGroup& group = groups_.groups[g];
    int kept = 0;
    for (int i = 0; i < group.quads; ++i)
    {
      kept += groups_.quads[group.quad[i]].isKept;
    }
    return kept;
  }

  // Two tetrahedra make a pyramid upon one quadrilateral at most. At the foot of a fan they have two: those between
  // one such pair and the next are given up, so that the fan's last ones have theirs for the wedges beside it.
  void partBetweenPairs(Index g)
  {
    const PrismGroup& group = groups_.groups[g];
    for (int i = 0; i < group.quads && group.size == 2 && countKept(g) > 1; ++i)
    {
      LateralQuad& quad = groups_.quads[group.quad[i]];
      const Index other = quad.group[1 - quad.sideOf(g)];
      if (other != None && groups_.groups[other].size == 2 && countKept(other) > 1)
      {
        quad.isKept = false;
      }
    }
  }

  void settle(Index g)
  {
    if (shapes_.make(g))
    {
      return;
    }
    const PrismGroup group = groups_.groups[g];
    bool hasPyramid = false;
    for (int i = 0; i < group.quads; ++i)
    {
      LateralQuad& quad = groups_.quads[group.quad[i]];
      if (quad.isKept && !hasPyramid && shapes_.isPyramid(g, group.quad[i]))
      {
        hasPyramid = true;
        continue;
      }
      giveUp(quad, g);
    }
  }

  void giveUp(LateralQuad& quad, Index g)
  {
    const Index other = quad.group[1 - quad.sideOf(g)];
    if (quad.isKept && other != None)
    {
      waiting_.push_back(other);
    }
    quad.isKept = false;
  }

  PrismGroups& groups_;
  PrismShapes shapes_;
  std::vector<Index> waiting_;
};
} // namespace

void chooseQuads(const MeshData& mesh, PrismGroups& groups)
{
  QuadChooser(mesh, groups).run();
}
} // namespace ransmesh
