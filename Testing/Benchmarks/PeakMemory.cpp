#include "PeakMemory.h"

#include <sys/resource.h>

#include <algorithm>
#include <fstream>
#include <malloc.h>
#include <string>

namespace ransmesh_benchmarks
{
namespace
{
// A figure of /proc/self/status, there in kB.
std::size_t statusBytes(const std::string& name)
{
  std::ifstream status("/proc/self/status");
  for (std::string line; std::getline(status, line);)
  {
    if (line.compare(0, name.size() + 1, name + ":") == 0)
    {
      return 1024 * std::stoul(line.substr(name.size() + 1));
    }
  }
  return 0;
}

rusage usageOfChildren()
{
  rusage usage{};
  getrusage(RUSAGE_CHILDREN, &usage);
  return usage;
}
} // namespace

PeakMemory::PeakMemory()
{
  malloc_trim(0);                                // what was freed before must not serve as a hidden reserve
  std::ofstream("/proc/self/clear_refs") << "5"; // resets the peak
  before_ = statusBytes("VmRSS");
}

std::size_t PeakMemory::bytes() const
{
  return std::max(statusBytes("VmHWM"), before_) - before_;
}

std::size_t peakOfChildren()
{
  return 1024 * static_cast<std::size_t>(usageOfChildren().ru_maxrss);
}

double secondsOfChildren()
{
  const rusage usage = usageOfChildren();
  return static_cast<double>(usage.ru_utime.tv_sec + usage.ru_stime.tv_sec) +
    1e-6 * static_cast<double>(usage.ru_utime.tv_usec + usage.ru_stime.tv_usec);
}
} // namespace ransmesh_benchmarks
