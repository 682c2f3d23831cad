#include "WorkerProcess.h"

#include <vtksys/Process.h>

#include <chrono>
#include <deque>
#include <memory>

#include <signal.h>

namespace ransmesh
{
namespace
{
using Clock = std::chrono::steady_clock;
constexpr double AskEvery = 0.1; // seconds

struct DeleteProcess
{
  void operator()(vtksysProcess* process) const { vtksysProcess_Delete(process); }
};
using ProcessPointer = std::unique_ptr<vtksysProcess, DeleteProcess>;

// Cuts a stream of characters into lines and remembers the last of them.
class Lines
{
public:
  explicit Lines(const std::function<void(const std::string&)>& onLine)
    : onLine_(onLine)
  {
  }

  void add(const char* data, int length)
  {
    for (int i = 0; i < length; ++i)
    {
      if (data[i] == '\n' || partial_.size() >= LongestLine)
      {
        finish();
      }
      else if (data[i] >= ' ' || data[i] == '\t' || static_cast<unsigned char>(data[i]) >= 0x80)
      {
        partial_ += data[i];
      }
    }
  }

  void finish()
  {
    if (partial_.empty())
    {
      return;
    }
    last_.push_back(partial_);
    if (last_.size() > LinesKept)
    {
      last_.pop_front();
    }
    if (onLine_)
    {
      onLine_(partial_);
    }
    partial_.clear();
  }

  std::string last() const
  {
    std::string text;
    for (const std::string& line : last_)
    {
      text += (text.empty() ? "" : "\n") + line;
    }
    return text;
  }

private:
  static constexpr std::size_t LongestLine = 1000;
  static constexpr std::size_t LinesKept = 6;
  const std::function<void(const std::string&)>& onLine_;
  std::string partial_;
  std::deque<std::string> last_;
};

// What the host does on SIGINT and SIGTERM. vtksysProcess puts its own actions there, which leave host and
// worker running, and does not put back all that was there.
class HostSignals
{
public:
  HostSignals()
  {
    sigaction(SIGINT, nullptr, &onInterrupt_);
    sigaction(SIGTERM, nullptr, &onTerminate_);
  }
  ~HostSignals() { restore(); }
  HostSignals(const HostSignals&) = delete;
  HostSignals& operator=(const HostSignals&) = delete;
  void restore() const
  {
    sigaction(SIGINT, &onInterrupt_, nullptr);
    sigaction(SIGTERM, &onTerminate_, nullptr);
  }

private:
  struct sigaction onInterrupt_ = {};
  struct sigaction onTerminate_ = {};
};

ProcessPointer start(const std::vector<std::string>& command)
{
  std::vector<const char*> arguments;
  for (const std::string& word : command)
  {
    arguments.push_back(word.c_str());
  }
  arguments.push_back(nullptr);
  ProcessPointer process(vtksysProcess_New());
  vtksysProcess_SetCommand(process.get(), arguments.data());
  vtksysProcess_SetOption(process.get(), vtksysProcess_Option_HideWindow, 1);
  vtksysProcess_Execute(process.get());
  return process;
}

ProgramEnd describe(vtksysProcess* process)
{
  ProgramEnd end;
  switch (vtksysProcess_GetState(process))
  {
    case vtksysProcess_State_Exited:
      end.status = vtksysProcess_GetExitValue(process);
      end.kind = end.status == 0 ? ProgramEnd::Kind::Done : ProgramEnd::Kind::Failed;
      end.how = "it ended with status " + std::to_string(end.status);
      break;
    case vtksysProcess_State_Exception:
      end.kind = vtksysProcess_GetExitException(process) == vtksysProcess_Exception_Interrupt
        ? ProgramEnd::Kind::Cancelled // the terminal's Ctrl-C, which reaches the worker too
        : end.kind;
      end.how = std::string("it crashed (") + vtksysProcess_GetExceptionString(process) + ")";
      break;
    default:
      end.how = std::string("it could not be run (") + vtksysProcess_GetErrorString(process) + ")";
  }
  return end;
}
} // namespace

ProgramEnd runProgram(const std::vector<std::string>& command, double timeLimit,
  const std::function<bool()>& mustStop, const std::function<void(const std::string&)>& onLine)
{
  const HostSignals signals; // outlives the process
  const ProcessPointer process = start(command);
  signals.restore();
  const auto began = Clock::now();
  Lines lines(onLine);
  double asked = 0; // when the context was asked last
  auto killed = ProgramEnd::Kind::Done;
  for (;;)
  {
    char* data = nullptr;
    int length = 0;
    double wait = AskEvery;
    const int pipe = vtksysProcess_WaitForData(process.get(), &data, &length, &wait);
    if (pipe == vtksysProcess_Pipe_STDOUT || pipe == vtksysProcess_Pipe_STDERR)
    {
      lines.add(data, length);
    }
    else if (pipe != vtksysProcess_Pipe_Timeout)
    {
      break;
    }
    const double seconds = std::chrono::duration<double>(Clock::now() - began).count();
    const bool isLate = timeLimit > 0 && seconds > timeLimit;
    if (!isLate && seconds < asked + AskEvery)
    {
      continue;
    }
    asked = seconds;
    killed = mustStop() ? ProgramEnd::Kind::Cancelled
      : isLate          ? ProgramEnd::Kind::TimedOut
                        : ProgramEnd::Kind::Done;
    if (killed != ProgramEnd::Kind::Done)
    {
      vtksysProcess_Kill(process.get());
      break;
    }
  }
  vtksysProcess_WaitForExit(process.get(), nullptr);
  lines.finish();
  ProgramEnd end = describe(process.get());
  end.lastWords = lines.last();
  end.kind = killed != ProgramEnd::Kind::Done ? killed : end.kind;
  return end;
}
} // namespace ransmesh
