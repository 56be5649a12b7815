// Laws that every model in space obeys, in 200 random ones: the three formulations move it alike,
// its energy grows by the work of all that acts on it, and it keeps what its hub lets it keep of
// its momentum.

#include <doctest/doctest.h>

#include <cmath>
#include <variant>

#include "models/reader/scenario_check.h"
#include "tests/engine/bodies/space/system/random_model.h"
#include "tests/engine/bodies/space/system/runs.h"

using namespace spoke;
using namespace spoke::test;
using spatial::testing::RandomHub;

namespace {

constexpr double kStep = 1e-4, kSeconds = 0.05;

double relative_difference(const Eigen::VectorXd& a, const Eigen::VectorXd& b) {
  return (a - b).norm() / (1.0 + b.norm());
}

/// The formulations, in a few steps.
void check_formulations(const System<Space>& system, const Method& method) {
  Run<Space> structured(system, {method, 1e-12});
  structured.advance(4);
  for (const Formulation formulation : {Formulation::subsystem, Formulation::augmented}) {
    CAPTURE(name_of(formulation));
    RunSetup setup{method, 1e-12};
    setup.formulation = formulation;
    Run<Space> run(system, setup);
    run.advance(4);
    CHECK(relative_difference(deformations(run), deformations(structured)) < 1e-9);
    const SystemRecord<Space>&found = run.record(), &expected = structured.record();
    CHECK((found.position - expected.position).norm() < 1e-9);
    CHECK((found.velocity - expected.velocity).norm() < 1e-9);
    // By beta h^2, the tolerance of the iteration leaves that much of the accelerations.
    CHECK(relative_difference(found.reaction, expected.reaction) < 1e-4);
    CHECK(std::abs(run.work - structured.work) < 1e-6 * (1.0 + std::abs(structured.work)));
  }
}

/// Energy by the work of drives, motors, prescribed joints, loads and dampers.
void check_energy(const System<Space>& system) {
  Run<Space> run(system, {Rk4{kStep}});
  const double before = calc_energy(run);
  run.advance_for(kSeconds);
  const double after = calc_energy(run);
  CHECK(std::abs(after - before - run.work + run.dissipated) <
        3e-6 * (1.0 + std::abs(before) + std::abs(after) + std::abs(run.work)));
}

/// All of the momentum if the hub flies, that about the axle if a torque turns the hub.
void check_momentum(RandomHub hub, const System<Space>& system) {
  if (hub != RandomHub::free && hub != RandomHub::torque) return;
  Run<Space> run(system, {Rk4{kStep}});
  const space::Twist before = calc_momentum(run);
  run.advance_for(kSeconds);
  const space::Twist after = calc_momentum(run);
  const double size = 1.0 + before.norm();
  if (hub == RandomHub::free)
    CHECK((after - before).norm() < 1e-7 * size);
  else
    CHECK(std::abs(after[Space::kAxial] - before[Space::kAxial] -
                   spatial::testing::kRandomTorque * kSeconds) < 1e-7 * size);
}

/// Gives every other beam, or all, strains of second order.
void make_nonlinear(bool all, spatial::Model& model) {
  int beams = 0;
  for (spatial::Subsystem& subsystem : model.subsystems)
    for (spatial::Body& body : subsystem.bodies)
      if (auto* beam = std::get_if<spatial::Beam>(&body.shape); beam && (all || ++beams % 2 == 1)) {
        beam->geometric_stiffening = true;
        beam->strain = spatial::BeamStrain::nonlinear;
      }
}

void check_models(RandomHub hub, int count = 50,
                  spatial::BeamStrain strain = spatial::BeamStrain::linear) {
  for (int number = 0; number < count; ++number) {
    CAPTURE(number);
    std::mt19937 random(static_cast<unsigned>(1000 * static_cast<int>(hub) + number));
    Scenario scenario;
    scenario.space = spatial::testing::make_random_model(hub, random);
    if (strain == spatial::BeamStrain::nonlinear) make_nonlinear(number % 3 > 0, *scenario.space);
    REQUIRE_NOTHROW(check_scenario(scenario));
    const System<Space> system = make_system(*scenario.space);
    check_formulations(
        system, number % 2 == 0 ? Method{Rk4{1e-4}} : Method{make_generalized_alpha(0.8, 2e-3)});
    check_energy(system);
    check_momentum(hub, make_system(spatial::testing::without_loads(*scenario.space)));
  }
}

}  // namespace

TEST_CASE("random forests on a hub that stands obey the laws of mechanics") {
  check_models(RandomHub::fixed);
}

TEST_CASE("random forests on a hub that is driven obey the laws of mechanics") {
  check_models(RandomHub::driven);
}

TEST_CASE("random forests on a hub that a torque turns obey the laws of mechanics") {
  check_models(RandomHub::torque);
}

TEST_CASE("random forests on a hub that flies obey the laws of mechanics") {
  check_models(RandomHub::free);
}

TEST_CASE("random forests whose beams have strains of second order obey the laws of mechanics") {
  for (const RandomHub hub :
       {RandomHub::fixed, RandomHub::driven, RandomHub::torque, RandomHub::free}) {
    CAPTURE(static_cast<int>(hub));
    check_models(hub, 12, spatial::BeamStrain::nonlinear);
  }
}

TEST_CASE("random trees of subsystems on subsystems, tied by springs, obey the laws of mechanics") {
  for (int number = 0; number < 40; ++number) {
    CAPTURE(number);
    const bool flies = number % 2 == 0;
    std::mt19937 random(static_cast<unsigned>(5000 + number));
    Scenario scenario;
    scenario.space = spatial::testing::make_random_levels(flies, random);
    REQUIRE_NOTHROW(check_scenario(scenario));
    const System<Space> system = make_system(*scenario.space);
    check_formulations(
        system, number % 4 < 2 ? Method{Rk4{1e-4}} : Method{make_generalized_alpha(0.8, 2e-3)});
    check_energy(system);
    if (flies)
      check_momentum(RandomHub::free,
                     make_system(spatial::testing::without_loads(*scenario.space)));
  }
}
