// How a stage ended: errors are values, with the text that the user is to read.
#pragma once

#include <string>
#include <utility>

namespace ransmesh
{
struct Outcome
{
  enum class Kind
  {
    Done,
    BadInput,
    Cancelled,
    InternalFault
  };

  Kind kind = Kind::Done;
  std::string message; // what is wrong, where, and what the user can do; empty when done

  bool ok() const { return kind == Kind::Done; }

  static Outcome done() { return {}; }
  static Outcome badInput(std::string text) { return { Kind::BadInput, std::move(text) }; }
  static Outcome cancelled() { return { Kind::Cancelled, "stopped on request" }; }
  static Outcome internalFault(std::string text) { return { Kind::InternalFault, std::move(text) }; }
};
} // namespace ransmesh
