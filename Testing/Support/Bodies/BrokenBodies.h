// Clean bodies that were broken by one mutation each, and what is to be found wrong with them.
#pragma once

#include "Bodies/Body.h"
#include "Triangles/SurfaceCheck.h"

#include <set>
#include <string>
#include <vector>

namespace bodies
{
struct BrokenBody
{
  // What comes of it.
  enum class End
  {
    Meshed,          // repaired by default, or harmless
    Welded,          // refused; the message proposes a weld, which works
    Filled,          // refused; the message proposes filling holes, which works
    Wrapped,         // refused; the message proposes wrapping, which works
    Refused,         // refused; the input must be mended by its maker
    MeshedOrRefused, // up to TetGen's tolerances; if refused, then with the near sheets marked
  };

  std::string name;
  Body body;
  ransmesh::SurfaceFault fault = ransmesh::SurfaceFault::OpenEdge;
  std::size_t count = 0;              // of the fault; 0: some
  std::set<ransmesh::Index> mustMark; // triangles that the fault's findings hold
  bool marksNoOthers = false;         // the findings are exactly these
  End end = End::Meshed;
};

std::vector<BrokenBody> brokenBodies();
} // namespace bodies
