// Drives the kernel's operators over a small mesh as a string of bytes tells, and checks the mesh after each.
#pragma once

#include <cstdint>
#include <span>
#include <string>

namespace kernel_driver
{
// Any bytes will do; they end the run. Gives what went wrong first, with the operator and its number; empty: nothing.
std::string drive(std::span<const std::uint8_t> bytes);
} // namespace kernel_driver
