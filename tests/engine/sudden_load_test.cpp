// Tests a load that is there at once, at the start or later: the response is that of the modes,
// whatever part of them the step resolves.

#include <doctest/doctest.h>

#include <array>
#include <cmath>
#include <complex>
#include <memory>
#include <numbers>
#include <vector>

#include "engine/simulation.h"
#include "engine/step/integrator/generalized_alpha.h"
#include "tests/approx.h"
#include "tests/engine/rotors.h"

using namespace spoke;
using namespace spoke::test;
using spoke::testing::approx;

namespace {

constexpr double kMoment = 10.0;   // N m
constexpr double kDamping = 0.02;  // share of the stiffness [s]

/// A blade of 5 m on a hub at rest, stiff enough to bend by little.
Scenario cantilever(int bodies, double radius, double step) {
  Blade blade = wu_haug_blade(bodies, 4);
  blade.length = 5.0;
  blade.youngs_modulus *= 10.0;
  Scenario scenario = spin_up_scenario(blade, step);
  scenario.rotor = make_rotor(blade, 1);
  scenario.rotor.hub.drive = SpinUp{0.0, 1.0};
  scenario.rotor.damping.stiffness_factor = kDamping;
  scenario.integration.duration = 1.0;
  scenario.integration.spectral_radius = radius;
  return scenario;
}

/// Makes the blade in space, loaded from the start.
Scenario spatial_cantilever(int bodies, double radius, double step) {
  Scenario scenario = cantilever(bodies, radius, step);
  const Blade planar = scenario.rotor.blades[0];
  const double bending = planar.youngs_modulus * planar.second_moment, L = planar.length;
  const auto uniform = [](double value) { return std::vector<double>(2, value); };
  spatial::Model model;
  model.hub.drive = FixedDrive{};
  model.damping = scenario.rotor.damping;
  spatial::Beam& beam = model.blades.emplace_back().beam;
  beam.length = L;
  beam.bodies = bodies;
  beam.elements = planar.elements;
  beam.sections = {.station = {0.0, L},
                   .axial_stiffness = uniform(planar.youngs_modulus * planar.area),
                   .flap_stiffness = uniform(bending),
                   .lag_stiffness = uniform(bending),
                   .torsion_stiffness = uniform(bending),
                   .mass_per_length = uniform(planar.density * planar.area)};
  spatial::PointLoad load;
  load.moment.z() = kMoment;
  model.loads = {load};
  scenario.rotor = {};
  scenario.space = model;
  return scenario;
}

PointLoad tip_moment(double moment) {
  PointLoad load;
  load.blade = BladeChoice::number(1);
  load.position = 5.0;
  load.moment = moment;
  return load;
}

/// Makes the moment as a load of the user's at the tip of four bodies.
std::shared_ptr<const Load> user_moment(double moment) {
  return make_load("moment", {{0, 3, 1.0}},
                   [moment](double, std::span<const MarkerMotion>, std::span<Wrench> out) {
                     out[0].moment.z() = moment;
                   });
}

/// Returns the deflection of the tip [m], `t` [s] after a moment has come: the sum over the modes
/// of a clamped beam; modes that are left out are damped so much that they creep to rest within
/// 1/kDamping. Mode shapes phi = cosh - cos - sigma (sinh - sin) have the integral of phi^2 L.
double exact_deflection(const Blade& blade, double t) {
  constexpr std::array<double, 6> roots{1.87510406871196, 4.69409113297417, 7.85475743823761,
                                        10.9955407348755, 14.1371683910465, 17.2787595320882};
  const double EI = blade.youngs_modulus * blade.second_moment, L = blade.length;
  const double mass = blade.density * blade.area * L;
  double sum = 0.0, rest = kMoment * L * L / (2.0 * EI);
  for (const double z : roots) {
    const double sigma = (std::cosh(z) + std::cos(z)) / (std::sinh(z) + std::sin(z));
    const double tip = std::cosh(z) - std::cos(z) - sigma * (std::sinh(z) - std::sin(z));
    const double slope =
        (std::sinh(z) + std::sin(z) - sigma * (std::cosh(z) - std::cos(z))) * z / L;
    const double square = EI * std::pow(z / L, 4) * L / mass;  // of the frequency
    const std::complex<double> half = 0.5 * kDamping * square;
    const std::complex<double> root = std::sqrt(half * half - square);
    const std::complex<double> s = -half + root, r = -half - root;
    const double response = 1.0 + std::real((r * std::exp(s * t) - s * std::exp(r * t)) / (s - r));
    const double share = tip * slope * kMoment / (mass * square);
    sum += share * response;
    rest -= share;
  }
  return sum + rest * (1.0 - std::exp(-t / kDamping));
}

/// Errors of a response, by the static deflection or the largest work.
struct Errors {
  double any = 0.0;   ///< of the deflection at any time
  double late = 0.0;  ///< of the deflection 0.1 s after the load has come and later
  double peak = 0.0;  ///< of the largest deflection
  double residual = 0.0;
};
/// Runs to the end and returns the errors; the load has come at `start` [s].
Errors follow(Simulation& simulation, const Blade& blade, double start) {
  const double EI = blade.youngs_modulus * blade.second_moment;
  const double rest = kMoment * blade.length * blade.length / (2.0 * EI);
  double error = 0.0, late = 0.0, peak = 0.0, exact_peak = 0.0, residual = 0.0, work = 0.0;
  while (!simulation.done()) {
    simulation.step();
    const double exact = exact_deflection(blade, simulation.time() - start);
    const double found = simulation.sensor("blade1.tip.y");
    error = std::max(error, std::abs(found - exact));
    if (simulation.time() > start + 0.1) late = std::max(late, std::abs(found - exact));
    peak = std::max(peak, found);
    exact_peak = std::max(exact_peak, exact);
    residual = std::max(residual, std::abs(simulation.sensor("energy.residual")));
    work = std::max(work, simulation.sensor("energy.work"));
  }
  return {error / rest, late / rest, std::abs(peak - exact_peak) / rest, residual / work};
}

/// The first mode of a clamped beam alone, at once under a load of its own shape.
struct FirstMode {
  static constexpr double kRoot = 1.87510406871196;
  static constexpr double kAtRest = 1e-3;  ///< deflection of the tip under the load [m]

  explicit FirstMode(const Blade& blade)
      : mass(blade.density * blade.area),
        frequency(kRoot * kRoot *
                  std::sqrt(blade.youngs_modulus * blade.second_moment / mass /
                            std::pow(blade.length, 4))) {}
  double mass;       ///< per length [kg/m]
  double frequency;  ///< [rad/s]

  /// Returns the deflection at x, a share of the length, by that of the tip.
  static double shape(double x) {
    const double z = kRoot * x;
    const double sigma =
        (std::cosh(kRoot) + std::cos(kRoot)) / (std::sinh(kRoot) + std::sin(kRoot));
    return 0.5 * (std::cosh(z) - std::cos(z) - sigma * (std::sinh(z) - std::sin(z)));
  }
  /// Returns forces in proportion to mass and shape, at so many places that no other mode feels
  /// them.
  std::shared_ptr<const Load> load(const Scenario& scenario) const {
    constexpr int kPlaces = 48;
    const double length = scenario.rotor.blades[0].length, share = 1.0 / kPlaces;
    std::vector<double> places, forces;
    for (int k = 0; k < kPlaces; ++k) {
      const double x = (k + 0.5) * share;
      places.push_back(x * length);
      forces.push_back(share * length * mass * frequency * frequency * kAtRest * shape(x));
    }
    return make_load("mode", markers_at(scenario, 0, places),
                     [forces](double, std::span<const MarkerMotion>, std::span<Wrench> out) {
                       for (std::size_t k = 0; k < forces.size(); ++k) out[k].force.y() = forces[k];
                     });
  }
  /// Returns the deflection by that at rest, after t, for a damping ratio.
  double exact(double t, double ratio) const {
    const std::complex<double> root = std::sqrt(std::complex<double>(ratio * ratio - 1.0));
    const std::complex<double> s = -ratio + root, r = -ratio - root;
    const double x = frequency * t;
    return 1.0 + std::real((r * std::exp(s * x) - s * std::exp(r * x)) / (s - r));
  }
};

/// Returns the largest deflection of an oscillator of unit frequency under a unit load, in `count`
/// steps of h from its true acceleration: the best start that the method can be given.
double calc_best_peak(double radius, double h, double ratio, int count) {
  const GeneralizedAlpha m = make_generalized_alpha(radius, h);
  double q = 0.0, v = 0.0, a = 1.0, al = 1.0, peak = 0.0;
  for (int n = 0; n < count; ++n) {
    const double carry = m.af_share * a - m.am_share * al;
    const double qp = q + h * v + h * h * ((0.5 - m.beta) * al + m.beta * carry);
    const double vp = v + h * ((1.0 - m.gamma) * al + m.gamma * carry);
    a = (1.0 - qp - 2.0 * ratio * vp) / (1.0 + m.position_gain + 2.0 * ratio * m.velocity_gain);
    al = carry + m.k * a;
    q = qp + m.position_gain * a;
    v = vp + m.velocity_gain * a;
    peak = std::max(peak, q);
  }
  return peak;
}

/// Results of two periods of the first mode, with so many steps a period.
struct Peak {
  double found, exact, best;  ///< by the deflection at rest
  double residual;            ///< by the work
};
Peak follow_first_mode(int bodies, double radius, double damping, double steps) {
  const FirstMode mode(cantilever(bodies, radius, 1.0).rotor.blades[0]);
  const double period = 2.0 * std::numbers::pi / mode.frequency;
  Scenario scenario = cantilever(bodies, radius, period / steps);
  scenario.integration.duration = 2.0 * period;
  scenario.rotor.damping.stiffness_factor = damping;
  Simulation simulation(scenario, {Formulation::structured, ExecutorKind::serial, 1},
                        {mode.load(scenario)});
  const double ratio = 0.5 * damping * mode.frequency;
  Peak peak{0.0, 0.0,
            calc_best_peak(radius, mode.frequency * simulation.step_size(), ratio,
                           static_cast<int>(simulation.planned_steps())),
            0.0};
  double work = 0.0;
  while (!simulation.done()) {
    simulation.step();
    peak.found = std::max(peak.found, simulation.sensor("blade1.tip.y") / FirstMode::kAtRest);
    peak.exact = std::max(peak.exact, mode.exact(simulation.time(), ratio));
    peak.residual = std::max(peak.residual, std::abs(simulation.sensor("energy.residual")));
    work = std::max(work, simulation.sensor("energy.work"));
  }
  peak.residual /= work;
  return peak;
}

/// Steps a period from which on the largest deflection and the balance of energy are good to 1 %,
/// and the start costs no more than that (docs/formulation.md, section 5).
struct Resolution {
  double radius, for_start, for_peak, for_energy;
};
constexpr Resolution kResolutions[] = {
    {0.0, 14, 25, 50}, {0.3, 12, 16, 28}, {0.5, 12, 12, 18}, {0.8, 12, 10, 18}, {1.0, 12, 10, 18}};

void check_first_mode(int bodies) {
  // Damping [s]: none, little, some, and so much that nothing swings.
  for (const double damping : {0.0, 0.002, 0.02, 0.2})
    for (const Resolution& at : kResolutions) {
      CAPTURE(bodies);
      CAPTURE(damping);
      CAPTURE(at.radius);
      const Peak start = follow_first_mode(bodies, at.radius, damping, at.for_start);
      CHECK(std::abs(start.found - start.best) < 0.01 * start.exact);
      const Peak peak = follow_first_mode(bodies, at.radius, damping, at.for_peak);
      CHECK(std::abs(peak.found - peak.exact) < 0.01 * peak.exact);
      CHECK(follow_first_mode(bodies, at.radius, damping, at.for_energy).residual < 0.01);
    }
}

}  // namespace

TEST_CASE("a vibration that the step resolves starts under its load as the true one") {
  for (const int bodies : {1, 4, 16}) check_first_mode(bodies);
}

TEST_CASE("a vibration of 64 bodies that the step resolves starts as the true one, too") {
  check_first_mode(64);
}

TEST_CASE("what the step does not resolve follows a sudden load, and makes no energy") {
  for (const int bodies : {1, 10, 64})
    for (const double radius : {0.0, 0.3, 0.8, 1.0})
      for (const double damping : {0.0, 0.002, 0.02, 0.2}) {
        CAPTURE(bodies);
        CAPTURE(radius);
        CAPTURE(damping);
        Scenario scenario = cantilever(bodies, radius, 0.01);
        scenario.rotor.damping.stiffness_factor = damping;
        scenario.rotor.loads = {tip_moment(kMoment)};
        Simulation simulation(scenario, {Formulation::structured, ExecutorKind::serial, 1});
        double least = 0.0, largest = 0.0, gained = 0.0, work = 0.0;
        while (!simulation.done()) {
          simulation.step();
          const double tip = simulation.sensor("blade1.tip.y");
          least = std::min(least, tip);
          largest = std::max(largest, tip);
          gained = std::max(gained, simulation.sensor("energy.residual"));
          work = std::max(work, simulation.sensor("energy.work"));
        }
        const Blade& blade = scenario.rotor.blades[0];
        const double rest = kMoment * blade.length * blade.length /
                            (2.0 * blade.youngs_modulus * blade.second_moment);
        CHECK(least > -0.01 * rest);
        CHECK(largest < 2.02 * rest);
        // The quadrature of the dissipation counts 1.4 % of the work too much.
        CHECK(gained < 0.02 * work);
      }
}

TEST_CASE("a blade that is loaded at the start moves as its modes do") {
  for (const int bodies : {1, 10, 64})
    for (const double radius : {0.0, 0.3, 0.8, 1.0}) {
      CAPTURE(bodies);
      CAPTURE(radius);
      Scenario scenario = cantilever(bodies, radius, 0.01);
      scenario.rotor.loads = {tip_moment(kMoment)};
      Simulation simulation(scenario, {Formulation::structured, ExecutorKind::serial, 1});
      const Errors errors = follow(simulation, scenario.rotor.blades[0], 0.0);
      CHECK(errors.peak < 0.01);
      // The first mode's period of 27 steps comes out longer, by less than 1 %.
      CHECK(errors.any < 0.06);
      // Radius 0 dissipates energy of motions that so many steps a period resolve, too.
      CHECK(errors.residual < (radius == 0.0 ? 0.03 : 0.01));
    }
}

TEST_CASE("a blade that is loaded at the start or later converges to its modes at second order") {
  const auto error = [](double step, double start, double radius) {
    Scenario scenario = cantilever(4, radius, step);
    Simulation simulation(scenario, {Formulation::structured, ExecutorKind::serial, 1},
                          {user_moment(start == 0.0 ? kMoment : 0.0)});
    if (start > 0.0) {
      simulation.run_until(start);
      simulation.set_load(0, user_moment(kMoment));
    }
    return follow(simulation, scenario.rotor.blades[0], start).late;
  };
  for (const double radius : {0.0, 0.8, 1.0})
    for (const double start : {0.0, 0.3}) {
      CAPTURE(radius);
      CAPTURE(start);
      const double fine = error(0.001, start, radius);
      CHECK(fine < 0.001);
      CHECK(std::log2(error(0.002, start, radius) / fine) > 1.7);
    }
}

TEST_CASE("a blade in space that is loaded at the start moves as its modes do") {
  for (const int bodies : {1, 10})
    for (const double radius : {0.0, 1.0}) {
      CAPTURE(bodies);
      CAPTURE(radius);
      const Blade blade = cantilever(bodies, radius, 0.01).rotor.blades[0];
      Simulation simulation(spatial_cantilever(bodies, radius, 0.01),
                            {Formulation::structured, ExecutorKind::serial, 1});
      const Errors errors = follow(simulation, blade, 0.0);
      CHECK(errors.peak < 0.01);
      CHECK(errors.any < 0.06);
      CHECK(errors.residual < (radius == 0.0 ? 0.03 : 0.01));
    }
}

TEST_CASE("a torque that sets in later moves a rotor as one that is there from the start") {
  for (const bool is_in_space : {false, true})
    for (const double radius : {0.0, 0.8}) {
      CAPTURE(is_in_space);
      CAPTURE(radius);
      Scenario scenario =
          is_in_space ? spatial_cantilever(4, radius, 0.01) : cantilever(4, radius, 0.01);
      Drive& drive = is_in_space ? scenario.space->hub.drive : scenario.rotor.hub.drive;
      if (is_in_space) scenario.space->loads.clear();
      const SimulationOptions serial{Formulation::structured, ExecutorKind::serial, 1};
      drive = TorqueDrive{Curve(kMoment), 0.0};
      Simulation at_once(scenario, serial);
      drive = TorqueDrive{Curve(0.0), 0.0};
      Simulation later(scenario, serial);
      later.run_until(0.2);
      later.set_drive(TorqueDrive{Curve(kMoment), 0.0});
      for (int step = 0; step < 50; ++step) {
        at_once.step();
        later.step();
        for (const char* sensor : {"hub.speed", "blade1.tip.y", "energy.work", "energy.strain"})
          CHECK(later.sensor(sensor) == approx(at_once.sensor(sensor)).epsilon(1e-6));
      }
      CHECK(std::abs(at_once.sensor("blade1.tip.y")) > 1e-4);
    }
}
