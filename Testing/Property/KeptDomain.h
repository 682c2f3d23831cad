// What operators must not change: the domain and its patches, where these lie in planes.
#pragma once

#include "Mesh/MeshData.h"
#include "Support/Patch.h"

#include <string>
#include <vector>

namespace kernel_driver
{
class KeptDomain
{
public:
  // The mesh as it is to stay.
  void remember(const ransmesh::MeshData& data, const ransmesh::PatchTable& patches);
  // What has changed since then, or nothing.
  std::string findChange(const ransmesh::MeshData& data);

private:
  std::vector<std::string> names_; // by patch
  std::vector<double> areas_;      // by patch
  double volume_ = 0;
  bool hadFlat_ = false; // some tetrahedron since then has been flat but for rounding
};
} // namespace kernel_driver
