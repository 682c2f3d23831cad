// Numbers of a gmsh file, one after the other, in text or binary.
#pragma once

#include <algorithm>
#include <charconv>
#include <cstdint>
#include <cstring>
#include <stdexcept>
#include <string>
#include <string_view>

namespace ransmesh
{
class GmshCursor
{
public:
  explicit GmshCursor(std::string_view text)
    : text_(text)
  {
  }

  void setBinary(bool binary) { binary_ = binary; }
  bool isBinary() const { return binary_; }

  // Goes to the line after the next one that starts with `$`, and gives the section's name without it; empty at the
  // end.
  std::string nextSection()
  {
    for (std::size_t at = at_; at < text_.size(); ++at)
    {
      if (text_[at] == '$' && (at == 0 || text_[at - 1] == '\n'))
      {
        at_ = at + 1;
        return line();
      }
    }
    at_ = text_.size();
    return "";
  }

  // Goes behind the section.
  void leave(const std::string& section)
  {
    const std::string end = "$End" + section;
    const std::size_t found = text_.find(end, at_);
    if (found == std::string_view::npos)
    {
      throw std::runtime_error("the section " + section + " has no end: the file is cut short");
    }
    at_ = found + end.size();
  }

  // The rest of the line.
  std::string line()
  {
    const std::size_t end = std::min(text_.find('\n', at_), text_.size());
    std::string rest(text_.substr(at_, end - at_));
    at_ = std::min(end + 1, text_.size());
    while (!rest.empty() && (rest.back() == '\r' || rest.back() == ' '))
    {
      rest.pop_back();
    }
    return rest;
  }

  std::string peekLine()
  {
    const std::size_t before = at_;
    std::string text = line();
    at_ = before;
    return text;
  }

  // In a text, numbers of all kinds are words.
  template <class Number>
  Number word()
  {
    at_ = std::min(text_.find_first_not_of(" \t\r\n", at_), text_.size());
    Number number{};
    const char* begin = text_.data() + at_;
    const auto [end, error] = std::from_chars(begin, text_.data() + text_.size(), number);
    if (error != std::errc())
    {
      throw std::runtime_error("a number is missing at byte " + std::to_string(at_));
    }
    at_ += end - begin;
    return number;
  }

  template <class Number>
  Number next()
  {
    if (!binary_)
    {
      return word<Number>();
    }
    Number number{};
    if (text_.size() - at_ < sizeof number)
    {
      throw std::runtime_error("the file is cut short");
    }
    std::memcpy(&number, text_.data() + at_, sizeof number);
    at_ += sizeof number;
    return number;
  }

  // A count of things that take at least `bytes` bytes each: more than the file holds cannot be.
  template <class Number>
  std::size_t count(std::size_t bytes)
  {
    const auto number = next<Number>();
    if (number < 0 || static_cast<std::uint64_t>(number) > (text_.size() - at_) / bytes + 1)
    {
      throw std::runtime_error("a count of " + std::to_string(number) + " exceeds the file's size");
    }
    return static_cast<std::size_t>(number);
  }

private:
  std::string_view text_;
  std::size_t at_ = 0;
  bool binary_ = false;
};
} // namespace ransmesh
