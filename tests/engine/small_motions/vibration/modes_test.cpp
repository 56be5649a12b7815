// Tests modes that are known: from closed forms, from an independent solution of the equations of
// the beam, and from other parts of the engine.

#include "engine/modes.h"

#include <doctest/doctest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "engine/simulation.h"
#include "models/error.h"
#include "tests/engine/small_motions/steady/blades.h"
#include "tests/message_of.h"
#include "tests/shipped.h"

namespace spoke {
namespace {

using test::make_planar;
using test::make_spatial;

/// Returns the frequencies of the modes of one kind, in their order [rad/s].
std::vector<double> frequencies_of(const ModesResult& result, const std::string& kind) {
  std::vector<double> list;
  for (const Mode& mode : result.modes)
    if (mode.name.find(kind) != std::string::npos) list.push_back(mode.frequency);
  return list;
}

/// Checks that the first frequencies are the known ones, to a relative error.
void check_frequencies(const ModesResult& result, const std::string& kind,
                       const std::vector<double>& known, double error) {
  const std::vector<double> found = frequencies_of(result, kind);
  REQUIRE(found.size() >= known.size());
  for (std::size_t k = 0; k < known.size(); ++k) {
    CAPTURE(kind);
    CAPTURE(k);
    CHECK(found[k] == doctest::Approx(known[k]).epsilon(error));
  }
}

struct RotatingBlade {
  double radius, speed;
  std::vector<double> flap, lag;
};

// L = m = EI = 1, and the hub's radius. A Legendre-Galerkin solution of the beam's equation (x^2
// times Legendre polynomials, of which 14 and 18 agree to 1e-8), which at a radius of 0 agrees with
// Wright, Smith, Thresher and Wang 1982, J. Appl. Mech. 49, 197-202.
const std::vector<RotatingBlade> kRotating{
    {0, 0, {3.516015, 22.034492, 61.697214}, {3.516015, 22.034492, 61.697214}},
    {0, 2, {4.13732, 22.614922, 62.273184}, {3.621797, 22.526311, 62.241059}},
    {0, 4, {5.585001, 24.273349, 63.96676}, {3.897723, 23.941501, 63.841573}},
    {0, 6, {7.360373, 26.809082, 66.683914}, {4.263225, 26.129042, 66.413436}},
    {0, 8, {9.256838, 29.995382, 70.292962}, {4.65715, 28.908873, 69.836241}},
    {0, 12, {13.17015, 37.603112, 79.614478}, {5.427049, 35.636976, 78.704925}},
    {1, 2, {4.833689, 23.366042, 63.067548}, {4.400517, 23.280290, 63.035828}},
    {1, 4, {7.475048, 26.957262, 66.986772}, {6.314772, 26.658844, 66.867239}},
    {1, 6, {10.443866, 32.027244, 72.986335}, {8.548353, 31.460203, 72.739296}},
    {1, 8, {13.507389, 37.953793, 80.529532}, {10.883454, 37.101084, 80.131177}},
    {1, 12, {19.721542, 51.070134, 98.526797}, {15.650534, 49.640292, 97.793301}}};

TEST_CASE("modes: a rotating cantilever has its known frequencies") {
  for (const RotatingBlade& known : kRotating) {
    CAPTURE(known.speed);
    CAPTURE(known.radius);
    const ModeOptions options{.state = {.speed = known.speed}, .count = 8};
    const double radius = known.radius;
    check_frequencies(solve_modes(make_planar({.radius = radius}), options), "lag", known.lag,
                      1e-4);
    const ModesResult space = solve_modes(make_spatial({.radius = radius}), options);
    check_frequencies(space, "lag", known.lag, 1e-4);
    check_frequencies(space, "flap", known.flap, 1e-4);
    const ModesResult coarse = solve_modes(make_spatial({.bodies = 1, .radius = radius}), options);
    check_frequencies(coarse, "lag", known.lag, 1e-2);
    check_frequencies(coarse, "flap", known.flap, 1e-2);
  }
}

TEST_CASE("modes: a hinged flexible blade has its known frequencies") {
  // A blade from the offset e to 1, m = EI = 1, 10 rad/s: frequencies by the speed, also from a
  // Legendre-Galerkin solution. Scaled to a blade of unit length: l = 1 - e, speed and frequencies
  // times l^2, the radius of the hub e/l.
  struct Hinged {
    double offset;
    std::vector<double> flap, lag;
  };
  for (const Hinged& known :
       {Hinged{0.0, {1.0, 2.94439267, 6.52554423}, {0.0, 2.76937686, 6.44846707}},
        Hinged{0.05, {1.03865946, 3.11236689, 7.04699278}, {0.28073736, 2.94734247, 6.9756797}},
        Hinged{0.3, {1.2801219, 4.48498792, 11.53176514}, {0.79919464, 4.37208378, 11.48832482}}}) {
    const double length = 1.0 - known.offset, speed = 10.0 * length * length;
    const std::string hinge =
        "[[blades.joint]]\nname = \"hinge\"\nstation = 0.0\nkind = \"universal\"\n"
        "axes = [[0.0, -1.0, 0.0], [0.0, 0.0, 1.0]]\n";
    const ModesResult result =
        solve_modes(make_spatial({.radius = known.offset / length, .joint = hinge}),
                    {.state = {.speed = speed}, .count = 8});
    std::vector<double> flap = known.flap, lag = known.lag;
    for (double& value : flap) value *= speed;
    for (double& value : lag) value *= speed;
    check_frequencies(result, "flap", flap, 1e-4);
    check_frequencies(result, "lag", lag, 1e-4);
  }
}

TEST_CASE("modes: a stiff articulated blade flaps and lags as its hinge offset says") {
  // sqrt(1 + 3 e/(2 (L - e))) and sqrt(3 e/(2 (L - e))) per revolution, with the hinge at e. With a
  // spring s and a damper d the square of the frequency gets s/I, and 2 d/(2 I) is its damping,
  // I = m l^3/3.
  const double radius = 0.1, speed = 1.0, length = 1.0, inertia = 1.0 / 3.0;
  const double ratio = 1.5 * radius / length, spring = 0.2, damper = 0.05;
  const auto hinge = [&](const char* axis, const std::string& more) {
    return "[[blades.joint]]\nname = \"hinge\"\nstation = 0.0\nkind = \"revolute\"\naxis = " +
           std::string(axis) + '\n' + more;
  };
  const auto solve = [&](const std::string& joint) {
    return solve_modes(make_spatial({.radius = radius, .bending_stiffness = 1e4, .joint = joint}),
                       {.state = {.speed = speed}, .count = 1})
        .modes.at(0);
  };
  CHECK(solve(hinge("[0.0, -1.0, 0.0]", "")).frequency ==
        doctest::Approx(std::sqrt(1.0 + ratio)).epsilon(1e-3));
  CHECK(solve(hinge("[0.0, 0.0, 1.0]", "")).frequency ==
        doctest::Approx(std::sqrt(ratio)).epsilon(1e-3));
  const Mode damped = solve(hinge("[0.0, 0.0, 1.0]", "stiffness = 0.2\ndamping = 0.05\n"));
  const double square = ratio + spring / inertia, decay = damper / (2.0 * inertia);
  CHECK(damped.name == "hinge lag 1");
  CHECK(damped.eigenvalue.real() == doctest::Approx(-decay).epsilon(2e-3));
  CHECK(damped.frequency == doctest::Approx(std::sqrt(square - decay * decay)).epsilon(1e-3));
  CHECK(damped.damping_ratio == doctest::Approx(decay / std::sqrt(square)).epsilon(2e-3));
}

TEST_CASE("modes: the shipped articulated rotor flaps and lags nearly as a stiff one") {
  const ModesResult result =
      solve_modes(test::read_shipped("articulated_rotor"), {.state = {.speed = 36.0}, .count = 2});
  const double offset = 0.3 / (7.3 - 0.3);
  const Mode& lag = result.modes.at(0);
  CHECK(lag.name == "hinges lag 1");
  const double undamped = lag.frequency / std::sqrt(1.0 - lag.damping_ratio * lag.damping_ratio);
  CHECK(undamped / 36.0 == doctest::Approx(std::sqrt(1.5 * offset)).epsilon(3e-3));
  const Mode& flap = result.modes.at(1);
  CHECK(flap.name == "hinges flap 1");
  CHECK(flap.frequency / 36.0 == doctest::Approx(std::sqrt(1.0 + 1.5 * offset)).epsilon(2e-3));
}

TEST_CASE("modes: a clamped beam at rest has ten known frequencies") {
  // Roots of cos x cosh x = -1.
  std::vector<double> known{3.51601527, 22.0344916, 61.6972144};
  for (int n = 4; n <= 10; ++n) {
    const double root = (n - 0.5) * std::acos(-1.0);
    known.push_back(root * root);
  }
  const ModesResult result = solve_modes(make_planar({.bodies = 10, .elements = 6}), {.count = 10});
  check_frequencies(result, "lag", known, 1e-4);
  for (const Mode& mode : result.modes) CHECK(mode.damping_ratio == 0.0);
}

TEST_CASE("modes: a free satellite at rest has rigid motions, and the frequencies of spoke check") {
  const Scenario scenario = test::read_shipped("free_hub_satellite");
  const ModesResult result = solve_modes(scenario, {.state = {.speed = 0.0}, .count = 8});
  CHECK(result.are_blades_coupled);
  for (int k = 0; k < 3; ++k) CHECK(result.modes[static_cast<std::size_t>(k)].eigenvalue == 0.0);
  const Simulation simulation(scenario);
  CHECK(result.modes.at(3).frequency ==
        doctest::Approx(simulation.linear_properties().lowest_frequency).epsilon(1e-6));
  CHECK(result.modes.at(3).name.starts_with("differential"));
  CHECK(result.modes.at(4).name.starts_with("collective"));
}

TEST_CASE("modes: two booms on a hub without mass are a free beam") {
  // A beam of length 2: roots of cos x cosh x = 1, (x/2)^2.
  const double known[] = {22.3732854 / 4.0, 61.6728229 / 4.0, 120.903392 / 4.0};
  Scenario plane = make_planar({});
  plane.rotor.blades.push_back(plane.rotor.blades[0]);
  plane.rotor.blades[1].azimuth = std::acos(-1.0);
  plane.rotor.hub = {
      .support = HubSupport::free, .mass = 1e-7, .inertia = 1e-9, .drive = FreeDrive{}};
  Scenario space = make_spatial({});
  space.space->blades.push_back(space.space->blades[0]);
  space.space->blades[1].azimuth += std::acos(-1.0);
  space.space->hub = {.support = HubSupport::free, .mass = 1e-7};
  space.space->hub.inertia = 1e-9 * spatial::Tensor::Identity();
  // Each frequency comes twice, in flap and lag; torsion is faster.
  for (const int times : {1, 2}) {
    const ModesResult result = solve_modes(times == 1 ? plane : space,
                                           {.state = {.speed = 0.0}, .count = 9 * times / 2 + 5});
    std::vector<double> found;
    for (const Mode& mode : result.modes)
      if (mode.eigenvalue != 0.0) found.push_back(mode.frequency);
    REQUIRE(std::ssize(found) >= 3 * times);
    for (int k = 0; k < 3 * times; ++k)
      CHECK(found[static_cast<std::size_t>(k)] == doctest::Approx(known[k / times]).epsilon(1e-4));
  }
}

TEST_CASE("modes: of clamped blades the lowest frequency is that of spoke check") {
  Scenario scenario = test::read_shipped("wu_haug_rotor");
  scenario.rotor.hub.drive = FixedDrive{};
  const ModesResult result = solve_modes(scenario, {.count = 3});
  CHECK(result.modes.at(0).of == "blades 1 to 3");
  CHECK(result.modes.at(0).frequency ==
        doctest::Approx(Simulation(scenario).linear_properties().lowest_frequency).epsilon(1e-7));
}

TEST_CASE("modes: a free body in space at rest has six rigid motions") {
  const ModesResult result =
      solve_modes(test::read_shipped("satellite_booms"), {.state = {.speed = 0.0}, .count = 8});
  for (std::size_t k = 0; k < 6; ++k) {
    const Mode& mode = result.modes[k];
    CHECK(mode.eigenvalue == 0.0);
    for (std::size_t i = 0; i < mode.shape.size(); ++i) {
      const Eigen::Vector3d tip = result.equilibrium.blades[i].nodes.back();
      const Eigen::Vector3cd carried =
          mode.hub_displacement + mode.hub_rotation.cross(tip.cast<std::complex<double>>());
      CHECK((mode.shape[i].back() - carried).norm() < 1e-6);
      CHECK((mode.rotations[i].back() - mode.hub_rotation).norm() < 1e-6);
    }
  }
  CHECK(result.modes.at(6).frequency > 0.1);
}

TEST_CASE("modes: the tip of a cantilever turns by 1.3765 u/L in its first mode") {
  // The slope of cosh - cos - 0.734096 (sinh - sin) at 1.875104, by its value there.
  for (const Scenario& scenario : {make_planar({}), make_spatial({})})
    for (const Mode& mode : solve_modes(scenario, {.count = 2}).modes) {
      const double turned = mode.rotations.at(0).back().norm();
      CHECK(turned == doctest::Approx(1.376506 * mode.shape[0].back().norm()).epsilon(1e-3));
      if (!scenario.space) break;  // the next one is the second of lag
    }
}

TEST_CASE(
    "modes: seen from the turning frame, a free rotor's rigid translation whirls at its speed") {
  Scenario scenario = make_planar({});
  for (int b = 1; b < 3; ++b) {
    scenario.rotor.blades.push_back(scenario.rotor.blades[0]);
    scenario.rotor.blades.back().azimuth = b * 2.0 * std::acos(-1.0) / 3.0;
  }
  scenario.rotor.hub.support = HubSupport::free;
  scenario.rotor.hub.mass = 2.0;
  scenario.rotor.hub.drive = FreeDrive{1.5};
  const ModesResult result = solve_modes(scenario, {.count = 6});
  int whirls = 0, rigid = 0, regressive = 0, progressive = 0;
  for (const Mode& mode : result.modes) {
    whirls += std::abs(mode.frequency - 1.5) < 1e-6;
    rigid += mode.eigenvalue == 0.0;
    regressive += mode.name.starts_with("regressive");
    progressive += mode.name.starts_with("progressive");
    CHECK_FALSE(mode.grows());
  }
  CHECK(whirls >= 1);
  CHECK(rigid == 1);
  CHECK(regressive >= 1);
  CHECK(progressive >= 1);
}

TEST_CASE("modes: a blade that is let go swings with the frequency of its mode") {
  // Damping leaves the first mode alone after some seconds.
  Scenario scenario = make_planar({.bodies = 1,
                                   .elements = 2,
                                   .axial_stiffness = 1e4,
                                   .more = "[[load]]\nforce = [0.0, 1e-4]\n[damping]\n"
                                           "stiffness_factor = 1e-2\n[initial]\n"
                                           "state = \"equilibrium\"\n"});
  scenario.rotor.hub.drive = ConstantSpeed{3.0};
  const Mode mode = solve_modes(scenario, {.count = 1}).modes.at(0);
  scenario.rotor.loads[0].factor = Curve({0.0, 1e-2}, {1.0, 0.0});
  scenario.integration = {.step = 2e-3, .duration = 20.0, .spectral_radius = 1.0};
  Simulation simulation(scenario);
  const std::size_t tip = simulation.sensor_index("blade1.tip.across");
  std::vector<double> crossings;
  double before = 0.0, last = 0.0;
  simulation.run_until(20.0, [&](double t, std::span<const double> values) {
    const double now = values[tip];
    if (t > 4.0 && before < 0.0 && now >= 0.0)
      crossings.push_back(last + (t - last) * before / (before - now));
    before = now;
    last = t;
  });
  REQUIRE(crossings.size() > 8);
  const double period =
      (crossings.back() - crossings.front()) / static_cast<double>(crossings.size() - 1);
  CHECK(2.0 * std::acos(-1.0) / period == doctest::Approx(mode.frequency).epsilon(1e-4));
}

TEST_CASE("modes: more than there are is said, and bad input gets a line") {
  const ModesResult capped = solve_modes(make_planar({.bodies = 1}), {.count = 13});
  CHECK(capped.modes.size() == 12);
  CHECK(capped.notes == std::vector<std::string>{"13 modes are asked for, blade 1 has 12"});
  CHECK(test::message_of([] { solve_modes(make_planar({}), {.count = 0}); }) ==
        "0 modes, expected 1 or more");
}

}  // namespace
}  // namespace spoke
