// Shafts in bearings against published values, multipliers, closed forms and runs.

#include "tests/engine/small_motions/vibration/shafts.h"

#include <doctest/doctest.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
#include <optional>
#include <sstream>
#include <string>
#include <vector>

#include "engine/campbell.h"
#include "engine/critical.h"
#include "engine/equilibrium.h"
#include "engine/linearize.h"
#include "engine/modes.h"
#include "models/error.h"
#include "models/scenario.h"
#include "tests/message_of.h"

namespace spoke {
namespace {

using doctest::Approx;
using test::make_shaft;
using test::make_shaft_text;
using test::message_of;
using test::Shaft;
using Complex = std::complex<double>;

std::vector<Mode> find_shaft_modes(const Shaft& shaft, int count,
                                   std::optional<ModeFrame> frame = std::nullopt) {
  return solve_modes(make_shaft(shaft), {.count = count, .frame = frame}).modes;
}

/// Returns the modes of a kind.
std::vector<Mode> pick(const std::string& kind, const std::vector<Mode>& modes) {
  std::vector<Mode> picked;
  for (const Mode& mode : modes)
    if (mode.kind == kind) picked.push_back(mode);
  return picked;
}

/// Values of ROSS with the same six elements [rad/s].
struct Published {
  double speed;
  std::vector<double> whirls;
};

TEST_CASE("shafts: the rotors of ROSS whirl at its frequencies, at rest and at any speed") {
  // test_campbell, and rotor_example at rest.
  for (const Published& at : std::vector<Published>{
           {0.0, {82.65303734, 86.65811435, 254.52047828, 274.31285391, 679.48903239}},
           {150.0, {82.60929602, 86.68625235, 251.70037114, 276.87787937, 652.85679897}},
           {300.0, {82.48132723, 86.76734307, 245.49092844, 282.33294699, 614.05536277}},
           {2000.0, {77.37957042, 88.98733512}}}) {
    CAPTURE(at.speed);
    const auto whirls =
        pick("whirl", find_shaft_modes({.speed = at.speed, .second_disc = 0.35}, 8));
    REQUIRE(whirls.size() >= at.whirls.size());
    for (std::size_t k = 0; k < at.whirls.size(); ++k)
      CHECK(whirls[k].frequency == Approx(at.whirls[k]).epsilon(5e-5));
  }
  const std::vector<double> example = {91.79655,  96.28900, 274.56595,
                                       296.50049, 722.8979, 765.0004};
  const auto whirls = pick("whirl", find_shaft_modes({}, 8));
  REQUIRE(whirls.size() >= example.size());
  for (std::size_t k = 0; k < example.size(); ++k)
    CHECK(whirls[k].frequency == Approx(example[k]).epsilon(5e-5));
}

TEST_CASE("shafts: with dampers in bearings whirls are those of Friswell's example 5.9.5") {
  Shaft shaft{.second_disc = 0.35, .bearing = "[1e6, 1e6]", .damping = "[3e3, 3e3]"};
  const double hertz = 2.0 * std::numbers::pi;
  const auto rest = pick("whirl", find_shaft_modes(shaft, 8));
  REQUIRE(rest.size() >= 4);
  CHECK(rest[0].frequency == Approx(13.88753 * hertz).epsilon(5e-5));
  CHECK(rest[2].frequency == Approx(46.54053 * hertz).epsilon(5e-5));
  shaft.speed = 4000.0 / 60.0 * hertz;
  const auto whirls = pick("whirl", find_shaft_modes(shaft, 8));
  REQUIRE(whirls.size() >= 4);
  const double published[] = {13.68188, 14.07164, 41.98290, 50.64868};
  const char* names[] = {"whirl 1 backward", "whirl 1 forward", "whirl 2 backward",
                         "whirl 2 forward"};
  for (std::size_t k = 0; k < 4; ++k) {
    CHECK(whirls[k].name == names[k]);
    CHECK(whirls[k].frequency == Approx(published[k] * hertz).epsilon(5e-5));
    CHECK(whirls[k].eigenvalue.real() < -1.0);
  }
}

TEST_CASE("shafts: stiffness across the opening makes a whirl grow, by ROSS's roots at 4000 rpm") {
  // Its test_example6_w_equals4000rpm has the matrix [kxx, kxy; 0, kyy] in fact.
  const Shaft shaft{.speed = 418.879, .second_disc = 0.35, .bearing = "[[1e6, 5e5], [0, 1e6]]"};
  const auto whirls = pick("whirl", find_shaft_modes(shaft, 7));
  REQUIRE(whirls.size() >= 5);
  const double magnitudes[] = {84.19790, 89.03269, 246.44121, 301.08623, 594.81950};
  for (std::size_t k = 0; k < 5; ++k)
    CHECK(std::abs(whirls[k].eigenvalue) == Approx(magnitudes[k]).epsilon(5e-5));
  CHECK(std::abs(whirls[0].eigenvalue - Complex(-1.88206, 84.17686)) < 2e-3);
  CHECK(std::abs(whirls[1].eigenvalue - Complex(2.38811, 89.00066)) < 2e-3);
  CHECK(whirls[1].grows());
  // At rest Friswell's example 5.9.4, with a symmetric matrix.
  const auto rest = pick(
      "whirl", find_shaft_modes({.second_disc = 0.35, .bearing = "[[1e6, 5e5], [5e5, 1e6]]"}, 7));
  const double hertz[] = {11.66259, 14.80139, 33.97000, 49.19360, 97.96684, 126.61408};
  REQUIRE(rest.size() >= 6);
  for (std::size_t k = 0; k < 6; ++k)
    CHECK(rest[k].frequency == Approx(hertz[k] * 2.0 * std::numbers::pi).epsilon(5e-5));
}

TEST_CASE("shafts: circulation q makes the forward whirl w grow from q = c w on, at any speed") {
  // Exact: with q = c w the force of bearings on that whirl is that of their springs alone.
  constexpr double kDamping = 3e3;
  for (const double speed : {1e-3, 300.0, 418.879}) {
    CAPTURE(speed);
    const auto find_growth = [&](double q) {
      std::ostringstream matrix;
      matrix.precision(17);
      matrix << "[[1e6, " << q << "], [" << -q << ", 1e6]]";
      const auto whirls = pick("whirl", find_shaft_modes({.speed = speed,
                                                          .second_disc = 0.35,
                                                          .bearing = matrix.str(),
                                                          .damping = "[[3e3, 0], [0, 3e3]]"},
                                                         4));
      double most = -1e300;
      for (const Mode& mode : whirls) most = std::max(most, mode.eigenvalue.real());
      return most;
    };
    const auto undamped =
        pick("whirl",
             find_shaft_modes({.speed = speed, .second_disc = 0.35, .bearing = "[1e6, 1e6]"}, 4));
    double w = 0.0;  // of the forward whirl, which next to rest has no sense
    for (const Mode& mode : undamped)
      if (w == 0.0 && !mode.name.ends_with("backward")) w = mode.frequency;
    REQUIRE(w > 80.0);
    CHECK(std::abs(find_growth(kDamping * w)) < 1e-6 * w);
    CHECK(find_growth(1.02 * kDamping * w) > 1e-3);
    CHECK(find_growth(0.98 * kDamping * w) < -1e-3);
  }
}

/// Returns the least distance of a root, or its conjugate, from those of modes, frequencies being
/// known up to multiples of the speed.
double find_distance(Complex s, double speed, const std::vector<Mode>& modes) {
  double nearest = 1e300;
  for (const Mode& mode : modes)
    for (const Complex root : {mode.eigenvalue, std::conj(mode.eigenvalue)}) {
      const double turns = std::round((s - root).imag() / speed);
      nearest = std::min(nearest, std::abs(s - root - Complex(0.0, turns * speed)));
    }
  return nearest;
}

TEST_CASE("shafts: multipliers over a turn are those of the modes seen from outside") {
  const Shaft shaft{.speed = 150.0, .bearing = "[1e6, 0.6e6]", .damping = "[300, 900]"};
  const auto outside = find_shaft_modes(shaft, 6, ModeFrame::fixed);
  const auto turning = find_shaft_modes(shaft, 9, ModeFrame::floquet);
  for (const Mode& mode : outside) {
    CAPTURE(mode.name);
    CHECK(find_distance(mode.eigenvalue, shaft.speed, turning) < 1e-5 * std::abs(mode.eigenvalue));
  }
  // Bearings that are alike in all directions leave constant matrices in the frame that turns, too.
  const Shaft alike{.speed = 150.0, .bearing = "[1e6, 1e6]", .damping = "[300, 300]"};
  const auto along = find_shaft_modes(alike, 9, ModeFrame::turning);
  for (const Mode& mode : find_shaft_modes(alike, 6))
    CHECK(find_distance(mode.eigenvalue, alike.speed, along) < 1e-6 * std::abs(mode.eigenvalue));
}

TEST_CASE("shafts: what a round shaft twists has the same frequency at any speed") {
  for (const char* strain : {"linear", "nonlinear"}) {
    const double at_rest = pick("torsion", find_shaft_modes({.strain = strain}, 7)).at(0).frequency;
    for (const double speed : {300.0, 2000.0})
      CHECK(pick("torsion", find_shaft_modes({.speed = speed, .strain = strain}, 7))
                .at(0)
                .frequency == Approx(at_rest).epsilon(1e-9));
  }
}

TEST_CASE("shafts: a flat one takes the frame that its bearings allow, with a note") {
  Shaft flat{.speed = 150.0, .lag_stiffness = 0.8, .bearing = "[1e6, 1e6]"};
  const ModesResult along = solve_modes(make_shaft(flat), {.count = 3});
  CHECK(along.frame == ModeFrame::turning);
  REQUIRE(along.notes.size() == 1);
  CHECK(
      along.notes[0].find("modes are in the frame \"turning\": the frame \"fixed\" expects shafts "
                          "whose mass and stiffness are alike in all directions") == 0);
  flat.bearing = "[1e6, 0.8e6]";
  CHECK(solve_modes(make_shaft(flat), {.count = 3}).frame == ModeFrame::floquet);
  CHECK(message_of([&] {
          find_shaft_modes(flat, 3, ModeFrame::fixed);
        }).find("as those of rotor are not: of modes the frame \"floquet\" takes any shafts") !=
        std::string::npos);
  CHECK(message_of([&] { find_shaft_modes(flat, 3, ModeFrame::turning); })
            .find("the frame \"turning\" expects springs alike in all directions across the hub's "
                  "axis, as those of rotor / loop \"left\"") != std::string::npos);
  CHECK(message_of([&] {
          solve_linear_system(make_shaft(flat), {}, std::nullopt);
        }).find("the frame \"turning\" expects springs alike") != std::string::npos);
}

/// Loads on the first disc, which turn with the shaft or stand, and its displacement.
const std::string kPushed = R"(
[[load]]
name = "turning"
subsystem = "rotor"
body = "first"
frame = "hub"
force = [0.0, 1.0, 0.0]
time = [0.0, 1.0]
factor = [0.0, 0.0]
[[load]]
name = "standing"
subsystem = "rotor"
body = "first"
frame = "inertial"
force = [0.0, 1.0, 0.0]
time = [0.0, 1.0]
factor = [0.0, 0.0]
[[sensor]]
name = "disc"
quantity = "displacement"
subsystem = "rotor"
body = "first"
frame = "hub"
[[sensor]]
name = "bent"
quantity = "section_force"
subsystem = "rotor"
body = "shaft"
position = 0.3
)";

/// Returns the answer x + i y of a disc to a circling force of this form, by that to a force along
/// y: directions across the hub's axis, which is z in its frame, are alike.
Complex answer(const LinearSystem& of, const std::string& load, const std::string& sensor,
               Complex s) {
  const auto index = [](const std::vector<LinearSignal>& all, const std::string& end) {
    for (std::size_t k = 0; k < all.size(); ++k)
      if (all[k].name.ends_with(end)) return static_cast<Eigen::Index>(k);
    FAIL(end << " is missing");
    return Eigen::Index{-1};
  };
  const Eigen::Index input = index(of.inputs, load);
  const Eigen::MatrixXcd resolvent = s * Eigen::MatrixXcd::Identity(of.A.rows(), of.A.rows()) -
                                     Eigen::MatrixXd(of.A).cast<Complex>();
  const Eigen::VectorXcd x =
      resolvent.partialPivLu().solve(Eigen::MatrixXd(of.B).col(input).cast<Complex>());
  const Eigen::VectorXcd shown =
      Eigen::MatrixXd(of.C).cast<Complex>() * x + Eigen::MatrixXd(of.D).col(input).cast<Complex>();
  return shown[index(of.outputs, sensor + ".y")] -
         Complex(0.0, 1.0) * shown[index(of.outputs, sensor + ".x")];
}

TEST_CASE("shafts: seen from outside a linear model answers as in the turning frame, shifted") {
  constexpr double kSpeed = 150.0;
  const std::string text =
      make_shaft_text({.speed = kSpeed, .bearing = "[1e6, 1e6]", .damping = "[300.0, 300.0]"}) +
      kPushed;
  const Scenario scenario = parse_scenario(text, "shaft.toml");
  const LinearSystem fixed = solve_linear_system(scenario, {}, ModeFrame::fixed);
  const LinearSystem turning = solve_linear_system(scenario, {}, ModeFrame::turning);
  CHECK(std::count(fixed.left_out_inputs.begin(), fixed.left_out_inputs.end(), "rotor / load.1") ==
        1);
  for (const double frequency : {20.0, 82.0, 240.0}) {
    const Complex s(-0.5, frequency);
    const Complex outside = answer(fixed, "load.2", "disc", s);
    const Complex inside = answer(turning, "load.1", "disc", s - Complex(0.0, kSpeed));
    CAPTURE(frequency);
    CAPTURE(outside.real());
    CAPTURE(inside.real());
    CHECK(std::abs(outside - inside) < 1e-6 * std::abs(inside));
  }
  // Shear forces and moments turn with the section; along the shaft they stand.
  const auto shows = [&](const std::string& name) {
    return std::any_of(fixed.outputs.begin(), fixed.outputs.end(),
                       [&](const LinearSignal& one) { return one.name.ends_with(name); });
  };
  CHECK(shows("bent.force.x"));
  CHECK(shows("bent.moment.x"));
  CHECK_FALSE(shows("bent.force.y"));
}

TEST_CASE("shafts: whirls keep their names over the speed, and part as they turn") {
  const CampbellResult result = solve_campbell(make_shaft({.second_disc = 0.35}),
                                               {.speeds = {50.0, 200.0, 350.0}, .count = 4});
  CHECK(result.gaps.empty());
  REQUIRE(result.branches.size() == 4);
  for (const CampbellBranch& branch : result.branches) {
    CAPTURE(branch.name);
    REQUIRE(branch.modes.front().has_value());
    REQUIRE(branch.modes.back().has_value());
    const double first = result.states.front().modes[*branch.modes.front()].frequency;
    const double last = result.states.back().modes[*branch.modes.back()].frequency;
    if (branch.name.ends_with("forward")) CHECK(last > first);
    if (branch.name.ends_with("backward")) CHECK(last < first);
  }
}

/// Returns a disc with its centre of mass beside the axis, between springs of the mount.
Scenario make_jeffcott(double speed, const std::string& stiffness) {
  return parse_scenario(
      "world = \"space\"\n[hub]\naxis = [1, 0, 0]\nmass = 1.0\ninertia = 1.0\n"
      "drive = { kind = \"constant\", speed = " +
          std::to_string(speed) +
          " }\n[integration]\nstep = 1e-3\nduration = 0.1\n[[subsystem]]\nname = \"disc\"\n"
          "[[subsystem.body]]\nname = \"disc\"\nkind = \"rigid\"\nmass = 20.0\n"
          "center = [0, 0.001, 0]\ninertia = 0.5\n"
          "[[subsystem.joint]]\nparent = \"hub\"\nchild = \"disc\"\nkind = \"bushing\"\n"
          "free = [\"y\", \"z\"]\n"
          "[[subsystem.loop]]\nname = \"rim\"\nkind = \"bearing\"\naxis = [1, 0, 0]\n"
          "from = { body = \"disc\", point = [0, 0, 0] }\nto = { body = \"mount\" }\nstiffness = "
          "[" +
          stiffness + "]\n",
      "disc.toml");
}

TEST_CASE("shafts: a disc out of balance turns where its spring and its spin leave it") {
  for (const double speed : {10.0, 90.0, 250.0}) {
    const double square = speed * speed, natural = 2e5 / 20.0;
    const EquilibriumResult rest = solve_equilibrium(make_jeffcott(speed, "2e5, 2e5"));
    REQUIRE(rest.blades.at(0).joints.size() == 2);
    CHECK(rest.blades[0].joints[0].value ==
          Approx(0.001 * square / (natural - square)).epsilon(1e-7));
  }
  CHECK(message_of([&] { solve_equilibrium(make_jeffcott(90.0, "2e5, 1e5")); })
            .find("disc / loop \"rim\" bears forces of what the hub turns against, which change "
                  "with its azimuth") != std::string::npos);
}

}  // namespace
}  // namespace spoke
