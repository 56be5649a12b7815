// Tests energy and momentum, which a scheme of order p keeps to order p, with steps at which its
// error is well above round-off. The blades start bent and vibrating.

#include <doctest/doctest.h>

#include <cmath>
#include <utility>

#include "engine/bodies/act/user_load/user_loads.h"
#include "engine/bodies/kernels/kinematics.h"
#include "engine/simulation/sensors.h"
#include "engine/step/run/time_stepper.h"
#include "engine/step/step_graph_builder.h"
#include "tests/engine/lagrangian.h"
#include "tests/engine/load_rotors.h"
#include "tests/engine/rotors.h"

using namespace spoke;
using namespace spoke::test;

namespace {

/// Makes two soft blades, whose fastest vibration has a period of some 1e-3 s.
Rotor soft_rotor(bool stiffening, ReferenceFrame frame, BeamStrain strain = BeamStrain::linear) {
  Blade blade;
  blade.length = 2.0;
  blade.bodies = 2;
  blade.elements = 2;
  blade.density = 1000.0;
  blade.area = 1e-4;
  blade.second_moment = 1e-8;
  blade.youngs_modulus = 2e8;
  blade.geometric_stiffening = stiffening;
  blade.reference_frame = frame;
  blade.strain = strain;
  Rotor rotor = make_rotor(blade, 2);
  rotor.hub.drive = SpinUp{3.0, 0.5};
  return rotor;
}

Rotor free_rotor(BeamStrain strain = BeamStrain::linear) {
  Rotor rotor = soft_rotor(true, ReferenceFrame::clamped, strain);
  rotor.blades[1].length = 1.3;  // lopsided: the hub is pulled about
  rotor.blades[1].reference_frame = ReferenceFrame::chord;
  rotor.hub.support = HubSupport::free;
  rotor.hub.mass = 0.3;
  rotor.hub.radius = 0.1;
  rotor.hub.drive = FreeDrive{2.0};
  return rotor;
}

/// A run of `duration` from a random bent state.
class Run {
 public:
  Run(const Rotor& rotor, const Method& method, double step, const Loads& loads = {})
      : step_(step), sensors_(prepare(rotor, method, loads), {}), lagrangian_(context_.system) {}

  /// Visits the state after every step.
  template <class Visit>
  void to(double duration, Visit&& visit) {
    const graph::StepGraph graph = build_step_graph(context_);
    const auto executor = graph::make_executor(graph, graph::ExecutorKind::serial);
    context_.integrator.limits = {1e-13, 0, 50};
    TimeStepper stepper(context_, graph);
    REQUIRE(stepper.start() == StepOutcome::done);
    sensors_.start(context_.system, context_.data);
    work_ = {};
    const auto steps = static_cast<std::int64_t>(std::lround(duration / step_));
    const auto outcome = stepper.advance(steps, *executor, false, [&](std::int64_t step) {
      work_.add(of_step(context_.data.records, step).step);
      step_done_ = step;
      visit();
    });
    REQUIRE(outcome == StepOutcome::done);
  }

  double energy_residual() {
    Sensors::sample(context_.system, step_done_, 0.0, context_.data);
    sensors_.measure(context_.system, work_, step_done_, context_.data);
    return sensors_.balance().residual;
  }

  /// Returns the linear momentum, and the angular momentum about the origin.
  Twist momentum() const {
    const Eigen::VectorXd y = independent_coordinates(context_);
    const Twist p = lagrangian_.hub_momenta(y, independent_velocities(context_));
    return {p[0], p[1], y[0] * p[1] - y[1] * p[0] + p[2]};
  }

  Position drawn_centre() const {
    return lagrangian_.drawn_centre(independent_coordinates(context_));
  }

  const SystemContext<Plane>& context() const { return context_; }

 private:
  const System<Plane>& prepare(const Rotor& rotor, const Method& method, const Loads& loads) {
    make_context(rotor, Formulation::structured, method, context_);
    place_loads(ask_loads(loads), context_.system, context_.data);
    std::mt19937 random(21);
    randomize_state(random, context_);
    return context_.system;
  }

  double step_;
  SystemContext<Plane> context_;
  Sensors sensors_;
  Lagrangian lagrangian_;
  WorkDone work_;
  std::int64_t step_done_ = 0;
};

Method rk4(double step) { return Rk4{step}; }
Method generalized_alpha(double step) { return make_generalized_alpha(0.9, step); }
using MakeMethod = Method (*)(double step);

double largest_residual(const Rotor& rotor, MakeMethod make, double step) {
  Run run(rotor, make(step), step);
  double largest = 0.0;
  run.to(0.24, [&] { largest = std::max(largest, std::abs(run.energy_residual())); });
  return largest;
}

double largest_momentum_change(MakeMethod make, double step, const Loads& loads = {},
                               BeamStrain strain = BeamStrain::linear) {
  Run run(free_rotor(strain), make(step), step, loads);
  const Twist before = run.momentum();
  double largest = 0.0;
  run.to(0.24,
         [&] { largest = std::max(largest, (run.momentum() - before).norm() / before.norm()); });
  return largest;
}

/// Returns the order with which an error falls when the step is halved.
template <class Error>
double order(Error&& error, double step) {
  return std::log2(error(step) / error(step / 2));
}

/// Returns the order of the error of energy with generalized_alpha, from a step that resolves the
/// vibrations which the start excites; with smaller steps the start leaves some of them out.
double residual_order(const Rotor& rotor) {
  return order([&](double h) { return largest_residual(rotor, generalized_alpha, h); }, 1e-4);
}

}  // namespace

TEST_CASE("the energy residual falls at the order of the scheme, with and without stiffening") {
  constexpr std::pair<bool, BeamStrain> kKinds[] = {
      {false, BeamStrain::linear}, {true, BeamStrain::linear}, {true, BeamStrain::nonlinear}};
  for (const auto& kind : kKinds)
    for (const ReferenceFrame frame : {ReferenceFrame::clamped, ReferenceFrame::chord}) {
      CAPTURE(kind.first);
      CAPTURE(name_of(kind.second));
      const Rotor rotor = soft_rotor(kind.first, frame, kind.second);
      // Strains of second order make the random shapes vibrate along the axis.
      const double coarse = kind.second == BeamStrain::linear ? 4e-4 : 1e-4;
      CHECK(order([&](double h) { return largest_residual(rotor, rk4, h); }, coarse) > 3.8);
      const double second = residual_order(rotor);
      CHECK(second > 1.8);
      CHECK(second < 3.2);  // numerical dissipation of the fast vibrations is of third order
    }
}

TEST_CASE("the energy residual falls at the order of the scheme with torque, damping and loads") {
  Rotor rotor = free_rotor();
  rotor.hub.drive = TorqueDrive{Curve({-1.0, 1.0}, {0.0, 1.0})};
  rotor.damping = {0.1, 1e-4};
  rotor.gravity = Position{0.3, -1.0};
  PointLoad load;
  load.blade = BladeChoice::number(1);
  load.position = 2.0;
  load.force = Position{0.0, 0.05};
  load.moment = 0.02;
  load.factor = Curve({-1.0, 1.0}, {0.0, 1.0});
  for (const LoadFrame frame : {LoadFrame::inertial, LoadFrame::hub, LoadFrame::section}) {
    load.frame = frame;
    rotor.loads = {load};
    CHECK(order([&](double h) { return largest_residual(rotor, rk4, h); }, 4e-4) > 3.8);
    CHECK(residual_order(rotor) > 1.8);
  }
}

TEST_CASE("the energy residual falls at the order of the scheme with loads of every kind") {
  constexpr std::pair<bool, BeamStrain> kKinds[] = {
      {true, BeamStrain::linear}, {false, BeamStrain::linear}, {true, BeamStrain::nonlinear}};
  for (const auto& kind : kKinds) {
    const bool is_free = kind.first;
    const BeamStrain strain = kind.second;
    CAPTURE(name_of(strain));
    Rotor rotor = is_free ? free_rotor(strain) : soft_rotor(true, ReferenceFrame::chord);
    rotor.damping = {0.1, 1e-4};
    if (is_free) rotor.hub.drive = TorqueBySpeed{Curve({-20.0, 20.0}, {1.0, -0.5}), 2.0, 1.0};
    rotor.gravity = Position{0.3, -1.0};
    add_all_loads(rotor);
    CAPTURE(is_free);
    CHECK(order([&](double h) { return largest_residual(rotor, rk4, h); }, 4e-4) > 3.8);
    CHECK(residual_order(rotor) > 1.8);
  }
}

TEST_CASE("a thruster changes momentum by its force, and angular momentum by its moment") {
  for (const LoadFrame frame : {LoadFrame::inertial, LoadFrame::hub}) {
    Rotor rotor = free_rotor();
    HubLoad thruster;
    thruster.position = {0.2, -0.1};
    thruster.frame = frame;
    thruster.force = {0.4, 0.7};
    thruster.torque = 0.05;
    rotor.hub_loads = {thruster};
    constexpr double step = 1e-4;
    Run run(rotor, Rk4{step}, step);
    const auto rate = [&] {
      const HubState<Plane> hub = calc_hub_state(run.context().data);
      // The mass centre keeps its place where bending draws blades inward: the hub gives way.
      const Position p = hub.p + hub.R * thruster.position - run.drawn_centre();
      const plane::Rotation R = frame == LoadFrame::hub ? hub.R : plane::Rotation{};
      return translate(p, R * Twist(0.4, 0.7, 0.05));
    };
    const Twist before = run.momentum();
    Twist impulse = Twist::Zero(), last = rate();
    run.to(0.24, [&] {
      const Twist now = rate();
      impulse += 0.5 * step * (last + now);
      last = now;
    });
    CHECK((run.momentum() - before - impulse).norm() < 1e-5 * impulse.norm());
  }
}

TEST_CASE("a free rotor keeps its linear and angular momentum, to the order of the scheme") {
  CHECK(order([](double h) { return largest_momentum_change(rk4, h); }, 2e-4) > 3.8);
  CHECK(largest_momentum_change(rk4, 2e-5) < 1e-9);
  CHECK(order([](double h) { return largest_momentum_change(generalized_alpha, h); }, 2e-4) > 1.8);
}

TEST_CASE("a free rotor whose strains are of second order keeps its momentum") {
  const auto change = [](MakeMethod make, double h) {
    return largest_momentum_change(make, h, {}, BeamStrain::nonlinear);
  };
  CHECK(order([&](double h) { return change(rk4, h); }, 1e-4) > 3.8);
  CHECK(change(rk4, 2e-5) < 1e-8);
  CHECK(order([&](double h) { return change(generalized_alpha, h); }, 1e-4) > 1.8);
}

TEST_CASE("a spring and damper between blades leave a free rotor its momentum") {
  const Loads loads{spring({0, 1, 1.0}, {1, 0, 0.4}, 1.0, 5.0, 0.2)};
  const auto change = [&](double h) { return largest_momentum_change(rk4, h, loads); };
  CHECK(order(change, 2e-4) > 3.8);
  CHECK(change(2e-5) < 1e-9);
}

TEST_CASE("the hub of a free rotor is pulled about while its momentum is kept") {
  Run run(free_rotor(), rk4(2e-4), 2e-4);
  const double before = run.context().data.hub_coordinates.v[0];
  double largest_change = 0.0;
  run.to(0.24, [&] {
    largest_change =
        std::max(largest_change, std::abs(run.context().data.hub_coordinates.v[0] - before));
  });
  CHECK(largest_change > 0.1);
}

TEST_CASE("generalized_alpha converges to rk4 with second order, rk4 with fourth") {
  for (const BeamStrain strain : {BeamStrain::linear, BeamStrain::nonlinear}) {
    CAPTURE(name_of(strain));
    const Rotor rotor = soft_rotor(true, ReferenceFrame::clamped, strain);
    const auto end_of = [&](MakeMethod make, double step) -> Eigen::VectorXd {
      Run run(rotor, make(step), step);
      run.to(0.24, [] {});
      return independent_coordinates(run.context());
    };
    const Eigen::VectorXd exact = end_of(rk4, 1e-5);
    const auto error = [&](MakeMethod make, double step) {
      return (end_of(make, step) - exact).lpNorm<Eigen::Infinity>();
    };
    const double coarse = strain == BeamStrain::linear ? 2e-4 : 5e-5;
    CHECK(order([&](double h) { return error(rk4, h); }, coarse) > 3.7);
    const double second =
        order([&](double h) { return error(generalized_alpha, h); }, 0.5 * coarse);
    CHECK(second > 1.8);
    CHECK(second < 2.2);
  }
}
