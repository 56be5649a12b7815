// A rotor on a support: what its motion must equal, and that it is one motion however it is found.

#include <doctest/doctest.h>

#include <cmath>

#include "engine/simulation.h"
#include "tests/engine/bodies/space/system/models.h"
#include "tests/engine/bodies/space/system/runs.h"

using namespace spoke;
using namespace spoke::test;

namespace {

constexpr int kSupportSteps = 40;

/// The free hub that is the sum of hub and fuselage of kFuselageHub.
const std::string kSumHub = R"(
[hub]
support = "free"
mass = 3.0
inertia = [0.4, 0.5, 0.6]
velocity = [0.3, -0.2, 0.5]
angular_velocity = [1.5, -1.0, 2.5]
)";
const std::string kHubLoad = R"(
[[hub_load]]
torque = [0.4, 0.6, 0.9]
force = [1.0, -0.5, 0.3]
)";

System<Space> make_supported(const std::string& text) { return make_system(parse_model(text)); }

Eigen::VectorXd first_of(const Run<Space>& run, Eigen::Index size) {
  return deformations(run).head(size);
}

}  // namespace

TEST_CASE("a hub fixed to a free fuselage moves as the free hub that is their sum") {
  const std::string blades = kBooms + kHinges;
  const System<Space> supported = make_supported(make_text(kFuselageHub, blades, kHubLoad));
  const System<Space> free = make_supported(make_text(kSumHub, blades, kHubLoad));
  for (const Formulation formulation : formulations()) {
    CAPTURE(name_of(formulation));
    RunSetup setup{Rk4{1e-3}};
    setup.formulation = formulation;
    Run<Space> a(supported, setup), b(free, setup);
    a.advance(5 * kSupportSteps);
    b.advance(5 * kSupportSteps);
    const Eigen::VectorXd expected = deformations(b);
    CHECK((first_of(a, expected.size()) - expected).cwiseAbs().maxCoeff() < 1e-12);
  }
}

TEST_CASE("a displacement in the inertial frame begins with zero on a support, too") {
  const std::string sensor = R"(
[[sensor]]
name = "root"
quantity = "displacement"
frame = "inertial"
position = 0.0
)";
  const Scenario scenario =
      make_scenario(make_text(kTurnedHub, kBooms, kTower + sensor), 1e-3, 1e-2);
  Simulation simulation(scenario, {Formulation::structured, ExecutorKind::serial, 1});
  for (const char* axis : {"x", "y", "z"})
    CHECK(std::abs(simulation.sensor(std::string("blade1.root.") + axis)) < 1e-14);
  simulation.run_until(1e-2);  // by the speed of the hub, whose radius is 0.1 m
  CHECK(std::abs(simulation.sensor("blade1.root.y")) < 1e-2);
}

TEST_CASE("the formulations agree on a rotor on a support") {
  const System<Space> system =
      make_supported(make_text(kTurnedHub, kBooms + kHinges, kTower + kGravity));
  for (const Method& method : {Method{Rk4{1e-3}}, Method{make_generalized_alpha(0.8, 2e-3)}}) {
    Run<Space> structured(system, {method});
    structured.advance(kSupportSteps);
    for (const Formulation formulation : formulations()) {
      CAPTURE(name_of(formulation));
      RunSetup setup{method};
      setup.formulation = formulation;
      Run<Space> other(system, setup);
      other.advance(kSupportSteps);
      CHECK(largest_difference(structured, other) < 1e-9);
    }
  }
}

TEST_CASE("a rotor on a support has one state, whatever executes it") {
  using Kind = graph::ExecutorKind;
  const System<Space> system =
      make_supported(make_text(kTurnedHub, kBooms + kHinges, kTower + kGravity));
  for (const Formulation formulation : formulations()) {
    RunSetup setup{Method{make_generalized_alpha(0.8, 5e-3)}, 1e-10};
    setup.formulation = formulation;
    const auto end = [&] {
      Run<Space> run(system, setup);
      run.advance(kSupportSteps);
      return run.hash();
    };
    const std::uint64_t expected = end();
    for (const Kind kind : {Kind::serial, Kind::flow_graph, Kind::openmp_levels,
                            Kind::openmp_scheme1, Kind::openmp_tasks}) {
      CAPTURE(name_of(kind));
      setup.executor = kind;
      setup.threads = {kind == Kind::serial ? 1 : 2};
      CHECK(expected == end());
    }
  }
}
