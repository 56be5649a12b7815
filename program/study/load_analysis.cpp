// Combines the statistics of runs by their factors, hours and speeds.

#include "program/study/load_analysis.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

namespace spoke::study {
namespace {

/// What the parameters say about a run as a load case.
class RunFacts {
 public:
  explicit RunFacts(const Study& study)
      : study_(study),
        load_case_(find(kLoadCase)),
        factor_(find(kPartialFactor)),
        hours_(find(kHours)),
        speed_(find("wind.iec.speed")) {}

  bool has_hours() const { return hours_.has_value(); }
  bool has_groups() const {
    return load_case_ || (speed_ && (study_.design.kind == DesignKind::table ||
                                     study_.design.kind == DesignKind::grid));
  }
  std::string load_case(const std::vector<double>& values) const {
    return load_case_ ? plain_text(study_.parameters[*load_case_], values[*load_case_]) : "";
  }
  /// Returns 1 where no column has factors; not a number: extremes of the run do not count.
  double factor(const std::vector<double>& values) const {
    return factor_ ? values[*factor_] : 1.0;
  }
  double hours(const std::vector<double>& values) const {
    return hours_ && !std::isnan(values[*hours_]) ? values[*hours_] : 0.0;
  }
  double speed(const std::vector<double>& values) const {
    return speed_ ? values[*speed_] : std::numeric_limits<double>::quiet_NaN();
  }

 private:
  std::optional<std::size_t> find(std::string_view name) const {
    for (std::size_t i = 0; i < study_.parameters.size(); ++i)
      if (study_.parameters[i].name == name || study_.parameters[i].key == name) return i;
    return {};
  }

  const Study& study_;
  std::optional<std::size_t> load_case_, factor_, hours_, speed_;
};

/// Takes an extreme of a run if it is beyond the one so far.
void take_extreme(std::int64_t run, const SensorStatistics& statistics, const std::string& of_case,
                  double factor, Extreme& extreme) {
  const double value = extreme.is_max ? statistics.max : statistics.min;
  const double design = factor * value, so_far = extreme.design_value();
  const bool is_beyond = extreme.is_max ? design > so_far : design < so_far;
  if (!std::isfinite(value) || (extreme.run >= 0 && !is_beyond)) return;
  extreme.run = run;
  extreme.load_case = of_case;
  extreme.time = extreme.is_max ? statistics.max_time : statistics.min_time;
  extreme.value = value;
  extreme.factor = factor;
  extreme.simultaneous = extreme.is_max ? statistics.at_max : statistics.at_min;
}

/// A sum of damages of ranges R^m, in units of that of the largest range, so that none overflows.
class DamageSum {
 public:
  explicit DamageSum(double exponent) : exponent_(exponent) {}

  void add(double range, double weight) {
    if (range > largest_) {
      sum_ *= std::pow(largest_ / range, exponent_);
      largest_ = range;
    }
    if (largest_ > 0.0) sum_ += weight * std::pow(range / largest_, exponent_);
  }
  /// Returns the range that does the sum's damage over so much weight.
  double range(double weight) const {
    return weight > 0.0 ? largest_ * std::pow(sum_ / weight, 1.0 / exponent_) : 0.0;
  }

 private:
  double exponent_, largest_ = 0.0, sum_ = 0.0;
};

std::vector<DamageSum> make_sums(const StatisticsPlan& plan) {
  std::vector<DamageSum> sums;
  for (const double exponent : plan.exponents) sums.emplace_back(exponent);
  return sums;
}

/// The sums of one sensor in a group.
struct GroupSums {
  SensorSummary summary;  ///< sums, until finish_group() divides them
  std::vector<DamageSum> damages;
};

void add_to_group(const SensorStatistics& statistics, bool is_first, GroupSums& sums) {
  SensorSummary& s = sums.summary;
  s.mean += statistics.mean;
  s.deviation += statistics.deviation * statistics.deviation;
  s.mean_min += statistics.min;
  s.mean_max += statistics.max;
  s.min = is_first ? statistics.min : std::min(s.min, statistics.min);
  s.max = is_first ? statistics.max : std::max(s.max, statistics.max);
  for (std::size_t e = 0; e < sums.damages.size(); ++e)
    sums.damages[e].add(statistics.ranges[e], 1.0);
}

SensorSummary finish_group(const GroupSums& sums, std::int64_t runs) {
  SensorSummary s = sums.summary;
  const auto count = static_cast<double>(runs);
  s.mean /= count;
  s.deviation = std::sqrt(s.deviation / count);
  s.mean_min /= count;
  s.mean_max /= count;
  for (const DamageSum& damage : sums.damages) s.ranges.push_back(damage.range(count));
  return s;
}

bool is_of(const SpeedGroup& group, const std::string& load_case, double speed) {
  return group.load_case == load_case &&
         (group.speed == speed || (std::isnan(group.speed) && std::isnan(speed)));
}

/// Collects groups; gives up where there are too many.
class Groups {
 public:
  Groups(const StatisticsPlan& plan, bool has_groups) : plan_(plan), has_groups_(has_groups) {}

  void add(const std::string& load_case, double speed,
           const std::vector<SensorStatistics>& statistics) {
    if (!has_groups_) return;
    std::size_t place = 0;
    while (place < groups_.size() && !is_of(groups_[place], load_case, speed)) ++place;
    if (place == kMostGroups) {
      has_groups_ = false;
      groups_.clear();
      return;
    }
    if (place == groups_.size()) {
      groups_.push_back({load_case, speed, 0, {}});
      sums_.emplace_back(plan_.sensors.size(), GroupSums{{}, make_sums(plan_)});
    }
    for (std::size_t i = 0; i < statistics.size(); ++i)
      add_to_group(statistics[i], groups_[place].runs == 0, sums_[place][i]);
    ++groups_[place].runs;
  }

  std::vector<SpeedGroup> take() {
    for (std::size_t g = 0; g < groups_.size(); ++g)
      for (const GroupSums& sums : sums_[g])
        groups_[g].sensors.push_back(finish_group(sums, groups_[g].runs));
    return std::move(groups_);
  }

 private:
  const StatisticsPlan& plan_;
  bool has_groups_;
  std::vector<SpeedGroup> groups_;
  std::vector<std::vector<GroupSums>> sums_;  ///< by group and sensor
};

/// Adds a run's hours to the damages of a lifetime.
void add_hours(double hours, const std::vector<SensorStatistics>& statistics,
               std::vector<std::vector<DamageSum>>& damages) {
  constexpr double kCyclesPerHour = 3600.0;  // of the ranges of a run
  for (std::size_t i = 0; i < statistics.size(); ++i)
    for (std::size_t e = 0; e < damages[i].size(); ++e)
      damages[i][e].add(statistics[i].ranges[e], kCyclesPerHour * hours);
}

}  // namespace

LoadAnalysis analyse_loads(const Study& study, const Sampling& sampling,
                           const ForEachRun& for_each) {
  const StatisticsPlan& plan = *study.statistics;
  const RunFacts facts(study);
  LoadAnalysis loads;
  for (std::size_t i = 0; i < plan.sensors.size(); ++i)
    for (const bool is_max : {false, true})
      loads.extremes.push_back({.sensor = i, .is_max = is_max});
  Groups groups(plan, facts.has_groups());
  std::vector<std::vector<DamageSum>> damages(plan.sensors.size(), make_sums(plan));
  for_each([&](const RunResult& result) {
    const std::vector<double> values = sampling.values(result.run);
    const double hours = facts.hours(values), factor = facts.factor(values);
    const std::string load_case = facts.load_case(values);
    (result.statistics.empty() ? loads.missing_hours : loads.hours) += hours;
    if (result.statistics.empty()) return;
    if (hours > 0.0) add_hours(hours, result.statistics, damages);
    if (!std::isnan(factor))
      for (Extreme& extreme : loads.extremes)
        take_extreme(result.run, result.statistics[extreme.sensor], load_case, factor, extreme);
    groups.add(load_case, facts.speed(values), result.statistics);
  });
  loads.groups = groups.take();
  loads.has_hours = facts.has_hours();
  for (const std::vector<DamageSum>& of_sensor : damages) {
    loads.lifetime.emplace_back();
    for (const DamageSum& damage : of_sensor)
      loads.lifetime.back().push_back(damage.range(plan.cycles));
  }
  return loads;
}

}  // namespace spoke::study
