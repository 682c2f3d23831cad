// Adds parts to a request.
#pragma once

#include "Worker/Protocol.h"

#include "Geometry/Vector3.h"

namespace ransmesh
{
inline void addPolygon(worker::Request& request, const std::vector<int>& corners, int marker)
{
  if (request.offsets.empty())
  {
    request.offsets.push_back(0);
  }
  request.corners.insert(request.corners.end(), corners.begin(), corners.end());
  request.offsets.push_back(static_cast<std::int32_t>(request.corners.size()));
  request.markers.push_back(marker);
}

inline void addPoint(worker::Request& request, const Vector3& p)
{
  request.points.insert(request.points.end(), { p.x, p.y, p.z });
}
} // namespace ransmesh
