// Just enough JSON to write a report.
#pragma once

#include <string>
#include <vector>

namespace commandline
{
class Json
{
public:
  static Json text(const std::string& value);
  static Json number(double value); // null for what JSON has no number for
  static Json truth(bool value);
  static Json raw(const std::string& json); // text that is JSON already
  static Json object();
  static Json array();

  Json& add(const std::string& key, const Json& value); // to an object
  Json& add(const Json& value);                         // to an array
  std::string write(int indent = 0) const;

private:
  enum class Kind
  {
    Leaf,
    Object,
    Array
  };
  explicit Json(Kind kind, std::string leaf = "");

  Kind kind_;
  std::string leaf_;
  std::vector<std::string> keys_;
  std::vector<Json> values_;
};
} // namespace commandline
