// How high the columns of a wall's face may grow where another wall is in front of its middle.
#pragma once

#include "Boundary/BoundaryStars.h"
#include "Layers/Column.h"

#include <vector>

namespace ransmesh
{
// Another wall in front of a face.
struct FaceMeeting
{
  Index face = None; // of the boundary
  Vector3 place;     // on it
  double room = 0;   // between the two there
};

// Faces may be wide, and pass over narrow places that none of their own corners see: there, too, the front that their
// columns' tops span stays within gapFraction of the room.
void limitFacesMet(
  const TetMesh& mesh, const std::vector<FaceMeeting>& meetings, double gapFraction, ColumnSet& set);

// In wedges of less than 30 degrees between two faces their fronts turn from the wedge's edge, each by no more than
// gapFraction of its angle.
void limitInWedges(const TetMesh& mesh, const BoundaryStars& stars, double gapFraction, ColumnSet& set);
} // namespace ransmesh
