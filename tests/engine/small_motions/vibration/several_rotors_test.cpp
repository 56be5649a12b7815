// Several rotors on one support: what their equilibria and modes must equal.

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "engine/campbell.h"
#include "engine/critical.h"
#include "engine/equilibrium.h"
#include "engine/modes.h"
#include "engine/simulation.h"
#include "engine/small_motions/vibration/frequency_limits.h"
#include "models/scenario.h"
#include "tests/engine/small_motions/vibration/rotors_on_carrier.h"
#include "tests/message_of.h"

namespace spoke {
namespace {

using doctest::Approx;
using test::kSprings;
using test::message_of;
using test::RotorText;

Scenario make(const std::string& joint, const std::vector<RotorText>& rotors,
              const std::string& more = "") {
  return test::make_on_carrier(joint, rotors, more);
}

std::vector<double> frequencies_of(const std::vector<Mode>& modes) {
  std::vector<double> list;
  for (const Mode& mode : modes) list.push_back(mode.frequency);
  return list;
}

const Mode& find_mode(const ModesResult& found, const std::string& name) {
  const auto mode = std::find_if(found.modes.begin(), found.modes.end(),
                                 [&name](const Mode& one) { return one.name == name; });
  CAPTURE(name);
  REQUIRE(mode != found.modes.end());
  return *mode;
}

/// Two discs on one axis at heights of 0.5 and 1 on a carrier that tips on a universal joint.
Scenario make_coaxial(double first, double second) {
  const std::string disc = "mass = 2.0, inertia = [0.2, 0.2, 0.4]";
  return make("kind = \"universal\"\naxes = [[1, 0, 0], [0, 1, 0]]\nstiffness = [900.0, 900.0]",
              {{.name = "lower", .speed = first, .place = "[0, 0, 0.5]", .hub = disc},
               {.name = "upper", .speed = second, .place = "[0, 0, 1.0]", .hub = disc}});
}

}  // namespace

TEST_CASE("several rotors: discs on one axis split a tipping mode by the sum of their spins") {
  // The carrier's 5, and of each disc 0.2 and its mass by the square of its height.
  constexpr double kInertia = 5.0 + 2.0 * 0.2 + 2.0 * (0.25 + 1.0), kSpring = 900.0, kSpin = 0.4;
  for (const auto& speeds : {std::pair(60.0, 60.0), std::pair(60.0, -60.0), std::pair(80.0, -30.0),
                             std::pair(0.0, 50.0)}) {
    const double first = speeds.first, second = speeds.second;
    CAPTURE(first);
    CAPTURE(second);
    const ModesResult found = solve_modes(make_coaxial(first, second));
    CHECK(found.frame == ModeFrame::fixed);
    REQUIRE(found.modes.size() == 2);
    // A w^2 -+ H w - k = 0.
    const double spin = std::abs(kSpin * (first + second));
    const double root = std::sqrt(spin * spin + 4.0 * kInertia * kSpring);
    CHECK(found.modes[0].frequency == Approx((root - spin) / (2.0 * kInertia)).epsilon(1e-9));
    CHECK(found.modes[1].frequency == Approx((root + spin) / (2.0 * kInertia)).epsilon(1e-9));
    REQUIRE(found.modes[0].hubs.size() == 2);
    // Both discs tip as one.
    CHECK((found.modes[0].hubs[0].rotation - found.modes[0].hubs[1].rotation).norm() <
          1e-9 * found.modes[0].hubs[0].rotation.norm());
  }
}

TEST_CASE("several rotors: modes that leave the hub at rest are those of the rotor alone") {
  const ModesResult alone =
      solve_modes(make("kind = \"fixed\"", {{.speed = 20.0, .blades = 4}}), {.count = 30});
  const ModesResult both = solve_modes(
      make(kSprings, {{.name = "left", .speed = 20.0, .place = "[0, 2.5, 1]", .blades = 4},
                      {.name = "right", .speed = -20.0, .place = "[0, -2.5, 1]", .blades = 4}}),
      {.count = 60});
  for (const std::string kind : {"flap 1", "lag 1", "flap 2"}) {
    const double expected = find_mode(alone, kind + " differential").frequency;
    for (const std::string rotor : {"left: ", "right: "})
      CHECK(find_mode(both, rotor + kind + " differential").frequency ==
            Approx(expected).epsilon(1e-9));
  }
}

TEST_CASE("several rotors: one without mass leaves the modes of the other as they are") {
  const std::string place = "[0.3, 0.2, 1]";
  const auto main = [&](const std::string& name) {
    return RotorText{.name = name, .speed = 20.0, .place = place, .blades = 3};
  };
  const auto one = frequencies_of(solve_modes(make(kSprings, {main("")}), {.count = 12}).modes);
  const RotorText tail{.name = "tail",
                       .speed = 90.0,
                       .place = "[-3, 0, 0.5]",
                       .hub = "axis = [0, 1, 0], mass = 1e-7, inertia = 1e-8"};
  const auto two =
      frequencies_of(solve_modes(make(kSprings, {main("main"), tail}), {.count = 12}).modes);
  REQUIRE(one.size() == two.size());
  for (std::size_t k = 0; k < one.size(); ++k) CHECK(two[k] == Approx(one[k]).epsilon(1e-6));
}

TEST_CASE("several rotors: the order in which they are given does not change modes") {
  const RotorText main{.name = "main", .speed = 20.0, .place = "[0.3, 0.2, 1]", .blades = 3};
  const RotorText tail{.name = "tail",
                       .speed = 90.0,
                       .place = "[-3, 0, 0.5]",
                       .hub = "axis = [0, 1, 0], mass = 0.5, inertia = 0.02",
                       .blades = 4,
                       .mass_factor = 0.1};
  const ModesResult one = solve_modes(make(kSprings, {main, tail}), {.count = 24});
  const ModesResult other = solve_modes(make(kSprings, {tail, main}), {.count = 24});
  for (std::size_t k = 0; k < one.modes.size(); ++k) {
    CHECK(one.modes[k].frequency == Approx(other.modes[k].frequency).epsilon(1e-7));
    const bool is_of_one = one.modes[k].name.find(" + ") == std::string::npos;
    if (is_of_one && (one.modes[k].kind == "flap" || one.modes[k].kind == "lag"))
      CHECK(one.modes[k].name == other.modes[k].name);
  }
  CHECK(find_mode(one, "tail: flap 1 differential").frequency > 0.0);
}

TEST_CASE("several rotors: two thrusts tip their carrier until a spring bears their moment") {
  constexpr double kFront = 300.0, kRear = 180.0, kSpring = 4000.0;
  const auto load = [](const std::string& rotor, double force) {
    return "[[hub_load]]\nrotor = \"" + rotor + "\"\nforce = [0, 0, " + std::to_string(force) +
           "]\n";
  };
  for (const bool turns : {false, true}) {
    const std::vector<RotorText> rotors = {
        {.name = "front", .speed = turns ? 20.0 : 0.0, .place = "[2, 0, 1]", .blades = 3},
        {.name = "rear", .speed = turns ? -30.0 : 0.0, .place = "[-2.5, 0, 1]", .blades = 3}};
    const EquilibriumResult found =
        solve_equilibrium(make("kind = \"revolute\"\naxis = [0, 1, 0]\nstiffness = 4000.0", rotors,
                               load("front", kFront) + load("rear", kRear)));
    REQUIRE(found.blades.size() == 7);
    REQUIRE(found.rotors.size() == 2);
    const double angle = (2.5 * kRear - 2.0 * kFront) / kSpring;
    CHECK(found.blades.back().joints[0].value == Approx(angle).epsilon(1e-9));
    const RotorEquilibrium& rear = found.rotors[1];
    CHECK(rear.name == "rear");
    CHECK(rear.speed == (turns ? -30.0 : 0.0));
    CHECK(rear.force.z() == Approx(-kRear).epsilon(1e-9));
    CHECK(rear.hub.position.x() == Approx(-2.5 * std::cos(angle) + std::sin(angle)).epsilon(1e-9));
    CHECK(found.hub_force.z() == Approx(-kFront).epsilon(1e-9));
    CHECK(found.blades[2].rotor == 0);
    CHECK(found.blades[3].rotor == 1);
    REQUIRE(found.stability);
    CHECK(found.stability->motions == SmallMotions::persist);
  }
}

TEST_CASE("several rotors: weights tip a soft carrier as one body of all masses") {
  // Undeformed blades would weigh the same: the sum of moments about the axis is m g x of all.
  const std::string gravity = "[gravity]\nacceleration = [0, 0, -9.81]\n";
  const RotorText front{.name = "front", .speed = 25.0, .place = "[1.0, 0, 0]", .blades = 3};
  const RotorText rear{.name = "rear", .speed = -10.0, .place = "[-0.4, 0, 0]"};
  const EquilibriumResult found = solve_equilibrium(
      make("kind = \"revolute\"\naxis = [0, 1, 0]\nstiffness = 3000.0", {front, rear}, gravity));
  const double angle = found.blades.back().joints[0].value;
  // m g x cos(angle): blades weigh 3 x 4, hubs 2 each, in the plane of the axis.
  const double moment = 9.81 * ((2.0 + 12.0) * 1.0 - 2.0 * 0.4) * std::cos(angle);
  const double lift = found.rotors[0].moment.y();  // blades bend along the axle: their own moment
  CHECK(3000.0 * angle == Approx(moment).epsilon(1e-3));
  CHECK(std::abs(lift) < 1e-3 * moment);
}

TEST_CASE("several rotors: a run that starts at the equilibrium stays there") {
  const std::string more =
      "[gravity]\nacceleration = [0, 0, -9.81]\n[initial]\nstate = \"equilibrium\"\n[[hub_load]]\n"
      "rotor = \"rear\"\nforce = [0, 0, 250]\n";
  Scenario scenario = make(kSprings,
                           {{.name = "front", .speed = 25.0, .place = "[1.0, 0, 0.5]", .blades = 3},
                            {.name = "rear",
                             .place = "[-2, 0, 0.5]",
                             .blades = 3,
                             .drive = "{ kind = \"free\", initial_speed = -20.0 }"}},
                           more);
  const EquilibriumResult found = solve_equilibrium(scenario);
  scenario.integration.step = 1e-3;
  scenario.integration.duration = 0.05;
  Simulation simulation(scenario);
  const auto columns = simulation.sensor_names();
  const std::vector<double> start(simulation.sensor_values().begin(),
                                  simulation.sensor_values().end());
  for (int k = 0; k < 50; ++k) simulation.step();
  for (std::size_t k = 0; k < columns.size(); ++k)
    if (columns[k].starts_with("blade") && columns[k].find("tip.z") != std::string::npos) {
      CAPTURE(columns[k]);
      // Weight across axles that tip by a milliradian turns against the blades.
      CHECK(std::abs(simulation.sensor_values()[k] - start[k]) < 1e-5);
    }
  CHECK(found.rotors[1].speed == -20.0);
}

TEST_CASE("several rotors: a shaft behind the second is twisted at the start by its torque") {
  Scenario scenario = make(
      kSprings,
      {{.name = "front",
        .place = "[1.0, 0, 0.5]",
        .blades = 3,
        .drive = "{ kind = \"free\", initial_speed = 25.0 }"},
       {.name = "rear", .speed = -20.0, .place = "[-2, 0, 0.5]", .blades = 3}},
      "[initial]\nstate = \"equilibrium\"\n[[hub_load]]\nrotor = \"rear\"\ntorque = [0, 0, 60]\n");
  scenario.space->rotors[0].axle.train = spatial::DriveTrain{2000.0, 5.0, 10.0, 0.02};
  scenario.integration = {.step = 1e-3, .duration = 0.1};
  Simulation simulation(scenario);
  for (int k = 0; k < 100; ++k) simulation.step();
  CHECK(simulation.sensor("rear.hub.speed") == Approx(-20.0).epsilon(1e-6));
  CHECK(simulation.sensor("rear.hub.angle") == Approx(60.0 / 2000.0 - 2.0).epsilon(1e-6));
  CHECK(simulation.sensor("hub.speed") == Approx(25.0).epsilon(1e-6));
  CHECK(simulation.sensor("hub.angle") == Approx(2.5).epsilon(1e-6));
}

TEST_CASE("several rotors: speeds are asked for by name, and sweep by their ratios") {
  const Scenario scenario = make_coaxial(60.0, -30.0);
  const auto speeds = [&](const SteadyState& state) {
    const EquilibriumResult found = solve_equilibrium(scenario, state);
    return std::pair(found.rotors[0].speed, found.rotors[1].speed);
  };
  CHECK(speeds({}) == std::pair(60.0, -30.0));
  CHECK(speeds({.speed = 10.0}) == std::pair(10.0, -30.0));
  CHECK(speeds({.speeds = {{"upper", 7.0}}}) == std::pair(60.0, 7.0));
  CHECK(speeds({.speed = 5.0, .speeds = {{"upper", 7.0}}}) == std::pair(5.0, 7.0));
  CHECK(speeds({.speeds = {{"lower", 1.0}, {"upper", 7.0}}}) == std::pair(1.0, 7.0));
  const auto refused = [&](const SteadyState& state) {
    return message_of([&] { solve_equilibrium(scenario, state); });
  };
  CHECK(refused({.speeds = {{"tail", 1.0}}}) ==
        "a speed is for the rotor \"tail\", expected one of \"lower\", \"upper\"");
  CHECK(refused({.speed = 1.0, .speeds = {{"lower", 1.0}}}) ==
        "a speed without a name and one for \"lower\" are given, expected only one of them: both "
        "are of the first rotor");
  const CampbellResult diagram = solve_campbell(scenario, {.speeds = {0.0, 30.0, 60.0}});
  CHECK(diagram.states[1].equilibrium.rotors[1].speed == -15.0);
  CHECK(diagram.states[2].modes[0].frequency ==
        Approx(solve_modes(scenario).modes[0].frequency).epsilon(1e-12));
}

TEST_CASE("several rotors: ground resonance sets on where it does without a small one") {
  const auto find = [](const std::string& name, const std::vector<RotorText>& more) {
    std::vector<RotorText> rotors{{.name = name, .speed = 3.0, .place = "[0, 0, 1]", .blades = 3}};
    rotors.insert(rotors.end(), more.begin(), more.end());
    const CriticalResult found =
        solve_critical(make(kSprings, rotors),
                       {.of = "speed", .from = 60.0, .to = 180.0, .points = 4, .count = 8});
    REQUIRE(found.critical);
    CHECK(found.critical->kind == CriticalKind::flutter);
    return found.critical->value;
  };
  const RotorText tail{.name = "tail",
                       .speed = 9.0,
                       .place = "[-3, 0, 0.5]",
                       .hub = "axis = [0, 1, 0], mass = 1e-7, inertia = 1e-8"};
  CHECK(find("main", {tail}) == Approx(find("", {})).epsilon(1e-5));
}

TEST_CASE("several rotors: Floquet's exponents are those of constant matrices, and of one alone") {
  constexpr double kSpeed = 20.0;
  const auto of = [](const std::string& name, double speed, int blades, const std::string& place) {
    return RotorText{.name = name,
                     .speed = speed,
                     .place = place,
                     .blades = blades,
                     .size = "bodies = 1\nelements = 1\n"};
  };
  // The frequencies of both frames differ by multiples of the speed.
  const auto distance = [](double w, const std::vector<Mode>& modes) {
    double least = 1e300;
    for (const Mode& mode : modes)
      for (const double sign : {-1.0, 1.0})
        least = std::min(least, std::abs(std::remainder(w + sign * mode.frequency, kSpeed)));
    return least;
  };
  const Scenario even = make(kSprings, {of("left", kSpeed, 3, "[0, 2.5, 1]"),
                                        of("right", -kSpeed, 3, "[0.2, -2.5, 1]"),
                                        {.name = "still", .hub = "mass = 3.0, inertia = 0.4"}});
  const ModesResult periodic = solve_modes(even, {.count = 16, .frame = ModeFrame::floquet});
  for (const Mode& mode : solve_modes(even, {.count = 10}).modes)
    CHECK(distance(mode.frequency, periodic.modes) < 1e-6 * kSpeed);
  const Scenario alone = make(kSprings, {of("", kSpeed, 2, "[0.3, 0.2, 1]")});
  const RotorText small{.name = "tail",
                        .speed = -kSpeed,
                        .place = "[-3, 0, 0.5]",
                        .hub = "axis = [0, 1, 0], mass = 1e-7, inertia = 1e-8"};
  const ModesResult one = solve_modes(alone, {.count = 8});
  const ModesResult two =
      solve_modes(make(kSprings, {of("main", kSpeed, 2, "[0.3, 0.2, 1]"), small}), {.count = 8});
  CHECK(two.frame == ModeFrame::floquet);
  REQUIRE(two.modes.size() == one.modes.size());
  for (std::size_t k = 0; k < one.modes.size(); ++k)
    CHECK(two.modes[k].frequency == Approx(one.modes[k].frequency).epsilon(1e-6));
}

TEST_CASE("several rotors: an uneven one has its modes among others at any speeds") {
  const RotorText main{.name = "main",
                       .speed = 20.0,
                       .place = "[0.3, 0.2, 1]",
                       .blades = 2,
                       .size = "bodies = 1\nelements = 1\n"};
  RotorText tail{.name = "tail",
                 .place = "[-3, 0, 0.5]",
                 .hub = "axis = [0, 1, 0], mass = 0.5, inertia = 0.02",
                 .blades = 3,
                 .mass_factor = 0.2,
                 .size = "bodies = 1\nelements = 1\n"};
  const auto solve = [](const std::vector<RotorText>& rotors, int count) {
    return solve_modes(make(kSprings, rotors), {.count = count});
  };
  const auto is_among = [&](const Mode& mode, const std::vector<Mode>& modes, double error) {
    double least = 1e300;
    for (const Mode& other : modes)
      for (const double sign : {-1.0, 1.0})
        least = std::min(
            least, std::abs(std::remainder(mode.frequency + sign * other.frequency, main.speed)));
    CAPTURE(mode.name);
    CHECK(least < error * main.speed);
  };
  SUBCASE("at nearly its speed the other has the modes that it has at the same") {
    // There blades are coordinates, here patterns of blades.
    tail.speed = -main.speed;
    const ModesResult same = solve({main, tail}, 14);
    tail.speed *= 1.0 + 1e-7;
    for (const bool is_first : {true, false}) {
      const ModesResult near = is_first ? solve({main, tail}, 14) : solve({tail, main}, 14);
      CHECK(near.frame == ModeFrame::floquet);
      for (std::size_t k = 0; k < 10; ++k) is_among(near.modes[k], same.modes, 1e-6);
    }
  }
  SUBCASE("nearly round the uneven one leaves those of constant matrices") {
    RotorText disc{.name = "disc", .speed = 20.0, .place = "[0.3, 0.2, 1]"};
    tail.speed = 53.0;
    const auto with_hub = [&](const std::string& inertia) {
      disc.hub = "mass = 2.0, inertia = " + inertia;
      return solve({disc, tail}, 14);
    };
    const ModesResult round = with_hub("[0.3, 0.3, 0.5]"), uneven = with_hub("[0.3, 0.30001, 0.5]");
    CHECK(round.frame == ModeFrame::fixed);
    CHECK(uneven.frame == ModeFrame::floquet);
    for (std::size_t k = 0; k < 10; ++k) {
      is_among(round.modes[k], uneven.modes, 1e-6);
      CHECK(uneven.modes[k].name == round.modes[k].name);
      CHECK(uneven.modes[k].frequency == Approx(round.modes[k].frequency).epsilon(1e-5));
    }
  }
  SUBCASE("one of next to no mass leaves its modes as they are") {
    tail.speed = 53.0;
    tail.hub = "axis = [0, 1, 0], mass = 1e-7, inertia = 1e-8";
    tail.mass_factor = 1e-6;
    const RotorText alone{
        .speed = main.speed, .place = main.place, .blades = main.blades, .size = main.size};
    const ModesResult one = solve({alone}, 8), two = solve({main, tail}, 30);
    for (const Mode& mode : one.modes) is_among(mode, two.modes, 1e-4);
  }
}

TEST_CASE("several rotors: what has no constant matrices is refused with its reason") {
  const auto refused = [](double first, double second, int first_blades, int second_blades,
                          std::optional<ModeFrame> frame) {
    return message_of([&] {
      solve_modes(make(kSprings, {{.name = "one", .speed = first, .blades = first_blades},
                                  {.name = "two", .speed = second, .blades = second_blades}}),
                  {.frame = frame});
    });
  };
  const std::string equally = "the frame \"floquet\" expects rotors that are equally fast";
  CHECK(refused(20.0, 31.0, 2, 2, {}) ==
        "the frame \"fixed\" expects three or more equal blades, got 2 of the kind of blade 1, "
        "blade 2; " +
            equally +
            ", of which \"one\" (20 rad/s), \"two\" (31 rad/s) are not alike in all directions: "
            "speeds that differ have no common period, so that there are no modes; runs have them");
  CHECK(refused(20.0, -31.0, 3, 1, ModeFrame::floquet) == "no error");
  CHECK(refused(20.0, 31.0, 3, 3, ModeFrame::floquet) ==
        equally + ": of these the frame \"fixed\" has modes");
  CHECK(refused(20.0, 31.0, 3, 3, ModeFrame::turning) ==
        "the frame \"turning\" expects a hub whose support does not move, or a speed of 0: on a "
        "support the frames \"fixed\" and \"floquet\" have modes");
  CHECK(refused(0.0, 0.0, 2, 1, {}) == "no error");
}

TEST_CASE("several rotors: those that are equal set the limits of one, and of what carries them") {
  const auto find = [](const std::vector<RotorText>& rotors) {
    return vibration::find_frequency_limits(make("kind = \"fixed\"", rotors));
  };
  const vibration::FrequencyLimits one = find({{.speed = 20.0, .blades = 3}});
  const vibration::FrequencyLimits two =
      find({{.name = "left", .speed = 20.0, .place = "[0, 2.5, 1]", .blades = 3},
            {.name = "right", .speed = 20.0, .place = "[0, -2.5, 1]", .blades = 3}});
  CHECK(two.lowest == Approx(one.lowest).epsilon(1e-9));
  CHECK(two.highest == Approx(one.highest).epsilon(1e-9));
  CHECK(two.rk4.step == Approx(one.rk4.step).epsilon(1e-9));
}

}  // namespace spoke
