// Loads of the user's on the interfaces of solids.

#include <doctest/doctest.h>

#include "engine/simulation.h"
#include "tests/contains.h"
#include "tests/engine/solids/solid_models.h"
#include "tests/engine/step/step_declarations.h"
#include "tests/message_of.h"

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

std::string refusal_of(const Marker& marker) {
  return message_of([&] { const Simulation simulation(make_scenario(), {}, {make_push(marker)}); });
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
  CHECK(
      contains(refusal_of({0, 0, 0.0, zero, "tp"}), "interface is \"tp\", did you mean \"tip\"?"));
  CHECK(contains(refusal_of({0, 0, 0.0, zero, ""}), "interface is \"\", expected"));
  CHECK(contains(refusal_of({0, 0, 0.5, zero, "tip"}), "expected the interface of a solid"));
  CHECK(contains(refusal_of({0, 0, 0.0, Vector::UnitX(), "tip"}),
                 "expected the interface of a solid"));
  CHECK(contains(refusal_of({0, 3, 0.0, zero, "tip"}), "belongs to solids"));
  CHECK(contains(refusal_of({0, 2, 0.0, zero, "tip"}), "belongs to solids"));
}

TEST_CASE("a load beyond solids that stiffen declares the memory in which they draw it inward") {
  constexpr int kMass = 2;
  for (const auto coordinates :
       {spatial::SolidCoordinates::reduced, spatial::SolidCoordinates::nodal}) {
    spatial::Model model = make_solid_trees(HubSupport::axle, coordinates);
    model.hub.drive = ConstantSpeed{2.0};
    check_step_declarations(make_system(model), Formulation::structured,
                            make_generalized_alpha(0.8, 5e-4),
                            {make_push({0, 0, 0.0, Vector::Zero(), "tip"}), make_push({0, kMass})});
  }
}

TEST_CASE("springs between solids keep the momentum of a free model") {
  const auto drift = [&](const Marker& marker, double step) {
    Scenario scenario = make_scenario();
    scenario.space = make_solid_trees(HubSupport::free);
    scenario.integration.method = IntegrationMethod::rk4;
    scenario.integration.step = step;
    Sensor momentum;
    momentum.quantity = SensorQuantity::momentum;
    scenario.sensors.push_back(momentum);
    const auto spring =
        make_load("spring", {{0, 0, 0.0, Vector::Zero(), "tip"}, marker},
                  [](double, std::span<const MarkerMotion> at, std::span<Wrench> out) {
                    out[0].force = 300.0 * (at[1].position - at[0].position);
                    out[1].force = -out[0].force;
                  });
    Simulation simulation(scenario, {}, {spring});
    const auto calc_momentum = [&]() {
      Eigen::VectorXd all(6);
      int next = 0;
      for (const char* part : {".x", ".y", ".z", ".angular.x", ".angular.y", ".angular.z"})
        all[next++] = simulation.sensor(std::string("momentum") + part);
      return all;
    };
    const Eigen::VectorXd before = calc_momentum();
    simulation.run_until(0.048);
    return (calc_momentum() - before).norm();
  };
  constexpr int kTree = 0, kPair = 1;
  for (const Marker& marker :
       {Marker{kTree, 0, 0.0, Vector::Zero(), "side"}, Marker{kTree, 1, 0.0, Vector::Zero(), "tip"},
        Marker{kPair, 0, 0.0, Vector::Zero(), "tip"},
        Marker{kPair, 1, 0.0, Vector::Zero(), "tip"}}) {
    CAPTURE(marker.blade);
    CAPTURE(marker.body);
    CHECK(drift(marker, 1.6e-4) / drift(marker, 8e-5) > 11.0);
  }
}

TEST_CASE("a spring on a solid with mean axes does the work that it stores") {
  const Marker tip{1, 0, 0.0, Vector::Zero(), "tip"};
  const Vector anchor(0.2, 1.0, -0.5);
  const auto residual = [&](double step) {
    Scenario scenario = make_scenario();
    scenario.integration.method = IntegrationMethod::rk4;
    scenario.integration.step = step;
    constexpr double kStiffness = 300.0;
    const auto spring = make_load(
        "spring", {tip}, [&](double, std::span<const MarkerMotion> at, std::span<Wrench> out) {
          out[0].force = kStiffness * (anchor - at[0].position);
        });
    Simulation simulation(scenario, {}, {spring});
    const auto stored = [&]() {
      return 0.5 * kStiffness * (simulation.marker(tip).position - anchor).squaredNorm();
    };
    const double before = stored();
    simulation.run_until(0.048);
    CHECK(std::abs(simulation.sensor("energy.work")) > 0.1);
    return std::abs(simulation.sensor("energy.work") + stored() - before);
  };
  CHECK(residual(1.6e-4) / residual(8e-5) > 12.0);
}
