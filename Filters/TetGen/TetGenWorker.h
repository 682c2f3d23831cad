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
  bool endless = false; // it failed because refining did not end: the surface has badly shaped triangles
};

class TetGenWorker
{
public:
  // program: the worker's path. timeLimit of one run, in seconds; 0: none.
  TetGenWorker(std::string program, double timeLimit)
    : program_(std::move(program))
    , timeLimit_(timeLimit)
  {
  }

  // Whatever TetGen does, this returns. Progress in the context goes from 0 to 1, by TetGen's phases.
  // The outcome is Cancelled, or BadInput with TetGen's last words.
  TetGenEnd run(worker::Request& request, const Context& context, worker::Result& result) const;

private:
  std::string program_;
  double timeLimit_;
};
} // namespace ransmesh
