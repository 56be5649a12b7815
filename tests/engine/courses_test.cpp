// Factors of loads that the program sets, and states with the courses that were in force.

#include "engine/courses.h"

#include <doctest/doctest.h>

#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "models/error.h"
#include "tests/contains.h"
#include "tests/engine/bodies/space/system/models.h"
#include "tests/message_of.h"
#include "tests/shown_values.h"

using namespace spoke;
using namespace spoke::test;

namespace {

const SimulationOptions kSerial{Formulation::structured, ExecutorKind::serial, 1, 1};

/// A rotor in the plane with one load of each kind, three of them by one name.
std::string planar(const std::string& factor) {
  return R"(
[hub]
inertia = 5.0
drive = { kind = "torque", torque = 2.0, initial_speed = 1.0 }
[blade]
count = 2
length = 4.0
bodies = 2
elements = 2
density = 2700.0
area = 1e-4
second_moment = 1e-8
youngs_modulus = 7e10
[[load]]
name = "push"
force = [0.0, 3.0]
ramp = 0.1
)" + factor +
         R"(
[[distributed_load]]
name = "push"
force_per_length = [0.0, -0.5]
)" + factor +
         R"(
[[drag]]
name = "air"
linear_per_length = 0.3
[[hub_load]]
name = "push"
torque = 1.5
)" + factor +
         R"(
[integration]
step = 0.005
duration = 1.0
)";
}

/// A model in space with loads on blade and hub; on a support, a load on the hub is one on a body.
std::string turned(const std::string& support, const std::string& factor) {
  return "world = \"space\"\n" + kTurnedHub + support + kBooms + R"(
[[load]]
name = "push"
blade = 1
force = [0.0, 1.0, 2.0]
)" + factor +
         R"(
[[hub_load]]
name = "push"
torque = [0.0, 0.0, 1.0]
force = [0.0, 0.5, 0.0]
)" + factor +
         "[integration]\nstep = 0.005\nduration = 1.0\n";
}

const std::string kMast = R"(
[support]
axle = { body = "mast" }
body = [{ name = "mast", kind = "rigid", mass = 10.0, inertia = 2.0 }]
joint = [{ parent = "ground", child = "mast", kind = "revolute", axis = [1.0, 0.0, 0.0], stiffness = 500.0, damping = 3.0 }]
)";

std::string half_at_once() { return "time = [0.0, 1.0]\nfactor = [0.5, 0.5]\n"; }

Simulation make(const std::string& text, const Overrides& overrides = {}) {
  return Simulation(parse_scenario(text, "courses.toml", overrides), kSerial);
}

/// A rotor in space, whose blades the program pitches, with a load.
Simulation make_pitched(const std::string& hub = kDrivenHub) {
  const std::string pitch = R"(
[[blade.joint]]
name = "pitch"
station = 1.0
kind = "revolute"
axis = [1.0, 0.0, 0.0]
motion = { by = "program", initial = 0.1 }
)";
  return make("world = \"space\"\n" + hub + kBooms + pitch + R"(
[[load]]
name = "push"
force = [0.0, 1.0, 2.0]
[integration]
step = 0.005
duration = 2.0
)");
}

/// An arm of two bodies on a wall; `shoulder`, `elbow`: further keys of its joints.
std::string arm(const std::string& shoulder = "", const std::string& elbow = "") {
  return R"(
world = "space"
[hub.drive]
kind = "fixed"
[gravity]
acceleration = [0.0, 0.0, -9.81]
[[subsystem]]
name = "arm"
body = [
  { name = "upper", kind = "rigid", mass = 2.0, center = [0.5, 0.0, 0.0], inertia = 0.2 },
  { name = "fore", kind = "rigid", mass = 1.0, center = [0.3, 0.0, 0.0], inertia = 0.05 }]
[[subsystem.joint]]
name = "shoulder"
parent = "hub"
child = "upper"
kind = "revolute"
axis = [0.0, 1.0, 0.0]
)" + shoulder +
         R"(
[[subsystem.joint]]
name = "elbow"
parent = "upper"
child = "fore"
kind = "cylindrical"
axis = [0.0, 1.0, 0.0]
offset = [1.0, 0.0, 0.0]
)" + elbow +
         "[integration]\nstep = 0.005\nduration = 1.0\n";
}

}  // namespace

TEST_CASE("a torque that the program adds to a joint is that of the scenario") {
  Simulation given = make(arm("torque = -12.0\n", "torque = -3.0\nforce = 1.5\n"));
  Simulation set = make(arm());
  set_joint_torque(set, 0, 0, 0, -12.0);
  set_joint_torque(set, 0, 1, 0, -3.0);
  set_joint_torque(set, 0, 1, 1, 1.5);
  Simulation clone = set.clone();
  for (Simulation* simulation : {&given, &set, &clone}) simulation->run_until(0.5);
  CHECK(set.state_hash() == given.state_hash());
  CHECK(clone.state_hash() == given.state_hash());
  CHECK(set.sensor("energy.work") == given.sensor("energy.work"));
  CHECK(std::abs(set.sensor("energy.residual")) < 1e-3 * set.sensor("energy.kinetic"));
  // One that is set once more takes the place of the one before.
  set_joint_torque(set, 0, 0, 0, 4.0);
  set_joint_torque(clone, 0, 0, 0, 1.0);
  set_joint_torque(clone, 0, 0, 0, 4.0);
  set.run_until(0.8);
  clone.run_until(0.8);
  CHECK(set.state_hash() == clone.state_hash());
}

TEST_CASE("torques that hold an arm find its place, and states go back to theirs") {
  Simulation simulation =
      make(arm("damping = 0.5\n", "stiffness = [20.0, 50.0]\ndamping = [1.0, 5.0]\n"));
  const int shoulder = simulation.joint_index(0, "shoulder");
  const auto go_on = [&](double until) {
    while (simulation.time() < until - 1e-9) {
      const CoordinateMotion now = simulation.joint_motion(0, shoulder);
      set_joint_torque(simulation, 0, shoulder, 0,
                       -400.0 * (now.value + 0.3) - 60.0 * now.velocity);
      simulation.step();
    }
    return simulation.state_hash();
  };
  go_on(0.4);
  const SavedState state = simulation.save();
  const Courses in_force = courses(simulation);
  REQUIRE(in_force.torques.size() == 1);
  const std::uint64_t expected = go_on(0.6);
  set_joint_torque(simulation, 0, 1, 1, 30.0);  // ends where the courses do not name it
  go_on(0.7);
  restore(simulation, state, in_force);
  CHECK(go_on(0.6) == expected);
  go_on(1.0);
  CHECK(std::abs(simulation.joint_motion(0, shoulder).velocity) < 0.05);
  CHECK(simulation.sensor("arm.shoulder") == simulation.joint_motion(0, shoulder).value);
}

TEST_CASE("torques are refused where no motor can be") {
  const auto refusal = [](const std::string& text, int joint, int coordinate, double torque) {
    Simulation simulation = make(text);
    return message_of([&] { set_joint_torque(simulation, 0, joint, coordinate, torque); });
  };
  CHECK(contains(refusal(planar(""), 0, 0, 1.0), "in the plane"));
  CHECK(contains(refusal(arm(), 0, 1, 1.0), "the coordinate of the joint"));
  CHECK(contains(refusal(arm(), 5, 0, 1.0), "the index of the joint"));
  CHECK(contains(refusal(arm(), 1, 1, std::numeric_limits<double>::quiet_NaN()), "is not finite"));
  CHECK(contains(refusal(arm("motion = { constant = 0.1 }\n"), 0, 0, 1.0), "prescribed motion"));
  const Simulation ball = make("world = \"space\"\n" + kTurnedHub + kBooms +
                               "[[blade.joint]]\nname = \"ball\"\nstation = 0.0\nkind = "
                               "\"spherical\"\nstiffness = 3.0\n"
                               "[integration]\nstep = 0.005\nduration = 1.0\n");
  CHECK(contains(message_of([&] { ball.joint_motion(0, 0); }), "rotation in space"));
}

TEST_CASE("a factor of loads that the program sets is that of the scenario") {
  for (const auto& texts : {std::pair{planar(""), planar(half_at_once())},
                            std::pair{turned("", ""), turned("", half_at_once())},
                            std::pair{turned(kMast, ""), turned(kMast, half_at_once())}}) {
    // rk4 follows a jump exactly.
    const Overrides exact{"integration.method=rk4", "integration.step=1e-4"};
    Simulation simulation = make(texts.first, exact), expected = make(texts.second, exact);
    Simulation plain = make(texts.first, exact);
    set_load_factor(simulation, "push", 0.5);
    for (Simulation* each : {&simulation, &expected, &plain}) each->run_until(0.1);
    REQUIRE(simulation.sensor_names() == expected.sensor_names());
    const std::vector<double> got = values_of(simulation), wanted = values_of(expected);
    for (std::size_t k = 0; k < got.size(); ++k) {
      CAPTURE(simulation.sensor_names()[k]);
      CHECK(got[k] == doctest::Approx(wanted[k]).epsilon(1e-9));
    }
    CHECK(simulation.sensor("hub.speed") !=
          doctest::Approx(plain.sensor("hub.speed")).epsilon(1e-4));
  }
}

TEST_CASE("a factor of 1 is what the scenario says, and energies close where loads are varied") {
  Simulation simulation = make(planar("")), plain = make(planar(""));
  simulation.run_until(0.2);
  set_load_factor(simulation, "push", 3.0);
  set_load_factor(simulation, "push", 1.0);
  simulation.run_until(0.4);
  plain.run_until(0.4);
  CHECK(simulation.sensor("hub.speed") == doctest::Approx(plain.sensor("hub.speed")).epsilon(1e-5));
  set_load_factor(simulation, "push", -2.0);
  set_load_factor(simulation, "air", 0.0);
  simulation.run_until(1.0);
  CHECK(std::abs(simulation.sensor("energy.residual")) <
        1e-3 * simulation.sensor("energy.kinetic"));
}

TEST_CASE("loads are refused that the scenario does not name") {
  Simulation simulation = make(planar(""));
  CHECK(load_names(simulation.scenario()) == std::vector<std::string>{"push", "air"});
  CHECK(contains(message_of([&] { set_load_factor(simulation, "pusj", 2.0); }), "push"));
  CHECK(contains(message_of([&] {
                   set_load_factor(simulation, "push", std::numeric_limits<double>::infinity());
                 }),
                 "not finite"));
  Simulation other = make("world = \"space\"\n" + kTurnedHub + kBooms +
                          "[integration]\nstep = 0.005\nduration = 1.0\n");
  CHECK(load_names(other.scenario()).empty());
  CHECK(contains(message_of([&] { set_load_factor(other, "push", 2.0); }), "no load"));
}

TEST_CASE("a simulation goes back to a state with the courses that were in force there") {
  Simulation simulation = make_pitched();
  const int joint = simulation.joint_index(0, "pitch");
  const CoordinateMotion up{0.1, 0.0, 0.5};
  simulation.run_until(0.1);
  simulation.set_joint_motion(0, joint, 0, up);
  set_load_factor(simulation, "push", 2.0);
  simulation.run_until(0.2);
  const Courses courses{simulation.drive(), {{0, joint, 0, 0.1, up, {}}}, {{"push", 2.0}}};
  const SavedState state = simulation.save();
  simulation.run_until(0.4);
  const std::uint64_t expected = simulation.state_hash();
  // Elsewhere, all is different.
  CoordinateMotion down = simulation.joint_motion(0, joint);
  down.acceleration = -3.0;
  simulation.set_joint_motion(0, joint, 0, down);
  set_load_factor(simulation, "push", -1.0);
  simulation.run_until(0.6);
  restore(simulation, state, courses);
  CHECK(simulation.time() == doctest::Approx(0.2));
  CHECK(simulation.joint_motion(0, joint).acceleration == 0.5);
  simulation.run_until(0.4);
  CHECK(simulation.state_hash() == expected);
  // What cannot be put in force leaves all as it is.
  Courses other = courses;
  other.drive = TorqueDrive{};
  CHECK(contains(message_of([&] { restore(simulation, state, other); }), "do not both"));
  other = courses;
  other.loads[0].load = "pull";
  CHECK(contains(message_of([&] { restore(simulation, state, other); }), "push"));
  other = courses;
  other.joints[0].joint = 7;
  CHECK(contains(message_of([&] { restore(simulation, state, other); }), "joint"));
  CHECK(simulation.state_hash() == expected);
}

TEST_CASE("the courses in force are those that the program has set, and those that it has not") {
  Simulation simulation = make_pitched();
  const int joint = simulation.joint_index(0, "pitch");
  Courses found = courses(simulation);
  REQUIRE(found.joints.size() == 2);  // a pitch joint on each blade
  for (const int blade : {0, 1}) {
    const JointCourse& own = found.joints[static_cast<std::size_t>(blade)];
    CHECK(own.tree == blade);
    CHECK(own.joint == joint);
    CHECK(own.motion.value == 0.1);
    CHECK(!own.curve);
  }
  REQUIRE(found.loads.size() == 1);
  CHECK(found.loads[0].load == "push");
  CHECK(found.loads[0].factor == 1.0);
  CHECK(found.anchors.empty());
  CHECK(!found.wind);
  simulation.run_until(0.1);
  simulation.set_joint_motion(0, joint, 0, {0.1, 0.0, 0.5});
  simulation.set_joint_course(1, joint, 0, Curve({0.0, 0.1, 1.0}, {0.1, 0.1, 0.2}));
  set_load_factor(simulation, "push", 2.0);
  found = courses(simulation);
  CHECK(found.joints[0].begin == doctest::Approx(0.1));
  CHECK(found.joints[0].motion.acceleration == 0.5);
  REQUIRE(found.joints[1].curve);
  CHECK(found.joints[1].curve->value(1.0) == 0.2);
  CHECK(found.loads[0].factor == 2.0);
}

TEST_CASE("with the courses in force a state is gone on from to the same bits, whatever was set") {
  Simulation simulation = make_pitched(kTurnedHub);
  const int joint = simulation.joint_index(0, "pitch");
  const SavedState start = simulation.save();
  const Courses at_start = courses(simulation);
  const auto go_on = [&](double t) {
    simulation.run_until(t);
    return simulation.state_hash();
  };
  const std::uint64_t plain = go_on(0.2);
  simulation.set_drive(TorqueDrive{Curve(-2.0), 4.0});
  simulation.set_joint_course(0, joint, 0, Curve({0.0, 0.2, 0.5, 0.5001}, {0.1, 0.1, 0.3, 0.5}));
  set_load_factor(simulation, "push", -1.0);
  const std::size_t warnings = simulation.warnings().size();
  const SavedState state = simulation.save();
  const Courses in_force = courses(simulation);
  const std::uint64_t driven = go_on(0.4);
  // The state alone goes on with what is in force now.
  simulation.restore(start);
  CHECK(go_on(0.2) != plain);
  restore(simulation, start, at_start);
  CHECK(simulation.warnings().size() < warnings);  // of the curve that jumps
  CHECK(go_on(0.2) == plain);
  restore(simulation, state, in_force);
  CHECK(simulation.warnings().size() == warnings);
  CHECK(go_on(0.4) == driven);
}
