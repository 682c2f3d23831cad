// A folder of its own for files that live as long as this object.
#pragma once

#include <filesystem>
#include <string>

#include <stdlib.h>

namespace ransmesh
{
class TemporaryFolder
{
public:
  TemporaryFolder()
  {
    std::error_code error;
    std::string pattern = (std::filesystem::temp_directory_path(error) / "ransmesh-XXXXXX").string();
    if (!error && mkdtemp(pattern.data()))
    {
      path_ = pattern;
    }
  }
  ~TemporaryFolder()
  {
    std::error_code ignored;
    if (ok())
    {
      std::filesystem::remove_all(path_, ignored);
    }
  }
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;

  bool ok() const { return !path_.empty(); }
  std::string file(const char* name) const { return path_ + "/" + name; }

private:
  std::string path_;
};
} // namespace ransmesh
