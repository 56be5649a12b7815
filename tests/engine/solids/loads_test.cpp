// Loads of the user's on the interfaces of solids.

#include <doctest/doctest.h>

#include "engine/simulation.h"
#include "models/error.h"
#include "tests/engine/solids/solid_models.h"

using namespace spoke;
using namespace spoke::test;
using spatial::Vector;

namespace {

const Vector kForce(3.0, 40.0, -20.0), kMoment(0.5, -0.4, 0.3);

Scenario make_scenario() {
  Scenario scenario;
  scenario.title = "trees";
  scenario.space = make_solid_trees(HubSupport::axle);
  scenario.integration.step = 1e-3;
  scenario.integration.duration = 0.05;
  return scenario;
}

std::shared_ptr<const Load> make_push(const Marker& marker) {
  return make_load("push", {marker},
                   [](double, std::span<const MarkerMotion>, std::span<Wrench> out) {
                     out[0] = {kForce, kMoment};
                   });
}

std::string message_of(const Marker& marker) {
  try {
    const Simulation simulation(make_scenario(), {}, {make_push(marker)});
  } catch (const InputError& error) {
    return error.what();
  }
  return {};
}

}  // namespace

TEST_CASE("a load of the user's on an interface does what one of the scenario does there") {
  for (const char* interface : {"tip", "side"}) {
    Simulation pushed(make_scenario(), {}, {make_push({0, 0, 0.0, Vector::Zero(), interface})});
    Scenario scenario = make_scenario();
    spatial::PointLoad load;
    load.place.subsystem = "tree";
    load.place.body = "arm";
    load.interface = interface;
    load.frame = spatial::LoadFrame::inertial;
    load.force = kForce;
    load.moment = kMoment;
    scenario.space->loads.push_back(load);
    Simulation loaded(scenario), free(make_scenario());
    for (Simulation* simulation : {&pushed, &loaded, &free}) simulation->run_until(0.05);
    const auto tip = [](const Simulation& simulation) {
      return Vector(simulation.sensor("tree.tip.x"), simulation.sensor("tree.tip.y"),
                    simulation.sensor("tree.tip.z"));
    };
    CHECK((tip(loaded) - tip(free)).norm() > 1e-4);
    CHECK((tip(pushed) - tip(loaded)).norm() < 1e-9);
  }
}

TEST_CASE("markers on solids that cannot be are refused in one line") {
  const Vector zero = Vector::Zero();
  CHECK(message_of({0, 0, 0.0, zero, "tp"}).find("interface is \"tp\", did you mean \"tip\"?") !=
        std::string::npos);
  CHECK(message_of({0, 0, 0.0, zero, ""}).find("interface is \"\", expected") != std::string::npos);
  CHECK(message_of({0, 0, 0.5, zero, "tip"}).find("expected the interface of a solid") !=
        std::string::npos);
  CHECK(message_of({0, 0, 0.0, Vector::UnitX(), "tip"}).find("expected the interface of a solid") !=
        std::string::npos);
  CHECK(message_of({0, 3, 0.0, zero, "tip"}).find("belongs to solids") != std::string::npos);
  CHECK(message_of({0, 2, 0.0, zero, "tip"}).find("belongs to solids") != std::string::npos);
}
