#include "Quality/JsonWriter.h"

#include <array>
#include <charconv>
#include <cmath>
#include <cstdio>

namespace ransmesh
{
void JsonWriter::separate()
{
  if (isNamed_)
  {
    isNamed_ = false;
    return;
  }
  if (!isFirst_)
  {
    text_ += inArray_ ? ", " : ",";
  }
  if (!inArray_ && depth_ > 0)
  {
    text_ += '\n';
    text_.append(static_cast<std::size_t>(depth_), ' ');
  }
  isFirst_ = false;
}

void JsonWriter::raw(std::string_view text)
{
  separate();
  text_ += text;
}

void JsonWriter::quoted(std::string_view text)
{
  text_ += '"';
  for (const char c : text)
  {
    if (c == '"' || c == '\\')
    {
      text_ += '\\';
      text_ += c;
    }
    else if (static_cast<unsigned char>(c) < 0x20)
    {
      std::array<char, 8> code{};
      std::snprintf(code.data(), code.size(), "\\u%04x", c);
      text_ += code.data();
    }
    else
    {
      text_ += c;
    }
  }
  text_ += '"';
}

void JsonWriter::begin(char bracket)
{
  separate();
  text_ += bracket;
  ++depth_;
  isFirst_ = true;
}

void JsonWriter::end(char bracket)
{
  --depth_;
  if (!isFirst_ && !inArray_)
  {
    text_ += '\n';
    text_.append(static_cast<std::size_t>(depth_), ' ');
  }
  text_ += bracket;
  isFirst_ = false;
}

void JsonWriter::beginArray()
{
  begin('[');
  inArray_ = true;
}

void JsonWriter::endArray()
{
  end(']');
  inArray_ = false;
}

JsonWriter& JsonWriter::name(std::string_view text)
{
  separate();
  quoted(text);
  text_ += ": ";
  isNamed_ = true;
  return *this;
}

void JsonWriter::value(double number)
{
  if (!std::isfinite(number))
  {
    raw("null");
    return;
  }
  std::array<char, 32> digits;
  const auto result = std::to_chars(digits.data(), digits.data() + digits.size(), number);
  raw({ digits.data(), static_cast<std::size_t>(result.ptr - digits.data()) });
}

void JsonWriter::value(std::size_t number)
{
  raw(std::to_string(number));
}

void JsonWriter::value(int number)
{
  raw(std::to_string(number));
}

void JsonWriter::value(bool yes)
{
  raw(yes ? "true" : "false");
}

void JsonWriter::value(std::string_view text)
{
  separate();
  quoted(text);
}
} // namespace ransmesh
