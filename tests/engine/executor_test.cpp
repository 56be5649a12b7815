// Tests that a model has bitwise the same states on every executor and number of threads.

#include <doctest/doctest.h>

#include "engine/simulation.h"
#include "tests/engine/rotors.h"

using namespace spoke;
using namespace spoke::test;

namespace {

/// Makes a rotor with `elements` in each of the four bodies of a blade; the second blade has three
/// bodies.
Scenario unequal_rotor(IntegrationMethod method, int elements = 4) {
  Scenario scenario = spin_up_scenario(wu_haug_blade(4, elements), 0.005);
  scenario.rotor.blades[0].strain = BeamStrain::nonlinear;
  scenario.rotor.blades[1] = wu_haug_blade(3, elements + 2);
  scenario.rotor.blades[1].azimuth = 2.0;
  scenario.rotor.blades[1].reference_frame = ReferenceFrame::chord;
  scenario.rotor.blades[2].geometric_stiffening = false;
  scenario.rotor.hub.support = HubSupport::free;
  scenario.rotor.hub.mass = 5.0;
  scenario.rotor.hub.drive = TorqueDrive{Curve(10.0)};
  scenario.integration.method = method;
  if (method == IntegrationMethod::rk4) scenario.integration.step = 4e-5;
  scenario.integration.duration = 1000 * scenario.integration.step;
  return scenario;
}

std::uint64_t final_hash(const Scenario& scenario, const SimulationOptions& options, int steps) {
  Simulation simulation(scenario, options);
  for (int n = 0; n < steps; ++n) simulation.step();
  return simulation.state_hash();
}

}  // namespace

TEST_CASE("all executors give bitwise equal states for every thread count") {
  for (const Formulation formulation : formulations())
    for (const IntegrationMethod method :
         {IntegrationMethod::generalized_alpha, IntegrationMethod::rk4}) {
      // One dense system has all coordinates: at the size of the others it would take most of the
      // time.
      const Scenario scenario =
          unequal_rotor(method, formulation == Formulation::augmented ? 1 : 4);
      constexpr int steps = 20;
      const std::uint64_t serial =
          final_hash(scenario, {formulation, ExecutorKind::serial, 1}, steps);
      CHECK(serial == final_hash(scenario, {formulation, ExecutorKind::serial, 1}, steps));
      for (const ExecutorKind kind : graph::executor_kinds()) {
        for (const int threads : {1, 2, 3, 6, 12}) {
          CAPTURE(name_of(formulation));
          CAPTURE(name_of(kind));
          CAPTURE(threads);
          CHECK(serial == final_hash(scenario, {formulation, kind, threads}, steps));
        }
      }
    }
}

TEST_CASE("nested teams give bitwise equal states") {
  const Scenario scenario = unequal_rotor(IntegrationMethod::generalized_alpha);
  constexpr int steps = 20;
  const SimulationOptions serial{Formulation::subsystem, ExecutorKind::serial, 1};
  const std::uint64_t expected = final_hash(scenario, serial, steps);
  for (const ExecutorKind kind : graph::executor_kinds()) {
    if (kind != ExecutorKind::openmp_scheme1 && kind != ExecutorKind::openmp_scheme2) continue;
    for (const graph::Threads threads : {graph::Threads{1, 2}, {2, 2}, {3, 4}}) {
      CAPTURE(name_of(kind));
      CAPTURE(name_of(threads));
      CHECK(expected == final_hash(scenario, {Formulation::subsystem, kind, threads}, steps));
    }
  }
}

TEST_CASE("the state hash tells states apart") {
  const Scenario scenario = unequal_rotor(IntegrationMethod::generalized_alpha);
  const SimulationOptions options{Formulation::structured, ExecutorKind::serial, 1};
  CHECK(final_hash(scenario, options, 10) != final_hash(scenario, options, 11));
}
