// Where the worker program is.
#pragma once

#include <string>

namespace ransmesh
{
// The first that exists of: the wanted one (if not empty, nothing else is tried), the environment
// variable RANSMESH_WORKER, the places beside the library in the build and install trees, PATH.
// Empty, with the places tried in `tried`, if there is none.
std::string findWorker(const std::string& wanted, std::string& tried);
} // namespace ransmesh
