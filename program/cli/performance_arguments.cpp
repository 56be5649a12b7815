// Parses lists of wind speeds, tip-speed ratios and pitch angles.

#include "program/cli/performance_arguments.h"

#include <CLI/CLI.hpp>
#include <cmath>
#include <numbers>

#include "program/cli/number_option.h"

namespace spoke::cli {
namespace {

/// An option that takes a number or a range.
struct RangeOption {
  const char* name;
  const char* unit;
  double least;

  /// Returns the numbers that a text gives: "8", or "3:25:1" with both ends as far as the step
  /// meets them.
  std::vector<double> parse(const std::string& text) const {
    constexpr double kMostSteps = 10000, kMost = 1e6;
    const std::string expected = std::string("a number") + (least >= 0.0 ? " above 0" : "") +
                                 " or FROM:TO:STEP, ascending" + unit;
    const auto number = [&](const std::string& part) {
      return parse_number(name, part, least, kMost, expected);
    };
    const std::size_t first = text.find(':'), second = text.find(':', first + 1);
    std::vector<double> values;
    if (first == std::string::npos) {
      values = {number(text)};
    } else {
      const auto refuse = [&] {
        throw CLI::ValidationError(name, "expected " + expected + ", got \"" + text + '"');
      };
      if (second == std::string::npos) refuse();
      const double from = number(text.substr(0, first));
      const double to = number(text.substr(first + 1, second - first - 1));
      const double step = number(text.substr(second + 1));
      const double whole = (to - from) * (1.0 + 1e-9);  // differences of decimals are rounded
      if (!(to > from) || !(step > 0.0) || !(step <= whole)) refuse();
      const double steps = std::floor(whole / step);
      if (steps >= kMostSteps)
        throw CLI::ValidationError(name, "expected 10000 numbers at most, got \"" + text + '"');
      for (int k = 0; k <= static_cast<int>(steps); ++k) values.push_back(from + k * step);
    }
    if (least >= 0.0 && values.front() == 0.0)
      throw CLI::ValidationError(name, "expected " + expected + ", got \"" + text + '"');
    return values;
  }
};

void add_range(CLI::App& command, const RangeOption& option, double scale,
               std::vector<double>& values, const char* text) {
  command
      .add_option_function<std::string>(
          option.name,
          [option, scale, &values](const std::string& given) {
            values = option.parse(given);
            for (double& value : values) value *= scale;
          },
          text)
      ->type_name("FROM:TO:STEP");
}

}  // namespace

void add_performance_options(CLI::App& command, PerformanceArguments& arguments) {
  constexpr double kDegree = std::numbers::pi / 180.0;
  add_range(command, {"--wind", " (m/s)", 0.0}, 1.0, arguments.wind,
            "Speeds of the wind at the hub [m/s], as 3:25:1; of a map one\n"
            "[the scenario's]");
  add_range(command, {"--tip-speed-ratio", "", 0.0}, 1.0, arguments.tip_speed_ratio,
            "Makes a map over tip-speed ratios, as 1:14:0.5, and pitch");
  add_range(command, {"--pitch", " (degrees)", -180.0}, kDegree, arguments.pitch,
            "Angles of the pitch joints in degrees, as -5:10:1; over wind\n"
            "speeds one [that of the control, or as the joints stand]");
  command
      .add_option("--joint", arguments.joint,
                  "Name of the joint that pitches a blade, where there is no\n"
                  "[control.pitch] [pitch]")
      ->type_name("NAME");
  command
      .add_option("--rotor", arguments.rotor, "Name of one of several rotors, which is taken alone")
      ->type_name("NAME");
  command.add_flag("--rigid", arguments.is_rigid, "Keep the blades undeformed");
}

}  // namespace spoke::cli
