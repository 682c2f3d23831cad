// Running a program under supervision.
#pragma once

#include <functional>
#include <string>
#include <vector>

namespace ransmesh
{
struct ProgramEnd
{
  enum class Kind
  {
    Done,      // it ended by itself with status 0
    Failed,    // it could not be started, crashed, or ended with another status
    Cancelled, // killed, as mustStop asked for
    TimedOut   // killed at the time limit
  };
  Kind kind = Kind::Failed;
  int status = 0;        // the exit status, if it ended by itself
  std::string how;       // in words, for example "it was ended by the signal SIGSEGV"
  std::string lastWords; // the last lines that it printed
};

// Runs the command (program, arguments) and gives each line that it prints to onLine. Asks mustStop ten times
// a second. timeLimit in seconds, 0: none. The program and its children are
// gone when this returns.
ProgramEnd runProgram(const std::vector<std::string>& command, double timeLimit,
  const std::function<bool()>& mustStop, const std::function<void(const std::string&)>& onLine);
} // namespace ransmesh
