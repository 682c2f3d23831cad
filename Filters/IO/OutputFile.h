// A file that is written from beginning to end: buffered, fast with numbers, and it remembers its first error.
#ifndef OutputFile_h
#define OutputFile_h

#include <bit>
#include <charconv>
#include <concepts>
#include <cstring>
#include <string>
#include <string_view>
#include <vector>

namespace ransmesh
{
class OutputFile
{
public:
  enum class Mode
  {
    Create, // empties what is there
    At      // writes from a position on into a file that is there
  };

  explicit OutputFile(const std::string& path, Mode mode = Mode::Create, long long position = 0);
  ~OutputFile();
  OutputFile(const OutputFile&) = delete;
  OutputFile& operator=(const OutputFile&) = delete;

  OutputFile& text(std::string_view words)
  {
    bytes(words.data(), words.size());
    return *this;
  }

  // Decimal; a floating-point number with as many digits as give the same number when read.
  template <class Number>
  OutputFile& number(Number value)
  {
    constexpr std::size_t most = 32;
    char* at = room(most);
    used_ += static_cast<std::size_t>(std::to_chars(at, at + most, value).ptr - at);
    return *this;
  }

  // As it lies in memory, or with the other order of bytes.
  template <std::endian Order = std::endian::native, class Number>
  OutputFile& binary(Number value)
  {
    char* at = room(sizeof value);
    std::memcpy(at, &value, sizeof value);
    if constexpr (Order != std::endian::native)
    {
      for (std::size_t i = 0; i < sizeof value / 2; ++i)
      {
        std::swap(at[i], at[sizeof value - 1 - i]);
      }
    }
    used_ += sizeof value;
    return *this;
  }

  long long position() const { return flushed_ + static_cast<long long>(used_); }

  // Writes what is left and closes. False if anything went wrong since the file was opened.
  bool close();
  // The system's number of the first error, or 0.
  int error() const { return error_; }

private:
  void bytes(const char* data, std::size_t size);
  void flush();
  char* room(std::size_t size)
  {
    if (used_ + size > buffer_.size())
    {
      flush();
    }
    return buffer_.data() + used_;
  }

  int file_ = -1;
  int error_ = 0;
  long long flushed_ = 0;
  std::size_t used_ = 0;
  std::vector<char> buffer_;
};
} // namespace ransmesh

#endif
