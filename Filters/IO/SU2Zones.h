// A mesh as SU2's files hold it: a zone for each region, each with points and markers of its own.
#ifndef SU2Zones_h
#define SU2Zones_h

#include "MeshView.h"

#include <string>
#include <utility>
#include <vector>

namespace ransmesh
{
struct SU2Marker
{
  std::string label;
  PatchType type = PatchType::Patch;
  std::vector<std::pair<vtkIdType, bool>> faces; // the view's; true: to be turned over, to point outward
};

struct SU2Zone
{
  std::string label;
  std::size_t region = 0;
  vtkIdType cells = 0;
  vtkIdType points = 0;
  std::vector<vtkIdType>
    pointNumbers; // of the mesh's points, -1 for those of other zones; empty: as they are
  std::vector<SU2Marker> markers;
};

class SU2Zones
{
public:
  explicit SU2Zones(const MeshView& mesh);

  // BadInput where a patch that is to divide regions has one region on both sides somewhere, or is no cell's face.
  Outcome prepare();
  std::size_t size() const { return mesh_.regions().size(); }
  // To be called after prepare.
  SU2Zone zone(std::size_t region) const;
  // The labels of each dividing patch on its two sides.
  std::vector<std::pair<std::string, std::string>> interfaces() const;

private:
  static constexpr std::size_t NoRegion = -1;
  void noteFaces();
  std::string labelIn(std::size_t patch, std::size_t region) const;
  void numberPoints(SU2Zone& zone) const;
  void addMarkers(SU2Zone& zone) const;

  const MeshView& mesh_;
  std::vector<std::string> labels_; // of the patches
  std::vector<std::string> regionLabels_;
  std::vector<std::array<std::size_t, 2>>
    sides_; // of faces: the region that they point out of, and the other
};
} // namespace ransmesh

#endif
