// Finds critical loads and speeds that are known.

#include "engine/critical.h"

#include <doctest/doctest.h>

#include <Eigen/Eigenvalues>
#include <cmath>
#include <complex>
#include <numbers>
#include <string>
#include <tuple>

#include "models/error.h"
#include "tests/engine/small_motions/steady/blades.h"
#include "tests/message_of.h"

namespace spoke {
namespace {

using doctest::Approx;
using test::make_planar;
using test::make_spatial;
using test::message_of;

/// A column along x with a load at its tip, softer in lag than in flap; or with gravity.
Scenario make_column(const std::string& more) {
  Scenario scenario = make_spatial({.axial_stiffness = 1e9, .more = more});
  scenario.space->blades[0].azimuth = 0.0;
  for (double& value : scenario.space->blades[0].beam.sections.flap_stiffness) value = 2.0;
  return scenario;
}
std::string push(const std::string& frame) {
  return "[[load]]\nname = \"push\"\nframe = \"" + frame + "\"\nforce = [-1.0, 0.0, 0.0]\n";
}
/// A load in the plane that follows the section.
std::string follower(const std::string& kind, const std::string& key) {
  return "[[" + kind + "]]\nname = \"push\"\nframe = \"section\"\n" + key + " = [-1.0, 0.0]\n";
}

CriticalPoint find(const Scenario& scenario, const CriticalOptions& options) {
  const CriticalResult result = solve_critical(scenario, options);
  REQUIRE(result.critical);
  REQUIRE(result.critical->mode);
  CHECK(result.values.size() == result.states.size());
  CHECK(result.values[result.critical->state] == result.critical->value);
  return *result.critical;
}

/// A light shaft along the axis of rotation with a disc at its end.
constexpr double kLength = 0.5, kShaft = 0.01, kDisc = 2.0, kPolar = 0.05, kTransverse = 0.03;
Scenario make_shaft(const std::string& lag, const std::string& more = "") {
  return parse_scenario(
      "world = \"space\"\n[hub]\ninertia = 1.0\n[hub.drive]\nkind = \"constant\"\n"
      "speed = 104.0\n[[subsystem]]\nname = \"shaft\"\n"
      "[[subsystem.body]]\nname = \"rod\"\nkind = \"beam\"\nlength = 0.5\nbodies = 1\n"
      "elements = 2\n[subsystem.body.sections]\nmass_per_length = 0.01\nlag_stiffness = " +
          lag +
          "\nflap_stiffness = 700.0\nlag_inertia = 1e-9\nflap_inertia = 1e-9\n"
          "axial_stiffness = 1e9\ntorsion_stiffness = 1e7\n"
          "[[subsystem.body]]\nname = \"disc\"\nkind = \"rigid\"\nmass = 2.0\n"
          "inertia = [0.05, 0.03, 0.03]\n[[subsystem.joint]]\nparent = \"hub\"\nchild = \"rod\"\n"
          "kind = \"fixed\"\norientation = [0.0, -1.5707963267948966, 0.0]\n"
          "[[subsystem.joint]]\nparent = \"rod\"\nchild = \"disc\"\n"
          "kind = \"fixed\"\n" +
          more + "[integration]\nduration = 1.0\n",
      "shaft.toml");
}

/// Returns the speed at which place and slope of the disc, turning with the shaft once per
/// revolution, need no force: det(K - w^2 (M - diag(0, Ip))) = 0, the mass of the shaft by its
/// static shape.
double calc_critical_speed(double stiffness) {
  const double L = kLength;
  Eigen::Matrix2d K, M;
  K << 12.0, -6.0 * L, -6.0 * L, 4.0 * L * L;
  K *= stiffness / std::pow(L, 3);
  M << 156.0, -22.0 * L, -22.0 * L, 4.0 * L * L;
  M *= kShaft * L / 420.0;
  M += Eigen::Vector2d(kDisc, kTransverse - kPolar).asDiagonal();
  // M is indefinite: one of the two squares is positive.
  return std::sqrt(Eigen::Matrix2d(M.inverse() * K).eigenvalues().real().maxCoeff());
}

/// Four stiff blades of unit mass and length, hinged in lag at the offset 0.1 from a hub of mass 3
/// that equal springs hold in the plane: in all directions, and so in the turning frame, too.
Scenario make_ground_resonance(double damping) {
  std::string text =
      "world = \"space\"\n[hub.drive]\nkind = \"constant\"\nspeed = 1.0\n[[subsystem]]\n"
      "name = \"rotor\"\n[[subsystem.body]]\nname = \"slide\"\nkind = \"rigid\"\nmass = 1e-9\n"
      "inertia = [1e-9, 1e-9, 1e-9]\n[[subsystem.body]]\nname = \"center\"\nkind = \"rigid\"\n"
      "mass = 3.0\ninertia = [1.0, 1.0, 1.0]\n"
      "[[subsystem.joint]]\nname = \"x\"\nparent = \"hub\"\nchild = \"slide\"\n"
      "kind = \"prismatic\"\naxis = [1.0, 0.0, 0.0]\nstiffness = 7.0\n"
      "[[subsystem.joint]]\nname = \"y\"\nparent = \"slide\"\nchild = \"center\"\n"
      "kind = \"prismatic\"\naxis = [0.0, 1.0, 0.0]\nstiffness = 7.0\n";
  for (int b = 0; b < 4; ++b) {
    const double azimuth = b * std::numbers::pi / 2.0;
    const std::string name = "blade" + std::to_string(b);
    text +=
        "[[subsystem.body]]\nname = \"" + name +
        "\"\nkind = \"rigid\"\nmass = 1.0\ncenter = [0.5, 0.0, 0.0]\n"
        "inertia = [0.001, 0.08333333333333333, 0.08333333333333333]\n"
        "[[subsystem.joint]]\nname = \"lag" +
        std::to_string(b) + "\"\nparent = \"center\"\nchild = \"" + name +
        "\"\nkind = \"revolute\"\naxis = [0.0, 0.0, 1.0]\ndamping = " + std::to_string(damping) +
        "\noffset = [" + std::to_string(0.1 * std::cos(azimuth)) + ", " +
        std::to_string(0.1 * std::sin(azimuth)) + ", 0.0]\norientation = [0.0, 0.0, " +
        std::to_string(azimuth) + "]\n";
  }
  return parse_scenario(text + "[integration]\nduration = 1.0\n", "ground_resonance.toml");
}

/// Returns the determinant of Coleman and Feingold (1958, NACA report 1351) at a root s of the
/// inertial frame, for the same rotor, see ground_resonance_test.cpp.
std::complex<double> determinant(std::complex<double> s, double w) {
  const std::complex<double> i(0.0, 1.0);
  return (7.0 * s * s + 7.0) * ((s * s - 2.0 * i * w * s - w * w) / 3.0 + 0.05 * w * w) -
         0.5 * s * s * s * s;
}

}  // namespace

TEST_CASE("critical: Euler's column, and one that its weight buckles") {
  const double euler = std::pow(std::numbers::pi, 2) / 4.0;
  for (const std::string frame : {"inertial", "hub"}) {
    const CriticalPoint found =
        find(make_column(push(frame)), {.of = "load=push", .from = 0.0, .to = 3.0, .points = 4});
    CHECK(found.kind == CriticalKind::buckling);
    CHECK(found.value == Approx(euler).epsilon(1e-6));
    CHECK(found.name == "lag 1");
    CHECK(found.of == "blade 1");
    CHECK(found.frequency == 0.0);
  }
  const Scenario plane = make_planar({.more = "[[load]]\nname = \"push\"\nframe = \"inertial\"\n"
                                              "force = [-2.0, 0.0]\n"});
  CHECK(find(plane, {.of = "load=push", .from = 0.0, .to = 3.0, .points = 4}).value ==
        Approx(euler / 2.0).epsilon(1e-6));
  // Greenhill 1881: q L^3/EI = 7.8373474.
  const CriticalPoint heavy = find(make_column("[gravity]\nacceleration = [-2.0, 0.0, 0.0]\n"),
                                   {.of = "load=gravity", .from = 0.0, .to = 5.0, .points = 4});
  CHECK(heavy.kind == CriticalKind::buckling);
  CHECK(heavy.value == Approx(7.8373474 / 2.0).epsilon(2e-6));
}

TEST_CASE("critical: columns that forces which follow them make flutter") {
  // Beck 1952: P L^2/EI = 20.0509536.
  const CriticalPoint beck =
      find(make_planar({.bodies = 6, .axial_stiffness = 1e9, .more = follower("load", "force")}),
           {.of = "load=push", .from = 18.0, .to = 22.0, .points = 3, .count = 2});
  CHECK(beck.kind == CriticalKind::flutter);
  CHECK(beck.value == Approx(20.0509536).epsilon(3e-6));
  CHECK(beck.frequency == Approx(11.0156).epsilon(1e-4));
  // Leipholz 1962: q L^3/EI = 40.054.
  const CriticalPoint leipholz =
      find(make_planar(
               {.axial_stiffness = 1e9, .more = follower("distributed_load", "force_per_length")}),
           {.of = "load=push", .from = 38.0, .to = 42.0, .points = 3, .count = 2});
  CHECK(leipholz.kind == CriticalKind::flutter);
  CHECK(leipholz.value == Approx(40.054).epsilon(2e-5));
}

TEST_CASE("critical: speeds of a shaft with a disc, equal and unequal in its stiffnesses") {
  const CriticalOptions options{.of = "speed", .from = 0.0, .to = 150.0, .points = 7};
  const double expected = calc_critical_speed(700.0);
  const CriticalPoint equal = find(make_shaft("700.0"), options);
  CHECK(equal.kind == CriticalKind::critical_speed);
  CHECK(equal.value == Approx(expected).epsilon(1e-6));
  // Between the critical speeds of its two directions a deflection grows.
  const CriticalPoint unequal = find(make_shaft("1000.0"), options);
  CHECK(unequal.kind == CriticalKind::divergence);
  CHECK(unequal.value == Approx(expected).epsilon(1e-6));
  // Damping that turns with the shaft makes it whirl beyond.
  const CriticalPoint damped =
      find(make_shaft("700.0", "[damping]\nstiffness_factor = 1e-4\n"), options);
  CHECK(damped.kind == CriticalKind::critical_speed);
  CHECK(damped.value == Approx(expected).epsilon(1e-5));
}

TEST_CASE("critical: ground resonance begins where the determinant has a double root") {
  const Scenario rotor = make_ground_resonance(0.0);
  // Once per revolution, s = i w: (7 - 7 w^2) 0.05 w^2 = w^4/2.
  const CriticalPoint whirl = find(rotor, {.of = "speed", .from = 0.1, .to = 0.8, .points = 8});
  CHECK(whirl.kind == CriticalKind::critical_speed);
  CHECK(whirl.value == Approx(std::sqrt(0.35 / 0.85)).epsilon(1e-7));
  const CriticalPoint onset = find(rotor, {.of = "speed", .from = 0.7, .to = 1.0, .points = 7});
  CHECK(onset.kind == CriticalKind::flutter);
  const std::complex<double> s(0.0, onset.value - onset.frequency);
  const std::complex<double> other(0.0, onset.value + onset.frequency);
  const auto is_root = [&](std::complex<double> root) {
    return std::abs(determinant(root, onset.value)) < 1e-7;
  };
  CHECK((is_root(s) || is_root(other)));
  const std::complex<double> root = is_root(s) ? s : other, step(0.0, 1e-4);
  const std::complex<double> slope =
      (determinant(root + step, onset.value) - determinant(root - step, onset.value)) /
      (2.0 * step);
  CHECK(std::abs(slope) < 1e-3);
}

TEST_CASE("critical: growth that comes slowly is found where it begins") {
  // A follower force on a column with damping: the real part of a root passes zero.
  const Scenario column =
      make_planar({.bodies = 2,
                   .axial_stiffness = 1e9,
                   .more = follower("load", "force") + "[damping]\nstiffness_factor = 1e-3\n"});
  const CriticalPoint found =
      find(column, {.of = "load=push", .from = 5.0, .to = 15.0, .points = 3, .count = 2});
  CHECK(found.kind == CriticalKind::flutter);
  CHECK(found.value < 15.0);  // damping takes half of the load (Ziegler)
  const auto growth_at = [&](double factor) {
    Scenario loaded = column;
    loaded.rotor.loads[0].force *= factor;
    double most = -1.0;
    for (const Mode& mode : solve_modes(loaded, {.count = 4}).modes)
      if (mode.frequency > 0.0) most = std::max(most, mode.eigenvalue.real());
    return most;
  };
  CHECK(growth_at(found.value * (1.0 - 1e-5)) < 0.0);
  CHECK(growth_at(found.value * (1.0 + 1e-5)) > 0.0);
}

TEST_CASE("critical: a truss snaps through where its equilibrium ends") {
  // Two springs at a slope that meet at a mass which slides: half of it, a spring to the hub.
  // The force of a spring of rest length sqrt(1 + h^2) on a slider at y <= h:
  // P(y) = k y (sqrt(1 + h^2)/sqrt(1 + y^2) - 1), largest where 1 + y^2 = (1 + h^2)^(1/3).
  const double h = 0.5;
  const std::string text =
      "world = \"space\"\n[hub.drive]\nkind = \"fixed\"\n[[subsystem]]\nname = \"truss\"\n"
      "[[subsystem.body]]\nname = \"slider\"\nkind = \"rigid\"\nmass = 1.0\n"
      "inertia = [1.0, 1.0, 1.0]\n[[subsystem.joint]]\nparent = \"hub\"\nchild = \"slider\"\n"
      "kind = \"prismatic\"\naxis = [0.0, 1.0, 0.0]\noffset = [1.0, 0.5, 0.0]\n"
      "[[subsystem.loop]]\nname = \"spring\"\nkind = \"distance\"\n"
      "from = {body = \"slider\", point = [0.0, 0.0, 0.0]}\n"
      "to = {body = \"hub\", point = [0.0, 0.0, 0.0]}\nstiffness = 100.0\n"
      "[[load]]\nname = \"push\"\nsubsystem = \"truss\"\nbody = \"slider\"\n"
      "frame = \"inertial\"\nforce = [0.0, -1.0, 0.0]\n[integration]\nduration = 1.0\n";
  const double y = std::sqrt(std::cbrt(1.0 + h * h) - 1.0);
  const double most = 100.0 * y * (std::sqrt((1.0 + h * h) / (1.0 + y * y)) - 1.0);
  const CriticalPoint found = find(parse_scenario(text, "truss.toml"),
                                   {.of = "load=push", .from = 0.0, .to = 2.0 * most, .points = 5});
  CHECK(found.kind == CriticalKind::limit_point);
  CHECK(found.value == Approx(most).epsilon(1e-7));
}

TEST_CASE("critical: a stable range has none, and loads of one name go together") {
  Scenario column = make_column(push("inertial") + push("inertial"));
  const CriticalResult none =
      solve_critical(column, {.of = "load=push", .from = -3.0, .to = 1.0, .points = 3, .count = 2});
  CHECK_FALSE(none.critical);
  CHECK(none.values == std::vector{-3.0, -1.0, 1.0});
  CHECK(none.branches.size() == 2);
  CHECK(find(column, {.of = "load=push", .from = 0.0, .to = 2.0, .points = 3}).value ==
        Approx(std::pow(std::numbers::pi, 2) / 8.0).epsilon(1e-6));
}

TEST_CASE("critical: options that make no sense are refused") {
  const Scenario column = make_column(push("inertial"));
  const auto refusal = [&](const CriticalOptions& options) {
    return message_of([&] { solve_critical(column, options); });
  };
  CHECK(refusal({.of = "load=pull", .from = 0.0, .to = 1.0}) ==
        "the load is \"pull\", did you mean \"push\"?");
  CHECK(refusal({.of = "load=thrust", .from = 0.0, .to = 1.0}) ==
        "the load is \"thrust\", expected \"gravity\" or \"push\"");
  CHECK(
      refusal({.of = "load=gravity", .from = 0.0, .to = 1.0}).starts_with("gravity.acceleration"));
  CHECK(refusal({.of = "mass", .from = 0.0, .to = 1.0}) ==
        "what is varied is \"mass\", expected \"speed\" or \"load=NAME\"");
  CHECK(refusal({.of = "load=push", .from = 1.0, .to = 1.0}) ==
        "the range goes from 1 to 1, expected it to ascend");
  CHECK(refusal({.of = "load=push", .from = 0.0, .to = NAN}).starts_with("an end of the range is"));
  CHECK(refusal({.of = "load=push", .from = 0.0, .to = 1.0, .points = 1}) ==
        "1 points, expected 2 or more");
  CHECK(refusal({.of = "load=push", .from = 0.0, .to = 1.0, .count = 0}) ==
        "0 modes, expected 1 or more");
  CHECK(refusal({.of = "speed", .from = 0.0, .to = 1.0, .state = {1.0}}) ==
        "a speed is given, expected none: it is the speed that is varied");
  CHECK(refusal({.of = "load=push", .from = 3.0, .to = 4.0})
            .find("times the load \"push\" the equilibrium is unstable already: lag ") !=
        std::string::npos);
}

/// A disc of 10 kg amid a light shaft of one metre between two bearings that hold its ends in their
/// places; its centre is off the axis by e [m]. With linear strains, which do not feel the tension
/// that the bearings make within the halves: with others the shaft stiffens as it bends, and its
/// whirl does not end.
Scenario make_unbalanced(const std::string& e) {
  const auto half = [](const std::string& name) {
    return "[[subsystem.body]]\nname = \"" + name +
           "\"\nkind = \"beam\"\nlength = 0.5\nbodies = 1\nelements = 2\nstrain = \"linear\"\n"
           "[subsystem.body.sections]\nmass_per_length = 0.01\naxial_stiffness = 6e7\n"
           "flap_stiffness = 1000.0\nlag_stiffness = 1000.0\ntorsion_stiffness = 800.0\n";
  };
  return parse_scenario(
      "world = \"space\"\n[hub]\naxis = [1, 0, 0]\ninertia = 1e-3\n[hub.drive]\n"
      "kind = \"constant\"\nspeed = 50.0\n[[subsystem]]\nname = \"r\"\n" +
          half("left") +
          "[[subsystem.body]]\nname = \"disc\"\nkind = \"rigid\"\nmass = 10.0\n"
          "inertia = [0.1, 0.05, 0.05]\ncenter = [0, " +
          e + ", 0]\n" + half("right") +
          "[[subsystem.joint]]\nparent = \"hub\"\nchild = \"left\"\nkind = \"universal\"\n"
          "axes = [[0, 1, 0], [0, 0, 1]]\n[[subsystem.joint]]\nparent = \"left\"\n"
          "child = \"disc\"\nkind = \"fixed\"\n[[subsystem.joint]]\nparent = \"disc\"\n"
          "child = \"right\"\nkind = \"fixed\"\n[[subsystem.loop]]\nname = \"bearing\"\n"
          "kind = \"spherical\"\nfrom = { body = \"right\", station = 0.5 }\n"
          "to = { body = \"mount\", point = [1.0, 0, 0] }\n[integration]\nduration = 1.0\n",
      "unbalanced.toml");
}

TEST_CASE("critical: an unbalanced shaft jumps where its steady state ends, whatever the points") {
  // Simply supported, with the disc amid it: sqrt(48 EI/(L^3 m)), the shaft adding 17/35 of its
  // mass.
  const double linear = std::sqrt(48.0 * 1000.0 / (10.0 + 17.0 / 35.0 * 0.01));
  const CriticalPoint balanced = find(
      make_unbalanced("0.0"), {.of = "speed", .from = 50.0, .to = 90.0, .points = 5, .count = 3});
  CHECK(balanced.kind == CriticalKind::critical_speed);
  CHECK(balanced.value == Approx(linear).epsilon(1e-4));
  // Tension stiffens the bent shaft, so that its whirl goes on beyond that speed.
  const Scenario shaft = make_unbalanced("0.0001");
  double value = 0.0;
  for (const auto& [from, to, points] : {std::tuple{50.0, 90.0, 5}, {60.0, 80.0, 4}}) {
    const CriticalResult found = solve_critical(
        shaft, {.of = "speed", .from = from, .to = to, .points = points, .count = 3});
    REQUIRE(found.critical);
    CHECK(found.critical->kind == CriticalKind::jump);
    CHECK(name_of(found.critical->kind) == "jump");
    CHECK(found.critical->value > linear);
    if (value != 0.0) CHECK(found.critical->value == Approx(value).epsilon(1e-7));
    value = found.critical->value;
    // Before, the disc is bent out with its unbalance; beyond, it turns about its centre of mass,
    // and is bent much less: e w^2/(w^2 - linear^2).
    REQUIRE(found.critical->beyond);
    const auto joint = [&](std::size_t state) {
      return std::abs(found.states[state].equilibrium.blades.at(0).joints.at(1).value);
    };
    CHECK(joint(*found.critical->beyond) < 0.2 * joint(found.critical->state));
    CHECK(found.values[*found.critical->beyond] == Approx(value).epsilon(1e-5));
  }
  CHECK_FALSE(
      solve_critical(shaft, {.of = "speed", .from = 50.0, .to = 68.0, .points = 4, .count = 3})
          .critical);
}

TEST_CASE("critical: a model without stiffness does not grow at rest") {
  // A blade on a free flap hinge is held by rotation alone.
  const Scenario blade = make_spatial(
      {.bodies = 1,
       .elements = 1,
       .joint = "[[blades.joint]]\nkind = \"revolute\"\naxis = [0, 1, 0]\nstation = 0.0\n"});
  const CriticalResult found =
      solve_critical(blade, {.of = "speed", .from = 0.0, .to = 2.0, .points = 3});
  CHECK_FALSE(found.critical);
}

}  // namespace spoke
