#include "Insertion/TensorStacks.h"

#include "Geometry/Angles.h"
#include "Geometry/Predicates.h"
#include "Insertion/TensorChains.h"

#include <algorithm>
#include <cmath>
#include <tuple>

namespace ransmesh
{
namespace
{
// How far the points that a grid brings to a wall may lie off the planes of its triangles, in lengths of its
// edges: the triangles move there.
constexpr double LargestDrift = 0.05;

// One end of a strip along a ridge: the points on the wall, from the ridge outward.
struct StripEnd
{
  std::vector<Index> chains; // one a base point; a single one where there is no grid
  Index root = None;
  bool hasGrid = false;
};

class StackMaker
{
public:
  StackMaker(const ColumnSet& set, const std::vector<BaseFace>& faces, const CornerChoice& choice,
    TensorChains& chains, TensorStacks& out)
    : set_(set)
    , faces_(faces)
    , choice_(choice)
    , chains_(chains)
    , out_(out)
    , squaresDone_(set.corners.size())
  {
  }

  // The corners of which some stack can not stand, each once.
  std::vector<Index> run(double maximumSurfaceAngle)
  {
    out_.replaced.assign(faces_.size(), 0);
    const double leastCosine = cosineOfDegrees(maximumSurfaceAngle);
    for (std::size_t i = 0; i < faces_.size(); ++i)
    {
      const BaseFace& face = faces_[i];
      const std::array<Index, 3> corners{ choice_.at(face, 0), choice_.at(face, 1), choice_.at(face, 2) };
      if (corners[0] == None && corners[1] == None && corners[2] == None)
      {
        continue;
      }
      out_.replaced[i] = 1;
      const std::size_t first = out_.stacks.size();
      writeFace(face, corners);
      for (int j = 0; j < 3; ++j)
      {
        if (choice_.isRidge(static_cast<Index>(i), j))
        {
          writeStrip(face, corners, j);
        }
        if (corners[j] != None && set_.corners[corners[j]].walls == 3)
        {
          writeSquare(face, corners[j], choice_.wallAt(corners[j], face));
        }
      }
      const Vector3 normal = normalOf(choice_.basePoints(face));
      if (!stand(first, normal, leastCosine) || drifts(face, corners, normal))
      {
        std::copy_if(
          corners.begin(), corners.end(), std::back_inserter(failed_), [](Index c) { return c != None; });
      }
    }
    std::sort(failed_.begin(), failed_.end());
    failed_.erase(std::unique(failed_.begin(), failed_.end()), failed_.end());
    return failed_;
  }

private:
  void addStack(const std::array<Index, 3>& chains, const std::array<int, 3>& levels,
    const std::array<int, 3>& sideOpposite, int patch)
  {
    TensorStack t;
    t.patch = patch;
    t.sideOpposite = sideOpposite;
    for (int j = 0; j < 3; ++j)
    {
      const std::vector<Index>& points = chains_.at(chains[j]);
      t.chain[j] = &points;
      t.stack.root[j] = points[0]; // no fans here: each stands on a point of its own
      t.stack.levels[j] = std::min(levels[j], static_cast<int>(points.size()) - 1);
    }
    // Columns rise before grid points: at a strip's end the column lies in the grid's halving plane, and a
    // tetrahedron of it and the points below the plane's would be flat.
    const auto key = [&](int j, bool isFirst)
    {
      const ChainOrder& order = chains_.order(chains[j]);
      return std::tuple(
        order.isOfGrid, order.risesLater, isFirst ? order.firstRank : 0, order.root, chains[j]);
    };
    std::sort(t.stack.rise.begin(), t.stack.rise.end(),
      [&key](int j, int k) { return key(j, false) < key(k, false); });
    std::sort(t.stack.firstRise.begin(), t.stack.firstRise.end(),
      [&key](int j, int k) { return key(j, true) < key(k, true); });
    out_.stacks.push_back(t);
  }

  void writeFace(const BaseFace& face, const std::array<Index, 3>& corners)
  {
    std::array<Index, 3> chains;
    for (int j = 0; j < 3; ++j)
    {
      chains[j] = chains_.outer(face, j, corners[j]);
    }
    constexpr int all = MaximumNumberOfLayers;
    addStack(chains, { all, all, all }, face.sideOpposite, face.patch);
  }

  StripEnd endOf(const BaseFace& face, int j, Index corner, int across)
  {
    StripEnd end;
    end.root = face.root[j];
    end.hasGrid = corner != None;
    if (!end.hasGrid)
    {
      end.chains = { chains_.plain(face, j) };
      return end;
    }
    const int wall = choice_.wallAt(corner, face);
    GridPlace place = chains_.outermost(corner, wall);
    for (place[across] = 0; place[across] <= chains_.levels(corner); ++place[across])
    {
      end.chains.push_back(chains_.ofGrid(corner, place, wall, face.patch));
    }
    return end;
  }

  // The wall of the corner on the other side of the ridge opposite to corner j of the face.
  int wallAcross(const BaseFace& face, int j, Index corner, int end) const
  {
    const TensorCorner& c = set_.corners[corner];
    const int wall = choice_.wallAt(corner, face);
    if (c.walls == 2)
    {
      return 1 - wall;
    }
    // The ridge between two of three walls rises from the third.
    const int other = 3 - j - end;
    const auto p = choice_.basePoints(face);
    const Vector3 along = normalized(p[other] - p[end]);
    const int first = (wall + 1) % 3;
    const int second = (wall + 2) % 3;
    const bool firstRises = dot(along, normalized(c.rise[first])) > dot(along, normalized(c.rise[second]));
    return firstRises ? second : first;
  }

  // The triangles between the ridge, the edge opposite to corner j of the face, and the base points farthest
  // from it.
  void writeStrip(const BaseFace& face, const std::array<Index, 3>& corners, int j)
  {
    const int p = (j + 1) % 3;
    const int q = (j + 2) % 3;
    const auto end = [&](int k)
    { return endOf(face, k, corners[k], corners[k] == None ? 0 : wallAcross(face, j, corners[k], k)); };
    const std::array<StripEnd, 2> ends{ end(p), end(q) };
    const std::array<int, 2> side{ sideAt(corners[p]), sideAt(corners[q]) };
    const std::size_t first = ends[0].root < ends[1].root ? 0 : 1;
    const std::size_t steps = std::max(ends[0].chains.size(), ends[1].chains.size());
    std::array<std::size_t, 2> at{ 0, 0 };
    for (std::size_t step = 1; step < steps; ++step)
    {
      for (const std::size_t e : { first, 1 - first })
      {
        if (step >= ends[e].chains.size())
        {
          continue;
        }
        const auto levelAt = [&](std::size_t i)
        { return ends[i].hasGrid ? MaximumNumberOfLayers : static_cast<int>(step); };
        // The edge from the point left to the next one lies in the side, where the ridge ends at one.
        std::array<int, 3> sides{};
        sides[1 - e] = side[e];
        addStack({ ends[0].chains[at[0]], ends[1].chains[at[1]], ends[e].chains[step] },
          { levelAt(0), levelAt(1), levelAt(e) }, sides, face.patch);
        at[e] = step;
      }
    }
  }
  int sideAt(Index corner) const
  {
    return corner == None ? 0 : set_.columns[set_.corners[corner].column].sides[0];
  }

  // The square of base points on one of three walls.
  void writeSquare(const BaseFace& face, Index corner, int wall)
  {
    std::array<char, 3>& done = squaresDone_[corner];
    if (done[wall])
    {
      return;
    }
    done[wall] = 1;
    const TensorCorner& c = set_.corners[corner];
    const bool turnsLeft = dot(cross(c.rise[(wall + 1) % 3], c.rise[(wall + 2) % 3]), c.normal[wall]) > 0;
    const auto chain = [&](int a, int b)
    {
      return chains_.ofGrid(corner,
        turnsLeft ? TensorChains::placeOn(wall, a, b) : TensorChains::placeOn(wall, b, a), wall, face.patch);
    };
    constexpr int all = MaximumNumberOfLayers;
    const int levels = chains_.levels(corner);
    for (int a = 0; a < levels; ++a)
    {
      for (int b = 0; b < levels; ++b)
      {
        addStack({ chain(a, b), chain(a + 1, b), chain(a + 1, b + 1) }, { all, all, all }, {}, face.patch);
        addStack({ chain(a, b), chain(a + 1, b + 1), chain(a, b + 1) }, { all, all, all }, {}, face.patch);
      }
    }
  }

  // Are the stacks from the first on positive, and their triangles on the wall where it was?
  bool stand(std::size_t first, const Vector3& normal, double leastCosine) const
  {
    return std::all_of(out_.stacks.begin() + static_cast<std::ptrdiff_t>(first), out_.stacks.end(),
      [&](const TensorStack& t)
      {
        std::array<Vector3, 3> current{ chains_.point(t.at(0, 0)), chains_.point(t.at(1, 0)),
          chains_.point(t.at(2, 0)) };
        bool stands = dot(normalOf(current), normal) > leastCosine;
        forEachRise(t.stack,
          [&](int below, int corner, bool)
          {
            const Vector3& risen = chains_.point(t.at(corner, below + 1));
            stands = stands && isPositive(current[0], current[1], current[2], risen);
            current[corner] = risen;
          });
        return stands;
      });
  }

  // Do the grids take the face's corners too far from its plane?
  bool drifts(const BaseFace& face, const std::array<Index, 3>& corners, const Vector3& normal)
  {
    bool result = false;
    for (int j = 0; j < 3; ++j)
    {
      if (corners[j] != None)
      {
        const Column& column = set_.columns[set_.corners[corners[j]].column];
        const Vector3& outermost = chains_.point(chains_.at(chains_.outer(face, j, corners[j]))[0]);
        result = result || std::fabs(dot(outermost - column.base, normal)) > LargestDrift * column.size;
      }
    }
    return result;
  }

  const ColumnSet& set_;
  const std::vector<BaseFace>& faces_;
  const CornerChoice& choice_;
  TensorChains& chains_;
  TensorStacks& out_;
  std::vector<std::array<char, 3>> squaresDone_;
  std::vector<Index> failed_;
};
} // namespace

TensorStacks makeTensorStacks(const TetMesh& mesh, const ColumnSet& set, const std::vector<BaseFace>& faces,
  const ColumnPoints& numbers, const std::vector<Index>& baseNumber, const std::vector<Vector3>& points,
  double maximumSurfaceAngle)
{
  TensorStacks none;
  none.replaced.assign(faces.size(), 0);
  if (set.corners.empty())
  {
    return none;
  }
  CornerChoice choice(mesh, set, faces);
  none.report = choice.report();
  choice.settle();
  while (choice.count() > 0)
  {
    TensorStacks made;
    made.report = none.report;
    made.report.made = choice.count();
    TensorChains chains(set, numbers, baseNumber, choice, points, made);
    const std::vector<Index> failed = StackMaker(set, faces, choice, chains, made).run(maximumSurfaceAngle);
    if (failed.empty())
    {
      return made;
    }
    std::for_each(failed.begin(), failed.end(), [&choice](Index c) { choice.drop(c); });
    choice.settle();
  }
  return none;
}
} // namespace ransmesh
