// Parses speeds, ranges and numbers of modes.

#include "program/cli/steady_arguments.h"

#include <CLI/CLI.hpp>
#include <cmath>
#include <map>
#include <string>
#include <utility>

#include "program/cli/number_option.h"

namespace spoke::cli {
namespace {

constexpr const char* kRange = "expected FROM:TO:STEP, ascending numbers up to 1e30 [rad/s], got ";
constexpr double kMostSpeeds = 10000;

/// Parses a speed within the limits that scenarios have [rad/s].
double parse_speed(const char* option, const std::string& text, const std::string& refused) {
  constexpr double most = 1e30;
  try {
    return parse_number(option, text, -most, most, "");
  } catch (const CLI::ValidationError&) {
    throw CLI::ValidationError(option, refused);
  }
}

/// Parses "0:12:0.5"; both ends are included as far as the step meets them.
std::vector<double> parse_range(const std::string& text) {
  const std::size_t first = text.find(':'), second = text.find(':', first + 1);
  if (first == std::string::npos || second == std::string::npos)
    throw CLI::ValidationError("--speeds", kRange + text);
  const auto parse = [&](const std::string& part) {
    return parse_speed("--speeds", part, kRange + text);
  };
  const double from = parse(text.substr(0, first));
  const double to = parse(text.substr(first + 1, second - first - 1));
  const double step = parse(text.substr(second + 1));
  if (to == from)
    throw CLI::ValidationError(
        "--speeds", kRange + text + "; of one speed: spoke modes --speed " + text.substr(0, first));
  if (!(to > from) || !(step > 0.0) || !(step <= to - from))
    throw CLI::ValidationError("--speeds", kRange + text);
  const double steps = std::floor((to - from) / step * (1.0 + 1e-9));
  if (steps >= kMostSpeeds)
    throw CLI::ValidationError("--speeds", "expected 10000 speeds at most, got " + text);
  std::vector<double> speeds;
  for (int k = 0; k <= static_cast<int>(steps); ++k) speeds.push_back(from + k * step);
  return speeds;
}

}  // namespace

void add_speeds(CLI::App& command, SteadyArguments& arguments) {
  command
      .add_option_function<std::string>(
          "--speeds", [&](const std::string& text) { arguments.speeds = parse_range(text); },
          "Speeds of the hub about its axis [rad/s], as 0:12:0.5; of several\n"
          "rotors of the first, the others by the ratios of their drives")
      ->required()
      ->type_name("FROM:TO:STEP");
}

namespace {

/// Adds a speed, or one of a rotor, "tail=180", to those that are asked for.
void add_one(const std::string& text, SteadyState& state) {
  const std::size_t equals = text.find('=');
  const std::string name = equals == std::string::npos ? "" : text.substr(0, equals);
  const double speed =
      parse_speed("--speed", equals == std::string::npos ? text : text.substr(equals + 1),
                  "expected a number from -1e30 to 1e30 [rad/s], got \"" + text + '"');
  if (equals == 0) throw CLI::ValidationError("--speed", "expected NAME=RAD_PER_S, got " + text);
  const bool is_second = name.empty() ? std::exchange(state.speed, speed).has_value()
                                      : !state.speeds.emplace(name, speed).second;
  if (is_second)
    throw CLI::ValidationError(
        "--speed", "expected one speed " +
                       (name.empty() ? "without a name" : "of the rotor \"" + name + '"') +
                       ", got another: " + text);
}

}  // namespace

void add_speed(CLI::App& command, SteadyArguments& arguments) {
  command
      .add_option(
          "--speed",
          [&arguments](const CLI::results_t& speeds) {
            for (const std::string& text : speeds) add_one(text, arguments.state);
            return true;
          },
          "Speed of the hub about its axis [the one that the drive leads to];\n"
          "of several rotors of the first, and tail=180 of the one of this\n"
          "name; may be repeated")
      ->type_name("[NAME=]RAD_PER_S")
      ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll)
      ->allow_extra_args(false);
}

void add_range(CLI::App& command, SteadyArguments& arguments) {
  command
      .add_option("--of", arguments.of,
                  "What is varied: speed, of the hub [rad/s], as in campbell, or\n"
                  "load=NAME, a factor of the loads of this name; load=gravity:\n"
                  "of gravity")
      ->required()
      ->check([](const std::string& text) {
        const bool is_load = text.starts_with("load=") && text.size() > 5;
        return text == "speed" || is_load ? std::string()
                                          : "expected speed or load=NAME, got \"" + text + '"';
      })
      ->type_name("speed|load=NAME");
  const auto add_end = [&](const char* option, double& value, const char* text) {
    command
        .add_option_function<std::string>(
            option,
            [option, &value](const std::string& given) {
              value = parse_speed(option, given,
                                  "expected a number from -1e30 to 1e30, got \"" + given + '"');
            },
            text)
        ->required()
        ->type_name("NUMBER");
  };
  add_end("--from", arguments.from, "Where the search begins, with a stable equilibrium");
  add_end("--to", arguments.to, "Where it ends");
  command
      .add_option("--points", arguments.points,
                  "Values in the range at which modes are sought [21]: what\n"
                  "comes and goes between two of them is missed")
      ->check(CLI::Range(2, 10000))
      ->type_name("N");
}

void add_count(CLI::App& command, SteadyArguments& arguments) {
  command
      .add_option("--count", arguments.count,
                  "Modes, from the lowest on: of each blade, or of all\n"
                  "where blades couple [10, or as many as there are]")
      ->check(CLI::Range(1, 1000000))
      ->type_name("N");
}

namespace {

/// Adds --frame with these frames.
void add_frames(CLI::App& command, const std::vector<std::string>& names, const char* text,
                SteadyArguments& arguments) {
  static const std::map<std::string, ModeFrame> frames = {{"turning", ModeFrame::turning},
                                                          {"fixed", ModeFrame::fixed},
                                                          {"floquet", ModeFrame::floquet}};
  command
      .add_option_function<std::string>(
          "--frame", [&](const std::string& name) { arguments.frame = frames.at(name); }, text)
      ->check(CLI::IsMember(names))
      ->type_name("FRAME");
}

}  // namespace

void add_frame(CLI::App& command, SteadyArguments& arguments) {
  add_frames(command, {"turning", "fixed", "floquet"},
             "From where vibrations are seen: turning with the hub; fixed:\n"
             "from outside, of 3 or more equal blades, and round shafts;\n"
             "floquet: of any blades and shafts, by harmonics [fixed on a\n"
             "support and in bearings, or what the rotor allows; else\n"
             "turning]",
             arguments);
}

void add_constant_frame(CLI::App& command, SteadyArguments& arguments) {
  add_frames(command, {"turning", "fixed"},
             "From where motions are seen: turning with the hub; fixed:\n"
             "from outside, of 3 or more equal blades [fixed for a rotor\n"
             "that turns on a support, else turning]",
             arguments);
}

}  // namespace spoke::cli
