// Lists that are filled and emptied again and again in inner loops.
#pragma once

#include <algorithm>
#include <cstddef>
#include <memory>
#include <span>

namespace ransmesh
{
// Room is made for several values at a time, so that adding one is a store and no more: a vector's push_back asks
// each time, and what it would do then keeps compilers from inlining the loop around it.
template <class T>
class Scratch
{
public:
  void clear() { count_ = 0; }
  std::size_t size() const { return count_; }
  // Makes room for so many more.
  void makeRoom(std::size_t more)
  {
    if (count_ + more > room_)
    {
      grow(2 * (count_ + more));
    }
  }
  // There must be room.
  void add(const T& value) { values_[count_++] = value; }
  // The same if that is wanted: quicker where nobody could guess whether it is.
  void addIf(bool wanted, const T& value)
  {
    values_[count_] = value;
    count_ += static_cast<std::size_t>(wanted);
  }
  // Drops the last ones; there must be as many.
  void shrink(std::size_t count) { count_ = count; }
  T& operator[](std::size_t i) { return values_[i]; }
  const T& operator[](std::size_t i) const { return values_[i]; }
  std::span<const T> view() const { return { values_.get(), count_ }; }

private:
  [[gnu::noinline]] void grow(std::size_t room)
  {
    std::unique_ptr<T[]> larger(new T[room]);
    std::copy_n(values_.get(), count_, larger.get());
    values_.swap(larger);
    room_ = room;
  }

  std::unique_ptr<T[]> values_;
  std::size_t count_ = 0;
  std::size_t room_ = 0;
};
} // namespace ransmesh
