// Equilibria, modes and performance of rotors in air against closed forms.

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <sstream>
#include <string>
#include <vector>

#include "engine/equilibrium.h"
#include "engine/modes.h"
#include "engine/performance.h"
#include "models/drive.h"
#include "spoke/error.h"
#include "tests/approx.h"
#include "tests/message_of.h"
#include "tests/shipped.h"

using namespace spoke;
using spoke::testing::approx;

namespace {

constexpr double kRadius = 5.0, kSpeed = 20.0, kMass = 3.0, kSlope = 5.7, kChord = 0.2;

/// Returns the stations of a blade, from the root to the tip.
std::string stations(int count) {
  std::ostringstream text;
  for (int k = 0; k < count; ++k) text << (k ? ", " : "[") << kRadius * k / (count - 1);
  return text.str() + "]";
}

/// A stiff blade of three on a hub that turns; lift is linear in the angle of attack, and there is
/// no drag. `joint`: tables of its joints; `air`: what is behind [air].
std::string make_rotor(const std::string& joint, const std::string& air, double pitch = 0.0,
                       const std::string& drive = "kind = \"constant\"\nspeed = 20.0\n") {
  std::ostringstream text;
  text << "world = \"space\"\n[hub]\nmass = 10.0\ninertia = 2.0\n[hub.drive]\n"
       << drive
       << "[blade]\ncount = 3\nlength = 5.0\nbodies = 1\nelements = 2\n[blade.sections]\n"
          "mass_per_length = 3.0\naxial_stiffness = 1e13\nflap_stiffness = 1e9\n"
          "lag_stiffness = 1e9\ntorsion_stiffness = 1e9\n"
       << joint << "[blade.aerodynamics]\nstation = " << stations(101)
       << "\nchord = 0.2\nairfoil = \"plate\"\ntwist = " << pitch
       << "\n[[airfoil]]\nname = \"plate\"\n"
          "angle = [-3.141592653589793, -0.5, 0.5, 3.141592653589793]\n"
          "lift = [0.0, -2.85, 2.85, 0.0]\ndrag = [0.0, 0.0, 0.0, 0.0]\n"
       << air << "[integration]\nduration = 1.0\n";
  return text.str();
}

const std::string kFlapHinge =
    "[[blade.joint]]\nname = \"flap\"\nstation = 0.0\nkind = \"revolute\"\n"
    "axis = [0, -1, 0]\n";
const std::string kPitchJoint =
    "[[blade.joint]]\nname = \"pitch\"\nstation = 0.0\nkind = \"revolute\"\n"
    "axis = [1, 0, 0]\nmotion = { constant = 0.0 }\n";
const std::string kNoInduction =
    "[air]\ndensity = 1.2\n[aerodynamics]\ninduction = \"none\"\nstall = \"static\"\n";

/// The Lock number: rho a c R^4 by the moment of inertia about the hinge.
double lock_number() {
  const double inertia = kMass * std::pow(kRadius, 3) / 3.0;
  return 1.2 * kSlope * kChord * std::pow(kRadius, 4) / inertia;
}

}  // namespace

TEST_CASE("air damps the flapping of a hinged blade by a sixteenth of its Lock number") {
  const Scenario scenario = parse_scenario(make_rotor(kFlapHinge, kNoInduction), "rotor.toml");
  const ModesResult modes = solve_modes(scenario, {.count = 1});
  REQUIRE(!modes.modes.empty());
  const Mode& flap = modes.modes.front();
  // Coned by beta the sections turn about the blade with Omega beta, which raises the flow at three
  // quarters of the chord: the stiffness falls by this share.
  const double turning = 1.2 * kSlope * kChord * kChord / (4.0 * kMass);
  const double magnitude = kSpeed * std::sqrt(1.0 - turning);
  CHECK(std::abs(flap.eigenvalue) == approx(magnitude).epsilon(1e-3));
  CHECK(-flap.eigenvalue.real() == approx(lock_number() / 16.0 * kSpeed).epsilon(1e-3));
}

TEST_CASE("a hinged blade cones by an eighth of its Lock number times its pitch") {
  const double pitch = 0.02;
  const Scenario scenario =
      parse_scenario(make_rotor(kFlapHinge, kNoInduction, pitch), "rotor.toml");
  const EquilibriumResult result = solve_equilibrium(scenario);
  const double turning = 1.2 * kSlope * kChord * kChord / (4.0 * kMass);
  CHECK(result.blades[0].joints[0].value ==
        approx(lock_number() / 8.0 * pitch / (1.0 - turning)).epsilon(2e-3));
}

TEST_CASE("thrust of a hovering rotor without induction is that of its sections") {
  const double pitch = 0.05;
  const Scenario scenario = parse_scenario(make_rotor("", kNoInduction, pitch), "rotor.toml");
  const EquilibriumResult result = solve_equilibrium(scenario);
  REQUIRE(result.air.has_value());
  const double thrust =
      3.0 * 0.5 * 1.2 * kChord * kSlope * pitch * kSpeed * kSpeed * std::pow(kRadius, 3) / 3.0;
  CHECK(result.air->thrust == approx(thrust).epsilon(1e-3));
  CHECK(result.air->wind == 0.0);
}

TEST_CASE("a rotor in wind takes no more than Betz allows, and its torque balances the drive") {
  const std::string air =
      "[air]\ndensity = 1.2\n[wind]\nvelocity = [0.0, 0.0, 8.0]\n[aerodynamics]\nstall = "
      "\"static\"\n";
  const std::string drive =
      "kind = \"torque_by_speed\"\nspeed = [0.0, 5.0, 30.0]\ntorque = [0.0, 0.0, -3000.0]\n"
      "initial_speed = 10.0\n";
  const Scenario scenario = parse_scenario(make_rotor(kPitchJoint, air, 0.0, drive), "rotor.toml");
  const PerformanceResult result = solve_performance(scenario, {.wind = {6.0, 8.0, 10.0}});
  REQUIRE(result.points.size() == 3);
  CHECK(result.radius == approx(kRadius));
  for (const PerformancePoint& point : result.points) {
    CAPTURE(point.wind);
    CHECK(point.gap.empty());
    CHECK(point.power_coefficient > 0.2);
    CHECK(point.power_coefficient < 16.0 / 27.0);
    const double torque = -calc_torque(scenario.space->hub.drive, 0.0, point.speed);
    CHECK(point.torque == approx(torque).epsilon(1e-4));
    const double area = std::numbers::pi * kRadius * kRadius;
    CHECK(point.thrust_coefficient ==
          approx(point.thrust / (0.6 * area * point.wind * point.wind)).epsilon(1e-12));
  }
}

TEST_CASE("a map of performance is that of single points, and pitch moves the joints") {
  const std::string air =
      "[air]\ndensity = 1.2\n[wind]\nvelocity = [0.0, 0.0, 8.0]\n[aerodynamics]\nstall = "
      "\"static\"\n";
  const Scenario joints = parse_scenario(make_rotor(kPitchJoint, air), "rotor.toml");
  const PerformanceResult map =
      solve_performance(joints, {.tip_speed_ratio = {5.0, 8.0}, .pitch = {-0.05, 0.0}});
  REQUIRE(map.points.size() == 4);
  CHECK(map.is_map);
  const Scenario twisted = parse_scenario(make_rotor("", air, -0.05), "rotor.toml");
  for (const std::size_t k : {0, 2}) {
    const PerformancePoint& point = map.points[k];
    CHECK(point.pitch == -0.05);
    CHECK(point.speed == approx(point.tip_speed_ratio * 8.0 / kRadius));
    const EquilibriumResult alone = solve_equilibrium(twisted, {point.speed});
    CHECK(point.thrust == approx(alone.air->thrust).epsilon(1e-5));
    CHECK(point.torque == approx(alone.air->torque).epsilon(1e-5));
  }
  CHECK(map.points[1].thrust > map.points[0].thrust);
}

namespace {

/// Two rotors of the blades of make_rotor() on a carrier.
std::string make_two_rotors(const std::string& air) {
  const std::string whole = make_rotor(kPitchJoint, air);
  const std::size_t blade = whole.find("[blade]"), shared = whole.find("[[airfoil]]");
  std::string blades = whole.substr(blade, shared - blade);
  for (std::size_t at = 0; (at = blades.find("[blade", at)) != std::string::npos; at += 7)
    blades.insert(at + 1, "rotor.");
  const auto rotor = [&](const std::string& name, double speed, const std::string& place) {
    std::ostringstream text;
    text << "[[rotor]]\nname = \"" << name << "\"\nhub = { mass = 10.0, inertia = 2.0, drive = "
         << "{ kind = \"constant\", speed = " << speed
         << " } }\naxle = { body = \"frame\", offset = " << place << " }\n";
    return text.str() + blades;
  };
  return "world = \"space\"\n[support]\nfrom = \"ground\"\n[[support.body]]\nname = \"frame\"\n"
         "kind = \"rigid\"\nmass = 20.0\ninertia = 5.0\n[[support.joint]]\nchild = \"frame\"\n"
         "kind = \"fixed\"\n" +
         rotor("front", 20.0, "[6.0, 0.0, 1.0]") + rotor("rear", 12.0, "[-6.0, 0.0, 1.0]") +
         whole.substr(shared);
}

}  // namespace

TEST_CASE("the performance of one of several rotors is that of the rotor alone") {
  const std::string air = "[air]\ndensity = 1.2\n[wind]\nvelocity = [0.0, 0.0, 8.0]\n";
  const Scenario both = parse_scenario(make_two_rotors(air), "two.toml");
  const auto same = [](const PerformanceResult& found, const PerformanceResult& known) {
    REQUIRE(found.points.size() == known.points.size());
    CHECK(found.radius == known.radius);
    for (std::size_t k = 0; k < known.points.size(); ++k) {
      CHECK(known.points[k].gap.empty());
      CHECK(std::abs(known.points[k].power) > 10.0);
      CHECK(found.points[k].speed == known.points[k].speed);
      CHECK(found.points[k].power == approx(known.points[k].power).epsilon(1e-9));
      CHECK(found.points[k].thrust == approx(known.points[k].thrust).epsilon(1e-9));
    }
  };
  for (const auto& own : {std::pair("front", 20.0), std::pair("rear", 12.0)}) {
    const char* const name = own.first;
    const double speed = own.second;
    CAPTURE(name);
    Scenario alone = parse_scenario(make_rotor(kPitchJoint, air), "one.toml");
    alone.space->hub.drive = ConstantSpeed{speed};
    for (const bool is_rigid : {true, false}) {
      PerformanceOptions options{.wind = {6.0, 9.0}, .pitch = {0.03}, .is_rigid = is_rigid};
      const PerformanceResult known = solve_performance(alone, options);
      options.rotor = name;
      const PerformanceResult found = solve_performance(both, options);
      CHECK(found.rotor == name);
      same(found, known);
    }
    PerformanceOptions map{.tip_speed_ratio = {5.0, 8.0}, .is_rigid = true};
    const PerformanceResult known = solve_performance(alone, map);
    map.rotor = name;
    same(solve_performance(both, map), known);
  }
}

TEST_CASE("what performance cannot find is refused in one line") {
  const std::string air = "[air]\n[wind]\nvelocity = [0.0, 0.0, 8.0]\n";
  const auto refused = [](const std::string& text, const PerformanceOptions& options) {
    const Scenario scenario = parse_scenario(text, "rotor.toml");
    return test::message_of([&] { solve_performance(scenario, options); });
  };
  Scenario vacuum = parse_scenario(make_rotor("", air), "rotor.toml");
  vacuum.space->air.reset();
  CHECK(test::message_of([&] { solve_performance(vacuum, {.wind = {8.0}}); }) ==
        "air: is missing, expected [air] with the aerodynamics of blades");
  CHECK(refused(make_two_rotors(air), {.wind = {8.0}}) ==
        "there are several rotors, expected the name of one of them (--rotor): each has a "
        "performance of its own");
  CHECK(refused(make_two_rotors(air), {.wind = {8.0}, .rotor = "rea"}) ==
        "the rotor is \"rea\", did you mean \"rear\"?");
  CHECK(refused(make_rotor("", air), {.wind = {8.0}, .rotor = "rear"}) ==
        "the rotor is \"rear\", expected no name: there is no [[rotor]]");
  CHECK(refused(make_rotor("", air), {}) ==
        "no wind speeds and no tip-speed ratios are given, expected either");
  CHECK(refused(make_rotor("", air), {.wind = {8.0, 9.0}, .tip_speed_ratio = {7.0}}) ==
        "several wind speeds are given along with tip-speed ratios, expected one or none");
  CHECK(refused(make_rotor("", air), {.wind = {0.0}}) == "a wind speed is not above 0 (m/s)");
  CHECK(refused(make_rotor("", air), {.tip_speed_ratio = {-1.0}}) ==
        "a tip-speed ratio is not above 0");
  CHECK(refused(make_rotor("", air), {.wind = {8.0}, .pitch = {0.1}}) ==
        "no blade has a joint \"pitch\", expected the name of the joint that pitches a blade");
  CHECK(refused(make_rotor("", air), {.wind = {8.0}, .pitch = {0.1, 0.2}}) ==
        "several pitch angles are given without tip-speed ratios, expected one or none");
}

TEST_CASE("the NREL 5 MW rotor has its published power and thrust, rigid and elastic") {
  // Electrical power, which is 0.944 of the rotor's [kW], and thrust [kN].
  struct Published {
    double wind, power, thrust;
  };
  const Published published[] = {{5.0, 403.9, 174.9}, {8.0, 1771.0, 384.0}, {10.0, 3448.0, 597.5}};
  const Scenario scenario = test::read_shipped("nrel_5mw_in_wind");
  for (const bool is_rigid : {true, false}) {
    const PerformanceResult result =
        solve_performance(scenario, {.wind = {5.0, 8.0, 10.0, 15.0}, .is_rigid = is_rigid});
    REQUIRE(result.points.size() == 4);
    for (std::size_t k = 0; k < 3; ++k) {
      CAPTURE(published[k].wind);
      CHECK(0.944e-3 * result.points[k].power == approx(published[k].power).epsilon(0.03));
      CHECK(1e-3 * result.points[k].thrust == approx(published[k].thrust).epsilon(0.03));
      CHECK(result.points[k].pitch == 0.0);
    }
    CHECK(0.944e-3 * result.points[3].power == approx(5000.0).epsilon(0.03));
    CHECK(result.points[3].speed == approx(1.267109));
    // 10.45 degrees are published for rigid blades, or such that do not twist.
    CHECK(result.points[3].pitch < -0.16);
    CHECK(result.points[3].pitch > -0.19);
  }
}

TEST_CASE(
    "laws of a turbine: performance takes their torque, their set point and their least pitch") {
  const auto with = [](const std::string& laws) {
    return test::read_shipped(
        "nrel_5mw_in_wind",
        {"control={ turbine = { joint = \"pitch\", sign = -1, torque = { square = "
         "2.1286e6, speed = 1.2671, rated = 4.180074e6, " +
         laws + "pitch = { speed = 1.267109, integral = 0.1, maximum = 1.57 } } }"});
  };
  for (const std::string gains : {"", "proportional = 1e6, integral = 1e5, minimum = 0.7, "}) {
    CAPTURE(gains);
    const PerformanceResult result = solve_performance(
        with(gains + "above = \"power\" }, "), {.wind = {4.0, 8.0, 15.0}, .is_rigid = true});
    const PerformancePoint& slow = result.points.at(0);
    if (gains.empty())
      CHECK(slow.torque == approx(2.1286e6 * slow.speed * slow.speed).epsilon(1e-4));
    else
      CHECK(slow.speed == approx(0.7).epsilon(1e-5));
    const PerformancePoint& below = result.points.at(1);
    CHECK(below.torque == approx(2.1286e6 * below.speed * below.speed).epsilon(1e-4));
    CHECK(below.pitch == 0.0);
    CHECK(result.points.at(2).speed == approx(1.267109));
    CHECK(result.points.at(2).power == approx(4.180074e6 * 1.2671).epsilon(1e-4));
    CHECK(result.points.at(2).pitch < -0.16);
  }
  const PerformanceResult shaved = solve_performance(
      with("above = \"power\" }, schedule = { wind = [8.0, 10.0], angle = [0.0, 0.05] }, "),
      {.wind = {8.0, 9.0, 10.0}, .is_rigid = true});
  CHECK(shaved.points.at(1).pitch == approx(-0.025));
  CHECK(shaved.points.at(2).pitch == approx(-0.05));
}

TEST_CASE("a governed rotor is found by itself in any wind, beyond that of shutdown too") {
  constexpr double kDegree = std::numbers::pi / 180.0;
  const Scenario scenario = test::read_shipped("nrel_5mw_in_wind");
  // Pitch as published to 25 m/s (NREL/TP-500-38060, table 7-1), of blades that do not twist under
  // load; beyond, about where that leads. Each wind alone: no neighbour leads there.
  struct Published {
    double wind, pitch;
  };
  for (const Published& state : {Published{20.0, 17.47}, {25.0, 23.47}, {32.0, 30.0}})
    for (const bool is_rigid : {true, false}) {
      CAPTURE(state.wind);
      CAPTURE(is_rigid);
      const PerformanceResult result =
          solve_performance(scenario, {.wind = {state.wind}, .is_rigid = is_rigid});
      const PerformancePoint& point = result.points.at(0);
      CHECK(point.gap == "");
      CHECK(point.speed == approx(1.267109));
      CHECK(0.944e-3 * point.power == approx(5000.0).epsilon(0.001));
      const double tolerance = state.wind > 25.0 ? 0.1 : is_rigid ? 0.02 : 0.08;
      CHECK(-point.pitch / kDegree == approx(state.pitch).epsilon(tolerance));
    }
}

TEST_CASE("pitch is what the joints stand at") {
  const std::string air = "[air]\n[wind]\nvelocity = [0.0, 0.0, 8.0]\n";
  std::string joint = kPitchJoint;
  joint.replace(joint.find("constant = 0.0"), 14, "constant = -0.0838");
  const Scenario held = parse_scenario(make_rotor(joint, air), "rotor.toml");
  CHECK(solve_performance(held, {.wind = {8.0}}).points.at(0).pitch == -0.0838);
  CHECK(solve_performance(held, {.tip_speed_ratio = {6.0}}).points.at(0).pitch == -0.0838);
  CHECK(solve_performance(held, {.wind = {8.0}, .pitch = {0.1}}).points.at(0).pitch == 0.1);
  // A controller's angle is added to the joint's own.
  Scenario governed = test::read_shipped("nrel_5mw_in_wind");
  const PerformanceOptions options{.wind = {8.0, 15.0}, .is_rigid = true};
  const PerformanceResult plain = solve_performance(governed, options);
  for (spatial::Blade& blade : governed.space->blades)
    for (spatial::BladeJoint& own : blade.joints)
      own.joint.coordinates[0].motion = spatial::MotionTable{Curve(-0.05)};
  const PerformanceResult turned = solve_performance(governed, options);
  CHECK(plain.points.at(0).pitch == 0.0);
  CHECK(turned.points.at(0).pitch == -0.05);
  CHECK(turned.points.at(1).pitch == approx(plain.points.at(1).pitch).epsilon(1e-5));
}

namespace {

/// Returns C_T of an untwisted rotor in hover by blade-element momentum theory, by the speed of the
/// tip: its inflow in closed form (Leishman, Principles of Helicopter Aerodynamics, 2006, section
/// 3.3) with Prandtl's loss at the tip. From `cut` times the radius on.
double hover_thrust(double solidity, double slope, double pitch, int blades, double cut,
                    double factor) {
  constexpr int kParts = 2000;
  double sum = 0.0;
  for (int k = 0; k < kParts; ++k) {
    const double r = cut + (1.0 - cut) * (k + 0.5) / kParts, share = solidity * slope;
    double loss = 1.0, inflow = 0.0;
    for (int n = 0; n < 100; ++n) {
      const double flow = 16.0 * loss / (factor * factor * share);
      inflow = (std::sqrt(1.0 + 2.0 * flow * pitch * r) - 1.0) / flow;
      const double f = 0.5 * blades * (1.0 - r) / inflow;
      loss = 2.0 / std::numbers::pi * std::acos(std::exp(-f));
    }
    sum += 0.5 * share * (pitch * r * r - inflow * r) * (1.0 - cut) / kParts;
  }
  return sum;
}

}  // namespace

TEST_CASE("the rotor of Caradonna and Tung hovers as blade-element momentum theory has it") {
  // NASA TM-81232 (1981): two untwisted blades of NACA 0012 at 8 degrees, 1250 rpm. The measured
  // C_T is 0.0046: momentum theory by annuli does not know how the wake contracts below the tips.
  // An inflow factor that is usual for hover stands for it.
  constexpr double kTip = 1.143, kSize = 0.1905, kTurn = 130.9, kPitch = 0.1396263;
  std::ostringstream text;
  text << "world = \"space\"\n[hub]\nmass = 10.0\ninertia = 2.0\n[hub.drive]\nkind = \"constant\"\n"
          "speed = 130.9\n[blade]\ncount = 2\nlength = 1.143\nbodies = 1\nelements = 2\n"
          "[blade.sections]\nmass_per_length = 1.0\naxial_stiffness = 1e13\nflap_stiffness = 1e8\n"
          "lag_stiffness = 1e8\ntorsion_stiffness = 1e8\n[blade.aerodynamics]\nstation = ";
  for (int k = 0; k <= 60; ++k) text << (k ? ", " : "[") << kSize + (kTip - kSize) * k / 60;
  text << "]\nchord = 0.1905\ntwist = 0.1396263\nairfoil = \"naca0012\"\n[[airfoil]]\n"
          "name = \"naca0012\"\nangle = [-3.141592653589793, -0.22, 0.22, 3.141592653589793]\n"
          "lift = [0.0, -1.26, 1.26, 0.0]\ndrag = [0.02, 0.01, 0.01, 0.02]\n[air]\n[aerodynamics]\n"
          "stall = \"static\"\n[integration]\nduration = 1.0\n";
  Scenario scenario = parse_scenario(text.str(), "rotor.toml");
  const double area = std::numbers::pi * kTip * kTip, tip = kTurn * kTip;
  // 3 %: losses at the root and the turn of lift by induced flow are in the engine alone.
  for (const double factor : {1.0, 1.15}) {
    scenario.space->air->inflow_factor = factor;
    const double thrust = solve_equilibrium(scenario).air->thrust / (1.225 * area * tip * tip);
    const double theory = hover_thrust(2.0 * kSize / (std::numbers::pi * kTip), 1.26 / 0.22, kPitch,
                                       2, kSize / kTip, factor);
    CHECK(thrust == approx(theory).epsilon(0.03));
    if (factor > 1.0) CHECK(thrust == approx(0.0046).epsilon(0.05));
  }
}
