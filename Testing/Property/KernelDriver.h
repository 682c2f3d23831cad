// Drives the kernel's operators over a small mesh as a string of bytes tells, and checks the mesh after each.
#pragma once

#include <cstdint>
#include <span>
#include <string>

namespace kernel_driver
{
enum class Operators
{
  All,
  WithoutCollapses // runs remembered from before there were these
};

// Any bytes will do; they end the run. Gives what went wrong first, with the operator and its number; empty: nothing.
std::string drive(std::span<const std::uint8_t> bytes, Operators operators = Operators::All);
} // namespace kernel_driver
