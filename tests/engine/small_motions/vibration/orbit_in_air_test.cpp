// Periodic motions in air against the turns of a run that has come to its own: the run's limit
// cycle.

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>
#include <sstream>
#include <string>
#include <vector>

#include "engine/modes.h"
#include "engine/simulation.h"
#include "engine/small_motions/steady/linear_support.h"
#include "engine/small_motions/steady/supported_model.h"
#include "engine/small_motions/vibration/periodic_orbit.h"
#include "engine/small_motions/vibration/turn_series.h"
#include "models/scenario.h"
#include "tests/approx.h"

namespace spoke {
namespace {

using spoke::testing::approx;

constexpr double kSpeed = 20.0, kTurn = 2.0 * std::numbers::pi / kSpeed;
constexpr int kTurns = 40, kSteps = 400;  ///< of a run, and of a turn

/// Writes numbers as an array.
std::string list(const std::vector<double>& numbers) {
  std::ostringstream text;
  text.precision(17);
  for (std::size_t k = 0; k < numbers.size(); ++k) text << (k ? ", " : "[") << numbers[k];
  return text.str() + "]";
}

/// Writes an aerofoil whose lift bends off smoothly, by points 0.05 rad apart; drag grows with the
/// square of the angle.
std::string make_airfoil() {
  std::vector<double> angle{-std::numbers::pi}, lift{0.0}, drag{1.0};
  for (int k = -20; k <= 20; ++k) {
    const double a = 0.05 * k;
    angle.push_back(a);
    lift.push_back(1.2 * std::tanh(5.7 * a / 1.2));
    drag.push_back(0.01 + 0.5 * a * a);
  }
  angle.push_back(std::numbers::pi);
  lift.push_back(0.0);
  drag.push_back(1.0);
  return "[[airfoil]]\nname = \"wing\"\nangle = " + list(angle) + "\nlift = " + list(lift) +
         "\ndrag = " + list(drag) + "\n";
}

/// A stiff blade on a flap hinge. `air`: [wind], [aerodynamics] and what else there is.
Scenario make_rotor(const std::string& air) {
  std::ostringstream text;
  text.precision(17);
  text << "world = \"space\"\n[hub]\n[hub.drive]\nkind = \"constant\"\nspeed = 20.0\n"
          "[blade]\ncount = 1\nlength = 5.0\nbodies = 1\nelements = 1\n[blade.sections]\n"
          "mass_per_length = 3.0\naxial_stiffness = 1e11\nflap_stiffness = 1e7\n"
          "lag_stiffness = 1e7\ntorsion_stiffness = 1e7\n[[blade.joint]]\nname = \"flap\"\n"
          "station = 0.0\nkind = \"revolute\"\naxis = [0, -1, 0]\n[blade.aerodynamics]\n"
          "station = [0.5, 1.5, 2.5, 3.5, 4.2, 4.7, 5.0]\nchord = 0.2\nairfoil = \"wing\"\n"
          "twist = 0.02\n"
       << make_airfoil() << "[air]\ndensity = 1.2\n"
       << air << "[integration]\nspectral_radius = 1.0\nduration = " << kTurns * kTurn
       << "\nstep = " << kTurn / kSteps << "\n";
  return parse_scenario(text.str(), "rotor.toml");
}

/// The flap angle over a turn.
struct Cycle {
  std::vector<double> values;

  double largest() const { return *std::max_element(values.begin(), values.end()); }
  double swing() const { return largest() - *std::min_element(values.begin(), values.end()); }
};

/// Returns that of the periodic motion, at the steps of a run.
Cycle find_cycle(const Scenario& scenario) {
  const auto model = steady::make_steady_model(scenario, {.speed = kSpeed, .is_axial = true});
  const steady::Equilibrium equilibrium = steady::find_machine_equilibrium(*model);
  const steady::LinearModel linear = steady::linearize_machine(equilibrium, *model);
  const vibration::Linearised all{*model, equilibrium, linear};
  const auto axes = vibration::make_standing_axes(model->free_components(), true, kSpeed);
  vibration::PeriodicSystem mean = vibration::make_periodic(linear, axes);
  mean.alike = linear.alike;
  mean.azimuths = model->azimuths();
  const auto whole = steady::make_steady_model(scenario, {.speed = kSpeed, .is_whole = true});
  const auto orbit = vibration::find_periodic_orbit(all, mean, *whole);
  REQUIRE(orbit.has_value());
  const Eigen::Index flap = mean.starts[0];
  Cycle cycle;
  for (int k = 0; k < kSteps; ++k) {
    double value = equilibrium.q[0][0] + orbit->harmonics(flap, 0).real();
    for (Eigen::Index h = 1; h < orbit->harmonics.cols(); ++h)
      value +=
          2.0 *
          std::real(orbit->harmonics(flap, h) *
                    std::polar(1.0, 2.0 * std::numbers::pi * static_cast<double>(h * k) / kSteps));
    cycle.values.push_back(value);
  }
  return cycle;
}

/// Returns that of the last turn of a run.
Cycle run_cycle(const Scenario& scenario) {
  Simulation simulation(scenario, {.executor = ExecutorKind::serial});
  const std::size_t flap = simulation.sensor_index("blade1.flap");
  simulation.run_until((kTurns - 1) * kTurn);
  Cycle cycle;
  for (int k = 0; k < kSteps; ++k) {
    cycle.values.push_back(simulation.sensor_values()[flap]);
    simulation.step();
  }
  return cycle;
}

/// Returns the largest distance of two cycles by the swing of one.
double distance(const Cycle& a, const Cycle& b) {
  double most = 0.0;
  for (std::size_t k = 0; k < a.values.size(); ++k)
    most = std::max(most, std::abs(a.values[k] - b.values[k]));
  return most / b.swing();
}

const std::string kFollowing = "inflow = \"quasi_steady\"\nstall = \"static\"\n";
const std::string kLagging = "inflow = \"dynamic\"\nstall = \"dynamic\"\n";
const std::string kGravity = "[gravity]\nacceleration = [0.0, -9.81, 0.0]\n";
const std::string kAxialWind = "[wind]\nvelocity = [0.0, 0.0, 8.0]\n[aerodynamics]\n";
/// Wind along the axis that grows across it, along y.
const std::string kShear =
    "[wind]\nvelocity = [0.0, 0.0, 8.0]\nup = [0.0, 1.0, 0.0]\nground = -12.0\n"
    "reference_height = 12.0\nshear_exponent = 0.4\n[aerodynamics]\n";
const std::string kYawed = "[wind]\nvelocity = [3.0, 0.0, 8.0]\n[aerodynamics]\n";

}  // namespace

TEST_CASE("orbit in air: gravity, shear and yaw make the limit cycle of a run") {
  struct Case {
    std::string air;
    double tolerance;
  };
  const std::vector<Case> cases{{kAxialWind + kFollowing + kGravity, 2e-3},
                                {kShear + kFollowing, 2e-3},
                                {kYawed + "induction = \"none\"\n" + kFollowing, 2e-3},
                                {kAxialWind + kLagging + kGravity, 5e-3},
                                {kShear + kLagging, 5e-3},
                                {kYawed + kLagging, 5e-3}};
  for (const Case& of : cases) {
    CAPTURE(of.air);
    const Scenario scenario = make_rotor(of.air);
    const Cycle run = run_cycle(scenario);
    CHECK(run.swing() > 1e-3);
    CHECK(distance(find_cycle(scenario), run) < of.tolerance);
  }
}

TEST_CASE("orbit in air: modes about the periodic motion are near those without what causes it") {
  const ModeOptions options{.state = {.speed = kSpeed}, .count = 1, .frame = ModeFrame::floquet};
  const Scenario calm = make_rotor(kAxialWind + kLagging);
  const Scenario pulled = make_rotor(kAxialWind + kLagging + kGravity);
  const Mode without = solve_modes(calm, options).modes.at(0);
  const Mode with = solve_modes(pulled, options).modes.at(0);
  CHECK(with.name == without.name);
  CHECK(std::abs(with.eigenvalue) == approx(std::abs(without.eigenvalue)).epsilon(0.05));
  CHECK(with.eigenvalue.real() == approx(without.eigenvalue.real()).epsilon(0.1));
  CHECK(with.eigenvalue != without.eigenvalue);
}

}  // namespace spoke
