#include "PatchNaming.h"

#include "Layers/LayerPlanning.h"

#include <algorithm>
#include <cctype>

namespace ransmesh
{
namespace
{
std::vector<std::string> wordsOf(const std::string& name)
{
  std::vector<std::string> words(1);
  bool lower = false;
  for (const char c : name)
  {
    const auto letter = static_cast<unsigned char>(c);
    if (!std::isalpha(letter) || (lower && std::isupper(letter)))
    {
      words.emplace_back();
    }
    if (std::isalpha(letter))
    {
      words.back() += static_cast<char>(std::tolower(letter));
    }
    lower = std::islower(letter) != 0;
  }
  return words;
}

bool begins(const std::string& word, const char* start)
{
  return word.rfind(start, 0) == 0;
}

bool ends(const std::string& word, const std::string& end)
{
  return word.size() >= end.size() && word.compare(word.size() - end.size(), end.size(), end) == 0;
}

PatchType typeOfWord(const std::string& w)
{
  if (w == "sym" || begins(w, "symm") || w == "symp" || w == "symplane")
  {
    return PatchType::Symmetry;
  }
  if (w == "far" || begins(w, "farfield") || begins(w, "freestream"))
  {
    return PatchType::FarField;
  }
  if (begins(w, "inlet") || begins(w, "inflow") || w == "inle")
  {
    return PatchType::Inlet;
  }
  if (begins(w, "outlet") || begins(w, "outflow") || w == "outl")
  {
    return PatchType::Outlet;
  }
  if (w == "wake" || w == "wakes")
  {
    return PatchType::Wake;
  }
  if (w == "interface" || w == "interfaces")
  {
    return PatchType::Interface;
  }
  if (ends(w, "wall") || ends(w, "walls") || w == "noslip" || w == "viscous")
  {
    return PatchType::Wall;
  }
  return PatchType::Patch;
}

// The numbers of the patches that a pattern takes: a name, a name with wildcards, or a number.
std::vector<std::size_t> takenBy(const std::string& pattern, const PatchTable& patches)
{
  std::vector<std::size_t> taken;
  for (std::size_t i = 1; i < patches.size(); ++i)
  {
    if (pattern == std::to_string(i) || matchesPattern(patches[i].name, pattern))
    {
      taken.push_back(i);
    }
  }
  return taken;
}

Outcome takesNone(const std::string& pattern, const char* option, const PatchTable& patches)
{
  std::string names;
  for (std::size_t i = 1; i < patches.size(); ++i)
  {
    names += (i > 1 ? ", " : "") + patches[i].name;
  }
  return Outcome::badInput("no patch is named '" + pattern + "' (" + option + "); there are: " + names);
}
} // namespace

PatchType guessType(const std::string& name)
{
  for (const std::string& word : wordsOf(name))
  {
    const PatchType type = typeOfWord(word);
    if (type != PatchType::Patch)
    {
      return type;
    }
  }
  return PatchType::Patch;
}

Outcome setTypes(const std::vector<std::pair<std::string, std::string>>& typeOfPattern, PatchTable& patches)
{
  for (const auto& [pattern, typeName] : typeOfPattern)
  {
    const auto type = patchTypeOf(typeName);
    if (!type)
    {
      return Outcome::badInput("'" + typeName +
        "' is no type of patch: use wall, symmetry, farfield, inlet, " + "outlet, wake, interface or patch");
    }
    const std::vector<std::size_t> taken = takenBy(pattern, patches);
    if (taken.empty())
    {
      return takesNone(pattern, "SetPatchType", patches);
    }
    for (const std::size_t i : taken)
    {
      patches[i].type = *type;
    }
  }
  return Outcome::done();
}

Outcome flagPatches(const std::vector<std::string>& patterns, const char* option, const PatchTable& patches,
  std::vector<char>& flags)
{
  flags.resize(patches.size(), 0);
  for (const std::string& pattern : patterns)
  {
    const std::vector<std::size_t> taken = takenBy(pattern, patches);
    if (taken.empty())
    {
      return takesNone(pattern, option, patches);
    }
    for (const std::size_t i : taken)
    {
      flags[i] = 1;
    }
  }
  return Outcome::done();
}

Outcome checkSheetTypes(const PatchTable& patches, const std::vector<char>& isSheet)
{
  for (std::size_t i = 1; i < isSheet.size(); ++i)
  {
    const PatchType type = patches[i].type;
    if (isSheet[i] && type != PatchType::Wake && type != PatchType::Wall && type != PatchType::Interface &&
      type != PatchType::Patch)
    {
      return Outcome::badInput("the sheet '" + patches[i].name + "' is of type " + std::string(nameOf(type)) +
        ": a sheet lies inside the fluid, so it can be wake, wall, interface or patch (SetPatchType)");
    }
  }
  return Outcome::done();
}
} // namespace ransmesh
