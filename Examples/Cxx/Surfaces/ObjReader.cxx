#include "ObjReader.h"

#include "TextScanner.h"

#include <stdexcept>

namespace surfaces
{
namespace
{
[[noreturn]] void fail(const TextScanner& scanner, const std::string& what)
{
  throw std::runtime_error("line " + std::to_string(scanner.lineNumber()) + ": " + what);
}

void readPoint(TextScanner& scanner, PatchedSurface& surface)
{
  double x[3];
  for (double& value : x)
  {
    if (!parse(scanner.word(), value))
    {
      fail(scanner, "a vertex needs three numbers");
    }
  }
  surface.addPoint(x[0], x[1], x[2]);
}

// A face's corner is "v", "v/vt", "v//vn" or "v/vt/vn"; v counts from 1, or backwards from -1.
vtkIdType cornerOf(std::string_view word, const TextScanner& scanner, vtkIdType pointCount)
{
  vtkIdType v = 0;
  if (!parse(word.substr(0, word.find('/')), v))
  {
    fail(scanner, "\"" + std::string(word) + "\" is no corner of a face");
  }
  const vtkIdType point = v < 0 ? pointCount + v : v - 1;
  if (point < 0 || point >= pointCount)
  {
    fail(scanner, "a face names vertex " + std::to_string(v) + " of " + std::to_string(pointCount));
  }
  return point;
}

void readFace(TextScanner& scanner, PatchedSurface& surface)
{
  std::vector<vtkIdType> corners;
  for (std::string_view word = scanner.word(); !word.empty(); word = scanner.word())
  {
    corners.push_back(cornerOf(word, scanner, surface.pointCount()));
  }
  if (corners.size() < 3)
  {
    fail(scanner, "a face needs at least three corners");
  }
  surface.addPolygon(corners);
}
} // namespace

void readObj(const std::string& content, PatchedSurface& surface)
{
  TextScanner scanner(content);
  std::string group = "default"; // the format's name for what stands before the first group
  while (scanner.nextLine())
  {
    const std::string_view keyword = scanner.word();
    if (keyword == "v")
    {
      readPoint(scanner, surface);
    }
    else if (keyword == "f")
    {
      surface.startPatch(group);
      readFace(scanner, surface);
    }
    else if (keyword == "g" || keyword == "o")
    {
      const std::string_view name = scanner.word(); // of several names, the first
      group = name.empty() ? "default" : std::string(name);
    }
  }
}
} // namespace surfaces
