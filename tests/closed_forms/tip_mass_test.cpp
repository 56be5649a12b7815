// Point masses on blades, against closed forms: frequencies of a cantilever with a mass at its tip,
// the forces that carry a rotor's blades, and Lagrange's equations of the whole.

#include <doctest/doctest.h>

#include <Eigen/Dense>
#include <cmath>
#include <functional>
#include <random>
#include <vector>

#include "engine/simulation.h"
#include "engine/step/run/time_stepper.h"
#include "engine/step/step_graph_builder.h"
#include "models/plane/beam_elements.h"
#include "models/system/system.h"
#include "tests/approx.h"
#include "tests/closed_forms/beams.h"
#include "tests/engine/lagrangian.h"
#include "tests/engine/rotors.h"
#include "tests/message_of.h"
#include "tests/relative_difference.h"

using namespace spoke;
using namespace spoke::test;
using spoke::testing::approx;

namespace {

double mass_per_length(const Blade& blade) { return blade.density * blade.area; }
double blade_mass(const Blade& blade) { return mass_per_length(blade) * blade.length; }

/// Returns zero where beta L = `b` is an eigenvalue of the cantilever with mass ratio mu = m/(rhoA
/// L) and inertia ratio nu = J/(rhoA L^3) at its tip: EI w'' = w^2 J w' and EI w''' = -w^2 m w
/// there.
double tip_determinant(double b, double mu, double nu) {
  const auto conditions = [&](double w, double slope, double second, double third) {
    return std::array{second - nu * b * b * b * slope, third + mu * b * w};
  };
  const double s = std::sin(b), c = std::cos(b), sh = std::sinh(b), ch = std::cosh(b);
  const auto A = conditions(ch - c, sh + s, ch + c, sh - s);
  const auto B = conditions(sh - s, ch - c, sh + s, ch + c);
  return A[0] * B[1] - B[0] * A[1];
}

/// Makes two tapered blades and a uniform one, with masses at root, tip, nodes, joints and in
/// between.
Rotor rotor_with_masses(HubSupport support) {
  Rotor rotor;
  for (int i = 0; i < 3; ++i) {
    Blade blade = wu_haug_blade(1 + i, 3);
    blade.length = 6.0;
    blade.azimuth = 2.0 * i;
    blade.reference_frame = i == 1 ? ReferenceFrame::chord : ReferenceFrame::clamped;
    if (i > 0) {
      blade.density = blade.area = blade.second_moment = blade.youngs_modulus = 0.0;
      blade.sections = {{0.0, 2.5, 6.0}, {0.3, 0.15, 0.1}, {6e6, 5e6, 2e6}, {800., 500., 300.}};
    }
    blade.point_masses = {{0.0, 0.2, 0.01}, {1.7, 0.3, 0.0}, {3.0, 0.25, 0.02}, {6.0, 0.4, 0.03}};
    rotor.blades.push_back(blade);
  }
  rotor.hub.support = support;
  rotor.hub.radius = 0.2;
  rotor.hub.mass = 3.0;
  rotor.hub.inertia = 1.5;
  rotor.hub.drive = TorqueDrive{Curve(2.0), 1.5};
  rotor.gravity = Position{0.7, -9.81};
  return rotor;
}

}  // namespace

TEST_CASE(
    "a cantilever with a mass at its tip has the frequencies of its characteristic equation") {
  for (const double mu : {0.1, 1.0, 10.0})
    for (const double nu : {0.0, 0.05}) {
      Blade blade = wu_haug_blade(2, 10);
      blade.point_masses = {{blade.length, mu * blade_mass(blade),
                             nu * blade_mass(blade) * blade.length * blade.length}};
      const double unit =
          std::sqrt(blade.youngs_modulus * blade.second_moment / mass_per_length(blade)) /
          (blade.length * blade.length);
      double b = 0.1;
      for (int number = 1; number <= 3; ++number) {
        b = find_next_root([&](double at) { return tip_determinant(at, mu, nu); }, b + 1e-6, 0.05);
        CAPTURE(mu);
        CAPTURE(nu);
        CAPTURE(number);
        CHECK(natural_frequency(blade, number) == approx(b * b * unit).epsilon(2e-5));
      }
    }
}

TEST_CASE("a mass between the nodes is at its own place") {
  // The lowest frequency of a light cantilever with a mass m at a: w^2 = 3 EI / (m a^3).
  for (const double place : {3.1, 4.0, 5.7}) {
    Blade blade = wu_haug_blade(2, 8);
    blade.density *= 1e-6;
    blade.point_masses = {{place, 2.0, 0.0}};
    const double stiffness =
        3.0 * blade.youngs_modulus * blade.second_moment / (place * place * place);
    CHECK(natural_frequency(blade, 1) == approx(std::sqrt(stiffness / 2.0)).epsilon(2e-4));
  }
}

TEST_CASE("mass, first moment and inertia of a blade are those of its parts") {
  const Rotor rotor = rotor_with_masses(HubSupport::axle);
  const System<Plane> system = make_system(rotor);
  for (std::size_t i = 0; i < 3; ++i) {
    const Blade& blade = rotor.blades[i];
    double mass = i == 0 ? blade_mass(blade) : 2.5 * 0.225 + 3.5 * 0.125;
    double moment = i == 0 ? blade_mass(blade) * 3.0
                           : 2.5 * 2.5 * (0.3 + 2 * 0.15) / 6 +
                                 3.5 * (2.5 * 0.125 + 3.5 * (0.15 + 2 * 0.1) / 6);
    for (const PointMass& point : blade.point_masses) {
      mass += point.mass;
      moment += point.mass * point.position;
    }
    for (std::size_t j = 0; j < system.subsystems[i].bodies.size(); ++j) {
      const plane::FlexibleBody& body = *system.subsystems[i].bodies[j].body;
      mass -= body.mass;
      moment -= body.S0.x() + static_cast<double>(j) * body.length * body.mass;
    }
    CHECK(std::abs(mass) < 1e-13);
    CHECK(std::abs(moment) < 1e-12);
  }
  Blade blade = wu_haug_blade(1, 3);
  const double before = make_beam_body(plane::make_beam_properties(blade, 0)).I0;
  blade.point_masses = {{5.0, 2.0, 0.3}};
  CHECK(make_beam_body(plane::make_beam_properties(blade, 0)).I0 - before ==
        approx(2.0 * 25.0 + 0.3).epsilon(1e-12));
}

TEST_CASE("the root of a turning blade carries the blade and its tip mass") {
  Blade blade = wu_haug_blade(2, 4);
  blade.point_masses = {{blade.length, 0.5, 0.0}, {3.0, 0.2, 0.0}};
  Scenario scenario;
  scenario.rotor = make_rotor(blade, 2);
  scenario.rotor.hub.radius = 0.5;
  scenario.rotor.hub.drive = SpinUp{3.0, 20.0};
  scenario.rotor.damping.stiffness_factor = 0.2;
  scenario.integration.step = 0.01;
  scenario.integration.duration = 60.0;
  Simulation simulation(scenario, {.executor = ExecutorKind::serial});
  simulation.run_until(60.0);
  const double moment =
      blade_mass(blade) * (0.5 + blade.length / 2) + 0.5 * (0.5 + blade.length) + 0.2 * 3.5;
  CHECK(simulation.joint_reaction(0, 0).force.norm() == approx(9.0 * moment).epsilon(2e-4));
  // The last element, from 7.5 m on, carries the tip mass and on average so much of the blade.
  const double of_blade = mass_per_length(blade) * (7.5 / 2 + 1.0 / 3);
  CHECK(simulation.section_force({0, 1, 1.0}).force.x() ==
        approx(9.0 * (0.5 * (0.5 + blade.length) + of_blade)).epsilon(2e-4));
  const double residual = simulation.sensor("energy.residual");
  CHECK(std::abs(residual) < 1e-5 * simulation.sensor("energy.kinetic"));
}

TEST_CASE("accelerations of blades with sections and masses satisfy Lagrange's equations") {
  std::mt19937 random(7);
  for (const bool is_stiffened : {false, true}) {
    Rotor rotor = rotor_with_masses(HubSupport::free);
    for (Blade& blade : rotor.blades) blade.geometric_stiffening = is_stiffened;
    SystemContext<Plane> context;
    make_context(rotor, Formulation::structured, Rk4{1e-5}, context);
    randomize_state(random, context);
    evaluate(1.0, context);
    const Lagrangian lagrangian(context.system, rotor.blades);
    const Eigen::VectorXd y = independent_coordinates(context);
    const Eigen::VectorXd v = independent_velocities(context);
    const Eigen::VectorXd a = independent_accelerations(context);
    Eigen::VectorXd force = lagrangian.residual(y, v, a);
    const double scale = (lagrangian.mass(y) * a).lpNorm<Eigen::Infinity>();
    CHECK(force[kRotation] == approx(2.0).epsilon(1e-5));  // the drive's torque
    force[kRotation] = 0.0;
    CHECK(force.lpNorm<Eigen::Infinity>() < 1e-7 * scale);
  }
}

TEST_CASE("the formulations agree on blades with sections and masses") {
  std::mt19937 random(5);
  for (const HubSupport support : {HubSupport::axle, HubSupport::free}) {
    const Rotor rotor = rotor_with_masses(support);
    SystemContext<Plane> structured, subsystem, augmented;
    make_context(rotor, Formulation::structured, Rk4{1e-5}, structured);
    make_context(rotor, Formulation::subsystem, Rk4{1e-5}, subsystem);
    make_context(rotor, Formulation::augmented, Rk4{1e-5}, augmented);
    randomize_state(random, structured);
    copy_state(structured, subsystem);
    copy_state(structured, augmented);
    const Evaluation a = evaluate(1.0, structured), b = evaluate(1.0, subsystem),
                     c = evaluate(1.0, augmented);
    CHECK(relative_difference(a.accelerations, c.accelerations) < 1e-9);
    CHECK(relative_difference(b.accelerations, c.accelerations) < 1e-9);
    CHECK(relative_difference(a.wrenches, c.wrenches) < 1e-9);
    CHECK(relative_difference(b.wrenches, c.wrenches) < 1e-9);
  }
}

TEST_CASE("a free rotor with sections and masses keeps energy and momentum") {
  Rotor rotor = rotor_with_masses(HubSupport::free);
  rotor.gravity.setZero();
  rotor.hub.drive = FreeDrive{2.0};
  SystemContext<Plane> context;
  make_context(rotor, Formulation::structured, Rk4{2e-5}, context);
  std::mt19937 random(9);
  randomize_state(random, context);
  const graph::StepGraph graph = build_step_graph(context);
  const auto executor = graph::make_executor(graph, graph::ExecutorKind::serial);
  TimeStepper stepper(context, graph);
  REQUIRE(stepper.start() == StepOutcome::done);
  const Lagrangian lagrangian(context.system, rotor.blades);
  const auto kept = [&] {
    const Eigen::VectorXd y = independent_coordinates(context);
    const Eigen::VectorXd v = independent_velocities(context);
    const Eigen::VectorXd p = lagrangian.momenta(y, v);
    return Eigen::Vector4d(lagrangian.kinetic_energy(y, v) + lagrangian.potential_energy(y), p[0],
                           p[1], y[0] * p[1] - y[1] * p[0] + p[2]);
  };
  const Eigen::Vector4d before = kept();
  const Twist hub_before = Twist::Map(context.data.hub_coordinates.v);
  REQUIRE(stepper.advance(2000, *executor) == StepOutcome::done);
  const Twist hub_change = Twist::Map(context.data.hub_coordinates.v) - hub_before;
  CHECK(hub_change.lpNorm<Eigen::Infinity>() > 0.01);
  for (int k = 0; k < 4; ++k) CHECK(kept()[k] == approx(before[k]).epsilon(1e-7));
}

TEST_CASE("turning a point's inertia out of the axis costs nothing at any speed") {
  // Masses off the axis have a moment towards it or away, which the rotation of a section lacks.
  Blade blade = wu_haug_blade(1, 4);
  blade.point_masses = {{5.1, 1e-9, 0.7}};
  const plane::BeamProperties with = plane::make_beam_properties(blade, 0);
  blade.point_masses[0].inertia = 0.0;
  const plane::BeamProperties without = plane::make_beam_properties(blade, 0);
  const Eigen::MatrixXd stiffening = make_centrifugal_stiffness(with, 0.1, 0.0).to_dense() -
                                     make_centrifugal_stiffness(without, 0.1, 0.0).to_dense();
  const Eigen::MatrixXd mass =
      make_beam_body(with).M_bending.to_dense() - make_beam_body(without).M_bending.to_dense();
  CHECK(stiffening.lpNorm<Eigen::Infinity>() > 0.1);
  CHECK((stiffening - mass).lpNorm<Eigen::Infinity>() < 1e-12);
}

TEST_CASE("a saved state of other sections or masses is refused by name, one of the same goes on") {
  Scenario scenario;
  scenario.rotor = rotor_with_masses(HubSupport::axle);
  scenario.integration.duration = 0.2;
  Simulation first(scenario, {.executor = ExecutorKind::serial});
  first.run_until(0.1);
  const SavedState state = first.save();
  first.run_until(0.2);
  Simulation same(scenario, {.executor = ExecutorKind::serial});
  same.restore(state);
  same.run_until(0.2);
  CHECK(same.state_hash() == first.state_hash());
  const auto refusal = [&](const Scenario& changed) {
    Simulation other(changed, {.executor = ExecutorKind::serial});
    return message_of([&] { other.restore(state); });
  };
  Scenario heavier = scenario, stiffer = scenario;
  heavier.rotor.blades[0].point_masses[3].mass = 0.5;
  stiffer.rotor.blades[1].sections.bending_stiffness[2] = 301.0;
  CHECK(refusal(heavier) ==
        "the saved state is of another model: blades.1.point_mass.4.mass is 0.4 in the saved state "
        "and 0.5 here");
  CHECK(refusal(stiffer) ==
        "the saved state is of another model: blades.2.sections.bending_stiffness.3 is 300.0 in "
        "the saved state and 301.0 here");
}
