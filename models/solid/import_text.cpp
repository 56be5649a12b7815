// Reads lines into one buffer: a file without ends of lines costs no memory.

#include "models/solid/import_text.h"

#include <cctype>
#include <cerrno>
#include <charconv>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <limits>

#include "models/solid/mesh_text.h"
#include "models/text_file.h"
#include "spoke/error.h"

namespace spoke::solid {
namespace {

bool separates(char c) { return c == ' ' || c == '\t' || c == '\r' || c == ','; }

bool is_text(std::string_view line) {
  for (const char c : line) {
    const auto code = static_cast<unsigned char>(c);
    if (code < 32 && c != '\t' && c != '\r') return false;
  }
  return true;
}

/// Numbers may begin with +, which from_chars() does not know.
std::string_view without_plus(std::string_view text) {
  if (text.size() > 1 && text[0] == '+' && text[1] != '-') text.remove_prefix(1);
  return text;
}

}  // namespace

void fail_in_file(const std::string& file, int line, const std::string& key,
                  const std::string& sentence) {
  const std::string place = line > 0 ? file + ':' + std::to_string(line) : file;
  throw InputError(place + ": " + sentence, {.file = file, .line = line, .key = key});
}

std::string in_small_letters(std::string_view text) {
  std::string small(text);
  for (char& c : small) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return small;
}

NumberText::NumberText(std::string file, std::string key, const std::string& kind)
    : file_(std::move(file)), key_(std::move(key)) {
  const auto refuse = [&](const std::string& what) { fail_at(0, what + ", expected " + kind); };
  std::error_code error;
  const auto status = std::filesystem::status(file_, error);
  if (status.type() == std::filesystem::file_type::not_found) refuse("no such file");
  if (error) refuse(error.message());
  if (std::filesystem::is_directory(status)) refuse("is a directory");
  errno = 0;
  stream_.open(file_, std::ios::binary);
  if (!stream_) refuse(std::strerror(errno));
}

void NumberText::fail_at(int line, const std::string& sentence) const {
  fail_in_file(file_, line, key_, sentence);
}

bool NumberText::next() {
  for (;;) {
    if (!stream_.getline(buffer_.data(), static_cast<std::streamsize>(buffer_.size()))) {
      if (stream_.bad()) fail_at(0, "cannot be read");
      if (stream_.gcount() == 0) return false;
      ++number_;
      fail("is a line of more than 4000 characters, expected a text file of numbers");
    }
    if (number_ == std::numeric_limits<int>::max()) fail("has too many lines");
    ++number_;
    auto length = static_cast<std::size_t>(stream_.gcount());
    if (!stream_.eof()) --length;  // the end of the line counts
    line_ = std::string_view(buffer_.data(), length);
    if (number_ == 1) line_ = without_byte_order_mark(line_);
    if (!is_text(line_)) fail("is no text, expected a text file of numbers");
    while (!line_.empty() && separates(line_.front())) line_.remove_prefix(1);
    while (!line_.empty() && line_.back() != ',' && separates(line_.back())) line_.remove_suffix(1);
    if (!line_.empty()) break;
  }
  fields_.clear();
  for (std::size_t at = 0; at < line_.size();) {
    std::size_t end = at;
    while (end < line_.size() && !separates(line_[end])) ++end;
    if (end > at) fields_.push_back(line_.substr(at, end - at));
    at = end + 1;
  }
  return true;
}

double NumberText::real(std::size_t field) const {
  std::string text(without_plus(fields_[field]));
  for (char& c : text)
    if (c == 'E' || c == 'D' || c == 'd') c = 'e';
  const char* end = text.data() + text.size();
  double value = 0.0;
  const auto read = std::from_chars(text.data(), end, value);
  if (text.empty() || read.ptr != end || read.ec == std::errc::invalid_argument)
    fail(show_text(fields_[field]) + " is no number, expected a number");
  const bool is_out_of_range = read.ec == std::errc::result_out_of_range;
  if (is_out_of_range && text.find("e-") != std::string::npos) return 0.0;
  if (is_out_of_range || !std::isfinite(value))
    fail(show_text(fields_[field]) + " is not finite, expected a number");
  return value;
}

std::int64_t NumberText::whole(std::size_t field) const {
  constexpr std::int64_t kLargest = 999'999'999'999'999'999;
  std::int64_t value = 0;
  if (!read_number(fields_[field], value) || value > kLargest || value < -kLargest)
    fail(show_text(fields_[field]) + " is no whole number, expected one");
  return value;
}

void NumberText::require_fields(std::size_t count, std::string_view expected) const {
  if (fields_.size() == count) return;
  fail("has " + std::to_string(fields_.size()) + (fields_.size() == 1 ? " field" : " fields") +
       ", expected " + std::string(expected));
}

}  // namespace spoke::solid
