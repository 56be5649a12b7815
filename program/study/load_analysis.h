#pragma once

// The loads of all runs of a study: extremes, lifetime loads, and statistics by wind speed.

#include <cstdint>
#include <string>
#include <vector>

#include "program/study/analysis.h"

namespace spoke::study {

/// The least or greatest value of a sensor, times its partial factor, over the runs whose extremes
/// count.
struct Extreme {
  std::size_t sensor = 0;
  bool is_max = false;
  std::int64_t run = -1;    ///< -1: no run counts
  std::string load_case{};  ///< of the run; empty: runs have none
  double time = 0.0;        ///< [s]
  double value = 0.0;
  double factor = 1.0;                 ///< partial safety factor
  std::vector<double> simultaneous{};  ///< values of all sensors at that time, without factor

  double design_value() const { return factor * value; }
};

/// The statistics of a sensor over runs.
struct SensorSummary {
  double mean = 0.0;       ///< mean of the means
  double deviation = 0.0;  ///< root of the mean of the squared deviations
  double min = 0.0, max = 0.0;
  double mean_min = 0.0, mean_max = 0.0;  ///< means of the extremes
  /// Damage-equivalent ranges by exponent: the mean of their powers, to the root.
  std::vector<double> ranges;
};

/// The runs of one load case at one speed of the wind.
struct SpeedGroup {
  std::string load_case;  ///< empty: runs have none
  double speed = 0.0;     ///< [m/s]; not a number: the wind's class has it
  std::int64_t runs = 0;  ///< with statistics
  std::vector<SensorSummary> sensors;
};

/// The loads of a study.
struct LoadAnalysis {
  std::vector<Extreme> extremes;  ///< the least and the greatest by sensor
  /// Groups in the order of their first runs; none where runs have neither load case nor speed, or
  /// in too many groups.
  std::vector<SpeedGroup> groups;
  bool has_hours = false;      ///< whether runs stand for hours of a lifetime
  double hours = 0.0;          ///< of runs with statistics [h]
  double missing_hours = 0.0;  ///< of others [h]
  /// By sensor and exponent: the range that, as often as the plan's cycles, does the damage of all
  /// hours.
  std::vector<std::vector<double>> lifetime;
};

/// The most groups of load case and speed.
inline constexpr std::size_t kMostGroups = 1000;

/// Analyses the statistics of a study that has some; visits all runs once.
LoadAnalysis analyse_loads(const Study& study, const Sampling& sampling,
                           const ForEachRun& for_each);

}  // namespace spoke::study
