// Takes edges away from a vertex, so that what is left of its ball can be starred without it.
#pragma once

#include "Boundary/BoundaryRules.h"
#include "Improvement/LocalImprovement.h"
#include "Improvement/OuterFaces.h"
#include "Mesh/Star.h"
#include "Mesh/Traversal.h"
#include "Removal/RemovalLimits.h"
#include "Removal/SurfaceStar.h"

#include <vector>

namespace ransmesh
{
class ValenceReduction
{
public:
  ValenceReduction(TetMesh& mesh, const BoundaryRules& rules, double cosine, SurfaceMemory& surfaces)
    : mesh_(mesh)
    , rules_(rules)
    , star_(mesh)
    , traversal_(mesh)
    , cavity_(mesh)
    , surface_(mesh, rules, cosine, surfaces)
  {
  }

  // Turns to vertex v: looks at all its edges. Edges on the surface may go only where it may change.
  void begin(Index v, const RemovalLimits& limits);
  // Turns to vertex v of a wall, whose surface may change here although it is a wall.
  void beginOnWall(Index v, const RemovalLimits& limits, const Vector3& normal);
  // Takes out the edge at v that leaves the best quality, within the limits of quality. The valence of v
  // falls by one. False if no edge may go. Only the star of v may have changed since begin, and only by
  // this.
  bool cutEdge();

  // Takes out the edge between two points of a wall, so that the other two points of its triangles meet.
  bool swapOnWall(Index v, Index end, const RemovalLimits& limits, const Vector3& normal);

  // The tetrahedra made by the last successful cut.
  const std::vector<Index>& made() const { return *made_; }

private:
  struct Cut
  {
    Index end;
    Index apex; // None: this edge may not go
    double quality;
  };

  void lookAtAllEdges();
  RemovalVerdict judgeSurface(const Cut& cut);
  Cut bestCut(Index tet, Index end);
  bool beginAt(Index tet, Index end);
  bool maySee(Index apex) const;
  double floorFor() const;
  bool apply(const Cut& cut);
  Index tetWith(Index end) const;
  void lookAgain();

  TetMesh& mesh_;
  const BoundaryRules& rules_;
  Star star_;
  Traversal traversal_;
  OuterFaces cavity_;
  SurfaceStar surface_;
  LocalMarks seen_;
  std::vector<Index> ball_;
  std::vector<Index> ring_;
  std::vector<Index> apexes_;
  std::vector<Cut> cuts_; // one for each edge at vertex_
  Index vertex_ = None;
  RemovalLimits limits_;
  bool onWall_ = false;
  Vector3 wallNormal_;
  const std::vector<Index>* made_ = nullptr;
};
} // namespace ransmesh
