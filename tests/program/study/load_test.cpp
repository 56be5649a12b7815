#include <doctest/doctest.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "program/study/load_analysis.h"
#include "program/study/sensor_statistics.h"

using namespace spoke::study;

namespace {

constexpr double kEmpty = std::numeric_limits<double>::quiet_NaN();

void add_column(const char* name, const std::vector<double>& values, Study& study) {
  Parameter parameter;
  parameter.name = name;
  parameter.kind = ParameterKind::column;
  parameter.column = values;
  study.parameters.push_back(parameter);
}

/// Three runs of two sensors, of one exponent.
Study make_load_study() {
  Study study;
  study.design.kind = DesignKind::table;
  study.design.runs = 3;
  study.statistics.emplace();
  study.statistics->exponents = {4.0};
  study.statistics->sensors = {"a", "b"};
  study.statistics->units = {"N", "m"};
  add_column("load_case", {1.1, 6.1, 1.2}, study);
  add_column("partial_factor", {1.35, 1.0, kEmpty}, study);
  add_column("hours", {30.0, kEmpty, 10.0}, study);
  return study;
}

SensorStatistics make_statistics(double least, double greatest, double range) {
  SensorStatistics statistics;
  statistics.min = least;
  statistics.max = greatest;
  statistics.ranges = {range};
  statistics.at_min = {least, 1.0};
  statistics.at_max = {greatest, 2.0};
  return statistics;
}

}  // namespace

TEST_CASE("statistics of a sine are those of closed form, whatever is before they begin") {
  const double mean = 1e6, amplitude = 30.0, frequency = 0.5;
  StatisticsPlan plan;
  plan.exponents = {3.0, 10.0};
  plan.from = 2.0;
  SensorCollector collector(plan, {1, 0});
  constexpr int kSteps = 400;  // in a cycle
  for (int k = 0; k <= 26 * kSteps; ++k) {
    const double t = k / (frequency * kSteps);
    const double value =
        mean + amplitude * std::cos(2.0 * std::numbers::pi * (k % kSteps) / kSteps);
    collector.add(t, std::vector<double>{t < plan.from ? -1e9 : 3.0 * t, t < 2.0 ? 1e9 : value});
  }
  const std::vector<SensorStatistics> result = collector.result();
  REQUIRE(result.size() == 2);
  CHECK(result[0].mean == doctest::Approx(mean).epsilon(1e-12));
  CHECK(result[0].deviation == doctest::Approx(amplitude / std::sqrt(2.0)).epsilon(1e-9));
  CHECK(result[0].max == mean + amplitude);
  CHECK(result[0].max_time == 2.0);
  CHECK(result[0].min_time == doctest::Approx(3.0));
  CHECK(result[0].at_min[1] == doctest::Approx(9.0));
  // All ranges are twice the amplitude, and there are `frequency` of them in a second.
  for (std::size_t e = 0; e < 2; ++e)
    CHECK(result[0].ranges[e] ==
          doctest::Approx(2.0 * amplitude * std::pow(frequency, 1.0 / plan.exponents[e])));
  CHECK(result[1].mean == doctest::Approx(3.0 * 0.5 * (2.0 + 52.0)));
}

TEST_CASE("extremes count by their factors, lifetimes by hours, and empty cells for nothing") {
  const Study study = make_load_study();
  const std::vector<SensorStatistics> of_a = {make_statistics(-1.0, 10.0, 2.0),
                                              make_statistics(-5.0, 12.0, 100.0),
                                              make_statistics(-9.0, 99.0, 3.0)};
  const LoadAnalysis loads = analyse_loads(study, Sampling(study), [&](const Visitor& visit) {
    for (std::int64_t run = 0; run < 3; ++run) {
      RunResult result;
      result.run = run;
      result.statistics = {of_a[static_cast<std::size_t>(run)], make_statistics(0.0, 0.0, 0.0)};
      visit(result);
    }
  });
  const Extreme &least = loads.extremes[0], &greatest = loads.extremes[1];
  CHECK(least.run == 1);
  CHECK(greatest.run == 0);  // 13.5 beyond 12, and 99 of fatigue alone does not count
  CHECK(greatest.design_value() == doctest::Approx(13.5));
  CHECK(greatest.simultaneous == std::vector<double>{10.0, 2.0});
  CHECK(greatest.load_case == "1.1");
  CHECK(loads.hours == 40.0);
  const double damage = 3600.0 * (30.0 * std::pow(2.0, 4) + 10.0 * std::pow(3.0, 4));
  CHECK(loads.lifetime[0][0] == doctest::Approx(std::pow(damage / 1e7, 0.25)).epsilon(1e-12));
  CHECK(loads.lifetime[1][0] == 0.0);
  CHECK(loads.groups.size() == 3);
}
