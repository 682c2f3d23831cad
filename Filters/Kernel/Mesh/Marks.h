// Marks on numbered things, cleared in constant time.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace ransmesh
{
class Marks
{
public:
  // Unmarks everything and makes room for numbers below size.
  void clear(std::size_t size)
  {
    if (stamp_.size() < size)
    {
      stamp_.resize(size + size / 2, 0);
    }
    if (++current_ == 0) // the stamps have been through: begin anew
    {
      std::fill(stamp_.begin(), stamp_.end(), 0);
      current_ = 1;
    }
  }
  bool test(std::size_t i) const { return stamp_[i] == current_; }
  void unset(std::size_t i) { stamp_[i] = current_ - 1; }
  // Marks i; false if it was marked already.
  bool set(std::size_t i)
  {
    const bool fresh = stamp_[i] != current_;
    stamp_[i] = current_;
    return fresh;
  }

private:
  std::vector<std::uint32_t> stamp_;
  std::uint32_t current_ = 1;
};
} // namespace ransmesh
