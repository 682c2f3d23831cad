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

std::string driveSeed(unsigned long seed, kernel_driver::Operators operators = kernel_driver::Operators::All)
{
  std::mt19937 random(static_cast<std::mt19937::result_type>(seed));
  std::vector<std::uint8_t> bytes(1500);
  for (std::uint8_t& byte : bytes)
  {
    byte = static_cast<std::uint8_t>(random());
  }
  return kernel_driver::drive(bytes, operators);
}
} // namespace

// Those that long runs found.
TEST(KernelDriver, OrdersThatOnceFailedLeaveAValidMesh)
{
  constexpr auto before = kernel_driver::Operators::WithoutCollapses;
  // Two tops in one side become neighbours across it.
  EXPECT_EQ(driveSeed(18747, before), "");
  EXPECT_EQ(driveSeed(14414, before), "");
  EXPECT_EQ(driveSeed(45535, before), "");
}

TEST(KernelDriver, AnyOrderOfOperatorsLeavesAValidMesh)
{
  const unsigned long first = numberFrom("RANSMESHING_FIRST_SEED", 1);
  const unsigned long count = numberFrom("RANSMESHING_RANDOM_RUNS", 200);
  for (unsigned long seed = first; seed < first + count; ++seed)
  {
    EXPECT_EQ(driveSeed(seed), "") << "seed " << seed;
  }
}
