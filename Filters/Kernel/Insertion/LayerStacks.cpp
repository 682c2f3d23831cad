#include "Insertion/LayerStacks.h"

namespace ransmesh
{
ColumnPoints::ColumnPoints(const ColumnSet& set, const std::vector<Index>& baseNumber, std::size_t firstNew)
{
  std::size_t next = firstNew;
  for (const Column& c : set.columns)
  {
    base_.push_back(baseNumber[c.root]);
    first_.push_back(static_cast<Index>(next));
    top_.push_back(c.ownsTop() ? baseNumber[c.vertex] : static_cast<Index>(next) + c.levels - 1);
    levels_.push_back(c.levels);
    next += static_cast<std::size_t>(c.ownsTop() ? c.levels - 1 : c.levels);
  }
  count_ = next - firstNew;
}

Stack stackOf(const ColumnSet& set, const BaseFace& face)
{
  Stack stack{ face.root, {}, face.rise, face.firstRise };
  for (int j = 0; j < 3; ++j)
  {
    stack.levels[j] = face.column[j] == None ? 0 : set.columns[face.column[j]].levels;
  }
  return stack;
}

// The new tetrahedron's faces in the sides: each has the risen point, the one below it, and a corner.
void StackWriter::writeSides(
  const std::array<int, 3>& sideOpposite, const std::array<Index, 3>& current, int corner, Index risen)
{
  for (int step = 1; step <= 2; ++step)
  {
    const int other = (corner + step) % 3;
    const int opposite = 3 - corner - other;
    if (sideOpposite[opposite] == 0)
    {
      continue;
    }
    const bool otherFollows = step == 1;
    const Index a = otherFollows ? current[other] : current[corner];
    const Index b = otherFollows ? current[corner] : current[other];
    sink_.sideTriangles.push_back({ b, a, risen });
    sink_.sidePatch.push_back(sideOpposite[opposite]);
  }
}

std::size_t countTets(const Stack& stack)
{
  const bool hasBase =
    stack.root[0] != stack.root[1] && stack.root[1] != stack.root[2] && stack.root[2] != stack.root[0];
  if (hasBase)
  {
    return static_cast<std::size_t>(stack.levels[0]) + static_cast<std::size_t>(stack.levels[1]) +
      static_cast<std::size_t>(stack.levels[2]);
  }
  std::size_t count = 0;
  forEachRise(stack, [&count](int, int, bool isFlat) { count += isFlat ? 0 : 1; });
  return count;
}
} // namespace ransmesh
