#pragma once

// Lines of numbers of text files that may be large: matrices and tables of nodes.

#include <array>
#include <cstdint>
#include <fstream>
#include <string>
#include <string_view>
#include <vector>

namespace spoke::solid {

/// A text file of numbers, read line by line in a buffer of fixed size. Whatever is wrong throws
/// InputError, its text "file:line: what is wrong, what is expected".
class NumberText {
 public:
  /// Opens a file. `key` is that of the description which names it: "mass"; `kind` is what messages
  /// expect.
  NumberText(std::string file, std::string key, const std::string& kind = "a text file of numbers");

  /// Goes to the next line that is not blank; false at the end of the file. Its fields are
  /// separated by blanks or commas.
  bool next();
  const std::vector<std::string_view>& fields() const { return fields_; }
  std::string_view line() const { return line_; }  ///< without blanks at its ends
  int number() const { return number_; }           ///< of the line, from 1; 0: none yet
  const std::string& file() const { return file_; }
  const std::string& key() const { return key_; }

  /// Returns a field as a finite number. Fortran's D for E is known.
  double real(std::size_t field) const;
  /// Returns a field as a whole number of at most 18 digits.
  std::int64_t whole(std::size_t field) const;
  /// Requires that the line has so many fields, which are `expected`: "row, column and value".
  void require_fields(std::size_t count, std::string_view expected) const;

  /// Throws "file:line: sentence".
  [[noreturn]] void fail(const std::string& sentence) const { fail_at(number_, sentence); }
  /// Throws "file:line: sentence", or "file: sentence" if line is 0.
  [[noreturn]] void fail_at(int line, const std::string& sentence) const;

 private:
  std::string file_;
  std::string key_;
  std::ifstream stream_;
  std::array<char, 4096> buffer_{};
  std::string_view line_;
  std::vector<std::string_view> fields_;
  int number_ = 0;
};

/// Throws InputError "file:line: sentence", or "file: sentence" if line is 0.
[[noreturn]] void fail_in_file(const std::string& file, int line, const std::string& key,
                               const std::string& sentence);

/// Returns text in small letters.
std::string in_small_letters(std::string_view text);

}  // namespace spoke::solid
