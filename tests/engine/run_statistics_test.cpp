#include "engine/run_statistics.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>
#include <string>
#include <vector>

#include "engine/results.h"
#include "tests/approx.h"
#include "tests/message_of.h"

using namespace spoke;
using spoke::test::message_of;
using spoke::testing::approx;

namespace {

Simulation simulate_blade() {
  constexpr const char* scenario = R"(
[hub.drive]
kind = "spin_up"
speed = 4.0
ramp = 15.0
[blade]
count = 1
length = 8.0
bodies = 1
elements = 2
density = 2766.67
area = 7.299e-5
second_moment = 8.214e-9
youngs_modulus = 6.895e10
[integration]
step = 0.01
duration = 0.1
)";
  SimulationOptions options;
  options.executor = ExecutorKind::serial;
  return Simulation(parse_scenario(scenario, "one.toml"), options);
}

}  // namespace

TEST_CASE("mean and deviation of values are those of closed forms") {
  SeriesStatistics ramp;
  constexpr int n = 101;
  for (int k = 0; k < n; ++k) ramp.add(1e6 + k);
  CHECK(ramp.count() == n);
  CHECK(ramp.mean() == 1e6 + 50.0);
  CHECK(ramp.deviation() == approx(std::sqrt((n * n - 1) / 12.0)));
  CHECK(ramp.min() == 1e6);
  CHECK(ramp.max() == 1e6 + 100.0);
  SeriesStatistics sine;
  for (int k = 0; k < 64; ++k) sine.add(5.0 + 2.0 * std::sin(2.0 * std::numbers::pi * k / 64));
  CHECK(sine.mean() == approx(5.0));
  CHECK(sine.deviation() == approx(std::sqrt(2.0)));
  SeriesStatistics none;
  CHECK(std::isnan(none.mean()));
  CHECK(std::isnan(none.deviation()));
  SeriesStatistics one;
  one.add(3.0);
  CHECK(one.mean() == 3.0);
  CHECK(one.deviation() == 0.0);
}

TEST_CASE("statistics are of models in air, or asked for") {
  const Simulation simulation = simulate_blade();
  CHECK(RunStatistics(simulation).series().empty());
  const RunStatistics asked(simulation, 0.0);
  REQUIRE(asked.series().size() == 2);
  const auto name = [&](int k) { return simulation.sensor_names()[asked.series()[k].sensor]; };
  CHECK(name(0) == "hub.speed");
  CHECK(!asked.series()[0].ranges);
  CHECK(name(1) == "blade1.root.moment");
  CHECK(asked.series()[1].ranges);
  for (const double from : {-1.0, std::nan("")})
    CHECK(message_of([&] { RunStatistics(simulation, from); }) ==
          "RunStatistics: expected a time of 0 or more (s)");
}

TEST_CASE("statistics begin at their time, and leave out what is not finite") {
  const Simulation simulation = simulate_blade();
  RunStatistics rows(simulation, 0.3);
  const std::size_t moment = rows.series()[1].sensor;
  std::vector<double> values(simulation.sensor_names().size(), 0.0);
  for (int k = 0; k <= 10; ++k) {
    values[moment] = k == 5 ? std::nan("") : (k % 2 ? 4.0 : -4.0);
    rows.add_row(0.1 * k, values);
  }
  CHECK(rows.rows() == 8);
  CHECK(rows.first_time() == approx(0.3));
  CHECK(rows.last_time() == approx(1.0));
  const SensorSeries& series = rows.series()[1];
  CHECK(series.values.count() == 7);
  CHECK(series.values.mean() == approx(-4.0 / 7.0));
  // 4, -4, -4, 4, -4, 4, -4: five half cycles of a range of 8 in 0.7 s, one cycle a second.
  CHECK(rows.equivalent_range(series) == approx(8.0 * std::pow(2.5 / 0.7, 0.1)));
  CHECK(std::isnan(rows.equivalent_range(rows.series()[0])));
}

TEST_CASE("the summary has a block of statistics, of the rows that were added") {
  Simulation simulation = simulate_blade();
  SensorStatistics extremes(simulation.sensor_names().size());
  RunStatistics rows(simulation, 0.02);
  std::vector<double> moments;
  const std::size_t moment = simulation.sensor_index("blade1.root.moment");
  simulation.run_until(1.0, [&](double t, std::span<const double> values) {
    extremes.add(t, values);
    rows.add_row(t, values);
    if (t > 0.015) moments.push_back(values[moment]);
  });
  using nlohmann::json;
  const json summary = json::parse(make_summary(simulation, extremes, {}, rows));
  const json& block = summary["statistics"];
  CHECK(block["of"] == "output rows");
  CHECK(block["from_s"] == 0.02);
  CHECK(block["rows"] == 9);
  CHECK(block["first_row_s"].get<double>() == approx(0.02));
  CHECK(block["last_row_s"].get<double>() == approx(0.1));
  CHECK(block["wohler_exponent"] == 10.0);
  CHECK(block["equivalent_frequency_hz"] == 1.0);
  const json& found = block["sensors"]["blade1.root.moment"];
  double sum = 0.0;
  for (const double value : moments) sum += value;
  CHECK(found["unit"] == "N m");
  CHECK(found["mean"].get<double>() == approx(sum / 9.0));
  CHECK(found["min"] == *std::min_element(moments.begin(), moments.end()));
  CHECK(found["max"] == *std::max_element(moments.begin(), moments.end()));
  CHECK(found["damage_equivalent_range"].get<double>() > 0.0);
  CHECK_FALSE(block["sensors"]["hub.speed"].contains("damage_equivalent_range"));
  CHECK_FALSE(json::parse(make_summary(simulation, extremes, {})).contains("statistics"));
}

TEST_CASE("statistics without a row are null") {
  const Simulation simulation = simulate_blade();
  const SensorStatistics extremes(simulation.sensor_names().size());
  const RunStatistics rows(simulation, 5.0);
  using nlohmann::json;
  const json block = json::parse(make_summary(simulation, extremes, {}, rows))["statistics"];
  CHECK(block["rows"] == 0);
  for (const char* value : {"mean", "standard_deviation", "min", "max", "damage_equivalent_range"})
    CHECK(block["sensors"]["blade1.root.moment"][value].is_null());
}

TEST_CASE("moments of each blade are about its own root, with the exponent of its material") {
  constexpr const char* scenario = R"(
world = "space"
[hub]
radius = 1.0
[hub.drive]
kind = "constant"
speed = 1.0
[blade]
count = 3
length = 8.0
precone = 0.2
bodies = 1
elements = 1
[blade.sections]
mass_per_length = 2.0
axial_stiffness = 2e7
flap_stiffness = 2e5
lag_stiffness = 2e5
torsion_stiffness = 2e5
[support]
from = "ground"
[[support.body]]
name = "nacelle"
kind = "rigid"
mass = 100.0
inertia = 50.0
[[support.joint]]
child = "nacelle"
kind = "revolute"
axis = [0, 1, 0]
stiffness = 1e6
[support.axle]
body = "nacelle"
[statistics]
exponents = { blade3 = 12 }
[integration]
step = 0.01
duration = 0.1
)";
  const Simulation simulation(parse_scenario(scenario, "three.toml"),
                              {.executor = ExecutorKind::serial});
  RunStatistics rows(simulation, 0.0);
  // Flapwise every blade has a sine's turning points of +-4, edgewise of +-1, the support +-4.
  std::vector<double> values(simulation.sensor_names().size(), 0.0);
  const auto set_moment = [&](const std::string& name, double x, double y, double z) {
    values[simulation.sensor_index(name + ".root.moment.x")] = x;
    values[simulation.sensor_index(name + ".root.moment.y")] = y;
    values[simulation.sensor_index(name + ".root.moment.z")] = z;
  };
  for (int k = 0; k <= 10; ++k) {
    const double sign = k % 2 ? 1.0 : -1.0, flap = 4.0 * sign, edge = sign;
    for (int blade = 0; blade < 3; ++blade) {
      const double azimuth = 2.0 * std::numbers::pi * blade / 3, c = std::cos(azimuth),
                   s = std::sin(azimuth), up = std::sin(0.2), out = std::cos(0.2);
      // Flapwise about the horizontal across the blade, edgewise about what is normal to both.
      set_moment("blade" + std::to_string(blade + 1), -flap * s - edge * up * c,
                 flap * c - edge * up * s, edge * out);
    }
    set_moment("support", flap, 0.0, 0.0);
    rows.add_row(0.1 * k, values);
  }
  const auto range_of = [&](const std::string& name) {
    for (const SensorSeries& series : rows.series())
      if (simulation.sensor_names()[series.sensor] == name) return rows.equivalent_range(series);
    return -1.0;
  };
  // Ten half cycles in 1 s.
  for (const char* blade : {"blade1", "blade2"}) {
    CHECK(range_of(blade + std::string(".root.moment.y")) == approx(8.0 * std::pow(5.0, 0.1)));
    CHECK(range_of(blade + std::string(".root.moment.z")) == approx(2.0 * std::pow(5.0, 0.1)));
    CHECK(range_of(blade + std::string(".root.moment.x")) < 1e-12);
  }
  CHECK(range_of("blade3.root.moment.y") == approx(8.0 * std::pow(5.0, 1.0 / 12.0)));
  CHECK(range_of("support.root.moment.x") == approx(8.0 * std::pow(5.0, 0.25)));
  const SensorStatistics extremes(simulation.sensor_names().size());
  const auto block =
      nlohmann::json::parse(make_summary(simulation, extremes, {}, rows))["statistics"];
  CHECK(block["wohler_exponent"] == 10.0);
  CHECK(block["sensors"]["blade3.root.moment.y"]["wohler_exponent"] == 12.0);
  CHECK(block["sensors"]["support.root.moment.x"]["wohler_exponent"] == 4.0);
}
