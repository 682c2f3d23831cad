// What a stage is given by its caller: ways to report progress, to log, and to be stopped.
#pragma once

#include <functional>
#include <string>

namespace ransmesh
{
struct Context
{
  // Called with a fraction in [0, 1] and the phase's name. May be empty.
  std::function<void(double, const char*)> progress;
  // Asked now and then; true stops the stage, whose outcome then is Cancelled. May be empty.
  std::function<bool()> cancelled;
  // Remarks for the user that are not errors. May be empty.
  std::function<void(const std::string&)> log;

  void report(double fraction, const char* phase) const
  {
    if (progress)
    {
      progress(fraction, phase);
    }
  }
  bool stopped() const { return cancelled && cancelled(); }
  void remark(const std::string& text) const
  {
    if (log)
    {
      log(text);
    }
  }
};
} // namespace ransmesh
