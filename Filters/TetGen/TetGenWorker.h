// TetGen as a function: a request goes in, a result or an error in words comes out.
#pragma once

#include "Worker/Protocol.h"

#include "Support/Context.h"
#include "Support/Outcome.h"

#include <string>

namespace ransmesh
{
struct TetGenEnd
{
  Outcome outcome = {};
  bool endless = false;   // it failed because refining did not end: the surface has badly shaped triangles
  bool exhausted = false; // it failed for want of memory: no other switches help
};

// What one run may take; 0: no limit.
struct WorkerLimits
{
  double seconds = 0;
  double megabytes = 0; // of 1e6 bytes
};

class TetGenWorker
{
public:
  // program: the worker's path.
  TetGenWorker(std::string program, const WorkerLimits& limits)
    : program_(std::move(program))
    , limits_(limits)
  {
  }

  // Whatever TetGen does, this returns. Progress in the context goes from 0 to 1, by TetGen's phases.
  // The outcome is Cancelled, or BadInput with TetGen's last words.
  TetGenEnd run(worker::Request& request, const Context& context, worker::Result& result) const;

private:
  std::string program_;
  WorkerLimits limits_;
};
} // namespace ransmesh
