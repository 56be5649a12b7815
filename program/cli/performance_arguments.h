#pragma once

// Options of `spoke performance`.

#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace spoke::cli {

/// Options besides scenario and folder, as PerformanceOptions has them.
struct PerformanceArguments {
  std::vector<double> wind;             ///< [m/s]
  std::vector<double> tip_speed_ratio;  ///< of a map
  std::vector<double> pitch;            ///< [rad]
  std::string joint = "pitch";
  std::string rotor;
  bool is_rigid = false;
};

/// Adds --wind, --tip-speed-ratio, --pitch, --joint, --rotor and --rigid.
void add_performance_options(CLI::App& command, PerformanceArguments& arguments);

}  // namespace spoke::cli
