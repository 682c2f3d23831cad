#include "Quality/SheetAssessment.h"

#include "Boundary/Sheets.h"

#include <algorithm>

namespace ransmesh
{
namespace
{
bool hasLayeredSheets(const ReportSubject& subject, const FaceMatching& matching)
{
  return std::any_of(matching.sheets.begin(), matching.sheets.end(),
    [&subject](const SheetFace& sheet)
    {
      const auto patch = static_cast<std::size_t>(subject.mesh.trianglePatch[sheet.triangle]);
      return patch < subject.plan.size() && subject.plan[patch].hasLayers();
    });
}

// A point is on a column if one of its copies is.
std::vector<char> closedMarks(
  const MeshData& mesh, const MeshData& open, const OpenedSheets& sheets, const std::vector<char>& marks)
{
  std::vector<char> closed(mesh.points.size(), 0);
  for (std::size_t v = 0; v < marks.size(); ++v)
  {
    const Index origin = sheets.origin[v];
    const bool isCopy = open.points[v] == mesh.points[origin]; // else it divides an edge
    closed[origin] = closed[origin] || (isCopy && marks[v]);
  }
  return closed;
}
} // namespace

WallAssessment assessBothSides(const ReportSubject& subject, const FaceMatching& matching,
  const std::vector<HalfFace>& innerFaces, const ReportOptions& options, const Context& context)
{
  MeshData open;
  OpenedSheets sheets;
  if (hasLayeredSheets(subject, matching))
  {
    open = subject.mesh;
  }
  if (open.points.empty() || !openSheets(open, sheets).ok())
  {
    return assessWalls(subject, innerFaces, options, context);
  }
  const ReportSubject opened{ open, subject.patches, subject.plan };
  WallAssessment result = assessWalls(opened, innerFacesOf(open, matchFaces(open)), options, context);
  result.onColumn = closedMarks(subject.mesh, open, sheets, result.onColumn);
  return result;
}
} // namespace ransmesh
