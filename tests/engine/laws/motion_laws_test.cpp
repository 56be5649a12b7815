// Laws of motions, for every model of the zoo: errors that fall by the order of the integrator, and
// equilibria at which runs stay.

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "engine/simulation.h"
#include "models/error.h"
#include "tests/engine/laws/zoo.h"
#include "tests/engine/serial.h"

using namespace spoke;
using namespace spoke::test;

namespace {

bool is_of_tip(const std::string& name) { return name.find(".tip.") != std::string::npos; }
bool is_of_hub(const std::string& name) {
  return name == "hub.x" || name == "hub.y" || name == "hub.z" || name == "hub.angle";
}

/// Returns the places of tips in the frame of the hub, and that of the hub.
std::vector<double> take_places(const Simulation& simulation, bool with_hub) {
  std::vector<double> places;
  const std::vector<std::string>& names = simulation.sensor_names();
  for (std::size_t k = 0; k < names.size(); ++k)
    if (is_of_tip(names[k]) || (with_hub && is_of_hub(names[k])))
      places.push_back(simulation.sensor_values()[k]);
  return places;
}

double differ(const std::vector<double>& a, const std::vector<double>& b) {
  double most = 0.0;
  for (std::size_t k = 0; k < a.size(); ++k) most = std::max(most, std::abs(a[k] - b[k]));
  return most;
}

double size_of(const std::vector<double>& places) {
  return differ(places, std::vector<double>(places.size(), 0.0));
}

/// Returns the places after some steps of the scenario, each made in `parts` steps.
std::vector<double> run_in(Scenario scenario, int parts) {
  const double duration = scenario.integration.duration;
  scenario.integration.method = IntegrationMethod::generalized_alpha;
  scenario.integration.step /= parts;
  Simulation simulation(scenario, kSerial);
  simulation.run_until(duration);
  return take_places(simulation, true);
}

/// Models that do not stay at what `static` finds, and why.
const std::map<std::string_view, std::string_view> kMoving{
    {"andrews_squeezer", "its motor leaves it no rest"},
    {"articulated_rotor", "blades pitch by their azimuth"},
    {"articulated_rotor, a ring of dampers", "blades pitch by their azimuth"},
    {"fairground_ride", "a rotor on one that turns has no steady state"},
    {"ground_resonance", "a push on the hub"},
    {"helicopter_on_gear", "blades pitch by their azimuth"},
    {"helicopter_on_gear, blades tied", "blades pitch by their azimuth"},
    {"nrel_5mw_in_wind", "gravity and wind turn against the blades"},
    {"nrel_5mw_rotor", "gravity turns against the blades"},
    {"nrel_5mw_turbine", "gravity turns against the blades"},
    {"nrel_5mw_turbine, past its tower", "gravity turns against the blades"},
    {"nrel_5mw_turbine, with a drive train", "gravity turns against the blades"},
    {"quadcopter, a rotor on a rotor", "a rotor on one that turns has no steady state"},
    {"satellite_booms", "a torque slews it"},
    {"shaft_in_bearings", "a push on the disc"},
    {"solid_bracket", "its rotor is out of balance"},
    {"whirl_rotor", "a push on the disc"},
    {"wu_haug_rotor, free hub", "a torque turns it"}};

}  // namespace

TEST_CASE("the errors of every model fall with the square of the step") {
  for (const ZooModel& model : list_zoo()) {
    CAPTURE(model.name);
    const Scenario scenario = model.read(16);
    const std::vector<double> whole = run_in(scenario, 1), half = run_in(scenario, 2),
                              quarter = run_in(scenario, 4);
    const double first = differ(whole, half), second = differ(half, quarter);
    if (first > 1e-12 * size_of(whole)) CHECK(first > 3.0 * second);
  }
}

TEST_CASE("every model stays where static says that it is at rest") {
  int resting = 0;
  for (const ZooModel& model : list_zoo()) {
    if (kMoving.contains(model.name)) continue;
    CAPTURE(model.name);
    Scenario scenario = model.read(12);
    scenario.initial = {InitialState::equilibrium, {}};
    try {
      Simulation simulation(scenario, kSerial);
      const std::vector<double> start = take_places(simulation, false);
      double moved = 0.0;
      simulation.run_until(scenario.integration.duration, [&](double, std::span<const double>) {
        moved = std::max(moved, differ(take_places(simulation, false), start));
      });
      CHECK(moved < 1e-7 * (size_of(start) + 1e-3));
      ++resting;
    } catch (
        const InputError&) {  // joints or a hub that move at the start, a drive without a speed
    }
  }
  CHECK(resting >= 8);
}
