// Lines of TOML. Numbers are written so that reading them gives the same bits.

#include "program/foreign/toml_text.h"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <cmath>

#include "program/foreign/input_lines.h"

namespace spoke::foreign {

std::string digits(double number) {
  constexpr double least = 1e-40;
  return std::abs(number) < least ? "0" : fmt::format("{}", number);
}

std::string digits(const std::vector<double>& numbers) {
  std::string text;
  for (const double number : numbers) text += (text.empty() ? "" : ", ") + digits(number);
  return '[' + text + ']';
}

std::string digits(const Eigen::Vector3d& v) {
  return digits(std::vector<double>{v.x(), v.y(), v.z()});
}

std::string quoted(const std::string& text) {
  std::string all;
  for (const char c : printable(text)) {
    if (c == '"' || c == '\\') all += '\\';
    all += c;
  }
  return '"' + all + '"';
}

void Toml::comment(const std::string& text) { text_ += "# " + printable(text) + '\n'; }

void Toml::comment_out(const std::string& lines) {
  for (std::size_t at = 0; at < lines.size();) {
    const std::size_t end = std::min(lines.find('\n', at), lines.size());
    if (end == at)
      text_ += '\n';
    else
      comment(lines.substr(at, end - at));
    at = end + 1;
  }
}

void Toml::table(const std::string& head) { text_ += '\n' + head + '\n'; }

void Toml::key(const std::string& name, const std::string& value, const std::string& from) {
  text_ += name + " = " + value;
  if (!from.empty()) text_ += "   # " + printable(from);
  text_ += '\n';
}

void Toml::lines(const std::string& name, const std::vector<std::string>& values,
                 const std::vector<std::string>& comments) {
  text_ += name + " = [\n";
  for (std::size_t i = 0; i < values.size(); ++i)
    text_ += "  " + values[i] + ",   # " + printable(comments[i]) + '\n';
  text_ += "]\n";
}

void Toml::numbers(const std::string& name, const std::vector<double>& values) {
  if (!values.empty()) text_ += name + " = " + digits(values) + '\n';
}

}  // namespace spoke::foreign
