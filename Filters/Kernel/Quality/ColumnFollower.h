// Columns of points above a wall, found along the edges of any mesh, whoever made it.
#pragma once

#include "Layers/LayerSpecification.h"
#include "Mesh/MeshData.h"
#include "Quality/WallPoints.h"

#include <vector>

namespace ransmesh
{
struct ColumnRules
{
  double cone = 20;       // degrees that an edge of a column may lean from the wall's normal
  double tolerance = 1.3; // factor by which a spacing may be off
  double outward = 45;    // degrees that the edge beyond a column's top may lean
};

// A column is followed from its wall point: of the edges within the cone whose length is within the
// tolerance of the spacing asked for, the one closest to the wall's normal, to its far end; and so on,
// as many times as layers are asked for.
struct FoundColumn
{
  std::vector<Index> points;    // from the wall point to the top
  std::vector<double> spacings; // one fewer: the lengths of the edges
  std::vector<double> leans;    // of each edge from the wall's normal, degrees
  double edgeBeyond = 0;        // length of the edge at the top that is closest to the normal and leads
                                // away from the wall; 0 where none is within ColumnRules::outward

  int layers() const { return static_cast<int>(spacings.size()); }
};

class ColumnFollower
{
public:
  ColumnFollower(const MeshData& mesh, const ColumnRules& rules);

  // The column's memory is used again: call with one object for many wall points.
  void follow(const ColumnFoot& from, const LayerHeights& asked, FoundColumn& column) const;

private:
  struct Step
  {
    Index to = None;
    double length = 0;
    double cosine = 0;
  };
  Step closestToNormal(
    Index from, const Vector3& normal, double leastCosine, double shortest, double longest) const;

  const MeshData& mesh_;
  ColumnRules rules_;
  std::vector<std::size_t> firstTet_; // of each point, in tetOfPoint_
  std::vector<Index> tetOfPoint_;
};
} // namespace ransmesh
