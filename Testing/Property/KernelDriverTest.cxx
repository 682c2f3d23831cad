// The kernel's operators at random. For long runs:
//   RANSMESHING_RANDOM_RUNS=100000 RANSMESHING_FIRST_SEED=1000 RANSMeshingKernelDriver
#include "KernelDriver.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <random>
#include <vector>

namespace
{
unsigned long numberFrom(const char* variable, unsigned long usual)
{
  const char* text = std::getenv(variable);
  return text ? std::strtoul(text, nullptr, 10) : usual;
}
} // namespace

TEST(KernelDriver, AnyOrderOfOperatorsLeavesAValidMesh)
{
  const unsigned long first = numberFrom("RANSMESHING_FIRST_SEED", 1);
  const unsigned long count = numberFrom("RANSMESHING_RANDOM_RUNS", 200);
  for (unsigned long seed = first; seed < first + count; ++seed)
  {
    std::mt19937 random(static_cast<std::mt19937::result_type>(seed));
    std::vector<std::uint8_t> bytes(1500);
    for (std::uint8_t& byte : bytes)
    {
      byte = static_cast<std::uint8_t>(random());
    }
    EXPECT_EQ(kernel_driver::drive(bytes), "") << "seed " << seed;
  }
}
