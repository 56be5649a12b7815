// Tests loads of the user's own: their mechanics, their nodes, and failures.

#include "engine/load.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <exception>

#include "engine/bodies/act/user_load/user_loads.h"
#include "engine/step/step_graph_builder.h"
#include "graph/declaration_check.h"
#include "models/error.h"
#include "tests/approx.h"
#include "tests/engine/load_rotors.h"
#include "tests/message_of.h"

using namespace spoke;
using namespace spoke::test;
using spoke::testing::approx;

namespace {

void make_hub(int kind, Rotor& rotor) {
  if (kind > 0) rotor.hub.drive = TorqueDrive{Curve(0.1), 1.0};
  if (kind > 1) rotor.hub.support = HubSupport::free;
}

/// Returns the largest difference of the sensors.
double largest_difference(const Simulation& a, const Simulation& b) {
  double largest = 0.0;
  for (std::size_t k = 0; k < a.sensor_values().size(); ++k)
    largest = std::max(largest, std::abs(a.sensor_values()[k] - b.sensor_values()[k]));
  return largest;
}

/// Visits a soft scenario of 0.04 s with each formulation, method and kind of hub.
template <class Visit>
void for_each_kind(Visit visit) {
  for (const Formulation formulation : formulations())
    for (const IntegrationMethod method :
         {IntegrationMethod::generalized_alpha, IntegrationMethod::rk4})
      for (const int hub : {0, 1, 2}) {
        CAPTURE(hub);
        Scenario scenario = soft_scenario(method, 0.04);
        make_hub(hub, scenario.rotor);
        visit(scenario, formulation);
      }
}

}  // namespace

TEST_CASE("a load equal to a scenario's point load moves the rotor as that does") {
  for_each_kind([](const Scenario& scenario, Formulation formulation) {
    Scenario with_load = scenario;
    PointLoad point;
    point.blade = BladeChoice::number(2);
    point.position = 1.43;  // within an element of the second body
    point.frame = LoadFrame::inertial;
    point.force = {0.3, -0.5};
    point.moment = 0.02;
    with_load.rotor.loads = {point};
    const SimulationOptions options{formulation, ExecutorKind::serial, 1, 1};
    Simulation of_scenario(with_load, options), unloaded(scenario, options);
    Simulation of_user(scenario, options, {steady_load({1, 1, 0.43}, 0.3, -0.5, 0.02)});
    for (Simulation* simulation : {&of_scenario, &unloaded, &of_user}) simulation->run_until(0.04);
    CHECK(largest_difference(of_scenario, of_user) < 1e-12);
    CHECK(largest_difference(of_scenario, unloaded) > 1e-4);
  });
}

TEST_CASE("the work of a follower load is the change of energy, to the order of the method") {
  const auto residual = [](IntegrationMethod method, double step) {
    Scenario scenario = soft_scenario(method, 0.08, step);
    scenario.rotor.hub.support = HubSupport::free;
    scenario.rotor.hub.drive = FreeDrive{2.0};
    // The load is within an element, on a clamped and on a chord body.
    Simulation simulation(scenario, {Formulation::structured, ExecutorKind::serial, 1, 1},
                          {follower({0, 0, 0.37}, 0.5, 0.05), follower({1, 1, 0.81}, 0.4, 0.03)});
    simulation.run_until(scenario.integration.duration);
    CHECK(simulation.sensor("energy.work") > 1e-3);
    return std::abs(simulation.sensor("energy.residual"));
  };
  const auto order = [&](IntegrationMethod method) {
    return std::log2(residual(method, 2e-4) / residual(method, 1e-4));
  };
  CHECK(order(IntegrationMethod::rk4) > 3.5);
  CHECK(order(IntegrationMethod::generalized_alpha) > 1.7);
}

TEST_CASE("a load's work is its force times the velocity of its marker") {
  Scenario scenario = soft_scenario(IntegrationMethod::generalized_alpha, 0.1);
  scenario.rotor.hub.drive = FreeDrive{2.0};
  const Marker marker{0, 1, 0.4};
  Simulation simulation(scenario, {}, {follower(marker, 0.5, 0.05)});
  const auto power = [&] {
    const MarkerState state = simulation.marker(marker);
    return (state.rotation * Eigen::Vector3d(0.0, 0.5, 0.0)).dot(state.velocity) +
           0.05 * state.angular_velocity.z();
  };
  double work = 0.0, before = power();
  while (!simulation.done()) {
    simulation.step();
    const double now = power();
    work += 0.5 * simulation.step_size() * (before + now);
    before = now;
  }
  CHECK(work == approx(simulation.sensor("energy.work")).epsilon(1e-4));
}

TEST_CASE("a damper takes energy away at every step") {
  Scenario scenario = soft_scenario(IntegrationMethod::rk4, 0.1);
  scenario.rotor.hub.drive = FreeDrive{2.0};
  const auto damper = make_load(
      "damper", {{0, 1, 1.0}}, [](double, std::span<const MarkerMotion> in, std::span<Wrench> out) {
        out[0].force = -0.1 * in[0].velocity;
      });
  Simulation simulation(scenario, {}, {damper});
  const auto energy = [&] {
    return simulation.sensor("energy.kinetic") + simulation.sensor("energy.strain");
  };
  const double at_start = energy();
  double before = at_start;
  int rises = 0;
  while (!simulation.done()) {
    simulation.step();
    rises += energy() > before ? 1 : 0;
    before = energy();
  }
  CHECK(rises == 0);
  CHECK(before < 0.99 * at_start);
}

TEST_CASE("a load on two blades moves them as a load on each does, and nothing by no force") {
  const Marker one{0, 1, 0.6}, other{1, 0, 0.9};
  const auto drag = [](double, std::span<const MarkerMotion> in, std::span<Wrench> out) {
    for (std::size_t k = 0; k < in.size(); ++k)
      out[k] = {Eigen::Vector3d(0.3, -0.5, 0.0) - 0.05 * in[k].velocity,
                -0.01 * in[k].angular_velocity};
  };
  const auto nothing = [](double, std::span<const MarkerMotion>, std::span<Wrench>) {};
  for_each_kind([&](Scenario scenario, Formulation formulation) {
    scenario.integration.tolerance = 1e-13;  // blades by themselves iterate less
    const auto run = [&](const Loads& loads) {
      Simulation simulation(scenario, {formulation, ExecutorKind::serial, 1, 1}, loads);
      simulation.run_until(0.04);
      return simulation;
    };
    const Simulation none = run({});
    const Simulation each = run({make_load("a", {one}, drag), make_load("b", {other}, drag)});
    const Simulation both = run({make_load("both", {one, other}, drag)});
    const Simulation idle = run({make_load("idle", {one, other}, nothing)});
    CHECK(largest_difference(both, each) < 1e-11);
    CHECK(largest_difference(idle, none) < 1e-11);
    CHECK(largest_difference(each, none) > 1e-4);
  });
}

TEST_CASE("what a spring between blades stores is what the rotor loses") {
  constexpr double length = 1.0, stiffness = 5.0;
  const Marker one{0, 1, 1.0}, other{1, 0, 0.4};
  const auto error = [&](int hub, double step) {
    Scenario scenario = soft_scenario(IntegrationMethod::rk4, 0.2, step);
    make_hub(hub, scenario.rotor);
    scenario.rotor.hub.drive = FreeDrive{2.0};
    Simulation simulation(scenario, {}, {spring(one, other, length, stiffness, 0.0)});
    const auto stored = [&] {
      const double stretch =
          (simulation.marker(one).position - simulation.marker(other).position).norm() - length;
      return 0.5 * stiffness * stretch * stretch;
    };
    const auto energy = [&] {
      return simulation.sensor("energy.kinetic") + simulation.sensor("energy.strain") + stored();
    };
    const double before = energy(), stored_before = stored();
    simulation.run_until(0.2);
    const double change = std::abs(energy() - before);
    CHECK(change < 1e-2 * std::abs(stored() - stored_before));
    return change;
  };
  for (const int hub : {1, 2}) CHECK(std::log2(error(hub, 2e-4) / error(hub, 1e-4)) > 3.5);
}

TEST_CASE("loads have the same bits on every executor and in every window") {
  for (const bool is_prescribed : {true, false}) {
    Scenario scenario = soft_scenario(IntegrationMethod::generalized_alpha, 0.04);
    if (!is_prescribed) make_hub(2, scenario.rotor);
    for (const bool between : {false, true}) {
      Loads loads{demanding_load(0), demanding_load(1), follower({0, 1, 1.0}, 0.1, 0.0)};
      if (between) loads.push_back(demanding_load_between());
      const auto hash = [&](ExecutorKind kind, int window) {
        Simulation simulation(scenario, {Formulation::structured, kind, 2, window}, loads);
        simulation.run_until(0.04);
        return simulation.state_hash();
      };
      const std::uint64_t serial = hash(ExecutorKind::serial, 1);
      CHECK(serial == hash(ExecutorKind::serial, 15));
      CHECK(serial == hash(ExecutorKind::flow_graph, 1));
      CHECK(serial == hash(ExecutorKind::flow_graph, 15));
      CHECK(serial == hash(ExecutorKind::automatic, 0));
      for (const ExecutorKind kind : graph::executor_kinds()) CHECK(serial == hash(kind, 5));
    }
  }
}

TEST_CASE("the nodes of loads declare what they read and write, and show in traces") {
  for (const int hub : {0, 2}) {
    SystemContext<Plane> context;
    Rotor rotor = soft_rotor();
    make_hub(hub, rotor);
    make_context(rotor, Formulation::structured, make_generalized_alpha(0.8, 1e-3), context);
    place_loads(ask_loads({demanding_load(0), demanding_load(1)}), context.system, context.data);
    std::mt19937 random(3);
    randomize_state(random, context);
    const graph::StepGraph graph = build_step_graph(context);
    start_progress({0.1, PassControl::kEvaluateOnly, false}, context.data);
    for (const graph::DeclarationFault& fault : graph::check_declarations(graph))
      FAIL_CHECK(fault.message);
    CHECK(graph::conflicts_are_ordered(graph));
  }
  Simulation simulation(soft_scenario(IntegrationMethod::generalized_alpha, 0.01), {},
                        {demanding_load(1)});
  const auto nodes = simulation.step_graph().nodes();
  const auto is_load = [](const graph::Node& node) {
    return node.label.stage == "load" && node.label.subsystem == 1;
  };
  CHECK(std::count_if(nodes.begin(), nodes.end(), is_load) == 1);
  CHECK(simulation.trace(2).slices.size() > 0);
}

TEST_CASE("a load that throws ends the step, and the simulation stands before it") {
  for (const bool is_prescribed : {true, false})
    for (const int window : {1, 20}) {
      CAPTURE(window);
      Scenario scenario = soft_scenario(IntegrationMethod::generalized_alpha, 0.05, 1e-3);
      if (!is_prescribed) make_hub(2, scenario.rotor);
      std::atomic<bool> is_broken = false;
      const auto load =
          make_load("wind", {{1, 1, 1.0}},
                    [&](double t, std::span<const MarkerMotion> in, std::span<Wrench> out) {
                      if (is_broken && t > 0.0305) throw std::runtime_error("no wind file");
                      out[0].force = -0.01 * in[0].velocity;
                    });
      const SimulationOptions options{Formulation::structured, ExecutorKind::flow_graph, 2, window};
      Simulation healthy(scenario, options, {load}), simulation(scenario, options, {load});
      healthy.run_until(0.03);
      is_broken = true;
      int told = 0;
      const auto count = [&](double, std::span<const double>) { ++told; };
      const std::string message = message_of<LoadError>([&] { simulation.run_until(0.05, count); });
      CHECK(message.find("the load \"wind\" of blade 2 failed at t = 0.031 s, step 31: no wind "
                         "file") != std::string::npos);
      CHECK(told == 30);
      CHECK(simulation.steps() == 30);
      CHECK(simulation.state_hash() == healthy.state_hash());
      CHECK(largest_difference(simulation, healthy) == 0.0);
      CHECK_THROWS_AS(simulation.step(), LoadError);
      is_broken = false;
      for (Simulation* each : {&simulation, &healthy}) each->run_until(0.05);
      CHECK(simulation.state_hash() == healthy.state_hash());
      CHECK(simulation.sensor("energy.work") == healthy.sensor("energy.work"));
    }
}

TEST_CASE("a load between blades that throws names them, and the simulation stands before it") {
  Scenario scenario = soft_scenario(IntegrationMethod::generalized_alpha, 0.02, 1e-3);
  bool is_broken = false;
  const auto load = make_load("rope", {{1, 1, 1.0}, {0, 1, 1.0}},
                              [&](double t, std::span<const MarkerMotion>, std::span<Wrench>) {
                                if (is_broken && t > 0.0105) throw std::runtime_error("it tore");
                              });
  Simulation simulation(scenario, {}, {load});
  const auto nodes = simulation.step_graph().nodes();
  CHECK(std::any_of(nodes.begin(), nodes.end(), [](const graph::Node& node) {
    return node.label.stage == "load" && node.label.subsystem == -1;
  }));
  const SavedState start = simulation.save();
  is_broken = true;
  const std::string message = message_of<LoadError>([&] { simulation.run_until(0.02); });
  CHECK(message == "the load \"rope\" of blades 1 and 2 failed at t = 0.011 s, step 11: it tore");
  // What the load threw is nested in the error.
  const std::string nested = message_of<std::runtime_error>([&] {
    try {
      simulation.step();
    } catch (const LoadError& error) {
      std::rethrow_if_nested(error);
    }
  });
  CHECK(nested == "it tore");
  CHECK(simulation.steps() == 10);
  is_broken = false;
  simulation.run_until(0.02);
  const std::uint64_t hash = simulation.state_hash();
  simulation.restore(start);
  simulation.run_until(0.02);
  CHECK(simulation.state_hash() == hash);
}

TEST_CASE("a load that is not there is refused with the indices that there are") {
  const Scenario scenario = soft_scenario(IntegrationMethod::generalized_alpha, 0.01);
  const auto load = steady_load({0, 0, 0.5}, 0.0, 0.0, 0.0);
  const auto refused = [&](const Loads& loads) {
    Simulation simulation(scenario, {}, loads);
    return message_of<InputError>([&] { simulation.set_load(7, load); });
  };
  CHECK(refused({}) == "load index 7, expected none");
  CHECK(refused({load}) == "load index 7, expected 0");
  CHECK(refused({load, load}) == "load index 7, expected 0 to 1");
}

TEST_CASE("loads without a place are refused, by name") {
  const Scenario scenario = soft_scenario(IntegrationMethod::generalized_alpha, 0.01);
  const auto refused = [&](std::vector<Marker> markers) {
    return message_of<InputError>(
        [&] { Simulation(scenario, {}, {make_load("gust", std::move(markers), {})}); });
  };
  CHECK(refused({}) == "the load \"gust\": it has no marker, expected one or more");
  CHECK(refused({{2, 0, 0.5}}) == "the load \"gust\": blade index 2, expected 0 to 1");
  CHECK(refused({{0, -1, 0.5}}) == "the load \"gust\": body index -1, expected 0 to 1");
  CHECK(refused({{0, 0, 1.5}}) == "the load \"gust\": station 1.500000, expected 0 to 1");
}

TEST_CASE("a load that pulls out of the plane, or by what is no number, fails") {
  const Scenario scenario = soft_scenario(IntegrationMethod::generalized_alpha, 0.01);
  const auto failure = [&](const Wrench& wrench) {
    return message_of<LoadError>([&] {
      Simulation(scenario, {},
                 {make_load("gust", {{0, 0, 1.0}},
                            [&](double, std::span<const MarkerMotion>, std::span<Wrench> out) {
                              out[0] = wrench;
                            })});
    });
  };
  CHECK(failure({{0.0, 0.0, 1.0}, {0.0, 0.0, 0.0}}).find("x-y plane") != std::string::npos);
  CHECK(failure({{0.0, 0.0, 0.0}, {1.0, 0.0, 0.0}}).find("x-y plane") != std::string::npos);
  CHECK(failure({{NAN, 0.0, 0.0}, {0.0, 0.0, 0.0}}).find("not finite") != std::string::npos);
}

TEST_CASE("errors have a code") {
  const Scenario scenario = soft_scenario(IntegrationMethod::generalized_alpha, 0.01);
  try {
    Simulation(scenario, {}, {make_load("gust", {}, {})});
    FAIL("expected an error");
  } catch (const Error& error) {
    CHECK(error.code() == ErrorCode::bad_input);
  }
}

TEST_CASE("markers of a blade in the plane are found by their distance from the root") {
  const Scenario scenario = soft_scenario(IntegrationMethod::rk4, 0.1);  // two bodies of 1 m
  const std::vector<Marker> markers = markers_at(scenario, 1, std::array{0.0, 1.0, 1.25, 2.0});
  const std::vector<Marker> expected{{1, 0, 0.0}, {1, 0, 1.0}, {1, 1, 0.25}, {1, 1, 1.0}};
  CHECK(markers == expected);
  CHECK(message_of([&] { markers_at(scenario, 0, std::array{-0.1}); }) ==
        "markers_at(): position -0.1, expected 0 to 2 (m)");
}
