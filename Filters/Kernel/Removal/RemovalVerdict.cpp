#include "Removal/RemovalVerdict.h"

namespace ransmesh
{
const char* nameOf(RemovalVerdict verdict)
{
  switch (verdict)
  {
    case RemovalVerdict::Collapsed:
      return "collapsed";
    case RemovalVerdict::RemovedWithCavity:
      return "removed with an enlarged cavity";
    case RemovalVerdict::Absorbed:
      return "absorbed by another removal";
    case RemovalVerdict::LowQuality:
      return "quality too low";
    case RemovalVerdict::OverLarge:
      return "element too large";
    case RemovalVerdict::SurfaceTurned:
      return "surface turned";
    case RemovalVerdict::SurfaceMoved:
      return "surface moved";
    case RemovalVerdict::PoorTriangle:
      return "wall triangle too poor";
    case RemovalVerdict::RidgeLost:
      return "ridge lost";
    case RemovalVerdict::VertexLost:
      return "other point lost";
    case RemovalVerdict::NotStarrable:
      return "not starrable";
    default:
      return "unknown";
  }
}
} // namespace ransmesh
