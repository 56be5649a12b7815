// Parses speeds and numbers of modes.

#include "engine/cli/steady_arguments.h"

#include <CLI/CLI.hpp>
#include <cmath>

namespace spoke::cli {

void add_speed(CLI::App& command, SteadyArguments& arguments) {
  command
      .add_option_function<double>(
          "--speed",
          [&](double speed) {
            if (!std::isfinite(speed))
              throw CLI::ValidationError("--speed", "expected a finite number [rad/s]");
            arguments.speed = speed;
          },
          "Speed of the hub about its axis [the one that the drive leads to]")
      ->type_name("RAD_PER_S");
}

void add_count(CLI::App& command, SteadyArguments& arguments) {
  command
      .add_option("--count", arguments.count,
                  "Modes, from the lowest on: of each blade, or of all\n"
                  "where blades couple")
      ->check(CLI::Range(1, 1000000))
      ->capture_default_str()
      ->type_name("N");
}

}  // namespace spoke::cli
