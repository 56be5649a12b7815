// Loads of the user's in space: their mechanics, their nodes, and what happens if they fail.

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "engine/bodies/act/user_load/user_loads.h"
#include "engine/load.h"
#include "engine/simulation.h"
#include "engine/step/step_graph_builder.h"
#include "graph/declaration_check.h"
#include "models/error.h"
#include "tests/engine/bodies/space/system/models.h"
#include "tests/engine/bodies/space/system/runs.h"
#include "tests/message_of.h"

using namespace spoke;
using namespace spoke::test;

namespace {

const SimulationOptions kSerial{Formulation::structured, ExecutorKind::serial, 1, 1};

const Eigen::Vector3d kForce(0.6, -0.9, 1.2), kMoment(0.05, -0.08, 0.11);

/// Bent, swept and twisted blades, whose sections are turned against their bodies.
const std::string kCurved = R"(
[blade]
count = 2
length = 2.0
bodies = 2
elements = 2
[blade.sections]
station = [0.0, 1.0, 2.0]
mass_per_length = 1.0
axial_stiffness = 2e4
lag_stiffness = 40.0
flap_stiffness = 30.0
torsion_stiffness = 30.0
twist = [0.5, 0.2, -0.3]
prebend = [0.0, 0.05, 0.2]
sweep = [0.0, -0.02, 0.1]
mass_center = [[0.02, 0.01], [0.01, -0.01], [0.0, 0.01]]
)";

/// Without numerical damping.
Scenario make_loaded_scenario(const std::string& text, double step,
                              IntegrationMethod method = IntegrationMethod::rk4,
                              double duration = 0.16) {
  Scenario scenario = test::make_scenario(text, step, duration, method);
  scenario.integration.spectral_radius = 1.0;
  return scenario;
}

/// A force and a moment that are constant in the inertial frame, or turn with the section.
std::shared_ptr<const Load> steady(const Marker& marker, bool follows) {
  return make_load("steady", {marker},
                   [follows](double, std::span<const MarkerMotion> in, std::span<Wrench> out) {
                     const Eigen::Matrix3d R =
                         follows ? in[0].rotation : Eigen::Matrix3d::Identity().eval();
                     out[0] = {R * kForce, R * kMoment};
                   });
}

/// Depends on all that a load may depend on, at all its markers.
std::shared_ptr<const Load> demanding(std::vector<Marker> markers) {
  return make_load("demanding", std::move(markers),
                   [](double t, std::span<const MarkerMotion> in, std::span<Wrench> out) {
                     for (std::size_t k = 0; k < in.size(); ++k) {
                       const MarkerMotion& other = in[(k + 1) % in.size()];
                       out[k].force = -0.3 * in[k].velocity + 0.1 * t * other.position +
                                      in[k].rotation * Eigen::Vector3d(0.0, 0.4, 0.5);
                       out[k].moment = -0.02 * other.angular_velocity;
                     }
                   });
}

std::string list(const Eigen::Vector3d& v) {
  return "[" + std::to_string(v.x()) + ", " + std::to_string(v.y()) + ", " + std::to_string(v.z()) +
         "]\n";
}

double largest_difference(const Simulation& a, const Simulation& b) {
  double largest = 0.0;
  for (std::size_t k = 0; k < a.sensor_values().size(); ++k)
    largest = std::max(largest, std::abs(a.sensor_values()[k] - b.sensor_values()[k]));
  return largest;
}

}  // namespace

TEST_CASE("a load in space that equals a scenario's moves the model as that does") {
  const auto check = [](const std::string& hub, const std::string& bodies, const std::string& place,
                        const std::shared_ptr<const Load>& user) {
    const std::string load =
        "[[load]]\n" + place + "force = " + list(kForce) + "moment = " + list(kMoment);
    Simulation of_user(make_loaded_scenario(make_text(hub, bodies), 1e-3), kSerial, {user});
    Simulation of_scenario(make_loaded_scenario(make_text(hub, bodies, load), 1e-3), kSerial);
    Simulation unloaded(make_loaded_scenario(make_text(hub, bodies), 1e-3), kSerial);
    for (Simulation* simulation : {&of_scenario, &unloaded, &of_user}) simulation->run_until(0.1);
    CHECK(largest_difference(of_scenario, of_user) < 1e-10);
    CHECK(largest_difference(of_scenario, unloaded) > 1e-3);
  };
  const Scenario curved = make_loaded_scenario(make_text(kDrivenHub, kCurved), 1e-3);
  const Marker at = markers_at(curved, 1, std::array{1.43})[0];
  CHECK(at.body == 1);
  const std::string place = "blade = 2\nposition = 1.43\n";
  check(kDrivenHub, kCurved, place + "frame = \"inertial\"\n", steady(at, false));
  check(kDrivenHub, kCurved, place + "frame = \"section\"\n", steady(at, true));
  // On a rigid body: boom, bracket, slider, screw, mirror.
  const Eigen::Vector3d point(0.1, 0.2, -0.1);
  const std::string on_mirror = "subsystem = \"arm\"\nbody = \"mirror\"\npoint = " + list(point);
  const Marker mirror{0, 4, 0.0, point};
  check(kFlyingHub, kTree, on_mirror + "frame = \"inertial\"\n", steady(mirror, false));
  check(kFlyingHub, kTree, on_mirror + "frame = \"body\"\n", steady(mirror, true));
}

TEST_CASE("the work of loads in space is the change of energy, to the order of the method") {
  struct Case {
    std::string text;
    Loads loads;
  };
  const Case cases[] = {{make_text(kDrivenHub, kCurved + kHinges + kPitch, kGravity),
                         {demanding({{0, 0, 0.3}, {0, 1, 0.8}}), demanding({{1, 1, 0.6}})}},
                        {make_text(kTurnedHub, kCurved), {demanding({{0, 0, 0.4}, {1, 1, 1.0}})}},
                        {make_text(kFlyingHub, kTree),
                         {demanding({{0, 0, 0.7}, {0, 4, 0.0, {0.1, 0.0, 0.2}}, {0, 5, 1.0}})}}};
  for (const Case& which : cases) {
    const auto residual = [&](IntegrationMethod method, double step) {
      Simulation simulation(make_loaded_scenario(which.text, step, method), kSerial, which.loads);
      simulation.run_until(0.16);
      CHECK(std::abs(simulation.sensor("energy.work")) > 1e-3);
      return std::abs(simulation.sensor("energy.residual"));
    };
    const double rk4 = residual(IntegrationMethod::rk4, 5e-4);
    CHECK(rk4 < 1e-6);
    CHECK(residual(IntegrationMethod::rk4, 1e-3) / rk4 > 13.0);
    const double alpha = residual(IntegrationMethod::generalized_alpha, 2.5e-4);
    CHECK(alpha < 1e-4);
    CHECK(residual(IntegrationMethod::generalized_alpha, 5e-4) / alpha > 3.3);
  }
}

TEST_CASE("runs in space with loads end in the same bits whatever executes them") {
  const Loads apart{demanding({{0, 0, 0.3}, {0, 1, 0.8}}), demanding({{1, 1, 0.6}})};
  const Loads tied{demanding({{0, 0, 0.3}, {1, 1, 0.8}})};
  const std::string text = make_text(kDrivenHub, kCurved + kHinges + kPitch, kGravity);
  for (const Loads& loads : {apart, tied}) {
    const auto end_of = [&](ExecutorKind kind, int threads, int window) {
      Simulation simulation(
          make_loaded_scenario(text, 2e-3, IntegrationMethod::generalized_alpha, 0.04),
          {Formulation::structured, kind, graph::Threads{threads}, window}, loads);
      simulation.run_until(0.04);
      return simulation.state_hash();
    };
    const std::uint64_t expected = end_of(ExecutorKind::serial, 1, 1);
    CHECK(expected == end_of(ExecutorKind::serial, 1, 7));
    CHECK(expected == end_of(ExecutorKind::flow_graph, 2, 7));
  }
}

TEST_CASE("a node of a load in space declares what it reads and writes") {
  const Loads loads{demanding({{0, 0, 0.3}, {0, 1, 0.8}}), demanding({{0, 1, 0.6}, {2, 4, 0.0}})};
  for (const Method& method : {Method{Rk4{1e-4}}, Method{make_generalized_alpha(0.8, 0.005)}}) {
    SystemContext<Space> context;
    const std::string text = make_text(kDrivenHub, kCurved + kHinges + kPitch + kTree, kGravity);
    context.system = make_system(parse_model(text));
    context.integrator = {method, {1e-10, 0, 50}};
    context.loads_tie_subsystems = true;
    allocate(context);
    place_loads(ask_loads(loads), context.system, context.data);
    const graph::StepGraph graph = build_step_graph(context);
    context.data.progress[0].control.is_implicit = std::holds_alternative<GeneralizedAlpha>(method);
    for (const graph::DeclarationFault& fault : graph::check_declarations(graph))
      FAIL_CHECK(fault.message);
    CHECK(graph::conflicts_are_ordered(graph));
  }
}

TEST_CASE("another load in the place of one acts from the next step on") {
  const Marker tip{0, 1, 1.0};
  const Scenario scenario = make_loaded_scenario(make_text(kDrivenHub, kCurved), 1e-3);
  Simulation changed(scenario, kSerial, {steady(tip, false)});
  Simulation steadily(scenario, kSerial, {steady(tip, true)});
  const SavedState start = changed.save();
  changed.run_until(0.02);
  changed.restore(start);
  changed.set_load(0, steady(tip, true));
  for (Simulation* simulation : {&changed, &steadily}) simulation->run_until(0.05);
  CHECK(changed.state_hash() == steadily.state_hash());
  CHECK(message_of([&] { changed.set_load(1, steady(tip, true)); }).starts_with("load index 1"));
  CHECK(message_of([&] {
          changed.set_load(0, steady({0, 1, 0.5}, true));
        }).find("its markers are not those") != std::string::npos);
}

TEST_CASE("a load in space that has no place is refused") {
  const Scenario scenario =
      make_loaded_scenario(make_text(kDrivenHub, kCurved + kHinges + kPitch + kTree), 1e-3);
  const auto refusal = [&](const Marker& marker) {
    return message_of([&] { Simulation(scenario, kSerial, {steady(marker, false)}); });
  };
  const std::string load = "the load \"steady\": ";
  CHECK(refusal({3, 0, 0.0}) == load + "blade index 3, expected 0 to 2");
  CHECK(refusal({0, 9, 0.0}).starts_with(load + "body index 9, expected 0 to "));
  CHECK(refusal({0, 0, 1.5}).starts_with(load + "station 1.5"));
  CHECK(refusal({0, 0, 0.5, {0.1, 0.0, 0.0}}).starts_with(load + "its point belongs to rigid"));
  CHECK(refusal({2, 4, 0.5}).starts_with(load + "its station belongs to beams"));
  const double none = std::numeric_limits<double>::quiet_NaN();
  CHECK(refusal({2, 4, 0.0, {none, 0.0, 0.0}}) == load + "its point is not finite");
  CHECK(refusal({2, 4, 0.0, {0.1, 0.0, 0.0}}) == "no error");
}

TEST_CASE("a load in space that fails is named with what it is on, and can be gone on from") {
  const Scenario scenario = make_loaded_scenario(make_text(kDrivenHub, kCurved + kTree), 1e-3);
  bool is_broken = false;
  const auto rope =
      make_load("rope", {{1, 0, 0.5}, {2, 0, 0.5}},
                [&is_broken](double t, std::span<const MarkerMotion>, std::span<Wrench> out) {
                  if (is_broken && t > 0.0105) throw std::runtime_error("it tore");
                  out[0].force.z() = 1.0;
                });
  Simulation simulation(scenario, kSerial, {rope});
  is_broken = true;
  CHECK(message_of<LoadError>([&] { simulation.run_until(0.02); }) ==
        "the load \"rope\" of blade 2 and arm failed at t = 0.011 s, step 11: it tore");
  CHECK(simulation.steps() == 10);
  is_broken = false;
  simulation.run_until(0.02);
  CHECK(simulation.steps() == 20);
  const auto endless = make_load(
      "endless", {{0, 0, 0.5}}, [](double t, std::span<const MarkerMotion>, std::span<Wrench> out) {
        out[0].force.z() = 1.0 / t;
      });
  CHECK(message_of<LoadError>([&] {
          Simulation(scenario, kSerial, {endless});
        }).find("its force or moment is not finite") != std::string::npos);
}

TEST_CASE("markers are found by their distance from the root") {
  const Scenario hinged =
      make_loaded_scenario(make_text(kDrivenHub, kCurved + kHinges + kPitch), 1e-3);
  const std::vector<Marker> markers = markers_at(hinged, 1, std::array{0.0, 0.4, 1.0, 1.75, 2.0});
  const std::vector<Marker> expected{
      {1, 0, 0.0}, {1, 0, 0.4}, {1, 0, 1.0}, {1, 1, 0.75}, {1, 1, 1.0}};
  for (std::size_t k = 0; k < expected.size(); ++k) {
    CHECK(markers[k].blade == expected[k].blade);
    CHECK(markers[k].body == expected[k].body);
    CHECK(markers[k].station == doctest::Approx(expected[k].station));
  }
  CHECK(message_of([&] { markers_at(hinged, 2, std::array{0.0}); }) ==
        "markers_at(): blade index 2, expected 0 to 1");
  CHECK(message_of([&] { markers_at(hinged, 0, std::array{2.1}); }) ==
        "markers_at(): position 2.1, expected 0 to 2 (m)");
}
