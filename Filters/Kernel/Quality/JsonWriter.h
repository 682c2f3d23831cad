// Writes JSON text: as much of it as a report needs.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace ransmesh
{
// Names come before the values of objects: name("a").value(1). The caller balances begin and end.
class JsonWriter
{
public:
  JsonWriter& name(std::string_view text);
  void value(double number); // null where it is not finite, which JSON cannot say
  void value(std::size_t number);
  void value(int number);
  void value(bool yes);
  void value(std::string_view text);
  void value(const char* text) { value(std::string_view(text)); }
  void beginObject() { begin('{'); }
  void endObject() { end('}'); }
  // On one line.
  void beginArray();
  void endArray();

  const std::string& text() const { return text_; }

private:
  void begin(char bracket);
  void end(char bracket);
  void separate();
  void raw(std::string_view text);
  void quoted(std::string_view text);

  std::string text_;
  int depth_ = 0;
  bool isFirst_ = true;
  bool isNamed_ = false;
  bool inArray_ = false;
};
} // namespace ransmesh
