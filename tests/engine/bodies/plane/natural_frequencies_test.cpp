#include "engine/bodies/kernels/plane/natural_frequencies.h"

#include <doctest/doctest.h>

#include <Eigen/Eigenvalues>
#include <cmath>

#include "engine/simulation.h"
#include "models/error.h"
#include "tests/approx.h"
#include "tests/engine/lagrangian.h"
#include "tests/engine/rotors.h"

using namespace spoke;
using namespace spoke::test;
using spoke::testing::approx;

namespace {

double bending_unit(const Blade& blade) {
  return std::sqrt(blade.youngs_modulus * blade.second_moment / (blade.density * blade.area)) /
         (blade.length * blade.length);
}

/// A blade on a hub at rest that falls by its weight.
Scenario resting_scenario() {
  Scenario scenario;
  scenario.rotor = make_rotor(wu_haug_blade(2, 3), 1);
  scenario.rotor.hub.drive = SpinUp{0.0, 1.0};
  scenario.rotor.gravity = Position{-9.81, -9.81};
  scenario.integration.method = IntegrationMethod::rk4;
  scenario.limits.energy_growth = 0.0;
  return scenario;
}

double limit_of(const Scenario& scenario) {
  return calc_rk4_step_with_drag(plane::calc_frequency_range(scenario.rotor), scenario.rotor);
}

/// Whether 2000 steps of this share of the limit can be made.
bool is_rk4_stable(Scenario scenario, double share) {
  scenario.integration.step = share * limit_of(scenario);
  scenario.integration.duration = 2000.0 * scenario.integration.step;
  Simulation simulation(scenario, {Formulation::structured, ExecutorKind::serial, 1});
  try {
    simulation.run_until(scenario.integration.duration);
  } catch (const DivergenceError&) {
    return false;
  }
  return true;
}

}  // namespace

TEST_CASE("the lowest frequency of a blade is that of a cantilever") {
  const Rotor rotor = make_rotor(wu_haug_blade(), 3);
  const plane::FrequencyRange range = plane::calc_frequency_range(rotor);
  // First root of cos(k) cosh(k) = -1, squared.
  CHECK(range.lowest == approx(3.5160153 * bending_unit(rotor.blades[0])).epsilon(1e-5));
  // All three blades have it, and the second follows.
  CHECK(plane::count_frequencies_below(rotor, 0.999 * range.lowest) == 0);
  CHECK(plane::count_frequencies_below(rotor, 1.001 * range.lowest) == 3);
  CHECK(plane::count_frequencies_below(rotor, 22.03 * bending_unit(rotor.blades[0])) == 3);
  CHECK(plane::count_frequencies_below(rotor, 22.04 * bending_unit(rotor.blades[0])) == 6);
}

TEST_CASE("the largest stable step of rk4 depends on the element length") {
  struct Reference {
    int elements;  // per body of 2 m
    double step;
  };
  for (const auto& [elements, step] :
       {Reference{1, 0.000346}, Reference{2, 0.0001659}, Reference{4, 8.207e-05},
        Reference{8, 4.093e-05}, Reference{16, 1.394e-05}}) {
    const Rotor rotor = make_rotor(wu_haug_blade(4, elements), 3);
    CHECK(calc_rk4_largest_step(plane::calc_frequency_range(rotor), {}) ==
          approx(step).epsilon(1e-3));
  }
}

TEST_CASE("frequencies of free and torque-driven hubs are those of the linearised Lagrangian") {
  for (const HubSupport support : {HubSupport::axle, HubSupport::free}) {
    Rotor rotor = make_rotor(wu_haug_blade(2, 2), 2);
    rotor.blades[1] = wu_haug_blade(1, 3);
    rotor.blades[1].length = 5.0;
    rotor.blades[1].azimuth = 2.5;
    rotor.hub.support = support;
    rotor.hub.mass = 0.7;
    rotor.hub.radius = 0.4;
    rotor.hub.drive = FreeDrive{};
    SystemContext<Plane> context;
    make_context(rotor, Formulation::structured, Rk4{1e-5}, context);
    const Lagrangian lagrangian(context.system);
    const Eigen::VectorXd rest = independent_coordinates(context);
    const int n = lagrangian.size();
    Eigen::MatrixXd K = Eigen::MatrixXd::Zero(n, n);
    int next = kTwist;
    for (const SubsystemData<Plane>& subsystem : context.data.subsystems)
      for (const BodyData<Plane>& member : subsystem.bodies) {
        const plane::FlexibleBody& body = *member.model->body;
        K.block(next, next, body.axial(), body.axial()) = body.K_axial.to_dense();
        next += body.axial();
        K.block(next, next, body.bending(), body.bending()) = body.K_bending.to_dense();
        next += body.bending();
      }
    const int fixed = support == HubSupport::axle ? 2 : 0;  // x and y
    const int rigid = kTwist - fixed;
    const Eigen::MatrixXd M = lagrangian.mass(rest).bottomRightCorner(n - fixed, n - fixed);
    const Eigen::VectorXd squares = Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::MatrixXd>(
                                        K.bottomRightCorner(n - fixed, n - fixed), M)
                                        .eigenvalues();
    const plane::FrequencyRange range = plane::calc_frequency_range(rotor);
    CHECK(range.lowest == approx(std::sqrt(squares[rigid])).epsilon(1e-6));
    CHECK(range.highest == approx(std::sqrt(squares[squares.size() - 1])).epsilon(1e-6));
  }
}

TEST_CASE("rk4 with damping is stable up to the limit that is told, and not beyond") {
  for (const double factor : {1e-6, 2e-5, 1e-3}) {
    CAPTURE(factor);
    Scenario scenario = resting_scenario();
    scenario.rotor.damping.stiffness_factor = factor;
    CHECK(is_rk4_stable(scenario, 0.97));
    CHECK_FALSE(is_rk4_stable(scenario, 1.03));
  }
}

TEST_CASE("rk4 with linear drag is stable up to the limit that is told") {
  const double undamped = limit_of(resting_scenario());
  for (const DragFrame frame : {DragFrame::inertial, DragFrame::hub}) {
    Scenario along = resting_scenario(), at_tip = along, halved = along;
    const Blade& blade = along.rotor.blades[0];
    const double mass = blade.density * blade.area;
    // Motion is slowed down ten times as fast as rk4 could follow by its limit without drag.
    along.rotor.drags = {{.relative_to = frame, .linear_per_length = 10.0 * mass / undamped}};
    CHECK(limit_of(along) == approx(0.2785 * undamped).epsilon(1e-3));
    CHECK(is_rk4_stable(along, 0.97));
    CHECK_FALSE(is_rk4_stable(along, 1.03));
    // At a point, and by its largest factor, the limit is a bound.
    at_tip.rotor.drags = {{.relative_to = frame, .linear = mass * 8.0 / 6 / undamped}};
    CHECK(limit_of(at_tip) < 0.3 * undamped);
    CHECK(is_rk4_stable(at_tip, 0.97));
    CHECK_FALSE(is_rk4_stable(at_tip, 1.5));
    halved.rotor.drags = {{.relative_to = frame,
                           .from = 0.5 * blade.length,
                           .linear_per_length = 20.0 * mass / undamped,
                           .factor = Curve({0.0, 1.0}, {0.5, 0.5})}};
    CHECK(limit_of(halved) == approx(limit_of(along)));
    CHECK(is_rk4_stable(halved, 0.97));
    // Some damping would allow a larger step, but not every vibration has it.
    Scenario mild = resting_scenario();
    mild.rotor.drags = {{.relative_to = frame, .linear = 0.5 * mass * 8.0 / 6 / 16 / undamped}};
    CHECK(calc_rk4_largest_step(plane::calc_frequency_range(mild.rotor),
                                plane::calc_total_damping(mild.rotor)) > 1.01 * undamped);
    CHECK(limit_of(mild) <= undamped);
    CHECK(is_rk4_stable(mild, 0.97));
  }
}
