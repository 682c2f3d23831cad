// What holds by construction, checked in debug builds.
#ifndef DebugCheck_h
#define DebugCheck_h

#include "Support/Outcome.h"

#include <string>

namespace ransmesh
{
// An internal fault if findFaults, for this kind of mesh, finds any in a debug build; the name goes into its message.
template <class Mesh>
Outcome checkInDebugBuilds([[maybe_unused]] const Mesh& mesh, [[maybe_unused]] const std::string& name)
{
#ifndef NDEBUG
  if (const auto faults = findFaults(mesh); !faults.none())
  {
    return Outcome::internalFault(name + " is not valid: " + faults.text());
  }
#endif
  return Outcome::done();
}
} // namespace ransmesh

#endif
