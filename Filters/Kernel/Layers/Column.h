// Columns: the lines of points that stand on the walls.
#pragma once

#include "Layers/Fan.h"
#include "Layers/LayerSpecification.h"
#include "Layers/SidePath.h"
#include "Layers/TensorCorner.h"
#include "Mesh/MeshData.h"

#include <array>
#include <string_view>
#include <vector>

namespace ransmesh
{
// Why a column has fewer layers than were asked for.
enum class StopReason
{
  Complete,      // all layers are there
  IsotropicSize, // the next spacing would exceed the isotropic fraction of the local size
  Gap,           // the opposite surface is near
  Corner,        // no direction sees all wall faces, or the sides meet too sharply
  CurvedSide,    // the patch that the layers run into is curved here
  Frozen,        // an interface patch
  Transition,    // a neighbour is much lower
  Refused,       // the mesh beyond would not give way
  Count
};

inline constexpr std::array<std::string_view, static_cast<std::size_t>(StopReason::Count)> StopReasonTexts = {
  "none", "isotropic size reached", "gap", "corner", "curved side", "frozen", "transition", "refused"
};

struct Column
{
  Index root = None;                // the wall's vertex
  Index vertex = None;              // its top in the mesh: the root, or in a fan a vertex of its own
  Vector3 base;                     // where it stands on the wall
  Vector3 direction;                // the step that rises by one above the wall faces
  int patch = 0;                    // whose heights it follows
  std::array<int, 2> sides{ 0, 0 }; // adjoining patches that it stays in; 0: none
  Index path = None;                // its path where it follows curved sides; None: it is straight, or
  Index bend = None;                // has places of its own, between walls of different heights
  Index squeezed = None;            // its own heights, where room is short; None: its patch's
  double size = 0;                  // mean length of the wall's edges here
  int firstRank = 0;                // when it rises in the first level
  int asked = 0;                    // layers asked for
  int levels = 0;                   // layers that it is to have, or has
  bool hasGrid = false;             // it stands in a tensor corner
  int lowest = 0;                   // it can not have fewer; 1 where another column of its root may have none
  double lifted = 0;                // height at which its top stands before the front rises
  StopReason reason = StopReason::Complete;

  bool staysIn(int p) const { return p != 0 && (sides[0] == p || sides[1] == p); }
  bool ownsTop() const { return vertex != root; }
  // Lowers the column to level, or as far as it can be, if it is higher.
  void limit(int level, StopReason why)
  {
    level = level < lowest ? lowest : level;
    if (level < levels)
    {
      levels = level;
      reason = why;
    }
  }
};

struct ColumnSet
{
  std::vector<Column> columns;        // one a root, in order of vertex number; then those of the fans
  std::vector<Index> ofVertex;        // the column with this top, or None
  std::vector<LayerHeights> heights;  // by patch
  std::vector<LayerHeights> squeezed; // of columns with heights of their own
  std::vector<SidePath> paths;        // of columns in curved sides
  std::vector<Fan> fans;              // in order of their main columns
  std::vector<TensorCorner> corners;  // in order of their columns
  std::vector<std::vector<Vector3>>
    bends; // by level, from the base up: the points of columns that are not straight

  const LayerHeights& heightsOf(const Column& c) const
  {
    return c.squeezed == None ? heights[c.patch] : squeezed[c.squeezed];
  }
  double thickness(const Column& c) const { return heightsOf(c).height(c.levels); }
  // The layers' height over a wall of this patch at the column's foot, as a share of its own height.
  double shareOver(int patch, const Column& c) const
  {
    const bool isOther = c.bend != None && heights[patch].count() >= c.asked;
    return isOther ? heights[patch].height(c.asked) / heightsOf(c).height(c.asked) : 1;
  }
  // The one place that computes where a level's point is.
  Vector3 pointAt(const Column& c, int level) const
  {
    return c.bend == None ? pointAtHeight(c, heightsOf(c).height(level)) : bends[c.bend][level];
  }
  Vector3 pointAtHeight(const Column& c, double height) const
  {
    return c.path != None ? paths[c.path].at(height)
      : c.bend != None    ? pointOnBend(c, height)
                          : c.base + height * c.direction;
  }
  // Between the levels' points; height is that over the column's own patch.
  Vector3 pointOnBend(const Column& c, double height) const;
  // The column that was first on the root of c; these are in order of root, before all others.
  Index mainOf(const Column& c) const { return ofVertex[c.root]; }
  // The wall's vertex below a vertex of the front; any other vertex is its own.
  Index rootOf(Index v) const { return ofVertex[v] == None ? v : columns[ofVertex[v]].root; }
  // The column at v if it has at least one layer, else None.
  Index standingAt(Index v) const
  {
    const Index c = ofVertex[v];
    return c != None && columns[c].levels > 0 ? c : None;
  }
};
} // namespace ransmesh
