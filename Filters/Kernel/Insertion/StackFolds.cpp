#include "Insertion/StackFolds.h"

#include "Geometry/Predicates.h"
#include "Insertion/LayerStacks.h"
#include "Insertion/StackCertainty.h"
#include "Layers/ColumnLimits.h"
#include "Mesh/Traversal.h"

#include <algorithm>

namespace ransmesh
{
namespace
{
// Where the tops of columns are taken to be.
enum class Tops
{
  InMesh,   // where the mesh's vertices are
  AsPlanned // where the columns end
};

Vector3 levelPoint(const TetMesh& mesh, const ColumnSet& set, const Column& c, int level, Tops tops)
{
  return tops == Tops::InMesh && level == c.levels ? mesh.point(c.vertex) : set.pointAt(c, level);
}

bool topsAreAsPlanned(const TetMesh& mesh, const ColumnSet& set, const BaseFace& face)
{
  return std::all_of(face.column.begin(), face.column.end(),
    [&](Index i)
    {
      const Column* c = i == None ? nullptr : &set.columns[i];
      return !c || c->levels == 0 || mesh.point(c->vertex) == set.pointAt(*c, c->levels);
    });
}

bool isFolded(const TetMesh& mesh, const ColumnSet& set, const BaseFace& face, Tops tops = Tops::InMesh)
{
  if ((tops == Tops::AsPlanned || topsAreAsPlanned(mesh, set, face)) && isSurelyPositive(mesh, set, face))
  {
    return false;
  }
  std::array<Vector3, 3> current = basePoints(mesh, set, face);
  bool positive = true;
  forEachRise(stackOf(set, face),
    [&](int below, int corner, bool isFlat)
    {
      const Vector3 risen = levelPoint(mesh, set, set.columns[face.column[corner]], below + 1, tops);
      positive = positive && (isFlat || isPositive(current[0], current[1], current[2], risen));
      current[corner] = risen;
    });
  return !positive;
}

// The slab as one layer, every column at its planned height.
bool slabFolds(const TetMesh& mesh, const ColumnSet& set, const BaseFace& face)
{
  std::array<Vector3, 3> current = basePoints(mesh, set, face);
  BaseCorners corners(face.root);
  for (const int corner : face.rise)
  {
    if (face.column[corner] == None)
    {
      continue;
    }
    const Column& c = set.columns[face.column[corner]];
    const Vector3 top = set.pointAt(c, c.levels);
    if (c.levels > 0 && !corners.isFlat() && !isPositive(current[0], current[1], current[2], top))
    {
      return true;
    }
    corners.rise(corner);
    current[corner] = top;
  }
  return false;
}
int highestLevel(const ColumnSet& set, const BaseFace& face)
{
  int highest = 0;
  for (const Index c : face.column)
  {
    highest = std::max(highest, c == None ? 0 : set.columns[c].levels);
  }
  return highest;
}

// By squeezing its levels where it has all of them, then by a quarter of them: most folds are gone so. Where columns were
// halved the steps to those around folded in turn.
void lowerALittle(ColumnSet& set, Column& column)
{
  const int levels = column.levels;
  const double height = set.thickness(column);
  limitHeight(set, column, set.heights[column.patch].squeezedHeight(levels), StopReason::Corner);
  if (!(set.thickness(column) < height))
  {
    column.limit(levels * 3 / 4, StopReason::Corner);
  }
}
} // namespace

std::vector<Index> limitByFolds(const TetMesh& mesh, const std::vector<BaseFace>& faces, ColumnSet& set)
{
  std::vector<char> isLeft(faces.size(), 0); // folded, with all columns as low as they can be
  // The round in which a column was lowered: only faces at those of the last one are looked at again.
  std::vector<int> loweredIn(set.columns.size(), 0);
  bool lowered = true;
  for (int round = 1; lowered; ++round)
  {
    lowered = false;
    for (std::size_t i = 0; i < faces.size(); ++i)
    {
      const BaseFace& face = faces[i];
      const bool isConcerned = std::any_of(face.column.begin(), face.column.end(),
        [&](Index c) { return c != None && loweredIn[c] >= round - 1; });
      if (!isConcerned)
      {
        continue;
      }
      const bool slab = slabFolds(mesh, set, face);
      isLeft[i] = slab || isFolded(mesh, set, face, Tops::AsPlanned);
      if (!isLeft[i])
      {
        continue;
      }
      // Where only the stack folds, it is the steps between columns: the highest ones are lowered.
      const int highest = slab ? 0 : highestLevel(set, face);
      for (const Index c : face.column)
      {
        if (c != None && set.columns[c].levels > set.columns[c].lowest && set.columns[c].levels >= highest)
        {
          lowerALittle(set, set.columns[c]);
          loweredIn[c] = round;
          lowered = true;
        }
      }
    }
  }
  std::vector<Index> left;
  for (std::size_t i = 0; i < faces.size(); ++i)
  {
    if (isLeft[i] && isFolded(mesh, set, faces[i]))
    {
      left.push_back(faces[i].face);
    }
  }
  return left;
}

std::vector<Index> findFoldedStacks(
  const TetMesh& mesh, const ColumnSet& set, const std::vector<BaseFace>& faces)
{
  std::vector<Index> folded;
  for (std::size_t i = 0; i < faces.size(); ++i)
  {
    if (isFolded(mesh, set, faces[i]))
    {
      folded.push_back(static_cast<Index>(i));
    }
  }
  return folded;
}

bool mendFolds(TetMesh& mesh, ColumnSet& set, std::vector<Index>& foldedFaces)
{
  const std::vector<BaseFace> faces = collectBaseFaces(mesh, set);
  foldedFaces = findFoldedStacks(mesh, set, faces);
  bool lowered = true;
  while (!foldedFaces.empty() && lowered)
  {
    lowered = false;
    std::vector<char> touched(set.columns.size(), 0);
    for (const Index face : foldedFaces)
    {
      const int highest = highestLevel(set, faces[face]);
      for (const Index c : faces[face].column)
      {
        if (c != None && !touched[c] && set.columns[c].levels > set.columns[c].lowest &&
          set.columns[c].levels >= highest)
        {
          touched[c] = lowerTop(mesh, set, c, set.columns[c].levels / 2);
          lowered = lowered || touched[c];
        }
      }
    }
    std::vector<Index> again;
    for (std::size_t i = 0; i < faces.size(); ++i)
    {
      const bool concerned = std::any_of(faces[i].column.begin(), faces[i].column.end(),
        [&touched](Index c) { return c != None && touched[c]; });
      const bool was = std::binary_search(foldedFaces.begin(), foldedFaces.end(), static_cast<Index>(i));
      if ((concerned || was) && isFolded(mesh, set, faces[i]))
      {
        again.push_back(static_cast<Index>(i));
      }
    }
    foldedFaces.swap(again);
  }
  for (Index& face : foldedFaces)
  {
    face = faces[face].face;
  }
  return foldedFaces.empty();
}

bool lowerTop(TetMesh& mesh, ColumnSet& set, Index column, int level)
{
  Column& c = set.columns[column];
  Traversal traversal(mesh);
  std::vector<Index> ball;
  traversal.ball(c.vertex, ball);
  for (level = std::max(level, c.lowest); level >= c.lowest; --level)
  {
    const Vector3 x = level > 0 ? set.pointAt(c, level) : c.base;
    const bool stands = std::all_of(ball.begin(), ball.end(),
      [&](Index t)
      {
        const auto& v = mesh.tet(t).vertex;
        const auto at = [&](int i) { return v[i] == c.vertex ? x : mesh.point(v[i]); };
        return isPositive(at(0), at(1), at(2), at(3));
      });
    if (stands)
    {
      mesh.movePoint(c.vertex, x);
      c.limit(level, StopReason::Refused);
      return true;
    }
  }
  return false;
}
} // namespace ransmesh
