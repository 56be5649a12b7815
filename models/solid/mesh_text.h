#pragma once

// Walks through the text of a mesh file, of words and numbers or of bytes.

#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>

#include "models/error.h"

namespace spoke::solid {

/// Throws InputError "file:line: what"; line 0: "file: what".
[[noreturn]] void refuse_mesh(const std::string& file, int line, const std::string& what);

/// Returns a text in quotes, short and printable whatever it holds.
std::string show_text(std::string_view text);

/// Reads a number that is all of the text, "1.5", "+1e3" or Fortran's "1.5D3"; false if it is none.
bool read_number(std::string_view text, double& number);
bool read_number(std::string_view text, std::int64_t& number);

/// Returns a text without blanks at its ends.
std::string_view trim(std::string_view text);

/// A text and the place in it. Everything it reads either is there or is refused by InputError.
class MeshText {
 public:
  MeshText(std::string_view text, std::string file)
      : at_(text.data()), end_(text.data() + text.size()), file_(std::move(file)) {}

  const std::string& file() const { return file_; }
  /// Returns the number of the line at which it stands, from 1.
  int line() const { return line_; }
  std::size_t bytes_left() const { return static_cast<std::size_t>(end_ - at_); }
  bool is_at_end() const { return at_ == end_; }

  [[noreturn]] void refuse(const std::string& what) const { refuse_mesh(file_, line_, what); }
  [[noreturn]] void refuse(int line, const std::string& what) const {
    refuse_mesh(file_, line, what);
  }

  /// Goes on to the next word; false at the end of the text.
  bool find_word();
  /// Returns whether nothing but blanks follows in this line.
  bool is_at_line_end();
  /// Returns what is left of the line, without its end, and goes to the next.
  std::string_view rest_of_line();

  // The next word, on this line or a later one. `what` is expected: "a node's number".
  std::string_view word(const char* what);
  double number(const char* what);
  std::int64_t integer(std::int64_t least, std::int64_t most, const char* what);
  /// Returns a text in quotes of this line.
  std::string quoted(const char* what);

  /// Returns a value of so many bytes; swaps them if `swapped`.
  template <class Value>
  Value binary(bool swapped, const char* what) {
    if (bytes_left() < sizeof(Value)) refuse_end(what);
    char bytes[sizeof(Value)];
    for (std::size_t k = 0; k < sizeof(Value); ++k)
      bytes[swapped ? sizeof(Value) - 1 - k : k] = at_[k];
    at_ += sizeof(Value);
    Value value;
    std::memcpy(&value, bytes, sizeof(Value));
    return value;
  }
  /// Goes behind the next place of a text; false if there is none.
  bool skip_behind(std::string_view text);

 private:
  [[noreturn]] void refuse_end(const char* what) const;

  const char* at_;
  const char* end_;
  std::string file_;
  int line_ = 1;
};

}  // namespace spoke::solid
