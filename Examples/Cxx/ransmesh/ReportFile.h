// What --report writes: what was asked for, what came out, times and quality.
#pragma once

#include "Chain.h"

#include <string>

namespace commandline
{
// The JSON text. error is empty for a mesh that was made.
std::string reportOf(const Options& options, const Chain& chain, const std::string& error);

// The same where not even a chain could be built.
std::string reportOf(const Options& options, const std::string& error);
} // namespace commandline
