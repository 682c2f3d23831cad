#include "Json.h"

#include <charconv>
#include <cmath>
#include <cstdio>
#include <utility>

namespace commandline
{
namespace
{
std::string quoted(const std::string& text)
{
  std::string out = "\"";
  for (const char c : text)
  {
    if (c == '"' || c == '\\')
    {
      out += '\\';
      out += c;
    }
    else if (static_cast<unsigned char>(c) < 0x20)
    {
      char code[8];
      std::snprintf(code, sizeof code, "\\u%04x", c);
      out += code;
    }
    else
    {
      out += c;
    }
  }
  return out + "\"";
}
} // namespace

Json::Json(Kind kind, std::string leaf)
  : kind_(kind)
  , leaf_(std::move(leaf))
{
}

Json Json::text(const std::string& value)
{
  return Json(Kind::Leaf, quoted(value));
}

Json Json::number(double value)
{
  if (!std::isfinite(value))
  {
    return Json(Kind::Leaf, "null");
  }
  char digits[32];
  const auto [end, error] = std::to_chars(digits, digits + sizeof digits, value);
  return Json(Kind::Leaf, std::string(digits, end));
}

Json Json::truth(bool value)
{
  return Json(Kind::Leaf, value ? "true" : "false");
}

Json Json::raw(const std::string& json)
{
  return Json(Kind::Leaf, json);
}

Json Json::object()
{
  return Json(Kind::Object);
}

Json Json::array()
{
  return Json(Kind::Array);
}

Json& Json::add(const std::string& key, const Json& value)
{
  keys_.push_back(key);
  values_.push_back(value);
  return *this;
}

Json& Json::add(const Json& value)
{
  values_.push_back(value);
  return *this;
}

std::string Json::write(int indent) const
{
  if (kind_ == Kind::Leaf)
  {
    return leaf_;
  }
  const bool isObject = kind_ == Kind::Object;
  const std::string margin(indent + 2, ' ');
  std::string out = isObject ? "{" : "[";
  for (std::size_t i = 0; i < values_.size(); ++i)
  {
    out += (i > 0 ? ",\n" : "\n") + margin + (isObject ? quoted(keys_[i]) + ": " : "") +
      values_[i].write(indent + 2);
  }
  out += values_.empty() ? "" : "\n" + std::string(indent, ' ');
  return out + (isObject ? "}" : "]");
}
} // namespace commandline
