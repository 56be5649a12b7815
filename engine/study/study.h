#pragma once

// What a study file says: a scenario, parameters of it, which values they take together, and what
// is asked of each run. The file format (TOML) is documented in docs/studies.md.

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "engine/study/expression.h"

namespace spoke::study {

/// The largest number of runs of a study.
inline constexpr std::int64_t kMostRuns = 10'000'000;

/// Which combinations of values are run.
enum class DesignKind {
  grid,             ///< all combinations of the parameters' values
  latin_hypercube,  ///< each parameter's range in as many equal parts as runs, one run in each
  sobol,            ///< points of Sobol's sequence
  saltelli,         ///< the points that Sobol indices are found from
  table,            ///< the rows of a CSV file
};

/// A value of a list: a number, or another value of TOML, counted as its place in the list.
struct Level {
  double number = 0.0;
  std::string text;  ///< as TOML writes it; empty: the number says it
};

/// Where the values of a parameter come from.
enum class ParameterKind {
  values,       ///< one of `levels`
  uniform,      ///< evenly from low to high
  normal,       ///< with mean `low` and deviation `high`
  log_uniform,  ///< evenly in the logarithm, from low to high
  expression,   ///< of other parameters
  column,       ///< of the design's table; `levels` if there are texts among them
};

/// A parameter of a study.
struct Parameter {
  std::string key;   ///< of the scenario; empty: only for expressions
  std::string name;  ///< of columns; the key unless the file says another
  ParameterKind kind = ParameterKind::values;
  std::vector<Level> levels;
  double low = 0.0, high = 0.0;
  Expression expression;       ///< of the parameters, by index
  std::vector<double> column;  ///< by run: numbers, or indices of `levels`
  std::string place;           ///< in the study file, for messages: "file:4:7: parameter.1"

  /// Whether values differ by their place in a list alone, as names do.
  bool is_choice() const { return !levels.empty() && !levels.front().text.empty(); }
};

/// Which values the parameters take together.
struct Design {
  DesignKind kind = DesignKind::grid;
  std::int64_t runs = 0;    ///< in all
  std::int64_t points = 0;  ///< of saltelli: runs / (parameters + 2)
  std::uint64_t seed = 0;
  bool is_scrambled = true;  ///< of sobol and saltelli: points are shifted by the seed
  std::string table;         ///< file
};

/// What is asked of a run.
enum class ResponseKind {
  min,
  max,
  mean,
  rms,
  final,
  at,              ///< a time
  first_crossing,  ///< of a level: when [s]
  period,          ///< mean time between upward crossings of a level [s]
  history,         ///< all values at output times
  frequency,       ///< of a vibration mode [Hz]
};

/// Which crossings of a level count.
enum class Direction { up, down, any };

/// A response: one number of a run, or a history.
struct Response {
  std::string name;
  ResponseKind kind = ResponseKind::min;
  std::string sensor;           ///< empty of frequencies
  double from = 0.0, to = 0.0;  ///< window of time [s]
  double time = 0.0;            ///< of `at` [s]
  std::optional<double> level;  ///< of crossings, in the sensor's unit; none, of period: the mean
  Direction direction = Direction::any;
  std::optional<double> every;  ///< of history: between values [s]; none: output.interval
  int mode = 0;                 ///< of frequency: from 1; 0: by name
  std::string mode_name, mode_of;
  std::optional<double> speed;  ///< of frequency [rad/s]; none: the one that the drive leads to
  std::string unit;             ///< "m"; of those of sensors known when a run was looked at
  std::string place;            ///< in the study file, for messages
};

/// A study file.
struct Study {
  std::string file;
  std::string name;   ///< the file's, without folder and ending
  std::string title;  ///< for people
  std::string text;   ///< of the file
  std::string scenario_file;
  std::string scenario_text;
  Design design;
  std::string table_text;  ///< of the design's table
  std::vector<Parameter> parameters;
  std::vector<Response> responses;

  /// Whether runs step through time, or only vibration modes are asked for.
  bool simulates() const;
  /// Whether a response is a history.
  bool has_histories() const;
};

/// The most bytes of the names of all parameters, or of all responses, with a line end each, and of
/// a title: an attribute of HDF5 holds 64 kB.
inline constexpr std::size_t kMostNameBytes = 60'000;
/// Whether a text may head a column: it has no comma, quote or control character, and is not empty.
bool is_column_name(std::string_view text);

/// The text in quotes, as TOML reads it.
std::string quote_as_toml(std::string_view text);

/// "grid", "latin_hypercube", "sobol", "saltelli", "table".
std::string_view name_of(DesignKind kind);
/// "values", "uniform", "normal", "log_uniform", "expression", "column".
std::string_view name_of(ParameterKind kind);
/// "min", "max", ..., "frequency".
std::string_view name_of(ResponseKind kind);
/// "up", "down", "any".
std::string_view name_of(Direction direction);

}  // namespace spoke::study
