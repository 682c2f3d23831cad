// ransmesh-tetgen-worker REQUEST RESULT [MEGABYTES]
//
// Runs TetGen once, in a process of its own, for vtkIsotropicTetMesher: TetGen aborts, loops or
// damages memory on bad input, and nothing of that shall reach the host. Reads the request file, writes
// the result file; what TetGen prints goes to the standard output, which the filter reads.
// MEGABYTES, of 1e6 bytes, is the memory that it may take; without it, or with 0, there is no limit.
#include "TetGenRun.h"

#include <cstdlib>
#include <new>

#ifdef __linux__
#include <csignal>
#include <sys/prctl.h>
#include <sys/resource.h>
#endif

namespace
{
void limitMemory(const char* megabytes)
{
#ifdef __linux__
  const long long limit = std::atoll(megabytes);
  if (limit > 0)
  {
    const auto bytes = static_cast<rlim_t>(limit) * 1000000;
    const rlimit both = { bytes, bytes };
    setrlimit(RLIMIT_AS, &both);
  }
#else
  (void)megabytes;
#endif
}
} // namespace

int main(int argc, char** argv)
{
  using namespace ransmesh::worker;
  if (argc != 3 && argc != 4)
  {
    std::fputs("usage: ransmesh-tetgen-worker REQUEST RESULT [MEGABYTES]\n"
               "The helper program of vtkIsotropicTetMesher; it is not meant to be run by hand.\n",
      stderr);
    return ExitUsage;
  }
#ifdef __linux__
  prctl(PR_SET_PDEATHSIG, SIGKILL); // a worker must not outlive its host
#endif
  if (argc == 4)
  {
    limitMemory(argv[3]);
  }
  std::setvbuf(stdout, nullptr, _IOLBF, 1 << 12);
  try
  {
    Request request;
    if (!load(request, argv[1]))
    {
      std::fprintf(stderr, "cannot read %s\n", argv[1]);
      return ExitUnreadable;
    }
    Result result = runTetGen(request);
    if (!save(result, argv[2]))
    {
      std::fprintf(stderr, "cannot write %s: is the disk full?\n", argv[2]);
      return ExitUnreadable;
    }
    std::fflush(stdout);
    std::_Exit(0); // the mesh need not be taken down piece by piece; TetGen would leak some of it anyway
  }
  catch (const std::bad_alloc&)
  {
    std::fputs("out of memory\n", stderr);
    return ExitMemory;
  }
}
