// How the options are called that set what messages of the filters name.
#pragma once

#include <string>

namespace commandline
{
// The message with an option beside each parameter or method of the filters, as in "set FirstHeight (--first-height)",
// but where the message names the option itself. ofLayers: it comes from a filter of the layers, not from the mesher.
std::string withOptionNames(const std::string& message, bool ofLayers);
} // namespace commandline
