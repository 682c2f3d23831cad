#include "StallGuard.h"

#include "Protocol.h"

#include <csignal>
#include <cstdlib>

#include <sys/time.h>

namespace ransmesh::worker
{
namespace
{
constexpr double Patience = 2; // seconds of processor time
constexpr double PatiencePerPoint = 0.002;

void limitProcessorTime(double seconds)
{
  itimerval limit = {};
  limit.it_value.tv_sec = static_cast<time_t>(seconds);
  setitimer(ITIMER_VIRTUAL, &limit, nullptr);
}
} // namespace

void watchRecovery(std::size_t points)
{
  signal(SIGVTALRM, [](int) { std::_Exit(ExitStalled); });
  limitProcessorTime(Patience + PatiencePerPoint * static_cast<double>(points));
}

void endRecovery()
{
  limitProcessorTime(0);
}
} // namespace ransmesh::worker
