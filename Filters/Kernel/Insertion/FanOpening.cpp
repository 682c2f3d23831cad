#include "Insertion/FanOpening.h"

#include "Geometry/Predicates.h"
#include "Layers/Directions.h"
#include "Mesh/Star.h"
#include "Mesh/Traversal.h"

#include <algorithm>

namespace ransmesh
{
namespace
{
// New tetrahedra have at least this sine between the column and their base, if that can be had.
constexpr double LeastSines[] = { 0.15, 0.03, 0 };

// Heights of a new top, in first heights: lower ones see past neighbours that are open already.
constexpr double Lifts[] = { 1, 0.5, 0.25 };
// A cavity may reach so many tetrahedra beyond the root's ball.
constexpr std::size_t MostBeyondBall = 20;

// A face of the front at the root, turned into the fluid: (root, second, third).
struct FrontFace
{
  Index face;
  Index second;
  Index third;
};

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
    , star_(mesh)
    , traversal_(mesh)
  {
  }

  std::size_t open(const Fan& fan)
  {
    std::vector<std::vector<Index>> lifted(fan.directions.size() + 1);
    opened_.clear();
    refused_ = !assignFaces(fan, lifted);
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
  bool isFront(const Column& column, Index b) const { return !column.staysIn(mesh_.boundaryFace(b).patch); }

  // The front's faces at the root in order, beginning with the one whose corners stand on the anchor.
  std::vector<FrontFace> facesAround(const Fan& fan)
  {
    const Column& column = set_.columns[fan.column];
    std::vector<FrontFace> found;
    traversal_.ball(column.vertex, ball_);
    for (const Index t : ball_)
    {
      for (int f = 0; f < 4; ++f)
      {
        const HalfFace beyond = mesh_.tet(t).neighbour[f];
        if (isBoundary(beyond) && mesh_.tet(t).vertex[f] != column.vertex &&
          isFront(column, boundaryFaceOf(beyond)))
        {
          auto v = mesh_.tet(t).face(f);
          while (v[0] != column.vertex)
          {
            v = { v[1], v[2], v[0] };
          }
          found.push_back({ boundaryFaceOf(beyond), v[1], v[2] });
        }
      }
    }
    std::vector<FrontFace> ordered;
    auto at = std::find_if(found.begin(), found.end(),
      [&](const FrontFace& f)
      {
        return mesh_.boundaryFace(f.face).patch != FrontOnly && set_.rootOf(f.second) == fan.anchor[0] &&
          set_.rootOf(f.third) == fan.anchor[1];
      });
    while (at != found.end() && ordered.size() < found.size())
    {
      ordered.push_back(*at);
      const Index end = at->third;
      at = std::find_if(found.begin(), found.end(), [end](const FrontFace& f) { return f.second == end; });
    }
    return ordered.size() == found.size() ? ordered : std::vector<FrontFace>{};
  }

  // Which of the front's faces each column of the fan lifts: the wall's by the plan, those of neighbouring
  // fans by direction. False if the faces are not what the plan says.
  bool assignFaces(const Fan& fan, std::vector<std::vector<Index>>& lifted)
  {
    const std::vector<FrontFace> faces = facesAround(fan);
    std::size_t at = 0;
    for (std::size_t step = 0; step < fan.walk.size();)
    {
      for (int i = 0; i < fan.walk[step].faces; ++i, ++at)
      {
        if (at >= faces.size() || mesh_.boundaryFace(faces[at].face).patch == FrontOnly)
        {
          return false;
        }
        lifted[fan.walk[step].column].push_back(faces[at].face);
      }
      std::size_t last = step + 1;
      while (last < fan.walk.size() && fan.walk[last].faces == 0)
      {
        ++last;
      }
      std::size_t current = step;
      for (; at < faces.size() && mesh_.boundaryFace(faces[at].face).patch == FrontOnly; ++at)
      {
        current = nearestStep(fan, current, std::min(last, lastStep(fan)), faces[at]);
        lifted[fan.walk[current % fan.walk.size()].column].push_back(faces[at].face);
      }
      step = last;
    }
    return at == faces.size() && !faces.empty();
  }
  // The last step that faces beside the walk may go to; a closed walk ends where it began.
  static std::size_t lastStep(const Fan& fan) { return fan.closed ? fan.walk.size() : fan.walk.size() - 1; }

  // Of the steps from first to last, the one whose column points most like the columns of a neighbour's face.
  std::size_t nearestStep(const Fan& fan, std::size_t first, std::size_t last, const FrontFace& face) const
  {
    const Vector3 middle = directionAt(face.second) + directionAt(face.third);
    const auto agreement = [&](std::size_t step)
    { return dot(middle, normalized(directionOf(fan, fan.walk[step % fan.walk.size()].column))); };
    std::size_t best = first;
    for (std::size_t step = first + 1; step <= last; ++step)
    {
      best = agreement(step) > agreement(best) + 1e-9 ? step : best;
    }
    return best;
  }
  Vector3 directionOf(const Fan& fan, int number) const
  {
    return static_cast<std::size_t>(number) < fan.directions.size() ? fan.directions[number]
                                                                    : set_.columns[fan.column].direction;
  }
  Vector3 directionAt(Index vertex) const
  {
    const Index c = set_.ofVertex[vertex];
    return c == None ? Vector3{} : normalized(set_.columns[c].direction);
  }

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
    for (std::size_t i = 0; i < cavity_.tets.size(); ++i)
    {
      const Tetrahedron& tet = mesh_.tet(cavity_.tets[i]);
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
    inCavity_.clear(mesh_.tetSlots());
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
    if (std::find(faces.begin(), faces.end(), b) != faces.end())
    {
      return true;
    }
    // Of a curved side only the faces at the root: others would turn.
    const auto v = mesh_.boundaryVertices(b);
    const bool isNear = column.path == None || std::find(v.begin(), v.end(), column.vertex) != v.end();
    return isNear && column.staysIn(mesh_.boundaryFace(b).patch);
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
        if (!isBoundary(beyond) || !isFront(column, boundaryFaceOf(beyond)))
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
    for (const Index t : ball_)
    {
      for (int f = 0; f < 4; ++f)
      {
        const HalfFace beyond = mesh_.tet(t).neighbour[f];
        if (isBoundary(beyond) && mesh_.tet(t).vertex[f] != column.vertex &&
          isFront(column, boundaryFaceOf(beyond)))
        {
          const auto v = mesh_.tet(t).face(f);
          normals.push_back(
            normalized(cross(mesh_.point(v[1]) - mesh_.point(v[0]), mesh_.point(v[2]) - mesh_.point(v[0]))));
        }
      }
    }
    const double length = norm(column.direction);
    column.direction = length * mostVisible(normals, SideProjection({}), normalized(column.direction));
    if (!(visibility(normals, column.direction) > 0))
    {
      column.limit(0, StopReason::Corner);
    }
  }

  TetMesh& mesh_;
  ColumnSet& set_;
  Star star_;
  Traversal traversal_;
  Marks inCavity_;
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
