// The choices that a string of bytes makes.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

namespace kernel_driver
{
// Zeros when the bytes are used up.
class Choices
{
public:
  explicit Choices(std::span<const std::uint8_t> bytes)
    : bytes_(bytes)
  {
  }
  bool isOver() const { return at_ >= bytes_.size(); }
  unsigned next() { return isOver() ? 0U : bytes_[at_++]; }
  std::size_t upTo(std::size_t count) { return count == 0 ? 0 : (256 * next() + next()) % count; }
  double between(double low, double high) { return low + (high - low) * next() / 255.0; }

private:
  std::span<const std::uint8_t> bytes_;
  std::size_t at_ = 0;
};
} // namespace kernel_driver
