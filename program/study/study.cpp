// Names of the choices in a study file.

#include "program/study/study.h"

#include <algorithm>
#include <array>

namespace spoke::study {

bool Study::simulates() const {
  return statistics || std::any_of(responses.begin(), responses.end(), [](const Response& r) {
           return r.kind != ResponseKind::frequency;
         });
}

bool Study::has_histories() const {
  return std::any_of(responses.begin(), responses.end(),
                     [](const Response& r) { return r.kind == ResponseKind::history; });
}

bool is_column_name(std::string_view text) {
  return !text.empty() && std::none_of(text.begin(), text.end(), [](unsigned char c) {
    return c == ',' || c == '"' || c < 0x20 || c == 0x7F;
  });
}

std::string quote_as_toml(std::string_view text) {
  std::string quoted = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') quoted += '\\';
    quoted += c;
  }
  return quoted + '"';
}

std::string_view name_of(DesignKind kind) {
  constexpr std::array<std::string_view, 5> names = {"grid", "latin_hypercube", "sobol", "saltelli",
                                                     "table"};
  return names[static_cast<std::size_t>(kind)];
}

std::string_view name_of(ParameterKind kind) {
  constexpr std::array<std::string_view, 6> names = {"values",      "uniform",    "normal",
                                                     "log_uniform", "expression", "column"};
  return names[static_cast<std::size_t>(kind)];
}

std::string_view name_of(ResponseKind kind) {
  constexpr std::array<std::string_view, 10> names = {
      "min",    "max",     "mean",     "rms", "final", "at", "first_crossing",
      "period", "history", "frequency"};
  return names[static_cast<std::size_t>(kind)];
}

std::string_view name_of(Direction direction) {
  constexpr std::array<std::string_view, 3> names = {"up", "down", "any"};
  return names[static_cast<std::size_t>(direction)];
}

}  // namespace spoke::study
