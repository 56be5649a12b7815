// Lines, their words and numbers.

#include "program/foreign/input_lines.h"

#include <algorithm>
#include <cctype>
#include <cmath>

#include "models/error.h"
#include "models/solid/mesh_text.h"

namespace spoke::foreign {
namespace {

bool is_separator(char c) { return c == ' ' || c == '\t' || c == '\r' || c == ','; }

/// Returns "2  NumBl": how a line of a value and a key looks.
std::string describe_line(std::string_view key) {
  return "a line of a value and then \"" + std::string(key) + "\"";
}

/// Whether a line has a value and then `key`. Headlines do not: "------ FURLING ------".
bool is_line_of(std::string_view line, std::string_view key) {
  if (line.starts_with("--") || line.starts_with("==")) return false;
  const auto words = split_words(line, 2);
  return words.size() == 2 && is_same_word(words[1], key);
}

}  // namespace

void refuse(const std::string& file, int line, const std::string& what) {
  const std::string where = line > 0 ? place(file, line) : file;
  throw InputError(where + ": " + what, {.file = file, .line = line});
}

std::string place(const std::string& file, int line) { return file + ':' + std::to_string(line); }

std::string printable(std::string_view text) {
  std::string shown(text);
  std::replace_if(
      shown.begin(), shown.end(), [](char c) { return c < ' ' || c > '~'; }, '?');
  return shown;
}

bool is_same_word(std::string_view a, std::string_view b) {
  const auto small = [](char c) { return std::tolower(static_cast<unsigned char>(c)); };
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [&](char x, char y) { return small(x) == small(y); });
}

std::vector<std::string_view> split_words(std::string_view line, std::size_t most) {
  std::vector<std::string_view> words;
  std::size_t i = 0;
  while (words.size() < most) {
    while (i < line.size() && is_separator(line[i])) ++i;
    if (i == line.size()) break;
    std::size_t end = i;
    if (line[i] == '"' || line[i] == '\'') {
      end = line.find(line[i], i + 1);
      if (end == std::string_view::npos) end = line.size();
      words.push_back(line.substr(i + 1, end - i - 1));
      i = std::min(end + 1, line.size());
      continue;
    }
    while (end < line.size() && !is_separator(line[end])) ++end;
    words.push_back(line.substr(i, end - i));
    i = end;
  }
  return words;
}

InputLines::InputLines(std::string_view text, std::string file) : file_(std::move(file)) {
  while (!text.empty()) {
    const std::size_t end = text.find('\n');
    lines_.push_back(text.substr(0, end));
    text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
  }
}

void InputLines::refuse(const std::string& what) const { foreign::refuse(file_, number(), what); }

std::string_view InputLines::line(std::size_t index) const { return solid::trim(lines_[index]); }

std::string_view InputLines::take(const std::string& what) {
  if (next_ == lines_.size()) refuse("the file ends here, expected " + what);
  return line(next_++);
}

std::string_view InputLines::take_filled(const std::string& what) {
  for (;;)
    if (const std::string_view taken = take(what); !taken.empty()) return taken;
}

double InputLines::to_number(std::string_view word, const std::string& what) const {
  constexpr double most = 1e30;  // as in scenarios
  double number = 0.0;
  if (!solid::read_number(word, number))
    refuse("found " + solid::show_text(word) + ", expected a number of " + what);
  if (std::abs(number) > most)
    refuse("found " + solid::show_text(word) + ", expected a number of at most 1e30 of " + what);
  return number;
}

std::vector<double> InputLines::take_numbers(std::size_t count, const std::string& what) {
  const auto words = split_words(take_filled(what), count);
  if (words.size() < count)
    refuse("has " + std::to_string(words.size()) + " words, expected " + std::to_string(count) +
           " numbers: " + what);
  std::vector<double> numbers;
  for (const std::string_view word : words) numbers.push_back(to_number(word, what));
  return numbers;
}

std::string InputLines::take_value(std::string_view key) {
  const std::string_view taken = take_filled(describe_line(key));
  if (!is_line_of(taken, key))
    refuse("found " + solid::show_text(taken) + ", expected " + describe_line(key));
  return std::string(split_words(taken, 1)[0]);
}

double InputLines::take_number(std::string_view key) {
  return to_number(take_value(key), std::string(key));
}

int InputLines::take_count(std::string_view key, int least, int most) {
  const std::string value = take_value(key);
  double count = 0.0;
  if (!solid::read_number(value, count) || count != std::floor(count) || count < least ||
      count > most)
    refuse(std::string(key) + " is " + solid::show_text(value) + ", expected a whole number from " +
           std::to_string(least) + " to " + std::to_string(most));
  return static_cast<int>(count);
}

bool InputLines::has(std::string_view key) const {
  return std::any_of(lines_.begin() + static_cast<std::ptrdiff_t>(next_), lines_.end(),
                     [&](std::string_view line) { return is_line_of(solid::trim(line), key); });
}

void InputLines::seek(std::string_view key) {
  if (!has(key)) {
    next_ = lines_.size();
    refuse("the file ends here, expected " + describe_line(key));
  }
  while (!is_line_of(line(next_), key)) ++next_;
}

std::string InputLines::find_value(std::string_view key) {
  seek(key);
  return take_value(key);
}

}  // namespace spoke::foreign
