// The kernel's operators under libFuzzer:
//   cmake -DCMAKE_CXX_COMPILER=clang++ -DRANSMESHING_BUILD_FUZZER=ON
//     -DRANSMESHING_SANITIZERS=address,undefined,fuzzer-no-link ...
//   bin/ransmesh-kernel-fuzzer -max_len=2000 CORPUS_FOLDER
#include "KernelDriver.h"

#include <cstdio>
#include <cstdlib>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  const std::string fault = kernel_driver::drive({ data, size });
  if (!fault.empty())
  {
    std::fprintf(stderr, "%s\n", fault.c_str());
    std::abort();
  }
  return 0;
}
