#include "PatchLabels.h"

#include <algorithm>
#include <set>

namespace ransmesh
{
namespace
{
bool isLetterOrDigit(char c)
{
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9');
}

template <class Named>
std::vector<std::string> labelsOf(const std::vector<Named>& things, std::string_view allowed,
  std::size_t longest, std::set<std::string> taken)
{
  std::vector<std::string> labels;
  for (const Named& thing : things)
  {
    std::string name = thing.name.substr(0, longest);
    std::replace_if(
      name.begin(), name.end(),
      [allowed](char c) { return !isLetterOrDigit(c) && allowed.find(c) == std::string_view::npos; }, '_');
    std::string label = name;
    for (int number = 2; !taken.insert(label).second; ++number)
    {
      const std::string end = "_" + std::to_string(number);
      label = name.substr(0, longest - end.size()) + end;
    }
    labels.push_back(label);
  }
  return labels;
}
} // namespace

std::vector<std::string> patchLabels(
  const std::vector<BoundaryPatch>& patches, std::string_view allowed, std::size_t longest)
{
  return labelsOf(patches, allowed, longest, {});
}

std::vector<std::string> regionLabels(const std::vector<Region>& regions, std::string_view allowed,
  std::size_t longest, const std::vector<std::string>& taken)
{
  return labelsOf(regions, allowed, longest, { taken.begin(), taken.end() });
}
} // namespace ransmesh
