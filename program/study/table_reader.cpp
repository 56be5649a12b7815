// Splits lines into cells, and cells into numbers and texts.

#include "program/study/table_reader.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <deque>
#include <limits>
#include <optional>
#include <string_view>

#include "models/count_text.h"
#include "models/error.h"

namespace spoke::study {
namespace {

struct Cell {
  std::string text;
  std::size_t column = 1;  ///< column in the line, from 1
};

std::string place(const std::string& file, std::size_t line, std::size_t column) {
  return file + ':' + std::to_string(line) + ':' + std::to_string(column);
}

std::string trimmed(std::string_view text) {
  const auto first = text.find_first_not_of(" \t");
  if (first == std::string_view::npos) return {};
  return std::string(text.substr(first, text.find_last_not_of(" \t") - first + 1));
}

/// Takes a cell in quotes, which begin at `at`; two quotes within stand for one.
std::string take_quoted(std::string_view line, std::size_t& at, const std::string& where) {
  std::string text;
  for (++at; at < line.size(); ++at) {
    if (line[at] != '"') {
      text += line[at];
    } else if (at + 1 < line.size() && line[at + 1] == '"') {
      text += line[at++];
    } else {
      ++at;
      return text;
    }
  }
  throw InputError(where + ": a quote is not closed, expected another one in this line");
}

std::vector<Cell> split(std::string_view line, const std::string& file, std::size_t number) {
  std::vector<Cell> cells;
  for (std::size_t at = 0; at <= line.size();) {
    const std::size_t begin = std::min(line.find_first_not_of(" \t", at), line.size());
    Cell cell{{}, begin + 1};
    if (begin < line.size() && line[begin] == '"') {
      at = begin;
      cell.text = take_quoted(line, at, place(file, number, begin + 1));
      const std::size_t comma = std::min(line.find(',', at), line.size());
      if (!trimmed(line.substr(at, comma - at)).empty())
        throw InputError(place(file, number, at + 1) +
                         ": text stands behind a quote, expected a comma");
      at = comma + 1;
    } else {
      const std::size_t comma = std::min(line.find(',', at), line.size());
      cell.text = trimmed(line.substr(at, comma - at));
      at = comma + 1;
    }
    cells.push_back(std::move(cell));
  }
  return cells;
}

std::optional<double> number_of(const std::string& text) {
  double number = 0.0;
  const char* begin = text.data() + (text.starts_with('+') ? 1 : 0);
  const auto [end, fault] = std::from_chars(begin, text.data() + text.size(), number);
  if (fault != std::errc{} || end != text.data() + text.size() || text.empty()) return {};
  return number;
}

/// Returns the index of a text among the levels, to which it is added if it is new.
double find_level(const std::string& text, std::vector<Level>& levels) {
  const bool is_flag = text == "true" || text == "false";
  const std::string quoted = is_flag ? text : quote_as_toml(text);
  const auto found = std::find_if(levels.begin(), levels.end(),
                                  [&](const Level& level) { return level.text == quoted; });
  if (found != levels.end()) return found->number;
  levels.push_back({static_cast<double>(levels.size()), quoted});
  return levels.back().number;
}

/// Adds a cell to a column, `is_first` if those before it are empty, as it then remains.
void add_cell(const Cell& cell, const std::string& where, Parameter& parameter, bool& is_first) {
  if (cell.text.empty()) {
    parameter.column.push_back(std::numeric_limits<double>::quiet_NaN());
    return;
  }
  const std::optional<double> number = number_of(cell.text);
  if (number && !std::isfinite(*number))
    throw InputError(where + ": " + parameter.name + ": is " + cell.text +
                     ", expected a finite number");
  if (!is_first && number.has_value() == parameter.is_choice())
    throw InputError(where + ": " + parameter.name + ": is \"" + cell.text + "\", expected a " +
                     (number ? "text" : "number") + ", as in the rows before");
  parameter.column.push_back(number ? *number : find_level(cell.text, parameter.levels));
  is_first = false;
}

/// Whether a head is of a column that says something about runs, and sets no key.
bool is_about_runs(const std::string& head) {
  return head == kLoadCase || head == kPartialFactor || head == kHours;
}

std::vector<Parameter> read_head(const std::vector<Cell>& cells, const std::string& file,
                                 std::size_t line) {
  std::vector<Parameter> parameters;
  for (const Cell& cell : cells) {
    const std::string where = place(file, line, cell.column);
    if (cell.text.empty())
      throw InputError(where + ": a column has no head, expected a key of the scenario");
    for (const Parameter& other : parameters)
      if (other.name == cell.text)
        throw InputError(where + ": is \"" + cell.text +
                         "\" a second time, expected different heads");
    Parameter parameter;
    parameter.name = cell.text;
    if (!is_about_runs(cell.text)) parameter.key = cell.text;
    parameter.kind = ParameterKind::column;
    parameter.place = where;
    parameters.push_back(std::move(parameter));
  }
  return parameters;
}

}  // namespace

std::vector<Parameter> read_table(const std::string& text, const std::string& file) {
  std::vector<Parameter> parameters;
  std::deque<bool> are_first;
  std::size_t number = 0;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = std::min(text.find('\n', at), text.size());
    std::string_view line = std::string_view(text).substr(at, end - at);
    if (line.ends_with('\r')) line.remove_suffix(1);
    at = end + 1;
    ++number;
    if (trimmed(line).empty() || line.starts_with('#')) continue;
    const std::vector<Cell> cells = split(line, file, number);
    if (parameters.empty()) {
      parameters = read_head(cells, file, number);
      are_first.assign(parameters.size(), true);
      continue;
    }
    if (cells.size() != parameters.size())
      throw InputError(place(file, number, 1) + ": has " + counted(std::ssize(cells), "cell") +
                       ", expected " + std::to_string(parameters.size()) + " as in the head");
    for (std::size_t k = 0; k < cells.size(); ++k)
      add_cell(cells[k], place(file, number, cells[k].column), parameters[k], are_first[k]);
  }
  if (parameters.empty() || parameters.front().column.empty())
    throw InputError(file + ": has no rows, expected a line of keys and lines of values");
  return parameters;
}

}  // namespace spoke::study
