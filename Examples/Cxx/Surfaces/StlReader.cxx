#include "StlReader.h"

#include "TextScanner.h"

#include <cstdint>
#include <cstring>
#include <stdexcept>

namespace surfaces
{
namespace
{
constexpr std::size_t headerSize = 84; // 80 of text, 4 for the number of triangles
constexpr std::size_t recordSize = 50; // normal, three points, two bytes

std::uint32_t triangleCount(const std::string& content)
{
  std::uint32_t count = 0;
  std::memcpy(&count, content.data() + headerSize - sizeof count, sizeof count);
  return count;
}

// Binary files may start with "solid" too: the size decides first.
bool isBinary(const std::string& content)
{
  if (content.size() < headerSize)
  {
    return false;
  }
  return content.size() == headerSize + recordSize * triangleCount(content) ||
    content.compare(0, 5, "solid") != 0;
}

void readBinary(const std::string& content, PatchedSurface& surface)
{
  const std::size_t count = triangleCount(content);
  if (content.size() < headerSize + recordSize * count)
  {
    throw std::runtime_error(
      "the file says " + std::to_string(count) + " triangles but ends before the last");
  }
  surface.startPatch("solid");
  for (std::size_t i = 0; i < count; ++i)
  {
    float x[12];
    std::memcpy(x, content.data() + headerSize + recordSize * i, sizeof x);
    const vtkIdType a = surface.addPoint(x[3], x[4], x[5]);
    const vtkIdType b = surface.addPoint(x[6], x[7], x[8]);
    const vtkIdType c = surface.addPoint(x[9], x[10], x[11]);
    surface.addPolygon({ a, b, c });
  }
}

vtkIdType readVertex(TextScanner& scanner, PatchedSurface& surface)
{
  double x[3];
  for (double& value : x)
  {
    if (!parse(scanner.word(), value))
    {
      throw std::runtime_error(
        "line " + std::to_string(scanner.lineNumber()) + ": a vertex needs three numbers");
    }
  }
  return surface.addPoint(x[0], x[1], x[2]);
}

void readText(const std::string& content, PatchedSurface& surface)
{
  TextScanner scanner(content);
  std::vector<vtkIdType> corners;
  int solids = 0;
  while (scanner.nextLine())
  {
    const std::string_view keyword = scanner.word();
    if (keyword == "solid")
    {
      ++solids;
      const std::string name(scanner.rest());
      surface.startPatch(name.empty() ? "solid_" + std::to_string(solids) : name);
    }
    else if (keyword == "vertex")
    {
      corners.push_back(readVertex(scanner, surface));
    }
    else if (keyword == "endloop")
    {
      if (corners.size() < 3)
      {
        throw std::runtime_error(
          "line " + std::to_string(scanner.lineNumber()) + ": a facet needs three vertices");
      }
      surface.addPolygon(corners);
      corners.clear();
    }
  }
  if (solids == 0 || !corners.empty())
  {
    throw std::runtime_error(solids == 0 ? "is no STL file" : "ends in the middle of a facet");
  }
}
} // namespace

void readStl(const std::string& content, PatchedSurface& surface)
{
  if (isBinary(content))
  {
    readBinary(content, surface);
  }
  else
  {
    readText(content, surface);
  }
}
} // namespace surfaces
