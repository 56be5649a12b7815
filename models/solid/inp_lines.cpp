// Splits an .inp file into keywords and data.

#include "models/solid/inp_lines.h"

#include <algorithm>
#include <climits>

namespace spoke::solid {

namespace {

std::string without_blanks(std::string text) {
  std::erase_if(text, [](char c) { return c == ' ' || c == '\t'; });
  return text;
}

}  // namespace

std::string in_capitals(std::string_view text) {
  text = trim(text);
  if (text.size() > 1 && text.front() == '"' && text.back() == '"')
    text = text.substr(1, text.size() - 2);
  std::string capitals(text);
  for (char& c : capitals)
    if (c >= 'a' && c <= 'z') c = static_cast<char>(c - 'a' + 'A');
  return capitals;
}

const std::string* InpKeyword::find(std::string_view parameter) const {
  for (const auto& [found, value] : parameters)
    if (found == parameter) return &value;
  return nullptr;
}

bool InpLines::fill() {
  while (next_.empty()) {
    if (text_.is_at_end()) return false;
    next_line_ = text_.line();
    next_ = trim(text_.rest_of_line());
    if (next_.starts_with("**")) next_ = {};
  }
  return true;
}

bool InpLines::next_data() {
  if (!fill() || next_.front() == '*') return false;
  data_ = next_;
  line_ = next_line_;
  next_ = {};
  return true;
}

bool InpLines::next_keyword(InpKeyword& keyword) {
  while (next_data()) {
  }
  if (!fill()) return false;
  keyword.parameters.clear();
  keyword.line = next_line_;
  std::string all(next_.substr(1));
  next_ = {};
  while (all.ends_with(',') && fill() && next_.front() != '*') {  // goes on in the next line
    all += next_;
    next_ = {};
  }
  std::string_view rest = all;
  for (bool is_name = true; !rest.empty(); is_name = false) {
    const std::size_t comma = std::min(rest.find(','), rest.size());
    const std::string_view item = trim(rest.substr(0, comma));
    rest.remove_prefix(std::min(comma + 1, rest.size()));
    if (is_name) {
      keyword.name = in_capitals(item);
      keyword.key = without_blanks(keyword.name);
      continue;
    }
    const std::size_t equals = std::min(item.find('='), item.size());
    std::string_view value = trim(item.substr(std::min(equals + 1, item.size())));
    if (value.size() > 1 && value.front() == '"' && value.back() == '"')
      value = value.substr(1, value.size() - 2);
    if (!item.empty())
      keyword.parameters.emplace_back(in_capitals(item.substr(0, equals)), std::string(value));
  }
  if (all.empty()) keyword.name = keyword.key = "";
  return true;
}

const std::vector<std::string_view>& InpLines::items() {
  items_.clear();
  std::string_view rest = data_;
  while (!rest.empty()) {
    const std::size_t comma = std::min(rest.find(','), rest.size());
    items_.push_back(trim(rest.substr(0, comma)));
    rest.remove_prefix(std::min(comma + 1, rest.size()));
  }
  return items_;
}

double InpLines::number(std::string_view item, const char* what) const {
  double value = 0.0;
  if (!item.empty() && !read_number(item, value))
    refuse("is " + show_text(item) + ", expected " + what + ", a finite number");
  return value;
}

int InpLines::label(std::string_view item, const char* what) const {
  std::int64_t value = 0;
  if (!read_number(item, value) || value < 1 || value > INT_MAX)
    refuse("is " + show_text(item) + ", expected " + what + ", an integer of 1 or more");
  return static_cast<int>(value);
}

}  // namespace spoke::solid
