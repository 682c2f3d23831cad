// Patches: the named parts of the boundary.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace ransmesh
{
enum class PatchType
{
  Wall,
  Symmetry,
  FarField,
  Inlet,
  Outlet,
  Wake,
  Interface, // frozen: no point enters, leaves or moves on it
  Patch      // a boundary of no stated kind
};

inline constexpr std::array<std::string_view, 8> PatchTypeNames = { "wall", "symmetry", "farfield", "inlet",
  "outlet", "wake", "interface", "patch" };

inline std::string_view nameOf(PatchType type)
{
  return PatchTypeNames[static_cast<std::size_t>(type)];
}

// The type of that name, or nothing.
inline std::optional<PatchType> patchTypeOf(std::string_view name)
{
  for (std::size_t i = 0; i < PatchTypeNames.size(); ++i)
  {
    if (PatchTypeNames[i] == name)
    {
      return static_cast<PatchType>(i);
    }
  }
  return std::nullopt;
}

struct Patch
{
  std::string name;
  PatchType type = PatchType::Patch;
};

// Indexed by patch number; row 0 stands for the fluid.
using PatchTable = std::vector<Patch>;
} // namespace ransmesh
