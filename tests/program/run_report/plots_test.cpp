#include "program/run_report/plots.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "tests/engine/bodies/space/system/models.h"
#include "tests/program/run_report/scenarios.h"

using namespace spoke;
using namespace spoke::run_report;
using namespace spoke::test;

namespace {

/// Returns the plot with a title. Fails if there is none.
Plot plot_with(const std::vector<Plot>& plots, const std::string& title) {
  const auto found = std::find_if(plots.begin(), plots.end(),
                                  [&](const Plot& plot) { return plot.title == title; });
  REQUIRE_MESSAGE(found != plots.end(), title);
  return *found;
}

/// Returns the sensors that are in some plot, each as often as it is.
std::vector<std::size_t> sensors_of(const std::vector<Plot>& plots) {
  std::vector<std::size_t> sensors;
  for (const Plot& plot : plots)
    for (const Channel& channel : plot.channels) sensors.push_back(channel.first);
  std::sort(sensors.begin(), sensors.end());
  return sensors;
}

}  // namespace

TEST_CASE("only a free hub has a plot of its place") {
  Scenario scenario = test_scenario();
  CHECK(make_plots(Simulation(scenario, test_options())).size() == 8);
  scenario.rotor.hub.support = HubSupport::free;
  scenario.rotor.hub.mass = 10.0;
  const auto plots = make_plots(Simulation(scenario, test_options()));
  REQUIRE(plots.size() == 9);
  CHECK(plots[4].title == "Place of the hub");
}

TEST_CASE("roots and the scenario's own sensors have plots") {
  Scenario scenario = test_scenario();
  scenario.sensors.resize(3);
  scenario.sensors[0].name = "mid";
  scenario.sensors[0].position = 3.0;
  scenario.sensors[1].quantity = SensorQuantity::kinetic_energy;
  scenario.sensors[1].blade = BladeChoice::number(2);
  scenario.sensors[2].quantity = SensorQuantity::momentum;
  const Simulation simulation(scenario, test_options());
  const auto plots = make_plots(simulation);
  REQUIRE(plots.size() == 8 + 3 + 1 + 3);
  CHECK(plots[7].title == "Bending moment at the root");
  CHECK(plots[7].channels[1].first == simulation.sensor_index("blade2.root.moment"));
  CHECK(plots[9].title == "mid.y");
  CHECK(plots[9].unit == "m");
  CHECK(plots[9].channels[1].first == simulation.sensor_index("blade2.mid.y"));
  REQUIRE(plots[11].channels.size() == 1);
  CHECK(plots[11].channels[0].name == "blade 2");
  CHECK(plots[11].channels[0].first == simulation.sensor_index("blade2.kinetic_energy"));
  CHECK(plots[14].channels[0].first == simulation.sensor_index("momentum.angular"));
}

TEST_CASE("wind, thrust, power and pitch of a rotor in air come behind its speed and torque") {
  const Simulation simulation(
      parse_scenario(make_text(kTurnedHub, kBooms + kControlledPitch + kAir), "test"),
      test_options());
  const auto plots = make_plots(simulation);
  const std::vector<std::string> titles{"Hub speed",
                                        "Torque on the hub",
                                        "Wind at the hub along the axis",
                                        "Thrust of the air",
                                        "Power of the air",
                                        "Torque of the air",
                                        "Coefficients of thrust and power",
                                        "Pitch by control",
                                        "Rate of pitch by control",
                                        "Energies"};
  REQUIRE(plots.size() > titles.size());
  for (std::size_t k = 0; k < titles.size(); ++k) CHECK(plots[k].title == titles[k]);
  CHECK(plots[4].unit == "W");
  CHECK(plots[6].channels[1].first == simulation.sensor_index("air.power_coefficient"));
  CHECK(plots[7].unit == "rad");
  CHECK(plots[7].channels[0].first == simulation.sensor_index("control.pitch.angle"));
  CHECK(plots[7].channels[1].first == simulation.sensor_index("control.pitch.demand"));
}

TEST_CASE("blades share plots, a support has its own, and every sensor is in one plot") {
  const Simulation simulation(parse_scenario(make_text(kTurnedHub, kBooms + kTower + kAir), "test"),
                              test_options());
  const auto plots = make_plots(simulation);
  const Plot blades = plot_with(plots, "root.force.z");
  REQUIRE(blades.channels.size() == 2);
  CHECK(blades.channels[1].name == "blade 2");
  CHECK(blades.channels[1].first == simulation.sensor_index("blade2.root.force.z"));
  const Plot support = plot_with(plots, "Support: root.force.z");
  REQUIRE(support.channels.size() == 1);
  CHECK(support.channels[0].first == simulation.sensor_index("support.root.force.z"));
  const std::vector<std::size_t> shown = sensors_of(plots);
  REQUIRE(shown.size() == simulation.sensor_names().size());
  for (std::size_t k = 0; k < shown.size(); ++k) CHECK(shown[k] == k);
}
