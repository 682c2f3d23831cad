// Work that makes new work: numbered things that are looked at in rounds.
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace ransmesh
{
// Each round looks at its things in the order of their numbers. What is to be looked at again while a round runs
// is so in that round, if its turn is still to come, and in the next one.
class WorkRounds
{
public:
  // Forgets all work, and makes room for numbers below size.
  void clear(std::size_t size)
  {
    now_.assign(size / WordBits + 1, 0);
    next_.assign(now_.size(), 0);
  }
  // Before the first round.
  void add(std::size_t i) { now_[i / WordBits] |= bitOf(i); }
  void addAgain(std::size_t i)
  {
    add(i);
    next_[i / WordBits] |= bitOf(i);
  }
  template <class Visit>
  void runRound(Visit visit)
  {
    for (std::size_t word = 0; word < now_.size(); ++word)
    {
      Word toCome = ~Word{ 0 };
      while ((now_[word] & toCome) != 0)
      {
        const int bit = std::countr_zero(now_[word] & toCome);
        toCome = ~Word{ 1 } << bit;
        visit(word * WordBits + static_cast<std::size_t>(bit));
      }
      now_[word] = 0;
    }
    now_.swap(next_);
  }

private:
  using Word = std::uint64_t;
  static constexpr std::size_t WordBits = 64;
  static Word bitOf(std::size_t i) { return Word{ 1 } << i % WordBits; }

  std::vector<Word> now_;
  std::vector<Word> next_;
};
} // namespace ransmesh
