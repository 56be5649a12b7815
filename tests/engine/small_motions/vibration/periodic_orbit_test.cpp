// Tests gravity across the axis: a rigid blade on a lag hinge against the monodromy matrix of its
// own equation, about the periodic motion that the test finds by shooting.

#include "engine/small_motions/vibration/periodic_orbit.h"

#include <doctest/doctest.h>

#include <Eigen/Eigenvalues>
#include <Eigen/QR>
#include <cmath>
#include <complex>
#include <functional>
#include <numbers>
#include <optional>
#include <string>

#include "engine/modes.h"
#include "engine/small_motions/vibration/turn_series.h"
#include "models/error.h"
#include "models/scenario.h"
#include "tests/contains.h"

namespace spoke {
namespace {

using Complex = std::complex<double>;
using Eigen::MatrixXd;
using Eigen::VectorXcd;
using Eigen::VectorXd;

/// The blade, and the hub whose axis z is level; gravity pulls along -y.
struct Pendulum {
  double mass = 2.0, arm = 0.6, inertia = 0.1;  ///< about its centre of mass
  double offset = 0.3, stiffness = 1.5, damping = 0.05;
  double gravity = 3.0;
  double hub = 5.0;  ///< its inertia [kg m^2]

  double about_hinge() const { return inertia + mass * arm * arm; }
};

std::string text_of(double value) { return std::to_string(value); }

Scenario make_scenario(const Pendulum& blade, const std::string& drive, const std::string& gravity,
                       const std::string& more = "", int count = 1) {
  return parse_scenario(
      "world = \"space\"\n[hub]\ninertia = " + text_of(blade.hub) + "\n[hub.drive]\n" + drive +
          "[gravity]\nacceleration = " + gravity +
          "\n[integration]\nduration = 1.0\nstep = 0.01\n" +
          "[[subsystem]]\nname = \"blade\"\nazimuth = 0.3\ncount = " + std::to_string(count) +
          "\n[[subsystem.body]]\nname = \"bar\"\nkind = \"rigid\"\nmass = " + text_of(blade.mass) +
          "\ncenter = [" + text_of(blade.arm) + ", 0.0, 0.0]\ninertia = [0.01, " +
          text_of(blade.inertia) + ", " + text_of(blade.inertia) +
          "]\n[[subsystem.joint]]\nname = \"lag_hinge\"\nparent = \"hub\"\nchild = \"bar\"\n" +
          "kind = \"revolute\"\naxis = [0.0, 0.0, 1.0]\noffset = [" + text_of(blade.offset) +
          ", 0.0, 0.0]\nstiffness = " + text_of(blade.stiffness) +
          "\ndamping = " + text_of(blade.damping) + "\n" + more,
      "blade.toml");
}
std::string down(double gravity) { return "[0.0, " + text_of(-gravity) + ", 0.0]"; }
std::string constant(double speed) {
  return "kind = \"constant\"\nspeed = " + text_of(speed) + "\n";
}

/// Rates of a state at a time.
using Rates = std::function<VectorXcd(double, const VectorXcd&)>;

/// Takes a state over a period by the classical method of fourth order. Imaginary parts that are
/// tiny are derivatives, without differences.
VectorXcd turn(const Rates& rates, VectorXcd y, double period) {
  constexpr int kSteps = 3000;
  const double h = period / kSteps;
  for (int k = 0; k < kSteps; ++k) {
    const double t = k * h;
    const VectorXcd a = rates(t, y), b = rates(t + 0.5 * h, y + 0.5 * h * a);
    const VectorXcd c = rates(t + 0.5 * h, y + 0.5 * h * b), d = rates(t + h, y + h * c);
    y += h / 6.0 * (a + 2.0 * b + 2.0 * c + d);
  }
  return y;
}

/// Returns the multipliers about the motion with this period, sought from `y`. The first `held`
/// entries stay, `gain` is what a state has gained over a turn.
VectorXcd find_multipliers(const Rates& rates, VectorXd y, const VectorXd& gain, double period,
                           Eigen::Index held) {
  const Eigen::Index n = y.size();
  MatrixXd slope(n, n);
  for (int i = 0; i < 12; ++i) {
    VectorXd left;
    for (Eigen::Index k = 0; k < n; ++k) {
      VectorXcd moved = y.cast<Complex>();
      moved[k] += Complex(0.0, 1e-30);
      const VectorXcd end = turn(rates, moved, period);
      slope.col(k) = end.imag() / 1e-30;
      left = end.real() - y - gain;
    }
    if (left.norm() < 1e-12) break;
    const MatrixXd change = (MatrixXd::Identity(n, n) - slope).rightCols(n - held);
    y.tail(n - held) += change.colPivHouseholderQr().solve(left);
  }
  return slope.eigenvalues();
}

/// Returns those of the blade on a hub at constant speed w:
/// I z'' + c z' + k z + w^2 e m l sin z = -m g l cos(w t + z).
VectorXcd solve_driven(const Pendulum& b, double w) {
  const Rates rates = [&](double t, const VectorXcd& y) {
    const double S = b.mass * b.arm;
    VectorXcd v(2);
    v << y[1], (-b.stiffness * y[0] - b.damping * y[1] - w * w * b.offset * S * std::sin(y[0]) -
                b.gravity * S * std::cos(w * t + y[0])) /
                   b.about_hinge();
    return v;
  };
  return find_multipliers(rates, VectorXd::Zero(2), VectorXd::Zero(2),
                          2.0 * std::numbers::pi / std::abs(w), 0);
}

/// Returns those of the blade on a hub that turns freely, at the mean speed w.
VectorXcd solve_free(const Pendulum& b, double w) {
  const double A = b.hub + b.mass * b.offset * b.offset, B = b.about_hinge();
  const double D = b.mass * b.offset * b.arm;
  const Rates rates = [&](double, const VectorXcd& y) {  // theta, zeta, their rates
    const Complex phi = y[0] + y[1], turning = y[2] + y[3];
    const Complex spring = b.stiffness * y[1] + b.damping * y[3];
    const Complex coupling = D * std::cos(y[1]), sine = D * std::sin(y[1]);
    const Complex p =
        sine * turning * turning + spring - b.mass * b.gravity * b.offset * std::cos(y[0]);
    const Complex q = -sine * y[2] * y[2] - spring - b.mass * b.gravity * b.arm * std::cos(phi);
    const Complex all = A * B - coupling * coupling;
    const Complex of_hub = (B * p - coupling * q) / all, of_blade = (A * q - coupling * p) / all;
    VectorXcd v(4);
    v << y[2], y[3], of_hub, of_blade - of_hub;
    return v;
  };
  VectorXd start = VectorXd::Zero(4), gain = VectorXd::Zero(4);
  start[2] = w;
  gain[0] = 2.0 * std::numbers::pi;
  return find_multipliers(rates, start, gain, 2.0 * std::numbers::pi / w, 1);
}

ModesResult solve(const Scenario& scenario, double w, std::optional<int> count = {}) {
  return solve_modes(scenario,
                     {.state = {.speed = w}, .count = count, .frame = ModeFrame::floquet});
}

/// Returns the distance of a mode's multiplier, or its conjugate, from the nearest of these.
double distance(const Mode& mode, const VectorXcd& multipliers, double w) {
  const Complex own = std::exp(mode.eigenvalue * (2.0 * std::numbers::pi / std::abs(w)));
  return std::min((multipliers.array() - own).abs().minCoeff(),
                  (multipliers.array() - std::conj(own)).abs().minCoeff());
}

}  // namespace

TEST_CASE("periodic orbit: a blade under gravity has the multipliers of its own equation") {
  for (const double gravity : {3.0, 9.81})
    for (const double speed : {6.0, -8.0}) {
      CAPTURE(gravity);
      CAPTURE(speed);
      Pendulum blade;
      blade.gravity = gravity;
      const VectorXcd expected = solve_driven(blade, speed);
      const ModesResult found = solve(make_scenario(blade, constant(speed), down(gravity)), speed);
      REQUIRE(found.modes.size() == 1);
      CHECK(distance(found.modes[0], expected, speed) < 1e-8);
      CHECK(found.modes[0].harmonics.size() > 1);
      // Gravity counts: without it the multiplier is another one.
      blade.gravity = 0.0;
      CHECK(distance(found.modes[0], solve_driven(blade, speed), speed) > 1e-5);
    }
}

TEST_CASE("periodic orbit: blades that are alike have equal modes, one after the other") {
  const Pendulum blade;
  const VectorXcd expected = solve_driven(blade, 6.0);
  const ModesResult found =
      solve(make_scenario(blade, constant(6.0), down(blade.gravity), "", 3), 6.0);
  REQUIRE(found.modes.size() == 3);
  for (std::size_t i = 0; i < 3; ++i) {
    CHECK(distance(found.modes[i], expected, 6.0) < 1e-8);
    CHECK(found.modes[i].of == found.equilibrium.blades[i].name);
    CHECK(found.modes[i].name == "lag_hinge 1");
  }
}

TEST_CASE("periodic orbit: a load of constant direction acts as gravity does") {
  const Pendulum blade;
  const std::string load =
      "[[load]]\nsubsystem = \"blade\"\nbody = \"bar\"\npoint = [" + text_of(blade.arm) +
      ", 0.0, 0.0]\nframe = \"inertial\"\nforce = " + down(blade.mass * blade.gravity) + "\n";
  const ModesResult falling = solve(make_scenario(blade, constant(6.0), down(blade.gravity)), 6.0);
  const ModesResult pulled = solve(make_scenario(blade, constant(6.0), down(0.0), load), 6.0);
  CHECK(std::abs(falling.modes[0].eigenvalue - pulled.modes[0].eigenvalue) < 1e-9);
}

TEST_CASE("periodic orbit: springs in a loop act as those of the joint do") {
  // About the hinge's axis a closure opens by the angle of the hinge; nothing else opens it.
  const Pendulum blade;
  Pendulum loose = blade;
  loose.stiffness = loose.damping = 0.0;
  const std::string loop =
      "[[subsystem.loop]]\nname = \"spring\"\nkind = \"fixed\"\n"
      "from = { body = \"bar\" }\nto = { body = \"hub\", point = [" +
      text_of(blade.offset) + ", 0.0, 0.0] }\nstiffness = [1e3, 1e3, 1e3, 1e3, 1e3, " +
      text_of(blade.stiffness) + "]\ndamping = [0.0, 0.0, 0.0, 0.0, 0.0, " +
      text_of(blade.damping) + "]\n";
  for (const double speed : {6.0, -8.0}) {
    const ModesResult found =
        solve(make_scenario(loose, constant(speed), down(blade.gravity), loop), speed);
    REQUIRE(found.modes.size() == 1);
    CHECK(found.modes[0].harmonics.size() > 1);
    CHECK(distance(found.modes[0], solve_driven(blade, speed), speed) < 1e-8);
  }
}

TEST_CASE("periodic orbit: a ball joint acts as three hinges that meet in it do") {
  const std::string head =
      "world = \"space\"\n[hub]\ninertia = 5.0\n[hub.drive]\nSPEED[gravity]\n"
      "acceleration = [0.0, -3.0, -2.0]\n[integration]\nduration = 1.0\nstep = 0.01\n"
      "[[subsystem]]\nname = \"blade\"\n[[subsystem.body]]\nname = \"bar\"\nkind = \"rigid\"\n"
      "mass = 2.0\ncenter = [0.6, 0.0, 0.0]\ninertia = [0.03, 0.08, 0.1]\n";
  const std::string ball =
      "[[subsystem.joint]]\nparent = \"hub\"\nchild = \"bar\"\nkind = \"spherical\"\n"
      "offset = [0.3, 0.0, 0.0]\n";
  const std::string hinges =
      "[[subsystem.body]]\nname = \"cross\"\nkind = \"rigid\"\nmass = 1e-6\ninertia = 1e-8\n"
      "[[subsystem.joint]]\nparent = \"hub\"\nchild = \"cross\"\nkind = \"universal\"\n"
      "axes = [[0, 0, 1], [0, 1, 0]]\noffset = [0.3, 0.0, 0.0]\n"
      "[[subsystem.joint]]\nparent = \"cross\"\nchild = \"bar\"\nkind = \"revolute\"\n"
      "axis = [1, 0, 0]\n";
  const std::string free = "kind = \"torque\"\ntorque = 0.0\ninitial_speed = 6.0\n";
  for (const std::string& drive : {constant(6.0), free}) {
    CAPTURE(drive);
    const auto of = [&](const std::string& joints) {
      std::string text = head + joints;
      text.replace(text.find("SPEED"), 5, drive);
      return solve(parse_scenario(text, "ball.toml"), 6.0);
    };
    const ModesResult one = of(ball), three = of(hinges);
    REQUIRE(one.modes.size() == three.modes.size());
    CHECK(one.modes.back().harmonics.size() > 1);
    VectorXcd expected(std::ssize(three.modes));
    for (std::size_t k = 0; k < three.modes.size(); ++k)
      expected[static_cast<Eigen::Index>(k)] =
          std::exp(three.modes[k].eigenvalue * (2.0 * std::numbers::pi / 6.0));
    for (const Mode& mode : one.modes) CHECK(distance(mode, expected, 6.0) < 1e-6);
  }
}

TEST_CASE("periodic orbit: gravity along the axis, or none, leaves constant matrices") {
  const Pendulum blade;
  for (const std::string gravity : {"[0.0, 0.0, 0.0]", "[0.0, 0.0, -9.81]"}) {
    const Scenario scenario = make_scenario(blade, constant(6.0), gravity);
    const ModesResult found = solve(scenario, 6.0);
    const ModesResult turning = solve_modes(scenario, {.state = {.speed = 6.0}});
    REQUIRE(found.modes.size() == 1);
    CHECK(std::abs(found.modes[0].eigenvalue - turning.modes[0].eigenvalue) < 1e-9);
    CHECK(found.modes[0].harmonics.size() == 1);
  }
}

TEST_CASE("periodic orbit: gravity drives the speed of a hub that turns freely") {
  Pendulum blade;
  blade.damping = 0.0;
  const std::string drive = "kind = \"torque\"\ntorque = 0.0\ninitial_speed = 9.0\n";
  const VectorXcd expected = solve_free(blade, 9.0);
  const ModesResult found = solve(make_scenario(blade, drive, down(blade.gravity)), 9.0);
  REQUIRE(found.modes.size() == 2);
  CHECK(found.modes[0].name == "rigid motion 1");
  CHECK(distance(found.modes[1], expected, 9.0) < 1e-8);
  blade.hub = 1e9;
  CHECK(distance(found.modes[1], solve_driven(blade, 9.0), 9.0) > 1e-4);
}

TEST_CASE("periodic orbit: a resonance with the speed is refused") {
  // A mass that slides outward: x'' + (k/m - w^2) x = -g cos(w t), exactly.
  const Scenario scenario = parse_scenario(
      "world = \"space\"\n[hub]\ninertia = 1.0\n[hub.drive]\nkind = \"constant\"\nspeed = 4.0\n"
      "[gravity]\nacceleration = [0.0, -9.81, 0.0]\n[integration]\nduration = 1.0\nstep = 0.01\n"
      "[[subsystem]]\nname = \"slider\"\n[[subsystem.body]]\nname = \"mass\"\nkind = \"rigid\"\n"
      "mass = 1.0\ninertia = [0.1, 0.1, 0.1]\n[[subsystem.joint]]\nname = \"spring\"\n"
      "parent = \"hub\"\nchild = \"mass\"\nkind = \"prismatic\"\naxis = [1.0, 0.0, 0.0]\n"
      "stiffness = 32.0\n",
      "slider.toml");
  try {
    solve(scenario, 4.0);
    FAIL("no refusal");
  } catch (const DivergenceError& error) {
    CHECK(test::contains(error.what(), "no periodic motion found at 4 rad/s"));
    CHECK(test::contains(error.what(), "slider / spring"));
  }
  const ModesResult off = solve(scenario, 3.0);
  REQUIRE(off.modes.size() == 1);
  CHECK(off.modes[0].frequency == doctest::Approx(std::sqrt(32.0 - 9.0)).epsilon(1e-9));
}

TEST_CASE("turn series: values, derivatives and shifts of a polynomial are exact") {
  const auto value = [](double psi) {
    return 0.7 + 2.0 * std::cos(psi) - 0.3 * std::sin(3.0 * psi);
  };
  Eigen::MatrixXd values(1, 9), moved(1, 9), slopes(1, 9);
  for (int l = 0; l < 9; ++l) {
    const double psi = 2.0 * std::numbers::pi * l / 9.0;
    values(0, l) = value(psi);
    moved(0, l) = value(psi + 0.4);
    slopes(0, l) = -2.0 * std::sin(psi) - 0.9 * std::cos(3.0 * psi);
  }
  const Eigen::MatrixXcd series = vibration::find_harmonics(values);
  CHECK((vibration::sum_harmonics(series, 9) - values).norm() < 1e-14);
  CHECK((vibration::sum_harmonics(vibration::shift_azimuth(series, 0.4), 9) - moved).norm() <
        1e-14);
  CHECK((vibration::sum_harmonics(vibration::differ_by_azimuth(series), 9) - slopes).norm() <
        1e-13);
}

}  // namespace spoke
