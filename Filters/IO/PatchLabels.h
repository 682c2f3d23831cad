// Patch names as a file format allows them.
#ifndef PatchLabels_h
#define PatchLabels_h

#include "MeshView.h"

#include <string>
#include <string_view>
#include <vector>

namespace ransmesh
{
// One label for each of the patches, all different: characters that are not letters, digits or one of `allowed`
// become underscores, a name longer than `longest` is cut, and a name that is there already gets a number.
std::vector<std::string> patchLabels(
  const std::vector<BoundaryPatch>& patches, std::string_view allowed, std::size_t longest = 1000);
// The same of the regions, which differ from the labels that are taken, too.
std::vector<std::string> regionLabels(const std::vector<Region>& regions, std::string_view allowed,
  std::size_t longest = 1000, const std::vector<std::string>& taken = {});
} // namespace ransmesh

#endif
