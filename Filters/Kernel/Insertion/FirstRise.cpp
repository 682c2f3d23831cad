#include "Insertion/FirstRise.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <tuple>

namespace ransmesh
{
namespace
{
// The first height is right if it is off by at most a tenth of itself, but for rounding.
constexpr double LargestMiss = 0.099;
// Triangles above which no column is right weigh so little.
constexpr double WeightOfHopeless = 1e-3;

// A triangle of the wall above which not all columns are right.
struct Choice
{
  std::array<Index, 3> root{}; // None where no column rises
  std::array<bool, 3> isRight{};
  double weight = 0;
  bool isMade = false;
};

// By how much the column's first height misses that of the patch above a triangle with this normal, as a share of it.
double missOf(const ColumnSet& set, const Column& c, int patch, const Vector3& normal)
{
  return std::fabs(dot(normal, set.pointAt(c, 1) - c.base) / set.heights[patch].height(1) - 1);
}

// False where the columns are all right. Where none is, that which misses least counts as right.
bool findChoice(const TetMesh& mesh, const ColumnSet& set, const BaseFace& face, Choice& choice)
{
  const auto p = basePoints(mesh, set, face);
  const Vector3 across = cross(p[1] - p[0], p[2] - p[0]);
  const Vector3 normal = normalized(across);
  std::array<double, 3> miss{};
  double least = INFINITY;
  double largest = 0;
  for (int j = 0; j < 3; ++j)
  {
    choice.root[j] = face.column[j] == None ? None : face.root[j];
    if (choice.root[j] != None)
    {
      miss[j] = missOf(set, set.columns[face.column[j]], face.patch, normal);
      least = std::min(least, miss[j]);
      largest = std::max(largest, miss[j]);
    }
  }
  for (int j = 0; j < 3; ++j)
  {
    choice.isRight[j] = miss[j] <= std::max(least, LargestMiss);
  }
  choice.weight = (least <= LargestMiss ? 1 : WeightOfHopeless) * norm(across);
  return largest > LargestMiss;
}

class Ranking
{
public:
  Ranking(const TetMesh& mesh, const std::vector<BaseFace>& faces, const ColumnSet& set)
  {
    Choice choice;
    for (const BaseFace& face : faces)
    {
      const bool isOfWall = face.hasBase() && set.heights[face.patch].count() > 0;
      if (isOfWall && findChoice(mesh, set, face, choice))
      {
        add(choice, set);
      }
    }
  }

  // Ranks by root, from 1 on; roots for which it does not matter have none.
  std::map<Index, int> run()
  {
    std::set<Place> waiting;
    for (const auto& [root, state] : roots_)
    {
      waiting.insert(placeOf(root));
    }
    std::map<Index, int> ranks;
    while (!waiting.empty())
    {
      const Index next = waiting.begin()->root;
      waiting.erase(waiting.begin());
      ranks[next] = static_cast<int>(ranks.size()) + 1;
      for (const std::size_t i : roots_[next].choices)
      {
        makeChoice(choices_[i], waiting);
      }
    }
    return ranks;
  }

private:
  struct Root
  {
    int group = 0;
    std::vector<std::size_t> choices;
  };

  // Where a root stands in the order, as things are: first columns that lean over a lower wall, which rise first anyhow;
  // those of grids last; among others those that would be wrong least.
  struct Place
  {
    int group = 0;
    double wrong = 0; // the weight of triangles above which they would rise first and not be right
    Index root = None;
    bool operator<(const Place& o) const
    {
      return std::tie(group, wrong, root) < std::tie(o.group, o.wrong, o.root);
    }
  };

  void add(const Choice& choice, const ColumnSet& set)
  {
    for (const Index root : choice.root)
    {
      if (root != None)
      {
        const Column& c = set.columns[set.ofVertex[root]];
        const bool mayHaveGrid = c.hasGrid && c.levels == c.asked;
        roots_[root].group = c.bend != None ? 0 : mayHaveGrid ? 2 : 1;
        roots_[root].choices.push_back(choices_.size());
      }
    }
    choices_.push_back(choice);
  }

  Place placeOf(Index root) const
  {
    const Root& r = roots_.at(root);
    Place place{ r.group, 0, root };
    for (const std::size_t i : r.choices)
    {
      const Choice& choice = choices_[i];
      const auto j = std::find(choice.root.begin(), choice.root.end(), root) - choice.root.begin();
      place.wrong += choice.isMade || choice.isRight[j] ? 0 : choice.weight;
    }
    return place;
  }

  // Another column has risen above the triangle: it is no concern of the others.
  void makeChoice(Choice& choice, std::set<Place>& waiting)
  {
    std::vector<Index> others;
    for (const Index root : choice.root)
    {
      if (!choice.isMade && root != None && waiting.erase(placeOf(root)) > 0)
      {
        others.push_back(root);
      }
    }
    choice.isMade = true;
    for (const Index root : others)
    {
      waiting.insert(placeOf(root));
    }
  }

  std::vector<Choice> choices_;
  std::map<Index, Root> roots_;
};
} // namespace

void orderFirstRise(const TetMesh& mesh, std::vector<BaseFace>& faces, ColumnSet& set)
{
  const std::map<Index, int> ranks = Ranking(mesh, faces, set).run();
  if (ranks.empty())
  {
    return;
  }
  for (Column& c : set.columns)
  {
    const auto found = ranks.find(c.root);
    c.firstRank = found == ranks.end() ? 0 : found->second;
  }
  std::for_each(faces.begin(), faces.end(), [&set](BaseFace& face) { sortFirstRise(set, face); });
}
} // namespace ransmesh
