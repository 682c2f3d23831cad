// A file or folder that is there whole or not at all: written under another name, then renamed.
#ifndef ReplacedPath_h
#define ReplacedPath_h

#include "Support/Outcome.h"

#include <string>

namespace ransmesh
{
class ReplacedPath
{
public:
  enum class Kind
  {
    File,
    MeshFolder // of OpenFOAM; another folder of that name is not replaced
  };

  // Devices and pipes are written to as they are. A link is followed.
  ReplacedPath(const std::string& target, Kind kind);
  // Removes what was written, unless commit was called.
  ~ReplacedPath();
  ReplacedPath(const ReplacedPath&) = delete;
  ReplacedPath& operator=(const ReplacedPath&) = delete;

  // What stands in the way of writing there: a folder where a file is to be, or the reverse. Makes the
  // temporary folder of a MeshFolder.
  Outcome prepare();
  // Where to write.
  const std::string& temporary() const { return temporary_; }
  // Puts what was written in its place.
  Outcome commit();

private:
  Outcome commitFolder();

  std::string asked_;
  std::string target_;
  std::string temporary_;
  Kind kind_;
  bool direct_ = false;
  bool committed_ = false;
};

// The message for a system's error number: what could not be written, why, and what can be done.
Outcome writingFailed(const std::string& path, int error);
} // namespace ransmesh

#endif
