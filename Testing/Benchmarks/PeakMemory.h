// The largest memory that a piece of work needs.
#pragma once

#include <cstddef>

namespace ransmesh_benchmarks
{
// Measures from its making on, beyond what was resident then. Linux only; elsewhere, or where the system
// does not allow it, bytes() is 0.
class PeakMemory
{
public:
  PeakMemory();
  std::size_t bytes() const;

private:
  std::size_t before_ = 0;
};

// The largest memory of any child process that has ended so far.
std::size_t peakOfChildren();

// Processor seconds, all threads, of child processes that have ended so far.
double secondsOfChildren();
} // namespace ransmesh_benchmarks
