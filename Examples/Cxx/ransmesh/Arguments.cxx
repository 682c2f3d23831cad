#include "Arguments.h"

#include <charconv>
#include <cmath>

namespace commandline
{
namespace
{
template <typename Number>
bool parseWhole(const std::string& word, Number& number)
{
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), number);
  return error == std::errc() && end == word.data() + word.size();
}
std::string textOf(double number)
{
  char digits[32];
  return { digits, std::to_chars(digits, digits + sizeof digits, number).ptr };
}
} // namespace

bool Arguments::atNumber() const
{
  double ignored = 0;
  return !atEnd() && parseWhole(words_[at_], ignored);
}

const std::string& Arguments::valueOf(const std::string& option)
{
  if (!atValue() && !atNumber())
  {
    throw UsageError(option + " needs a value");
  }
  return next();
}

double finiteNumber(const std::string& word, const std::string& option)
{
  double value = 0;
  if (!parseWhole(word, value) || !std::isfinite(value))
  {
    throw UsageError(option + " needs a number, not \"" + word + "\"");
  }
  return value;
}

double numberBetween(Arguments& arguments, const std::string& option, double least, double most)
{
  const std::string& word = arguments.valueOf(option);
  const double value = finiteNumber(word, option);
  if (value < least || value > most)
  {
    throw UsageError(
      option + " must lie between " + textOf(least) + " and " + textOf(most) + ", not " + word);
  }
  return value;
}

double positiveUpTo(Arguments& arguments, const std::string& option, double most)
{
  const std::string& word = arguments.valueOf(option);
  const double value = finiteNumber(word, option);
  if (value <= 0 || value > most)
  {
    throw UsageError(option + " must be above 0 and at most " + textOf(most) + ", not " + word);
  }
  return value;
}

double positiveOf(Arguments& arguments, const std::string& option, double atLeast)
{
  const std::string& word = arguments.valueOf(option);
  const double value = finiteNumber(word, option);
  if (value <= 0 || value < atLeast)
  {
    throw UsageError(option +
      (atLeast > 0 ? " must be at least " + textOf(atLeast) : std::string(" must be above 0")) + ", not " +
      word);
  }
  return value;
}

int countOf(Arguments& arguments, const std::string& option)
{
  const std::string& word = arguments.valueOf(option);
  int value = 0;
  if (!parseWhole(word, value) || value < 1)
  {
    throw UsageError(option + " needs a whole number above 0, not \"" + word + "\"");
  }
  return value;
}

std::vector<std::string> valuesOf(Arguments& arguments, const std::string& option)
{
  std::vector<std::string> values = { arguments.valueOf(option) };
  while (arguments.atValue())
  {
    values.push_back(arguments.next());
  }
  return values;
}

void addValues(Arguments& arguments, const std::string& option, std::vector<std::string>& values)
{
  const std::vector<std::string> more = valuesOf(arguments, option);
  values.insert(values.end(), more.begin(), more.end());
}

std::pair<std::string, std::string> assignmentOf(
  const std::string& word, const std::string& option, const std::string& form)
{
  const std::size_t equals = word.rfind('=');
  if (equals == std::string::npos || equals == 0 || equals + 1 == word.size())
  {
    throw UsageError(option + " needs " + form + ", not " + word);
  }
  return { word.substr(0, equals), word.substr(equals + 1) };
}

bool endsWith(const std::string& text, const std::string& end)
{
  return text.size() > end.size() && text.compare(text.size() - end.size(), end.size(), end) == 0;
}
} // namespace commandline
