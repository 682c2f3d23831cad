#include "Progress.h"

#include <vtkAlgorithm.h>

#include <csignal>
#include <cstdio>
#include <unistd.h>

namespace commandline
{
namespace
{
volatile std::sig_atomic_t interrupted = 0;

void onInterrupt(int signal)
{
  interrupted = 1;
  std::signal(signal, SIG_DFL);
}
} // namespace

void Progress::catchInterrupts()
{
  std::signal(SIGINT, onInterrupt);
  std::signal(SIGTERM, onInterrupt);
}

void Progress::setQuiet(bool quiet)
{
  shown_ = !quiet && isatty(STDERR_FILENO) != 0;
}

void Progress::watch(vtkAlgorithm* algorithm, const std::string& stage)
{
  stage_ = stage;
  lastPercent_ = -1;
  algorithm->AddObserver(vtkCommand::ProgressEvent, this);
}

void Progress::clear()
{
  if (lineIsOpen_)
  {
    std::fputs("\r\033[K", stderr);
    lineIsOpen_ = false;
  }
}

void Progress::Execute(vtkObject* caller, unsigned long, void* data)
{
  if (interrupted != 0)
  {
    static_cast<vtkAlgorithm*>(caller)->SetAbortExecute(1);
  }
  const int percent = static_cast<int>(100 * *static_cast<double*>(data));
  if (!shown_ || percent == lastPercent_)
  {
    return;
  }
  lastPercent_ = percent;
  const char* phase = static_cast<vtkAlgorithm*>(caller)->GetProgressText();
  std::fprintf(
    stderr, "\r\033[K%3d %%  %s%s%s", percent, stage_.c_str(), phase ? ": " : "", phase ? phase : "");
  std::fflush(stderr);
  lineIsOpen_ = true;
}
} // namespace commandline
