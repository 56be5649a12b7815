// Loads of the user's own on every model of the zoo: they act as a scenario's do.

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <memory>
#include <span>
#include <string>
#include <variant>
#include <vector>

#include "engine/load.h"
#include "engine/simulation.h"
#include "models/tree/tree.h"
#include "tests/engine/laws/zoo.h"
#include "tests/engine/serial.h"

using namespace spoke;
using namespace spoke::test;

namespace {

/// A load that a scenario has, and the same one of the user's.
struct Pair {
  Scenario loaded;
  std::shared_ptr<const Load> own;
};

/// The force and the moment, which keep their direction in space; in the plane z is no direction of
/// forces, and the only one of moments.
Wrench choose_wrench(bool in_space) {
  Wrench wrench{{3.0, -5.0, 2.0}, {0.1, -0.2, 0.4}};
  if (!in_space) wrench.force.z() = wrench.moment.x() = wrench.moment.y() = 0.0;
  return wrench;
}

std::shared_ptr<const Load> make_own(const Marker& marker, const Wrench& wrench) {
  return make_load(
      "own", {marker},
      [wrench](double, std::span<const MarkerMotion>, std::span<Wrench> out) { out[0] = wrench; });
}

/// Returns the body of a subsystem's scenario that a body of its tree is, or is part of.
const spatial::Body& find_body(const spatial::Subsystem& subsystem, const std::string& name) {
  return *std::find_if(subsystem.bodies.begin(), subsystem.bodies.end(),
                       [&name](const spatial::Body& body) { return name.starts_with(body.name); });
}

/// Lets a load act on the last body of the first subsystem that is its own, no hub that it carries:
/// on its tip, an interface, or a point
/// beside its axes. Returns the place as a marker.
Marker choose_place(const spatial::Model& model, spatial::PointLoad& load) {
  const spatial::Tree tree = spatial::build_trees(model).front();
  const spatial::Subsystem& subsystem = model.subsystems.front();
  std::size_t last = tree.bodies.size() - 1;
  while (tree.bodies[last].is_hub()) --last;
  const spatial::Body& body = find_body(subsystem, tree.bodies[last].name);
  load.place.subsystem = subsystem.name;
  load.place.body = body.name;
  Marker marker{0, static_cast<int>(last), 0.0};
  if (std::holds_alternative<spatial::RigidBody>(body.shape))
    load.point = marker.point = {0.1, 0.02, -0.03};
  else if (const auto* solid = std::get_if<spatial::SolidBody>(&body.shape))
    load.interface = marker.interface = solid->interfaces.back().name;
  else
    marker.station = 1.0;
  return marker;
}

constexpr double kAlongBlade = 0.7;  // place of the load by the length of the blade

/// Adds the load to a model; returns its place.
Marker add_load(const Wrench& wrench, const Scenario& scenario, spatial::Model& model) {
  spatial::PointLoad load;
  load.frame = spatial::LoadFrame::inertial;
  load.force = wrench.force;
  load.moment = wrench.moment;
  Marker marker;
  if (model.blades.empty()) {
    marker = choose_place(model, load);
  } else {
    load.place.blade = BladeChoice::number(1);
    load.position = kAlongBlade * model.blades.front().beam.length;
    marker = markers_at(scenario, 0, std::vector{*load.position}).front();
  }
  model.loads.push_back(load);
  return marker;
}
Marker add_load(const Wrench& wrench, const Scenario& scenario, Rotor& rotor) {
  PointLoad load;
  load.blade = BladeChoice::number(1);
  load.frame = LoadFrame::inertial;
  load.position = kAlongBlade * rotor.blades.front().length;
  load.force = wrench.force.head<2>();
  load.moment = wrench.moment.z();
  rotor.loads.push_back(load);
  return markers_at(scenario, 0, std::vector{*load.position}).front();
}

Pair make_pair_of(const Scenario& scenario) {
  const Wrench wrench = choose_wrench(scenario.space.has_value());
  Pair pair{scenario, nullptr};
  pair.own = make_own(scenario.space ? add_load(wrench, scenario, *pair.loaded.space)
                                     : add_load(wrench, scenario, pair.loaded.rotor),
                      wrench);
  return pair;
}

Simulation run_whole(const Scenario& scenario, const Loads& loads) {
  Simulation simulation(scenario, kSerial, loads);
  simulation.run_until(scenario.integration.duration);
  return simulation;
}

/// Of the sensors of one unit: their size, and how much those of runs differ.
struct Difference {
  double size = 0.0, of_own = 0.0, of_none = 0.0;
};

/// Compares a run by the load of a scenario with one by that of the user's and one without, by
/// unit.
std::map<std::string, Difference> compare_runs(const Simulation& known, const Simulation& own,
                                               const Simulation& none) {
  std::map<std::string, Difference> differences;
  for (std::size_t k = 0; k < own.sensor_names().size(); ++k) {
    const std::string& name = own.sensor_names()[k];
    Difference& difference = differences[own.sensor_units()[k]];
    const double value = known.sensor(name);
    difference.size = std::max(difference.size, std::abs(value));
    difference.of_own = std::max(difference.of_own, std::abs(own.sensor(name) - value));
    difference.of_none = std::max(difference.of_none, std::abs(none.sensor(name) - value));
  }
  return differences;
}

}  // namespace

TEST_CASE("a load of the user's own moves every model as the same one of the scenario does") {
  constexpr double kTolerance = 1e-10;  // of the iteration
  for (const ZooModel& model : list_zoo()) {
    CAPTURE(model.name);
    Scenario scenario = model.read(12);
    scenario.initial = {};  // loads of the user's own do not count in an equilibrium
    const Pair pair = make_pair_of(scenario);
    const Simulation known = run_whole(pair.loaded, {}), own = run_whole(scenario, {pair.own}),
                     none = run_whole(scenario, {});
    double effect = 0.0;
    for (const auto& entry : compare_runs(known, own, none)) {
      const Difference& difference = entry.second;
      CAPTURE(entry.first);
      CHECK(difference.of_own <= kTolerance * difference.size);
      if (difference.size > 0.0) effect = std::max(effect, difference.of_none / difference.size);
    }
    CHECK(effect > 1e-6);  // else what is equal says nothing
    CHECK(own.sensor("energy.work") != none.sensor("energy.work"));
  }
}
