#include "OutputFile.h"

#include <algorithm>
#include <cerrno>
#include <fcntl.h>
#include <unistd.h>

namespace ransmesh
{
namespace
{
constexpr std::size_t BufferSize = 1 << 20;
}

OutputFile::OutputFile(const std::string& path, Mode mode, long long position)
  : buffer_(BufferSize)
{
  const int flags = O_WRONLY | O_CLOEXEC | (mode == Mode::Create ? O_CREAT | O_TRUNC : 0);
  file_ = ::open(path.c_str(), flags, 0666);
  if (file_ < 0 || (mode == Mode::At && ::lseek(file_, position, SEEK_SET) < 0))
  {
    error_ = errno;
  }
  flushed_ = mode == Mode::At ? position : 0;
}

OutputFile::~OutputFile()
{
  close();
}

void OutputFile::bytes(const char* data, std::size_t size)
{
  while (size > 0)
  {
    char* at = room(1);
    const std::size_t part = std::min(size, buffer_.size() - used_);
    std::memcpy(at, data, part);
    used_ += part;
    data += part;
    size -= part;
  }
}

void OutputFile::flush()
{
  std::size_t done = 0;
  while (error_ == 0 && done < used_)
  {
    const ssize_t part = ::write(file_, buffer_.data() + done, used_ - done);
    if (part < 0 && errno != EINTR)
    {
      error_ = errno;
    }
    done += part > 0 ? static_cast<std::size_t>(part) : 0;
  }
  flushed_ += static_cast<long long>(used_);
  used_ = 0;
}

bool OutputFile::close()
{
  flush();
  if (file_ >= 0 && ::close(file_) < 0 && error_ == 0)
  {
    error_ = errno;
  }
  file_ = -1;
  return error_ == 0;
}
} // namespace ransmesh
