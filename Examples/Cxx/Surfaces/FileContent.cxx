#include "FileContent.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <stdexcept>

#include <zlib.h>

namespace surfaces
{
namespace
{
std::string lowered(std::string text)
{
  std::transform(text.begin(), text.end(), text.begin(), [](unsigned char c) { return std::tolower(c); });
  return text;
}

std::filesystem::path withoutGz(const std::string& path)
{
  std::filesystem::path name = std::filesystem::path(path).filename();
  return lowered(name.extension().string()) == ".gz" ? name.stem() : name;
}
} // namespace

std::string readFile(const std::string& path)
{
  if (std::filesystem::is_directory(path))
  {
    throw std::runtime_error(path + ": is a folder, not a surface file");
  }
  gzFile file = gzopen(path.c_str(), "rb"); // reads files that are not packed as they are
  if (!file)
  {
    throw std::runtime_error(path + ": cannot be opened: " + std::strerror(errno));
  }
  std::string content;
  std::array<char, 1 << 16> block;
  int count = 0;
  while ((count = gzread(file, block.data(), block.size())) > 0)
  {
    content.append(block.data(), count);
  }
  const bool isClosed = gzclose(file) == Z_OK; // it knows of an end too early
  if (count != 0 || !isClosed)
  {
    throw std::runtime_error(path + ": is damaged: it cannot be unpacked to its end");
  }
  return content;
}

std::string stemOf(const std::string& path)
{
  return withoutGz(path).stem().string();
}

std::string extensionOf(const std::string& path)
{
  return lowered(withoutGz(path).extension().string());
}
} // namespace surfaces
