#pragma once

// A file of lines of a value and its key, which are looked for by name, since their order differs
// from version to version.

#include <algorithm>
#include <initializer_list>
#include <string>
#include <string_view>

#include "models/support/quantity.h"
#include "program/foreign/beamdyn_reader.h"
#include "program/foreign/input_lines.h"
#include "program/foreign/value.h"

namespace spoke::foreign {

/// A file that another one names.
struct NamedFile {
  std::string name;  ///< as it is given, relative to the folder of the file that names it
  int line = 0;      ///< where it is given
};

/// Finds keys and checks their values; refuses by InputError with file and line.
class KeyedLines {
 public:
  explicit KeyedLines(const SourceFile& source) : lines_(source.text, source.name) {}

  InputLines& lines() { return lines_; }

  /// Takes the first line, which says what the file is, and returns the second one, a title. Keys
  /// are looked for behind them.
  std::string take_head(std::string_view kind) {
    lines_.take("the first line of " + std::string(kind));
    std::string title = printable(lines_.take("a title"));
    begin_ = 2;
    return title;
  }

  /// Goes before the line of a key.
  void seek(std::string_view key) {
    lines_.rewind(begin_);
    lines_.seek(key);
  }
  bool has(std::string_view key) {
    lines_.rewind(begin_);
    return lines_.has(key);
  }
  std::string text(std::string_view key) {
    seek(key);
    return lines_.take_value(key);
  }
  Value number(std::string_view key) {
    seek(key);
    Value value{lines_.take_number(key), {}};
    value.from = std::string(key) + ", " + lines_.place();
    return value;
  }
  int count(std::string_view key, int least, int most) {
    seek(key);
    return lines_.take_count(key, least, most);
  }
  Value at_least(std::string_view key, double least) {
    Value value = number(key);
    if (value.number < least)
      lines_.refuse(std::string(key) + " is " + describe(value.number) + ", expected " +
                    describe(least) + " or more");
    return value;
  }
  Value positive(std::string_view key) {
    Value value = number(key);
    if (!(value.number > 0.0))
      lines_.refuse(std::string(key) + " is " + describe(value.number) + ", expected more than 0");
    return value;
  }
  /// Whether a flag is there and false.
  bool is_off(std::string_view key) {
    if (!has(key)) return false;
    const std::string flag = text(key);
    const auto is_one_of = [&flag](std::initializer_list<std::string_view> words) {
      return std::any_of(words.begin(), words.end(),
                         [&flag](std::string_view word) { return is_same_word(flag, word); });
    };
    if (is_one_of({"False", "F", ".false."})) return true;
    if (is_one_of({"True", "T", ".true.", "default"})) return false;
    lines_.refuse(std::string(key) + " is \"" + printable(flag) + "\", expected True or False");
  }
  /// A key that other versions spell otherwise, and that may be missing.
  NamedFile file(std::string_view key, std::string_view other) {
    if (!has(key)) key = other;
    if (!has(key)) return {};
    NamedFile named{text(key), 0};
    named.line = lines_.number();
    return named;
  }

 private:
  InputLines lines_;
  std::size_t begin_ = 0;  ///< lines before those with keys
};

}  // namespace spoke::foreign
