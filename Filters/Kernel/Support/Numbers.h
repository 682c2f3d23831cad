// Numbers in messages.
#pragma once

#include <array>
#include <cstdio>
#include <string>

namespace ransmesh
{
// Six significant digits: 1e-08 stays 1e-08, where std::to_string would say 0.000000.
inline std::string textOf(double number)
{
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%g", number);
  return text.data();
}
} // namespace ransmesh
