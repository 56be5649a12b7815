// Reads values, ranges, distributions and expressions.

#include "program/study/parameter_reader.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "models/error.h"

namespace spoke::study {
namespace {

constexpr std::array<std::string_view, 6> kSources = {"values", "range",       "uniform",
                                                      "normal", "log_uniform", "expression"};

/// Reads a number, text or flag of a list. Texts and flags count as their place in the list.
Level read_level(const TomlValue& value, std::size_t place, const TomlSection& section) {
  if (const auto* integer = value.as_integer()) return {static_cast<double>(*integer), {}};
  if (const auto* number = value.as_floating_point()) {
    if (!std::isfinite(*number))
      section.fail_at("values." + std::to_string(place + 1),
                      "is " + describe(value) + ", expected a finite number");
    return {*number, {}};
  }
  if (const auto* text = value.as_text()) return {static_cast<double>(place), quote_as_toml(*text)};
  if (const auto* flag = value.as_flag())
    return {static_cast<double>(place), *flag ? "true" : "false"};
  section.fail_at("values." + std::to_string(place + 1),
                  "is " + describe(value) + ", expected a number, text in quotes, true or false");
}

void read_values(const TomlSection& section, Parameter& parameter) {
  for (const TomlValue& value : section.values("values"))
    parameter.levels.push_back(read_level(value, parameter.levels.size(), section));
  const auto is_text = [](const Level& level) { return !level.text.empty(); };
  const auto texts = std::count_if(parameter.levels.begin(), parameter.levels.end(), is_text);
  if (texts != 0 && texts != std::ssize(parameter.levels))
    section.fail("values", "mixes numbers with other values, expected values of one type");
}

/// Reads [from, to, count]: count values, evenly spaced, both ends included.
void read_range(const TomlSection& section, Parameter& parameter) {
  constexpr double kMostLevels = 1e6;
  const std::vector<double> range = section.numbers("range", Quantity::any(""), 3);
  const double from = range[0], to = range[1], count = range[2];
  if (!(count >= 2.0) || count > kMostLevels || count != std::floor(count))
    section.fail_at("range.3", "is " + describe(count) +
                                   ", expected a whole number of values from 2 to 1000000");
  if (!(to > from))
    section.fail_at("range.2",
                    "is " + describe(to) + ", expected more than the first, " + describe(from));
  for (int k = 0; k < static_cast<int>(count); ++k) {
    const double share = k / (count - 1.0);
    parameter.levels.push_back({(1.0 - share) * from + share * to, {}});
  }
}

/// Reads [low, high] of a distribution.
void read_interval(const TomlSection& section, std::string_view key, Parameter& parameter) {
  const Quantity quantity =
      parameter.kind == ParameterKind::log_uniform ? Quantity::positive("") : Quantity::any("");
  const std::vector<double> ends = section.numbers(key, quantity, 2);
  parameter.low = ends[0];
  parameter.high = ends[1];
  const std::string second = std::string(key) + ".2";
  if (parameter.kind == ParameterKind::normal) {
    if (!(ends[1] > 0.0))
      section.fail_at(second, "is " + describe(ends[1]) + ", expected a deviation greater than 0");
  } else if (!(ends[1] > ends[0])) {
    section.fail_at(
        second, "is " + describe(ends[1]) + ", expected more than the first, " + describe(ends[0]));
  }
}

std::string read_source(const TomlSection& section) {
  std::string given;
  for (const std::string_view key : kSources) {
    if (!section.has(key)) continue;
    if (!given.empty()) section.fail(key, "stands beside " + given + ", expected one of the two");
    given = key;
  }
  if (given.empty())
    section.fail(
        "", "has no values, expected one of " + join_names({kSources.begin(), kSources.end()}));
  return given;
}

void require_kind(const TomlSection& section, const std::string& source, DesignKind design) {
  const bool is_listed = source == "values" || source == "range";
  if (source == "expression") return;
  if (design == DesignKind::table)
    section.fail(source,
                 "does not go with a table, whose columns are the parameters, expected "
                 "\"expression\"");
  if (design == DesignKind::grid && !is_listed)
    section.fail(source, "does not go with a grid, expected \"values\" or \"range\"");
}

Parameter read_parameter(const TomlSection& section, DesignKind design) {
  Parameter parameter;
  parameter.key = section.text("key", "");
  parameter.name = section.text("name", parameter.key);
  parameter.place = section.place(section.has("key") ? "key" : "");
  if (parameter.name.empty())
    section.fail("", "has no key, expected the key of the scenario, such as \"blade.length\"");
  const std::string source = read_source(section);
  require_kind(section, source, design);
  if (source == "values") {
    read_values(section, parameter);
  } else if (source == "range") {
    read_range(section, parameter);
  } else if (source == "expression") {
    parameter.kind = ParameterKind::expression;
    if (section.text("expression", "").empty())
      section.fail("expression", "is empty, expected arithmetic such as \"2 * blade.length\"");
  } else {
    parameter.kind = source == "uniform"  ? ParameterKind::uniform
                     : source == "normal" ? ParameterKind::normal
                                          : ParameterKind::log_uniform;
    read_interval(section, source, parameter);
  }
  return parameter;
}

/// Refuses a name that is taken or cannot head a column.
void require_new_name(const TomlSection& section, const std::vector<Parameter>& before,
                      const Parameter& parameter) {
  const std::string_view key = section.has("name") ? "name" : "key";
  if (!is_column_name(parameter.name))
    section.fail(key, "has a comma, quote or control character, expected a name of a column");
  std::size_t bytes = parameter.name.size() + 1;
  for (const Parameter& other : before) bytes += other.name.size() + 1;
  if (bytes > kMostNameBytes)
    section.fail(key, "makes the names of parameters " + std::to_string(bytes) +
                          " bytes long together, expected at most " +
                          std::to_string(kMostNameBytes));
  for (const Parameter& other : before) {
    if (other.name == parameter.name)
      section.fail(key, "is \"" + parameter.name + "\" a second time, expected different ones");
    if (!parameter.key.empty() && other.key == parameter.key)
      section.fail("key", "is \"" + parameter.key + "\" a second time, expected different keys");
  }
}

/// Refuses expressions that need one another.
void require_order(std::size_t index, const std::vector<Parameter>& parameters,
                   std::vector<int>& seen, const TomlSection& section) {
  if (seen[index] == 2) return;
  if (seen[index] == 1)
    section.fail("expression", "needs itself, directly or by others, expected one of others alone");
  seen[index] = 1;
  for (const std::size_t other : parameters[index].expression.variables())
    require_order(other, parameters, seen, section);
  seen[index] = 2;
}

/// Reads expressions last, since they may name parameters that stand behind them.
void read_expressions(const std::vector<TomlSection>& sections, std::size_t first,
                      std::vector<Parameter>& parameters) {
  std::vector<std::string> names;
  for (const Parameter& parameter : parameters) names.push_back(parameter.name);
  for (std::size_t i = 0; i < sections.size(); ++i) {
    Parameter& parameter = parameters[first + i];
    if (parameter.kind != ParameterKind::expression) continue;
    try {
      parameter.expression = Expression(sections[i].text("expression", ""), names);
    } catch (const ExpressionError& error) {
      sections[i].fail_expected("expression", std::string("arithmetic: ") + error.what());
    }
    for (const std::size_t other : parameter.expression.variables())
      if (parameters[other].is_choice())
        sections[i].fail("expression", "needs \"" + names[other] +
                                           "\", whose values are texts, expected numbers");
  }
  std::vector<int> seen(parameters.size(), 0);
  for (std::size_t i = 0; i < sections.size(); ++i)
    require_order(first + i, parameters, seen, sections[i]);
}

}  // namespace

void read_parameters(const TomlSection& root, DesignKind design,
                     std::vector<Parameter>& parameters) {
  const std::size_t first = parameters.size();
  TomlSection::Keys keys = {"key", "name"};
  keys.insert(keys.end(), kSources.begin(), kSources.end());
  const std::vector<TomlSection> sections = root.sections("parameter", keys);
  for (const TomlSection& section : sections) {
    Parameter parameter = read_parameter(section, design);
    require_new_name(section, parameters, parameter);
    parameters.push_back(std::move(parameter));
  }
  read_expressions(sections, first, parameters);
  if (parameters.size() == first && design != DesignKind::table)
    root.fail("parameter", "is missing, expected tables headed [[parameter]]");
}

}  // namespace spoke::study
