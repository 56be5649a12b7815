#pragma once

// The content of a study file: a scenario, parameters of it, the combinations of their values, and
// the responses of each run. The file format (TOML) is documented in docs/studies.md.

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "models/scenario.h"
#include "program/study/expression.h"

namespace spoke::study {

/// The largest number of runs of a study.
inline constexpr std::int64_t kMostRuns = 10'000'000;

/// The choice of the combinations of values that are run.
enum class DesignKind {
  grid,             ///< all combinations of the parameters' values
  latin_hypercube,  ///< each parameter's range in as many equal parts as runs, one run in each
  sobol,            ///< points of Sobol's sequence
  saltelli,         ///< the points from which Sobol indices are computed
  table,            ///< the rows of a CSV file
};

/// A value of a list: a number, or another value of TOML, counted as its place in the list.
struct Level {
  double number = 0.0;
  std::string text;  ///< its text in TOML; empty: it is the number
};

/// The source of a parameter's values.
enum class ParameterKind {
  values,       ///< each is one of `levels`
  uniform,      ///< uniform from low to high
  normal,       ///< normal with mean `low` and deviation `high`
  log_uniform,  ///< uniform in the logarithm, from low to high
  expression,   ///< an expression of other parameters
  /// A column of the design's table; `levels` holds texts if there are any. An empty cell, not a
  /// number, leaves the scenario's own value.
  column,
};

/// A parameter of a study.
struct Parameter {
  std::string key;   ///< key of the scenario; empty: used only in expressions
  std::string name;  ///< name in columns; the key unless the file says otherwise
  ParameterKind kind = ParameterKind::values;
  std::vector<Level> levels;
  double low = 0.0, high = 0.0;
  Expression expression;       ///< function of the parameters, by index
  std::vector<double> column;  ///< values by run: numbers, or indices of `levels`
  std::string place;           ///< place in the study file, for messages: "file:4:7: parameter.1"

  /// Whether values are only places in a list, as names are.
  bool is_choice() const { return !levels.empty() && !levels.front().text.empty(); }
};

/// The combinations of values that the parameters take.
struct Design {
  DesignKind kind = DesignKind::grid;
  std::int64_t runs = 0;    ///< in all
  std::int64_t points = 0;  ///< number of points of saltelli: runs / (parameters + 2)
  std::uint64_t seed = 0;
  bool is_scrambled = true;  ///< whether the seed shifts the points of sobol and saltelli
  std::string table;         ///< file
};

/// The kind of a response.
enum class ResponseKind {
  min,
  max,
  mean,
  rms,
  final,
  at,              ///< a time
  first_crossing,  ///< time of the first crossing of a level [s]
  period,          ///< mean time between upward crossings of a level [s]
  history,         ///< all values at output times
  frequency,       ///< frequency of a vibration mode [Hz]
};

/// The direction of crossings that count.
enum class Direction { up, down, any };

/// A response: one number of a run, or a history.
struct Response {
  std::string name;
  ResponseKind kind = ResponseKind::min;
  std::string sensor;           ///< name of the sensor; empty for frequencies
  double from = 0.0, to = 0.0;  ///< window of time [s]
  double time = 0.0;            ///< time of an `at` response [s]
  /// Level of crossings, in the sensor's unit; none: the mean, for period.
  std::optional<double> level;
  Direction direction = Direction::any;
  std::optional<double> every;  ///< time between values of a history [s]; none: output.interval
  int mode = 0;                 ///< number of the mode of a frequency, from 1; 0: by name
  std::string mode_name, mode_of;
  /// Hub speed of a frequency [rad/s]; none: the one that the drive leads to.
  std::optional<double> speed;
  std::string unit;   ///< unit, "m"; for sensors filled in by check_study()
  std::string place;  ///< place in the study file, for messages
};

/// The statistics of sensors that a study keeps of each run.
struct StatisticsPlan {
  /// Names of sensors, or their beginnings with "*" behind; none: all sensors.
  std::vector<std::string> asked;
  std::vector<double> exponents;  ///< of Woehler's curves
  double from = 0.0;              ///< time from which steps count [s]
  double cycles = 1e7;            ///< that lifetime loads are equivalent to
  std::string place;              ///< place in the study file, for messages
  // Filled in by check_study().
  std::vector<std::string> sensors, units;
};

/// The content of a study file.
struct Study {
  std::string file;
  std::string name;   ///< the file's name without folder and ending
  std::string title;  ///< title for people
  std::string text;   ///< text of the file
  std::string scenario_file;
  std::string scenario_text;
  Design design;
  std::string table_text;  ///< text of the design's table
  Overrides replaced;      ///< set in all runs, before the parameters
  std::vector<Parameter> parameters;
  std::vector<Response> responses;
  std::optional<StatisticsPlan> statistics;

  /// Returns whether runs step through time, or only vibration modes are asked for.
  bool simulates() const;
  /// Returns whether a response is a history.
  bool has_histories() const;
};

/// The most bytes of the names of all parameters, or of all responses, with a line end each, and of
/// a title: an attribute of HDF5 holds 64 kB.
inline constexpr std::size_t kMostNameBytes = 60'000;
// Columns of tables that are no keys of scenarios: the name of a load case, its partial safety
// factor, and the hours of a lifetime that a run stands for.
inline constexpr std::string_view kLoadCase = "load_case", kPartialFactor = "partial_factor",
                                  kHours = "hours";
/// Returns whether a text may head a column: it has no comma, quote or control character, and is
/// not empty.
bool is_column_name(std::string_view text);

/// Returns the text in quotes, as TOML reads it.
std::string quote_as_toml(std::string_view text);

/// Returns "grid", "latin_hypercube", "sobol", "saltelli" or "table".
std::string_view name_of(DesignKind kind);
/// Returns "values", "uniform", "normal", "log_uniform", "expression" or "column".
std::string_view name_of(ParameterKind kind);
/// Returns "min", "max", ..., "frequency".
std::string_view name_of(ResponseKind kind);
/// Returns "up", "down" or "any".
std::string_view name_of(Direction direction);

}  // namespace spoke::study
