// The words of a command line, read one after the other; what does not fit throws UsageError.
#pragma once

#include "Options.h"

#include <functional>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace commandline
{
// The arguments that have not been read yet.
class Arguments
{
public:
  explicit Arguments(const std::vector<std::string>& words)
    : words_(words)
  {
  }

  bool atEnd() const { return at_ == words_.size(); }
  bool atValue() const { return !atEnd() && (words_[at_].empty() || words_[at_][0] != '-'); }
  bool atNumber() const;
  const std::string& next() { return words_[at_++]; }
  const std::string& valueOf(const std::string& option);

private:
  const std::vector<std::string>& words_;
  std::size_t at_ = 0;
};

double finiteNumber(const std::string& word, const std::string& option);
// From least to most; angles are in degrees.
double numberBetween(Arguments& arguments, const std::string& option, double least, double most);
double positiveUpTo(Arguments& arguments, const std::string& option, double most);
double positiveOf(Arguments& arguments, const std::string& option, double atLeast = 0);
int countOf(Arguments& arguments, const std::string& option); // above 0
// One or more values, up to the next option.
std::vector<std::string> valuesOf(Arguments& arguments, const std::string& option);
// The same behind those that an option that is given several times has already.
void addValues(Arguments& arguments, const std::string& option, std::vector<std::string>& values);

// NAME=VALUE, parted at the last sign; form, as in "PATCH=TYPE", is what the message asks for.
std::pair<std::string, std::string> assignmentOf(
  const std::string& word, const std::string& option, const std::string& form);

bool endsWith(const std::string& text, const std::string& end);

// What an option does with the words that follow it.
using Reader = std::function<void(Options&, Arguments&, const std::string&)>;

// Options of one kind: how they are read, what is asked of them together, how --help describes them.
struct OptionGroup
{
  std::map<std::string, Reader> readers;
  void (*check)(const Options&);
  const char* help;
};

const OptionGroup& surfaceOptions(); // files, what is done to the surfaces
const OptionGroup& repairOptions();  // what is done to faulty surfaces
const OptionGroup& domainOptions();  // what bounds the domain, sizes within it
const OptionGroup& layerOptions();
const OptionGroup& flowOptions();   // what the layers are for
const OptionGroup& outputOptions(); // files written, what is told
} // namespace commandline
