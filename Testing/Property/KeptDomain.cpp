#include "KeptDomain.h"

#include "Geometry/TetrahedronMeasures.h"
#include "Mesh/Validation.h"

#include <algorithm>
#include <cmath>

namespace kernel_driver
{
namespace
{
using namespace ransmesh;

std::vector<double> areasOf(const MeshData& data, std::size_t patches)
{
  std::vector<double> areas(patches);
  for (std::size_t t = 0; t < data.triangles.size(); ++t)
  {
    const auto& v = data.triangles[t];
    const Vector3& a = data.points[v[0]];
    areas[static_cast<std::size_t>(data.trianglePatch[t])] +=
      norm(cross(data.points[v[1]] - a, data.points[v[2]] - a)) / 2;
  }
  return areas;
}

// Whether a tetrahedron has no volume but that of rounding.
bool anyIsFlat(const MeshData& data)
{
  const auto& p = data.points;
  return std::any_of(data.tetrahedra.begin(), data.tetrahedra.end(),
    [&](const auto& v) { return quality(p[v[0]], p[v[1]], p[v[2]], p[v[3]]) < 1e-12; });
}
} // namespace

void KeptDomain::remember(const MeshData& data, const PatchTable& patches)
{
  names_.clear();
  for (const Patch& patch : patches)
  {
    names_.push_back(patch.name);
  }
  volume_ = totalVolume(data);
  areas_ = areasOf(data, names_.size());
  hadFlat_ = anyIsFlat(data);
}

// Beside tetrahedra that are flat but for rounding, which stars may make in a plane, a triangle of it may be turned
// over: areas are not compared then.
std::string KeptDomain::findChange(const MeshData& data)
{
  const auto differs = [](double now, double before) { return std::fabs(now - before) > 1e-9 * before; };
  if (const double volume = totalVolume(data); differs(volume, volume_))
  {
    return "the volume has changed from " + std::to_string(volume_) + " to " + std::to_string(volume);
  }
  const std::vector<double> areas = areasOf(data, names_.size());
  hadFlat_ = hadFlat_ || anyIsFlat(data);
  for (std::size_t i = 1; i < areas.size() && !hadFlat_; ++i)
  {
    if (differs(areas[i], areas_[i]))
    {
      return "the area of " + names_[i] + " has changed by " +
        std::to_string(1e6 * (areas[i] / areas_[i] - 1)) + " millionths";
    }
  }
  return {};
}
} // namespace kernel_driver
