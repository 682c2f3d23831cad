// What the user asked for on the command line.
#pragma once

#include <stdexcept>
#include <string>
#include <vector>

namespace commandline
{
struct Options
{
  std::vector<std::string> surfaces;
  std::vector<std::string> wakes; // files of sheets
  std::string output;
  std::string report;   // empty: none
  std::string problems; // empty: none
  std::vector<std::string> walls;
  double farField = 0;    // body lengths on each side; 0: no far field
  double size = 0;        // 0: no limit
  double surfaceSize = 0; // 0: surfaces are kept
  double swapAngle = -1;  // degrees; 0: the surface triangles are kept; negative: not given
  double firstHeight = 0; // 0: not given
  double growth = 0;      // 0: not given
  double thickness = 0;   // 0: not given
  int layers = 0;         // 0: not given
  int threads = 0;        // 0: not given
  bool isotropicOnly = false;
  bool quiet = false;
  bool help = false;
  bool version = false;
};

// Wrong usage: what() says what is wrong and what to write instead.
struct UsageError : std::runtime_error
{
  using std::runtime_error::runtime_error;
};

// Throws UsageError.
Options parseOptions(const std::vector<std::string>& arguments);

// The text of --help.
std::string helpText();
} // namespace commandline
