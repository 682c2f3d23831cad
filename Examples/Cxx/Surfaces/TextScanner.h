// Words and numbers of a text, line by line.
#pragma once

#include <algorithm>
#include <charconv>
#include <string>
#include <string_view>

namespace surfaces
{
class TextScanner
{
public:
  explicit TextScanner(std::string_view text)
    : text_(text)
  {
  }

  // Goes to the next line; false at the end.
  bool nextLine()
  {
    if (at_ >= text_.size())
    {
      return false;
    }
    const std::size_t end = text_.find('\n', at_);
    line_ = text_.substr(at_, end == std::string_view::npos ? end : end - at_);
    at_ = end == std::string_view::npos ? text_.size() : end + 1;
    ++lineNumber_;
    return true;
  }
  int lineNumber() const { return lineNumber_; }

  // The next word of the line, or an empty one at its end.
  std::string_view word()
  {
    const std::size_t start = std::min(line_.find_first_not_of(blanks), line_.size());
    const std::size_t end = std::min(line_.find_first_of(blanks, start), line_.size());
    const std::string_view found = line_.substr(start, end - start);
    line_.remove_prefix(end);
    return found;
  }

  // What is left of the line, without blanks at its ends.
  std::string_view rest() const
  {
    const std::size_t start = std::min(line_.find_first_not_of(blanks), line_.size());
    const std::size_t last = line_.find_last_not_of(blanks);
    return last == std::string_view::npos ? std::string_view() : line_.substr(start, last + 1 - start);
  }

private:
  static constexpr std::string_view blanks = " \t\r";
  std::string_view text_;
  std::string_view line_;
  std::size_t at_ = 0;
  int lineNumber_ = 0;
};

// Whether the whole word is a number, then given in `number`.
template <typename Number>
bool parse(std::string_view word, Number& number)
{
  if (!word.empty() && word.front() == '+')
  {
    word.remove_prefix(1);
  }
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), number);
  return error == std::errc() && end == word.data() + word.size();
}
} // namespace surfaces
