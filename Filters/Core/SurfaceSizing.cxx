#include "SurfaceSizing.h"

#include "Layers/LayerPlanning.h"

#include "vtkCompositeDataIterator.h"
#include "vtkCompositeDataSet.h"
#include "vtkDataArray.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <array>
#include <map>
#include <sstream>

namespace ransmesh
{
namespace
{
std::vector<vtkPolyData*> leavesOf(const std::vector<vtkDataObject*>& surfaces)
{
  std::vector<vtkPolyData*> leaves;
  for (vtkDataObject* data : surfaces)
  {
    if (auto* composite = vtkCompositeDataSet::SafeDownCast(data))
    {
      auto at = vtkSmartPointer<vtkCompositeDataIterator>::Take(composite->NewIterator());
      for (at->InitTraversal(); !at->IsDoneWithTraversal(); at->GoToNextItem())
      {
        leaves.push_back(vtkPolyData::SafeDownCast(at->GetCurrentDataObject()));
      }
    }
    else
    {
      leaves.push_back(vtkPolyData::SafeDownCast(data));
    }
  }
  return leaves;
}

Outcome lengthsOfPatches(const SurfaceSizing& sizing, const PatchTable& patches, RemeshingOptions& options)
{
  options.patchLengths.assign(patches.size(), 0);
  for (const auto& [pattern, length] : sizing.lengthOfPattern)
  {
    bool taken = false;
    std::string names;
    for (std::size_t i = 1; i < patches.size(); ++i)
    {
      names += (i > 1 ? ", " : "") + patches[i].name;
      if (pattern == std::to_string(i) || matchesPattern(patches[i].name, pattern))
      {
        options.patchLengths[i] = length;
        taken = true;
      }
    }
    if (!taken)
    {
      return Outcome::badInput(
        "no patch is named '" + pattern + "' (SetPatchEdgeLength); there are: " + names);
    }
  }
  return Outcome::done();
}

// By the place: points may have been merged or left out since.
std::vector<double> lengthsOfPoints(const SurfaceSizing& sizing, const SurfaceMesh& surface)
{
  std::map<std::array<double, 3>, double> lengths;
  for (const auto& [p, length] : sizing.lengthAtPoint)
  {
    const auto [entry, isNew] = lengths.try_emplace({ p.x, p.y, p.z }, length);
    entry->second = std::min(entry->second, length);
  }
  std::vector<double> found(surface.points.size(), INFINITY);
  for (std::size_t v = 0; v < found.size(); ++v)
  {
    const Vector3& p = surface.points[v];
    if (const auto entry = lengths.find({ p.x, p.y, p.z }); entry != lengths.end())
    {
      found[v] = entry->second;
    }
  }
  return found;
}
} // namespace

Outcome readLengthsAtPoints(
  const std::vector<vtkDataObject*>& surfaces, const std::string& array, SurfaceSizing& sizing)
{
  bool isThere = false;
  for (vtkPolyData* leaf : leavesOf(surfaces))
  {
    vtkDataArray* lengths = leaf ? leaf->GetPointData()->GetArray(array.c_str()) : nullptr;
    isThere = isThere || lengths;
    for (vtkIdType i = 0; lengths && i < lengths->GetNumberOfTuples(); ++i)
    {
      std::array<double, 3> p{};
      leaf->GetPoint(i, p.data());
      if (const double length = lengths->GetComponent(i, 0); length > 0)
      {
        sizing.lengthAtPoint.emplace_back(Vector3{ p[0], p[1], p[2] }, length);
      }
    }
  }
  return isThere ? Outcome::done()
                 : Outcome::badInput("no surface has the point array '" + array + "' (SizeArray)");
}

Outcome remeshingOptions(const SurfaceSizing& sizing, const PatchTable& patches, const SurfaceMesh& surface,
  RemeshingOptions& options)
{
  options = sizing.general;
  if (Outcome outcome = lengthsOfPatches(sizing, patches, options); !outcome.ok())
  {
    return outcome;
  }
  if (!sizing.lengthAtPoint.empty())
  {
    options.pointLengths = lengthsOfPoints(sizing, surface);
  }
  const bool onlyPatches = !sizing.general.isWanted() && sizing.lengthAtPoint.empty();
  options.keptPatches.assign(patches.size(), 0);
  for (std::size_t i = 1; i < patches.size(); ++i)
  {
    options.keptPatches[i] =
      patches[i].type == PatchType::Interface || (onlyPatches && options.patchLengths[i] == 0);
  }
  return Outcome::done();
}

std::string textOf(const RemeshingReport& made)
{
  std::ostringstream text;
  text << "Remeshed: " << made.trianglesBefore << " surface triangles became " << made.trianglesAfter
       << ", which lie within " << made.largestDeviation << " of the given surface (" << made.meanDeviation
       << " in the mean), most at (" << made.deviationPlace.x << ", " << made.deviationPlace.y << ", "
       << made.deviationPlace.z << "); their smallest angle is " << made.smallestAngle << " degrees, above "
       << made.lowAngle << " for 99 % of them.";
  return text.str();
}
} // namespace ransmesh
