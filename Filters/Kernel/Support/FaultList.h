// What is wrong with a mesh, counted, as text.
#pragma once

#include <cstddef>
#include <string>

namespace ransmesh
{
class FaultList
{
public:
  // Says nothing of what there is none of.
  void add(std::size_t count, const char* what)
  {
    if (count > 0)
    {
      text_ += (text_.empty() ? "" : ", ") + std::to_string(count) + " " + what;
    }
  }

  const std::string& text() const { return text_; }

private:
  std::string text_;
};
} // namespace ransmesh
