// The whole content of a file, unpacked if it is gzipped.
#pragma once

#include <string>

namespace surfaces
{
// Throws std::runtime_error, with the file's name, where the file cannot be read.
std::string readFile(const std::string& path);

// "wing" of "parts/wing.stl.gz": what a patch is called that has no name of its own.
std::string stemOf(const std::string& path);

// ".stl" of "parts/Wing.STL.gz": in lower case, without the ".gz".
std::string extensionOf(const std::string& path);
} // namespace surfaces
