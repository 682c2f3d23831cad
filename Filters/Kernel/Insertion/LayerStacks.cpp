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

namespace
{
class StackWriter
{
public:
  StackWriter(
    const ColumnSet& set, const ColumnPoints& numbers, const std::vector<Index>& baseNumber, StackSink& sink)
    : set_(set)
    , numbers_(numbers)
    , baseNumber_(baseNumber)
    , sink_(sink)
  {
  }

  void write(const BaseFace& face)
  {
    std::array<Index, 3> current;
    for (int j = 0; j < 3; ++j)
    {
      current[j] = baseNumber_[face.root[j]];
    }
    int level = -1;
    forEachRise(set_, face,
      [&](int below, int corner, bool isFlat)
      {
        prism_ += below != level;
        level = below;
        const Index risen = numbers_.at(face.column[corner], below + 1);
        if (isFlat)
        {
          current[corner] = risen;
          return;
        }
        sink_.tetrahedra.push_back({ current[0], current[1], current[2], risen });
        sink_.layer.push_back(below + 1);
        sink_.prism.push_back(prism_);
        writeSides(face, current, corner, risen);
        current[corner] = risen;
      });
  }

private:
  // The new tetrahedron's faces in the sides: each has the risen point, the one below it, and a corner.
  void writeSides(const BaseFace& face, const std::array<Index, 3>& current, int corner, Index risen)
  {
    for (int step = 1; step <= 2; ++step)
    {
      const int other = (corner + step) % 3;
      const int opposite = 3 - corner - other;
      if (face.sideOpposite[opposite] == 0)
      {
        continue;
      }
      const bool otherFollows = step == 1;
      const Index a = otherFollows ? current[other] : current[corner];
      const Index b = otherFollows ? current[corner] : current[other];
      sink_.sideTriangles.push_back({ b, a, risen });
      sink_.sidePatch.push_back(face.sideOpposite[opposite]);
    }
  }

  const ColumnSet& set_;
  const ColumnPoints& numbers_;
  const std::vector<Index>& baseNumber_;
  StackSink& sink_;
  Index prism_ = -1;
};
} // namespace

std::size_t countStackTets(const ColumnSet& set, const std::vector<BaseFace>& faces)
{
  std::size_t count = 0;
  for (const BaseFace& face : faces)
  {
    if (!face.hasBase())
    {
      forEachRise(set, face, [&count](int, int, bool isFlat) { count += isFlat ? 0 : 1; });
      continue;
    }
    for (const Index c : face.column)
    {
      count += c == None ? 0 : static_cast<std::size_t>(set.columns[c].levels);
    }
  }
  return count;
}

void writeStacks(const ColumnSet& set, const std::vector<BaseFace>& faces, const ColumnPoints& numbers,
  const std::vector<Index>& baseNumber, StackSink& sink)
{
  const std::size_t count = sink.tetrahedra.size() + countStackTets(set, faces);
  sink.tetrahedra.reserve(count);
  sink.layer.reserve(count);
  sink.prism.reserve(count);
  StackWriter writer(set, numbers, baseNumber, sink);
  for (const BaseFace& face : faces)
  {
    writer.write(face);
  }
}
} // namespace ransmesh
