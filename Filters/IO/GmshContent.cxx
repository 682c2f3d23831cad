// The format: gmsh reference manual, "MSH file format" and "MSH file format version 2 (Legacy)".
#include "GmshContent.h"

#include "GmshCursor.h"

#include <cstdio>
#include <cstdlib>
#include <limits>
#include <unordered_map>

namespace ransmesh
{
namespace
{
struct Shape
{
  int corners;
  int points;
};

// By gmsh's numbers: lines, triangles, quadrilaterals, tetrahedra, hexahedra, prisms, pyramids, points.
Shape shapeOf(int type)
{
  constexpr std::array<Shape, 20> shapes = { { { 0, 0 }, { 2, 2 }, { 3, 3 }, { 4, 4 }, { 4, 4 }, { 8, 8 },
    { 6, 6 }, { 5, 5 }, { 2, 3 }, { 3, 6 }, { 4, 9 }, { 4, 10 }, { 8, 27 }, { 6, 18 }, { 5, 14 }, { 1, 1 },
    { 4, 8 }, { 8, 20 }, { 6, 15 }, { 5, 13 } } };
  return type > 0 && type < static_cast<int>(shapes.size()) ? shapes[type] : Shape{ 0, 0 };
}

class GmshReader
{
public:
  explicit GmshReader(std::string_view file)
    : at_(file)
  {
  }

  GmshContent read()
  {
    bool hasFormat = false;
    for (std::string section = at_.nextSection(); !section.empty(); section = at_.nextSection())
    {
      if (section == "MeshFormat")
      {
        readFormat();
        hasFormat = true;
      }
      else if (!hasFormat)
      {
        throw std::runtime_error("it does not begin with $MeshFormat");
      }
      else if (!section.starts_with("End"))
      {
        readSection(section);
      }
    }
    if (content_.points.empty() || content_.elements.empty())
    {
      throw std::runtime_error("it holds no mesh");
    }
    return std::move(content_);
  }

private:
  void readFormat()
  {
    version_ = at_.word<double>();
    const int type = at_.word<int>();
    at_.line();
    if (!(version_ >= 2 && version_ < 2.3) && !(version_ > 4.05 && version_ < 4.2))
    {
      throw std::runtime_error("its format is " + std::to_string(version_) +
        "; 2.2 and 4.1 can be read: save it by gmsh -save -format msh41");
    }
    at_.setBinary(type == 1);
    if (at_.isBinary() && at_.next<std::int32_t>() != 1)
    {
      throw std::runtime_error("it comes from a machine with another order of bytes");
    }
    at_.leave("MeshFormat");
  }

  void readSection(const std::string& section)
  {
    const bool isNew = version_ > 4;
    if (section == "PhysicalNames")
    {
      readNames();
    }
    else if (section == "Comments")
    {
      readComments();
    }
    else if (section == "Entities" && isNew)
    {
      readEntities();
    }
    else if (section == "Nodes")
    {
      isNew ? readPointBlocks() : readPoints();
    }
    else if (section == "Elements")
    {
      isNew ? readElementBlocks() : readElements();
    }
    at_.leave(section);
  }

  // Always text.
  void readNames()
  {
    const auto count = at_.word<int>();
    at_.line();
    for (int i = 0; i < count; ++i)
    {
      const auto dimension = at_.word<int>();
      const auto number = at_.word<int>();
      const std::string quoted = at_.line();
      const std::size_t first = quoted.find('"');
      const std::size_t last = quoted.rfind('"');
      if (first != std::string::npos && last > first)
      {
        content_.names[{ dimension, number }] = quoted.substr(first + 1, last - first - 1);
      }
    }
  }

  // Lines "patch 3: symmetry" among others.
  void readComments()
  {
    for (std::string line = at_.peekLine(); !line.empty() && line[0] != '$'; line = at_.peekLine())
    {
      int number = 0;
      std::array<char, 32> type{};
      if (std::sscanf(line.c_str(), "patch %d: %31s", &number, type.data()) == 2)
      {
        content_.types[number] = type.data();
      }
      at_.line();
    }
  }

  void addPoint(std::uint64_t tag)
  {
    numberOf_[tag] = static_cast<std::int64_t>(content_.points.size());
    auto& x = content_.points.emplace_back();
    for (double& coordinate : x)
    {
      coordinate = at_.next<double>();
    }
  }

  void readPoints()
  {
    const auto count = static_cast<std::size_t>(at_.word<std::int64_t>());
    at_.line();
    for (std::size_t i = 0; i < count; ++i)
    {
      addPoint(static_cast<std::uint64_t>(at_.next<std::int32_t>()));
    }
  }

  void readPointBlocks()
  {
    const std::size_t blocks = at_.count<std::int64_t>(8);
    skip(3);
    for (std::size_t b = 0; b < blocks; ++b)
    {
      const auto dimension = at_.next<std::int32_t>();
      at_.next<std::int32_t>();
      const bool isParametric = at_.next<std::int32_t>() != 0;
      std::vector<std::uint64_t> tags(at_.count<std::int64_t>(2));
      for (auto& tag : tags)
      {
        tag = static_cast<std::uint64_t>(at_.next<std::int64_t>());
      }
      for (const auto tag : tags)
      {
        addPoint(tag);
        for (int i = 0; isParametric && i < dimension; ++i)
        {
          at_.next<double>();
        }
      }
    }
  }

  void skip(int sizes)
  {
    for (int i = 0; i < sizes; ++i)
    {
      at_.next<std::int64_t>();
    }
  }

  // Which entity belongs to which physical group.
  void readEntities()
  {
    std::array<std::size_t, 4> counts{};
    for (auto& count : counts)
    {
      count = at_.count<std::int64_t>(8);
    }
    for (int dimension = 0; dimension < 4; ++dimension)
    {
      for (std::size_t i = 0; i < counts[dimension]; ++i)
      {
        const auto tag = at_.next<std::int32_t>();
        for (int k = 0; k < (dimension == 0 ? 3 : 6); ++k)
        {
          at_.next<double>();
        }
        const std::size_t groups = at_.count<std::int64_t>(1);
        for (std::size_t k = 0; k < groups; ++k)
        {
          const auto group = std::abs(at_.next<std::int32_t>());
          physicalOf_.try_emplace({ dimension, tag }, group);
        }
        const std::size_t bounds = dimension > 0 ? at_.count<std::int64_t>(1) : 0;
        for (std::size_t k = 0; k < bounds; ++k)
        {
          at_.next<std::int32_t>();
        }
      }
    }
  }

  std::int64_t pointOf(std::uint64_t tag) const
  {
    const auto found = numberOf_.find(tag);
    if (found == numberOf_.end())
    {
      throw std::runtime_error("an element names point " + std::to_string(tag) + ", which is not there");
    }
    return found->second;
  }

  template <class Tag>
  void addElement(GmshElement element)
  {
    const Shape shape = shapeOf(element.type);
    for (int i = 0; i < shape.points; ++i)
    {
      const auto tag = static_cast<std::uint64_t>(at_.next<Tag>());
      if (i < shape.corners)
      {
        element.points[i] = pointOf(tag);
      }
    }
    content_.elements.push_back(element);
  }

  static void checkType(int type)
  {
    if (shapeOf(type).points == 0)
    {
      throw std::runtime_error(
        "it has elements of gmsh's type " + std::to_string(type) + ", of a high order: save it with order 1");
    }
  }

  void readElementBlocks()
  {
    const std::size_t blocks = at_.count<std::int64_t>(8);
    skip(3);
    for (std::size_t b = 0; b < blocks; ++b)
    {
      GmshElement element;
      const auto dimension = at_.next<std::int32_t>();
      element.elementary = at_.next<std::int32_t>();
      element.type = at_.next<std::int32_t>();
      checkType(element.type);
      const auto group = physicalOf_.find({ dimension, element.elementary });
      element.physical = group == physicalOf_.end() ? 0 : group->second;
      const std::size_t count = at_.count<std::int64_t>(2);
      for (std::size_t i = 0; i < count; ++i)
      {
        at_.next<std::int64_t>();
        addElement<std::int64_t>(element);
      }
    }
  }

  // Text: each element with its tags; binary: tags' number and the type once for several.
  void readElements()
  {
    const auto total = static_cast<std::size_t>(at_.word<std::int64_t>());
    at_.line();
    for (std::size_t read = 0; read < total;)
    {
      GmshElement element;
      std::size_t several = 1;
      if (!at_.isBinary())
      {
        at_.next<std::int32_t>();
      }
      element.type = at_.next<std::int32_t>();
      checkType(element.type);
      if (at_.isBinary())
      {
        several = at_.count<std::int32_t>(4);
      }
      const auto tags = at_.next<std::int32_t>();
      for (std::size_t i = 0; i < several; ++i, ++read)
      {
        if (at_.isBinary())
        {
          at_.next<std::int32_t>();
        }
        for (int k = 0; k < tags; ++k)
        {
          const auto tag = at_.next<std::int32_t>();
          element.physical = k == 0 ? std::abs(tag) : element.physical;
          element.elementary = k == 1 ? tag : element.elementary;
        }
        addElement<std::int32_t>(element);
      }
      if (several == 0)
      {
        throw std::runtime_error("a block of elements is empty");
      }
    }
  }

  GmshCursor at_;
  GmshContent content_;
  double version_ = 0;
  std::unordered_map<std::uint64_t, std::int64_t> numberOf_; // of points
  std::map<std::pair<int, int>, int> physicalOf_;            // of (dimension, entity)
};
} // namespace

int gmshCorners(int type)
{
  return shapeOf(type).corners;
}

GmshContent readGmsh(std::string_view file)
{
  return GmshReader(file).read();
}
} // namespace ransmesh
