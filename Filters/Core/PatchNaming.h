// Types of patches, guessed from their names or set by the user.
#pragma once

#include "Support/Outcome.h"
#include "Support/Patch.h"

#include "RANSMeshingCoreModule.h"

#include <string>
#include <utility>
#include <vector>

namespace ransmesh
{
// The type that a name suggests by one of its words: wall, symmetry, farfield, inlet, outlet, wake,
// interface and common short forms of them, in any case; else `patch`. Words are parted by signs,
// digits and changes from lower to upper case: "SymmPlane_2" is a symmetry, "asymptote" is not.
RANSMESHINGCORE_EXPORT PatchType guessType(const std::string& name);

// Sets the types of the patches that the patterns take: a name, a name with the wildcards * and ?, or a
// number; later rules win. BadInput for an unknown type, or a pattern that takes no patch.
RANSMESHINGCORE_EXPORT Outcome setTypes(
  const std::vector<std::pair<std::string, std::string>>& typeOfPattern, PatchTable& patches);

// Flags, by number, the patches that the patterns take, beside those that are flagged. BadInput for a pattern
// that takes none; `option` names where it was given.
RANSMESHINGCORE_EXPORT Outcome flagPatches(const std::vector<std::string>& patterns, const char* option,
  const PatchTable& patches, std::vector<char>& flags);

// Whether sheets (by patch number) have types that a sheet can have: wake, wall, interface or patch.
RANSMESHINGCORE_EXPORT Outcome checkSheetTypes(const PatchTable& patches, const std::vector<char>& isSheet);
} // namespace ransmesh
