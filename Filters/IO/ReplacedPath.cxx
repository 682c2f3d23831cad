#include "ReplacedPath.h"

#include <cerrno>
#include <filesystem>
#include <system_error>
#include <unistd.h>

namespace ransmesh
{
namespace fs = std::filesystem;

namespace
{
std::string beside(const fs::path& target, const char* what)
{
  const std::string name = "." + target.filename().string() + "." + what + std::to_string(getpid());
  return (target.parent_path() / name).string();
}

bool isMeshFolder(const fs::path& folder)
{
  std::error_code error;
  return fs::is_empty(folder, error) || fs::exists(folder / "points", error) ||
    fs::exists(folder / "points.gz", error);
}

fs::path withoutTrailingSlash(const std::string& path)
{
  const fs::path given(path);
  return given.has_filename() ? given : given.parent_path();
}
} // namespace

Outcome writingFailed(const std::string& path, int error)
{
  std::string remedy;
  switch (error)
  {
    case ENOSPC:
    case EDQUOT:
    case EFBIG:
      remedy = "; make room, or choose another disk";
      break;
    case EACCES:
    case EPERM:
    case EROFS:
      remedy = "; choose a folder that you may write to";
      break;
    case ENOENT:
    case ENOTDIR:
      remedy = "; make the folder first";
      break;
    default:
      break;
  }
  return Outcome::badInput(path + ": could not be written: " +
    (error ? std::generic_category().message(error) : std::string("unknown reason")) + remedy);
}

ReplacedPath::ReplacedPath(const std::string& target, Kind kind)
  : asked_(target)
  , target_(withoutTrailingSlash(target).string())
  , kind_(kind)
{
  std::error_code error;
  if (fs::is_symlink(target_, error))
  {
    const fs::path followed = fs::weakly_canonical(target_, error);
    target_ = error ? target_ : followed.string();
  }
  const fs::file_status status = fs::status(target_, error);
  direct_ = kind == Kind::File && fs::exists(status) && !fs::is_regular_file(status);
  temporary_ = direct_ ? target_ : beside(target_, "");
}

ReplacedPath::~ReplacedPath()
{
  if (!committed_ && !direct_)
  {
    std::error_code ignored;
    fs::remove_all(temporary_, ignored);
  }
}

Outcome ReplacedPath::prepare()
{
  std::error_code error;
  const bool folder = fs::is_directory(target_, error);
  if (kind_ == Kind::File)
  {
    return folder ? Outcome::badInput(asked_ + ": is a folder; name a file") : Outcome::done();
  }
  if (fs::exists(target_, error) && !folder)
  {
    return Outcome::badInput(asked_ + ": is a file; name a folder, or remove it");
  }
  if (folder && !isMeshFolder(target_))
  {
    return Outcome::badInput(asked_ + ": holds other things than a mesh; name another folder, or empty it");
  }
  const fs::path parent = fs::path(target_).parent_path();
  if (!parent.empty())
  {
    fs::create_directories(parent, error);
  }
  if (!error)
  {
    fs::create_directory(temporary_, error);
  }
  return error ? writingFailed(asked_, error.value()) : Outcome::done();
}

Outcome ReplacedPath::commit()
{
  if (direct_)
  {
    return Outcome::done();
  }
  if (kind_ == Kind::MeshFolder)
  {
    return commitFolder();
  }
  std::error_code error;
  fs::rename(temporary_, target_, error);
  committed_ = !error;
  return error ? writingFailed(asked_, error.value()) : Outcome::done();
}

// A folder cannot be renamed onto one that holds something: the old one goes aside first.
Outcome ReplacedPath::commitFolder()
{
  std::error_code error;
  const std::string old = beside(target_, "old");
  const bool replaces = fs::exists(target_, error);
  if (replaces)
  {
    fs::rename(target_, old, error);
  }
  if (!error)
  {
    fs::rename(temporary_, target_, error);
  }
  if (error)
  {
    std::error_code ignored;
    if (replaces && !fs::exists(target_, ignored))
    {
      fs::rename(old, target_, ignored);
    }
    return writingFailed(asked_, error.value());
  }
  committed_ = true;
  if (replaces)
  {
    fs::remove_all(old, error);
  }
  return Outcome::done();
}
} // namespace ransmesh
