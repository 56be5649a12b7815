#pragma once

// The lines of a text file of OpenFAST's kind: a value and its key in a line, and tables of
// numbers.

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace spoke::foreign {

/// Throws InputError "file:line: what"; line 0: "file: what".
[[noreturn]] void refuse(const std::string& file, int line, const std::string& what);

/// Returns "file:line".
std::string place(const std::string& file, int line);

/// Returns a text with everything but printable ASCII replaced by question marks.
std::string printable(std::string_view text);

/// Returns whether two texts are equal but for capital and small letters.
bool is_same_word(std::string_view a, std::string_view b);

/// Reads a file's lines from front to back. Words are separated by blanks or commas; one in quotes
/// may have these within it. Whatever is not there is refused by InputError with file and line.
class InputLines {
 public:
  /// Splits the text, which must outlive this object.
  InputLines(std::string_view text, std::string file);

  const std::string& file() const { return file_; }
  /// Returns the number of the line that was taken last, from 1; 0: none yet.
  int number() const { return static_cast<int>(next_); }
  /// Returns "file:line" of the line that was taken last.
  std::string place() const { return foreign::place(file_, number()); }
  [[noreturn]] void refuse(const std::string& what) const;

  /// Takes the next line, without blanks at its ends. `what` is expected: "a title".
  std::string_view take(const std::string& what);
  /// Takes the next line that is not blank.
  std::string_view take_filled(const std::string& what);
  /// Takes the next line that is not blank, which must begin with so many finite numbers; what
  /// follows them is a comment. `what` is expected: "eta of section 3".
  std::vector<double> take_numbers(std::size_t count, const std::string& what);
  /// Takes the next line that is not blank, which must be of a value and then `key`: "3  NumBl".
  /// Returns the value, without quotes.
  std::string take_value(std::string_view key);
  double take_number(std::string_view key);
  /// Takes such a line whose value is a whole number of the range.
  int take_count(std::string_view key, int least, int most);
  /// Goes to the next line of a value and then `key`, which comes next. If there is none, refuses
  /// the file.
  void seek(std::string_view key);
  /// Does so, and takes the line as take_value() does.
  std::string find_value(std::string_view key);
  /// Goes back before the line that was taken last, of which there must be one.
  void step_back() { --next_; }
  /// Returns the number of lines.
  int count() const { return static_cast<int>(lines_.size()); }
  /// Goes back behind so many lines of the beginning.
  void rewind(std::size_t behind = 0) { next_ = behind; }
  /// Returns whether a line of a value and then `key` is still to come.
  bool has(std::string_view key) const;

 private:
  std::string_view line(std::size_t index) const;
  double to_number(std::string_view word, const std::string& what) const;

  std::string file_;
  std::vector<std::string_view> lines_;
  std::size_t next_ = 0;
};

/// Returns the words of a line, at most so many; a word in quotes comes without them.
std::vector<std::string_view> split_words(std::string_view line, std::size_t most = 64);

}  // namespace spoke::foreign
