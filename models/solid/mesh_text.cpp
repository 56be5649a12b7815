// Words and numbers of a mesh file, by std::from_chars.

#include "models/solid/mesh_text.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>

namespace spoke::solid {
namespace {

bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\r' || c == '\f' || c == '\v'; }

template <class Number>
bool read_all(std::string_view text, Number& number) {
  if (text.starts_with('+') && !text.starts_with("+-")) text.remove_prefix(1);
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  return error == std::errc() && end == text.data() + text.size();
}

/// Describes the integers of a range.
std::string describe_range(std::int64_t least, std::int64_t most) {
  std::string from = std::to_string(least);
  if (least == most) return from;
  if (most >= std::numeric_limits<std::int32_t>::max()) return "an integer of " + from + " or more";
  return "an integer from " + from + " to " + std::to_string(most);
}

}  // namespace

void refuse_mesh(const std::string& file, int line, const std::string& what) {
  const std::string place = line > 0 ? file + ':' + std::to_string(line) : file;
  throw InputError(place + ": " + what, {.file = file, .line = line});
}

std::string show_text(std::string_view text) {
  constexpr std::size_t kMost = 40;
  std::string shown = "\"";
  for (const char c : text.substr(0, kMost)) shown += c >= ' ' && c <= '~' ? c : '?';
  return shown + (text.size() > kMost ? "...\"" : "\"");
}

bool read_number(std::string_view text, double& number) {
  if (read_all(text, number)) return std::isfinite(number);
  std::string copy(text.substr(0, 64));
  const std::size_t exponent = copy.find_first_of("dD");
  if (exponent == std::string::npos || text.size() > 64) return false;
  copy[exponent] = 'e';
  if (copy.compare(exponent + 1, 1, "+") == 0) copy.erase(exponent + 1, 1);
  return read_all(std::string_view(copy), number) && std::isfinite(number);
}

bool read_number(std::string_view text, std::int64_t& number) { return read_all(text, number); }

std::string_view trim(std::string_view text) {
  while (!text.empty() && is_blank(text.front())) text.remove_prefix(1);
  while (!text.empty() && is_blank(text.back())) text.remove_suffix(1);
  return text;
}

bool MeshText::find_word() {
  for (; at_ != end_; ++at_) {
    if (*at_ == '\n')
      ++line_;
    else if (!is_blank(*at_))
      return true;
  }
  return false;
}

bool MeshText::is_at_line_end() {
  while (at_ != end_ && is_blank(*at_)) ++at_;
  return at_ == end_ || *at_ == '\n';
}

std::string_view MeshText::rest_of_line() {
  const char* begin = at_;
  at_ = std::find(at_, end_, '\n');
  std::string_view line(begin, static_cast<std::size_t>(at_ - begin));
  if (at_ != end_) {
    ++at_;
    ++line_;
  }
  if (line.ends_with('\r')) line.remove_suffix(1);
  return line;
}

std::string_view MeshText::word(const char* what) {
  if (!find_word()) refuse_end(what);
  const char* begin = at_;
  while (at_ != end_ && *at_ != '\n' && !is_blank(*at_)) ++at_;
  return {begin, static_cast<std::size_t>(at_ - begin)};
}

double MeshText::number(const char* what) {
  const std::string_view text = word(what);
  double value = 0.0;
  if (!read_number(text, value))
    refuse("is " + show_text(text) + ", expected " + what + ", a finite number");
  return value;
}

std::int64_t MeshText::integer(std::int64_t least, std::int64_t most, const char* what) {
  const std::string_view text = word(what);
  std::int64_t value = 0;
  if (!read_number(text, value) || value < least || value > most)
    refuse("is " + show_text(text) + ", expected " + what + ", " + describe_range(least, most));
  return value;
}

std::string MeshText::quoted(const char* what) {
  if (is_at_line_end() || *at_ != '"')
    refuse(std::string("has no name in quotes, expected ") + what);
  ++at_;
  const char* begin = at_;
  while (at_ != end_ && *at_ != '"' && *at_ != '\n') ++at_;
  if (at_ == end_ || *at_ != '"') refuse("has a name that does not end, expected a quote");
  return {begin, at_++};
}

bool MeshText::skip_behind(std::string_view text) {
  const std::string_view rest(at_, bytes_left());
  const std::size_t found = rest.find(text);
  const std::size_t length = found == std::string_view::npos ? rest.size() : found + text.size();
  line_ += static_cast<int>(std::count(at_, at_ + length, '\n'));
  at_ += length;
  return found != std::string_view::npos;
}

void MeshText::refuse_end(const char* what) const {
  refuse(std::string("the file ends here, expected ") + what);
}

}  // namespace spoke::solid
