#include "Insertion/FanOpening.h"

#include "Geometry/Predicates.h"
#include "Insertion/FanFaces.h"
#include "Layers/Directions.h"
#include "Mesh/Star.h"
#include "Mesh/Traversal.h"

#include <algorithm>
#include <cmath>

namespace ransmesh
{
namespace
{
// New tetrahedra have at least this sine between the column and their base, if that can be had.
constexpr double LeastSines[] = { 0.15, 0.03, 0 };

// Heights of a new top, in first heights: lower ones see past neighbours that are open already.
constexpr double Lifts[] = { 1, 0.5, 0.25 };
// A face lies in the root's plane if the root is so near to its plane, in the wall's sizes.
constexpr double InPlane = 1e-3;
// A cavity may reach so many tetrahedra beyond the root's ball.
constexpr std::size_t MostBeyondBall = 20;

// The two faces that come between the root and a column split off from it.
struct Cliffs
{
  Index start = None; // where the walk comes to the column
  Index end = None;   // where it leaves it
};

class FanOpener
{
public:
  FanOpener(TetMesh& mesh, ColumnSet& set)
    : mesh_(mesh)
    , set_(set)
    , faces_(mesh, set)
    , star_(mesh)
    , traversal_(mesh)
  {
  }

  std::size_t open(const Fan& fan)
  {
    std::vector<std::vector<Index>> lifted(fan.directions.size() + 1);
    opened_.clear();
    refused_ = !faces_.assign(fan, lifted);
    if (!refused_)
    {
      splitOff(fan, lifted);
    }
    if (opened_.empty())
    {
      closeFan(fan);
    }
    else if (refused_)
    {
      aimAgain(set_.columns[fan.column]);
    }
    for (const Index c : opened_)
    {
      set_.columns[c].lowest = 1;
    }
    return opened_.size();
  }

private:
  void splitOff(const Fan& fan, std::vector<std::vector<Index>>& lifted)
  {
    Cliffs before;
    Cliffs first;
    for (std::size_t k = 0; k < fan.directions.size(); ++k)
    {
      std::vector<Index> faces = lifted[k];
      const bool isLast = k + 1 == fan.directions.size();
      const auto take = [&faces](Index face)
      {
        if (face != None && std::find(faces.begin(), faces.end(), face) == faces.end())
        {
          faces.push_back(face);
        }
      };
      take(before.end);
      if (!fan.aroundMain)
      {
        take(before.start);
      }
      else if (fan.closed && isLast)
      {
        take(first.start);
      }
      Cliffs cliffs;
      if (split(fan, k, faces, cliffs))
      {
        first = k == 0 ? cliffs : first;
        before = cliffs;
        continue;
      }
      refused_ = true;
      if (fan.aroundMain)
      {
        before = {};
      }
      else if (k == 0)
      {
        return;
      }
      else if (!isLast)
      {
        lifted[k + 1].insert(lifted[k + 1].end(), lifted[k].begin(), lifted[k].end());
      }
    }
  }

  // Splits the column of this number, with these faces, off from the root.
  bool split(const Fan& fan, std::size_t number, const std::vector<Index>& faces, Cliffs& cliffs)
  {
    Column column = set_.columns[fan.column];
    column.direction = fan.directions[number];
    column.path = fan.paths.empty() ? None : fan.paths[number];
    const Index vertex = mesh_.addVertex(column.base);
    for (const double share : Lifts)
    {
      column.lifted = share * set_.heightsOf(column).height(1);
      mesh_.movePoint(vertex, set_.pointAtHeight(column, column.lifted));
      if (findCavity(column, vertex, faces))
      {
        cliffs = markCliffs(column, vertex, star_.apply());
        column.vertex = vertex;
        opened_.push_back(static_cast<Index>(set_.columns.size()));
        set_.ofVertex.push_back(opened_.back());
        set_.columns.push_back(column);
        return true;
      }
    }
    mesh_.removeLastVertices(1);
    return false;
  }

  bool findCavity(const Column& column, Index vertex, const std::vector<Index>& faces)
  {
    // Where surfaces only touch, a face may have gone with another column's cavity.
    const bool allThere =
      std::all_of(faces.begin(), faces.end(), [this](Index b) { return mesh_.boundaryFace(b).isAlive(); });
    return allThere &&
      std::any_of(std::begin(LeastSines), std::end(LeastSines),
        [&](double sine)
        {
          return buildCavity(column, vertex, faces, sine) &&
            star_.check(cavity_, vertex) == StarVerdict::Possible && star_.lostVertices().empty();
        });
  }

  // The tetrahedra behind the faces, and those that the new vertex would not see from inside.
  bool buildCavity(const Column& column, Index vertex, const std::vector<Index>& faces, double sine)
  {
    collectFirst(column.vertex, faces);
    std::size_t next = 0;
    while (next < cavity_.tets.size()) // they become more
    {
      const Tetrahedron& tet = mesh_.tet(cavity_.tets[next++]);
      for (int f = 0; f < 4; ++f)
      {
        const HalfFace beyond = tet.neighbour[f];
        if (!isBoundary(beyond) && inCavity_.test(tetOf(beyond)))
        {
          continue;
        }
        if (isBoundary(beyond) && isStarred(column, boundaryFaceOf(beyond), faces))
        {
          cavity_.starredFaces.push_back(boundaryFaceOf(beyond));
        }
        else if (!sees(tet.face(f), column, vertex, sine))
        {
          if (isBoundary(beyond) || cavity_.tets.size() > ball_.size() + MostBeyondBall)
          {
            return false;
          }
          add(tetOf(beyond));
        }
      }
    }
    return true;
  }

  // Edges of the root between two of the faces go, so all tetrahedra around them do.
  void collectFirst(Index root, const std::vector<Index>& faces)
  {
    cavity_.tets.clear();
    cavity_.starredFaces.clear();
    inCavity_.clear();
    std::vector<Index> ends;
    for (const Index b : faces)
    {
      add(tetOf(mesh_.boundaryFace(b).inner));
      for (const Index v : mesh_.boundaryVertices(b))
      {
        if (v != root)
        {
          ends.push_back(v);
        }
      }
    }
    std::sort(ends.begin(), ends.end());
    traversal_.ball(root, ball_);
    for (std::size_t i = 0; i + 1 < ends.size(); ++i)
    {
      if (ends[i] == ends[i + 1])
      {
        std::for_each(ball_.begin(), ball_.end(),
          [&](Index t)
          {
            if (mesh_.tet(t).has(ends[i]))
            {
              add(t);
            }
          });
      }
    }
  }
  void add(Index t)
  {
    if (inCavity_.set(t))
    {
      cavity_.tets.push_back(t);
    }
  }

  bool isStarred(const Column& column, Index b, const std::vector<Index>& faces) const
  {
    return std::find(faces.begin(), faces.end(), b) != faces.end() ||
      (column.staysIn(mesh_.boundaryFace(b).patch) && isOfRootsSide(column, b));
  }

  // Of a curved side only the faces at the root: others would turn. A patch may also have several planes; the
  // column stays in those that go through its root.
  bool isOfRootsSide(const Column& column, Index b) const
  {
    const auto v = mesh_.boundaryVertices(b);
    const bool hasRoot = std::find(v.begin(), v.end(), column.vertex) != v.end();
    if (hasRoot || column.path != None)
    {
      return hasRoot;
    }
    const Vector3& a = mesh_.point(v[0]);
    const Vector3 n = normalized(cross(mesh_.point(v[1]) - a, mesh_.point(v[2]) - a));
    return std::fabs(dot(n, column.base - a)) <= InPlane * column.size;
  }

  bool sees(const std::array<Index, 3>& v, const Column& column, Index vertex, double sine) const
  {
    const Vector3& a = mesh_.point(v[0]);
    const Vector3& b = mesh_.point(v[1]);
    const Vector3& c = mesh_.point(v[2]);
    if (!isPositive(a, b, c, mesh_.point(vertex)))
    {
      return false;
    }
    const bool hasRoot = v[0] == column.vertex || v[1] == column.vertex || v[2] == column.vertex;
    const Vector3 normal = normalized(cross(b - a, c - a));
    return !hasRoot || dot(normal, normalized(column.direction)) >= sine;
  }

  // Gives the faces between the root and the new vertex their patch.
  Cliffs markCliffs(const Column& column, Index vertex, const std::vector<Index>& created)
  {
    Cliffs cliffs;
    for (const Index t : created)
    {
      for (int f = 0; f < 4; ++f)
      {
        const HalfFace beyond = mesh_.tet(t).neighbour[f];
        if (!isBoundary(beyond) || !isFrontFace(mesh_, column, boundaryFaceOf(beyond)))
        {
          continue;
        }
        const auto v = mesh_.tet(t).face(f);
        for (int i = 0; i < 3; ++i)
        {
          if (v[i] != column.vertex)
          {
            continue;
          }
          Index& cliff = v[(i + 1) % 3] == vertex ? cliffs.end : cliffs.start;
          if (v[(i + 1) % 3] == vertex || v[(i + 2) % 3] == vertex)
          {
            cliff = boundaryFaceOf(beyond);
            mesh_.setPatch(cliff, FrontOnly);
          }
        }
      }
    }
    return cliffs;
  }

  void closeFan(const Fan& fan)
  {
    Column& column = set_.columns[fan.column];
    column.direction = fan.single;
    if (norm(fan.single) == 0)
    {
      column.limit(0, StopReason::Corner);
    }
  }

  // Some column was refused: the main one has other faces than planned. In a side it has no choice.
  void aimAgain(Column& column)
  {
    if (column.sides[0] != 0)
    {
      return;
    }
    std::vector<Vector3> normals;
    traversal_.ball(column.vertex, ball_);
    forEachFrontFaceAt(mesh_, column, ball_,
      [&](Index, const std::array<Index, 3>& v)
      {
        normals.push_back(
          normalized(cross(mesh_.point(v[1]) - mesh_.point(v[0]), mesh_.point(v[2]) - mesh_.point(v[0]))));
      });
    const double length = norm(column.direction);
    column.direction = length * mostVisible(normals, SideProjection({}), normalized(column.direction));
    if (!(visibility(normals, column.direction) > 0))
    {
      column.limit(0, StopReason::Corner);
    }
  }

  TetMesh& mesh_;
  ColumnSet& set_;
  FanFaces faces_;
  Star star_;
  Traversal traversal_;
  LocalMarks inCavity_;
  Cavity cavity_;
  std::vector<Index> ball_;
  std::vector<Index> opened_;
  bool refused_ = false;
};
} // namespace

FanReport openFans(TetMesh& mesh, ColumnSet& set)
{
  FanReport report;
  FanOpener opener(mesh, set);
  for (const Fan& fan : set.fans)
  {
    const Column& main = set.columns[fan.column];
    if (main.levels > 0)
    {
      report.planned += fan.directions.size();
      report.opened += opener.open(fan);
    }
  }
  return report;
}
} // namespace ransmesh
