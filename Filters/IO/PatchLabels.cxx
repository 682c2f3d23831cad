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
} // namespace

std::vector<std::string> patchLabels(
  const std::vector<BoundaryPatch>& patches, std::string_view allowed, std::size_t longest)
{
  std::vector<std::string> labels;
  std::set<std::string> taken;
  for (const BoundaryPatch& patch : patches)
  {
    std::string name = patch.name.substr(0, longest);
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
} // namespace ransmesh
