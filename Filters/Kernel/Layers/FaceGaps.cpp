#include "Layers/FaceGaps.h"

#include "Layers/ColumnLimits.h"
#include "Layers/FaceRing.h"

#include <algorithm>
#include <limits>

namespace ransmesh
{
namespace
{
using Three = std::array<double, 3>;

// Barycentric, of a place on the triangle; not negative.
Three sharesOf(const Vector3& place, const TetMesh& mesh, const std::array<Index, 3>& v)
{
  Three share{};
  double sum = 0;
  for (int i = 0; i < 3; ++i)
  {
    share[i] = norm(cross(mesh.point(v[(i + 1) % 3]) - place, mesh.point(v[(i + 2) % 3]) - place));
    sum += share[i];
  }
  for (double& s : share)
  {
    s = sum > 0 ? s / sum : 1.0 / 3;
  }
  return share;
}

// The cap on heights under which their mean by the shares is not above what is allowed.
double commonCap(const Three& share, const Three& height, double allowed)
{
  std::array<int, 3> order{ 0, 1, 2 };
  std::sort(order.begin(), order.end(), [&](int a, int b) { return height[a] < height[b]; });
  double below = 0; // by those that stay under the cap
  double capped = 1;
  for (const int i : order)
  {
    if (below + capped * height[i] > allowed)
    {
      return (allowed - below) / capped;
    }
    below += share[i] * height[i];
    capped -= share[i];
  }
  return std::numeric_limits<double>::infinity();
}

void limitAt(Index vertex, double height, ColumnSet& set)
{
  if (const Index c = set.standingAt(vertex); c != None)
  {
    limitHeight(set, set.columns[c], height, StopReason::Gap);
  }
}

// Between the ways from the edge (a, b) to two others, and how far the first one goes.
struct Opening
{
  double angle;
  double reach;
};

Opening openingAt(const TetMesh& mesh, Index a, Index b, Index one, Index other)
{
  const Vector3 along = normalized(mesh.point(b) - mesh.point(a));
  const auto across = [&](Index v)
  {
    const Vector3 way = mesh.point(v) - mesh.point(a);
    return way - dot(way, along) * along;
  };
  const Vector3 first = across(one);
  const Vector3 second = across(other);
  return { std::atan2(norm(cross(first, second)), dot(first, second)), norm(first) };
}

bool mayHaveWedge(const std::vector<FaceAtVertex>& faces)
{
  const double cosine = std::cos(Turn::LeastOfWedge);
  return std::any_of(faces.begin(), faces.end(),
    [&](const FaceAtVertex& f)
    {
      return std::any_of(
        faces.begin(), faces.end(), [&](const FaceAtVertex& g) { return dot(f.normal, g.normal) < cosine; });
    });
}

// Of two faces with a common edge at the root: limits the columns at their other corners.
void limitInWedge(
  const TetMesh& mesh, const FaceAtVertex& here, const FaceAtVertex& next, double gapFraction, ColumnSet& set)
{
  const Index root = here.vertex[0];
  const Index end = here.vertex[2];
  for (const auto& [one, other] :
    { std::pair(here.vertex[1], next.vertex[2]), std::pair(next.vertex[2], here.vertex[1]) })
  {
    const Opening opening = openingAt(mesh, root, end, one, other);
    limitAt(one, gapFraction * opening.angle * opening.reach, set);
  }
}
} // namespace

void limitFacesMet(
  const TetMesh& mesh, const std::vector<FaceMeeting>& meetings, double gapFraction, ColumnSet& set)
{
  for (const FaceMeeting& meeting : meetings)
  {
    const auto v = mesh.boundaryVertices(meeting.face);
    Three height{};
    for (int i = 0; i < 3; ++i)
    {
      const Index c = set.standingAt(v[i]);
      height[i] = c == None ? 0 : set.thickness(set.columns[c]);
    }
    const double cap = commonCap(sharesOf(meeting.place, mesh, v), height, gapFraction * meeting.room);
    for (const Index w : v)
    {
      limitAt(w, cap, set);
    }
  }
}

void limitInWedges(const TetMesh& mesh, const BoundaryStars& stars, double gapFraction, ColumnSet& set)
{
  std::vector<FaceAtVertex> faces;
  FaceRing ring;
  for (const Column& c : set.columns)
  {
    faces.clear();
    for (const Index face : stars.facesAt(c.root))
    {
      if (!c.staysIn(mesh.boundaryFace(face).patch))
      {
        faces.push_back(stars.seenFrom(c.root, face));
      }
    }
    const std::size_t edges = mayHaveWedge(faces) && makeRing(faces, ring) ? ring.edgeCount() : 0;
    for (std::size_t k = 0; k < edges; ++k)
    {
      if (ring.turnAfter(c.base, mesh, k).isWedge())
      {
        limitInWedge(mesh, ring.faces[k], ring.faces[(k + 1) % ring.faces.size()], gapFraction, set);
      }
    }
  }
}
} // namespace ransmesh
