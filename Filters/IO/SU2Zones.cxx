#include "SU2Zones.h"

#include "FaceChains.h"
#include "PatchLabels.h"

#include <algorithm>
#include <set>

namespace ransmesh
{
namespace
{
constexpr std::string_view Allowed = "_-.+";

// Do two faces of the same points run the same way round?
bool turnAlike(const Corners& a, const Face& b)
{
  const auto at = std::find(b.begin(), b.end(), a[0]) - b.begin();
  return b.points[(at + 1) % b.count] == a[1];
}
} // namespace

SU2Zones::SU2Zones(const MeshView& mesh)
  : mesh_(mesh)
  , labels_(patchLabels(mesh.patches(), Allowed))
  , regionLabels_(regionLabels(mesh.regions(), Allowed))
{
}

Outcome SU2Zones::prepare()
{
  if (size() == 1)
  {
    return Outcome::done();
  }
  noteFaces();
  for (const BoundaryPatch& patch : mesh_.patches())
  {
    for (vtkIdType f = patch.first; f < patch.first + patch.count(); ++f)
    {
      const auto& [own, other] = sides_[f];
      if (own == NoRegion && other == NoRegion)
      {
        return Outcome::badInput(
          "the mesh is not conforming: a face of patch " + patch.name + " is no cell's face");
      }
      if (own == other)
      {
        return Outcome::badInput("patch " + patch.name + " divides regions in one part and lies inside of " +
          mesh_.regions()[own].name +
          " in another: give that part a patch of its own, or write a polyMesh, .cgns or "
          ".msh");
      }
    }
  }
  return Outcome::done();
}

// Which region's cells lie on which side of each boundary face.
void SU2Zones::noteFaces()
{
  sides_.assign(mesh_.numberOfFaces(), { NoRegion, NoRegion });
  FaceChains faces;
  faces.reset(mesh_.numberOfPoints(), mesh_.numberOfFaces());
  for (vtkIdType f = 0; f < mesh_.numberOfFaces(); ++f)
  {
    faces.insert(keyOf(mesh_.face(f)), static_cast<std::uint32_t>(f));
  }
  for (vtkIdType c = 0; c < mesh_.numberOfCells(); ++c)
  {
    const Corners cell = mesh_.cell(c);
    for (int i = 0; i < facesOf(cell.kind); ++i)
    {
      const Face face = faceOf(cell, i);
      const std::uint32_t found = faces.find(keyOf(face));
      if (found != FaceChains::None)
      {
        sides_[found][turnAlike(mesh_.face(found), face) ? 0 : 1] = mesh_.regionOf(c);
      }
    }
  }
}

// A dividing patch is a marker on either side, and the names differ.
std::string SU2Zones::labelIn(std::size_t patch, std::size_t region) const
{
  return mesh_.patches()[patch].inside ? labels_[patch] + "_" + regionLabels_[region] : labels_[patch];
}

SU2Zone SU2Zones::zone(std::size_t region) const
{
  SU2Zone zone;
  zone.label = regionLabels_[region];
  zone.region = region;
  zone.cells = mesh_.regions()[region].count();
  zone.points = mesh_.numberOfPoints();
  if (size() > 1)
  {
    numberPoints(zone);
  }
  addMarkers(zone);
  return zone;
}

void SU2Zones::numberPoints(SU2Zone& zone) const
{
  zone.pointNumbers.assign(mesh_.numberOfPoints(), -1);
  for (vtkIdType c = 0; c < mesh_.numberOfCells(); ++c)
  {
    if (mesh_.regionOf(c) == zone.region)
    {
      const Corners cell = mesh_.unturnedCell(c);
      std::for_each(cell.begin(), cell.end(), [&zone](vtkIdType p) { zone.pointNumbers[p] = 0; });
    }
  }
  zone.points = 0;
  for (vtkIdType& number : zone.pointNumbers)
  {
    number = number == 0 ? zone.points++ : -1;
  }
}

void SU2Zones::addMarkers(SU2Zone& zone) const
{
  for (std::size_t p = 0; p < labels_.size(); ++p)
  {
    const BoundaryPatch& patch = mesh_.patches()[p];
    SU2Marker marker{ labelIn(p, zone.region), patch.type, {} };
    for (vtkIdType f = patch.first; f < patch.first + patch.count(); ++f)
    {
      const bool isBehind = size() == 1 || sides_[f][0] == zone.region;
      if (isBehind || sides_[f][1] == zone.region)
      {
        marker.faces.emplace_back(f, !isBehind);
      }
    }
    if (!marker.faces.empty())
    {
      zone.markers.push_back(std::move(marker));
    }
  }
}

std::vector<std::pair<std::string, std::string>> SU2Zones::interfaces() const
{
  std::set<std::pair<std::string, std::string>> pairs;
  for (std::size_t p = 0; p < labels_.size(); ++p)
  {
    const BoundaryPatch& patch = mesh_.patches()[p];
    for (vtkIdType f = patch.first; patch.inside && f < patch.first + patch.count(); ++f)
    {
      const auto [low, high] = std::minmax(sides_[f][0], sides_[f][1]);
      pairs.emplace(labelIn(p, low), labelIn(p, high));
    }
  }
  return { pairs.begin(), pairs.end() };
}
} // namespace ransmesh
