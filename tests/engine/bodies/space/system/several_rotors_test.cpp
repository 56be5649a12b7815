// Several rotors on one support: what they conserve, and what their motion must equal.

#include <doctest/doctest.h>

#include <array>
#include <cmath>
#include <string>

#include "engine/courses.h"
#include "engine/simulation.h"
#include "engine/step/step_graph_builder.h"
#include "graph/executor.h"
#include "tests/engine/bodies/space/system/models.h"
#include "tests/engine/bodies/space/system/runs.h"

using namespace spoke;
using namespace spoke::test;

namespace {

constexpr int kRotorSteps = 40;

/// Returns text with `rotor.` before the names of its tables, and the keys of a rotor in front.
std::string make_rotor_text(const std::string& name, const std::string& hub,
                            const std::string& axle, const std::string& blades = "") {
  std::string text = "[[rotor]]\nname = \"" + name + "\"\nhub = { " + hub + " }\naxle = { " + axle +
                     " }\n" + blades;
  for (const char* table : {"[blade", "[[blade"})
    for (std::size_t at = text.find(table); at != std::string::npos; at = text.find(table, at + 8))
      text.insert(text.find("blade", at), "rotor.");
  return text;
}

/// A cabin on a soft mast that stands on a fuselage: the main rotor on the mast, a tail rotor with
/// an axis across on the fuselage.
const std::string kTwoOnFuselage = R"(
[support]
from = "free"
mass = 4.0
center = [0.05, -0.02, 0.1]
inertia = [0.4, 0.5, 0.6]
velocity = [0.3, -0.2, 0.5]
angular_velocity = [0.5, -0.4, 0.7]
[[support.body]]
name = "mast"
kind = "beam"
length = 1.0
bodies = 1
elements = 2
[support.body.sections]
mass_per_length = 1.0
axial_stiffness = 2e4
lag_stiffness = 400.0
flap_stiffness = 300.0
torsion_stiffness = 300.0
[[support.joint]]
child = "mast"
kind = "fixed"
orientation = [0.0, -1.5, 0.0]
)";
const std::string kMainHub =
    "mass = 2.0, center = [0.03, 0.02, 0.0], inertia = 0.5, radius = 0.1, axis = [0.1, 0.2, 1.0], "
    "drive = { kind = \"free\", initial_speed = 6.0 }";
const std::string kTailHub =
    "mass = 0.3, inertia = 0.02, axis = [0.0, 1.0, 0.0], "
    "drive = { kind = \"free\", initial_speed = -15.0 }";
/// Two rigid paddles, one on a flapping hinge.
const std::string kPaddles = R"(
[[subsystem]]
name = "paddles"
rotor = "tail"
[[subsystem.body]]
name = "one"
kind = "rigid"
mass = 0.2
center = [0.3, 0.0, 0.0]
inertia = [1e-3, 8e-3, 8e-3]
[[subsystem.body]]
name = "other"
kind = "rigid"
mass = 0.2
center = [-0.3, 0.0, 0.0]
inertia = [1e-3, 8e-3, 8e-3]
[[subsystem.joint]]
parent = "hub"
child = "one"
kind = "revolute"
axis = [0.0, 0.0, 1.0]
offset = [0.05, 0.0, 0.0]
stiffness = 3.0
initial = 0.1
[[subsystem.joint]]
parent = "hub"
child = "other"
kind = "fixed"
offset = [-0.05, 0.0, 0.0]
)";

System<Space> make_several(const std::string& text) {
  return make_system(parse_model(make_text("", text)));
}

std::string make_two(const std::string& main_hub, const std::string& tail_hub,
                     const std::string& rest = "") {
  return kTwoOnFuselage +
         make_rotor_text("main", main_hub,
                         "body = \"mast\", orientation = [0.0, 1.5, 0.0], offset = [0.1, 0.0, 0.2]",
                         kBooms) +
         make_rotor_text("tail", tail_hub, "body = \"fuselage\", offset = [-2.0, 0.1, 0.3]") +
         kPaddles + rest;
}

std::string with_torque(std::string hub, double torque) {
  const std::string free = "kind = \"free\"";
  return hub.replace(hub.find(free), free.size(),
                     "kind = \"torque\", torque = " + std::to_string(torque));
}

/// What one evaluation of the start finds.
SystemContext<Space>& evaluate_start(const std::string& text, Formulation formulation,
                                     SystemContext<Space>& context) {
  context.system = make_several(text);
  context.formulation = formulation;
  context.integrator.method = Rk4{1e-4};
  allocate(context);
  const graph::StepGraph graph = build_step_graph(context);
  context.data.progress[0] = {};
  context.data.progress[0].control = {0.0, PassControl::kEvaluateOnly, false};
  graph::make_executor(graph, graph::ExecutorKind::serial)->run();
  return context;
}

const BodyData<Space>& hub_of_rotor(const SystemContext<Space>& context, std::size_t r) {
  const SupportedRotor& rotor = context.system.rotors.at(r);
  return context.data.subsystems[static_cast<std::size_t>(rotor.subsystem)]
      .bodies[static_cast<std::size_t>(rotor.body)];
}

}  // namespace

TEST_CASE("a machine with two rotors that flies keeps energy and momentum, of order 4") {
  const System<Space> system = make_several(make_two(kMainHub, kTailHub));
  REQUIRE(system.rotors.size() == 2);
  const Drift whole = calc_drift(system, Rk4{1e-3}, 0.1);
  const Drift half = calc_drift(system, Rk4{5e-4}, 0.1);
  CAPTURE(whole.energy);
  CAPTURE(half.energy);
  CHECK(half.energy < 1e-6);
  CHECK(whole.energy / half.energy > 12.0);
  CHECK(half.momentum.norm() < 1e-7);
}

TEST_CASE("motors of two rotors act against the fuselage: no momentum changes") {
  const System<Space> system =
      make_several(make_two(with_torque(kMainHub, 3.0), with_torque(kTailHub, -0.4)));
  for (const Formulation formulation : formulations()) {
    CAPTURE(name_of(formulation));
    RunSetup setup{Rk4{5e-4}};
    setup.formulation = formulation;
    Run<Space> run(system, setup);
    const space::Twist before = calc_momentum(run);
    const double speed = run.context.data.rotors[1].turn.speed;
    run.advance_for(0.08);
    CHECK(run.context.data.rotors[1].turn.speed < speed - 0.1);
    CHECK((calc_momentum(run) - before).norm() < 1e-7);
  }
}

TEST_CASE("the formulations agree on two rotors, and so do executors and windows") {
  const System<Space> system =
      make_several(make_two(with_torque(kMainHub, 3.0), with_torque(kTailHub, -0.4), kGravity));
  for (const Method& method : {Method{Rk4{5e-4}}, Method{make_generalized_alpha(0.8, 1e-3)}}) {
    Run<Space> structured(system, {method});
    structured.advance(kRotorSteps);
    for (const Formulation formulation : formulations()) {
      CAPTURE(name_of(formulation));
      RunSetup setup{method};
      setup.formulation = formulation;
      Run<Space> other(system, setup);
      other.advance(kRotorSteps);
      CHECK(largest_difference(structured, other) < 1e-9);
    }
    check_equal_bits(system, method, kRotorSteps);
  }
}

TEST_CASE("one [[rotor]] is the short form of it, bit by bit") {
  const std::string brief = "hub = { " + kMainHub + " }\n" + kBooms + kTwoOnFuselage +
                            "[support.axle]\nbody = \"mast\"\norientation = [0.0, 1.5, 0.0]\n";
  const std::string named =
      kTwoOnFuselage +
      make_rotor_text("main", kMainHub, "body = \"mast\", orientation = [0.0, 1.5, 0.0]", kBooms);
  for (const Method& method : {Method{Rk4{5e-4}}, Method{make_generalized_alpha(0.8, 1e-3)}}) {
    Run<Space> a(make_several(brief), {method}), b(make_several(named), {method});
    a.advance(kRotorSteps);
    b.advance(kRotorSteps);
    CHECK(a.hash() == b.hash());
  }
}

TEST_CASE("rotors on one axis turn the body between them by the sum of their torques") {
  constexpr double kBody = 0.8, kFirst = 0.05, kSecond = 0.07;  // inertias about the axis [kg m^2]
  constexpr double kTorque = 0.9, kOther = -0.5;                // [N m]
  const auto hub = [](double inertia, double torque) {
    return "mass = 1.0, inertia = " + std::to_string(inertia) +
           ", drive = { kind = \"torque\", initial_speed = 20.0, torque = " +
           std::to_string(torque) + " }";
  };
  const std::string text =
      "[support]\nfrom = \"free\"\nmass = 5.0\ninertia = [0.9, 1.0, " + std::to_string(kBody) +
      "]\n" + make_rotor_text("lower", hub(kFirst, kTorque), "offset = [0.0, 0.0, 0.2]") +
      make_rotor_text("upper", hub(kSecond, kOther), "offset = [0.0, 0.0, 0.5]");
  for (const Formulation formulation : formulations()) {
    CAPTURE(name_of(formulation));
    SystemContext<Space> context;
    evaluate_start(text, formulation, context);
    const double turn = -(kTorque + kOther) / kBody;
    CHECK(context.data.hub_solution.acceleration[Space::kAxial] == doctest::Approx(turn));
    CHECK(hub_of_rotor(context, 0).joint.a_found[0] == doctest::Approx(kTorque / kFirst - turn));
    CHECK(hub_of_rotor(context, 1).joint.a_found[0] == doctest::Approx(kOther / kSecond - turn));
  }
}

TEST_CASE("the program turns any axle that its drive leaves free") {
  constexpr double kBody = 0.8, kUpper = 0.07, kTorque = 0.3, kTurnSeconds = 0.05;
  const std::string hub =
      "mass = 1.0, drive = { kind = \"free\", initial_speed = 20.0 }, inertia = ";
  const std::string text = "[support]\nfrom = \"free\"\nmass = 5.0\ninertia = [0.9, 1.0, 0.8]\n" +
                           make_rotor_text("lower", hub + "0.05", "offset = [0.0, 0.0, 0.2]") +
                           make_rotor_text("upper", hub + "0.07", "offset = [0.0, 0.0, 0.5]");
  Simulation simulation(make_scenario(make_text("", text), 1e-3, kTurnSeconds),
                        {Formulation::structured, ExecutorKind::serial, 1});
  const int axle = simulation.joint_index(0, "upper.axle");
  set_joint_torque(simulation, 0, axle, 0, kTorque);
  simulation.run_until(kTurnSeconds);
  const double turn = kTorque * kTurnSeconds;
  CHECK(simulation.sensor("upper.hub.speed") ==
        doctest::Approx(20.0 + turn / kUpper + turn / kBody).epsilon(1e-10));
  CHECK(simulation.sensor("hub.speed") == doctest::Approx(20.0 + turn / kBody).epsilon(1e-10));
  CHECK(simulation.sensor("upper.hub.torque") == doctest::Approx(kTorque));
  CHECK(simulation.sensor("fuselage.spin.z") == doctest::Approx(-turn / kBody).epsilon(1e-10));
}

// Thirteen rigid bodies. The accelerations are those of Lagrange's equations in minimal
// coordinates, whose matrices were made of the bodies' velocities by differences of sixth order, by
// a program of its own.
TEST_CASE("a quadcopter with flapping blades moves by Lagrange's equations") {
  std::string text = R"(
[support]
from = "free"
mass = 1.2
center = [0.0, 0.0, 0.01]
inertia = [0.012, 0.013, 0.02]
attitude = [0.1, -0.2, 0.3]
velocity = [1.0, 2.0, -1.0]
angular_velocity = [0.42496625465958593, -0.423034278792158, 0.14298839591869938]
)";
  constexpr std::array<double, 4> kTorques{0.02, -0.021, 0.019, -0.02};
  constexpr double kPlaces[4][2] = {{0.2, 0.2}, {-0.2, 0.2}, {-0.2, -0.2}, {0.2, -0.2}};
  constexpr double kFlap[4][2] = {{0.003781067635870661, -0.010454968829614948},
                                  {-0.008261270867837869, -0.04882934765279712},
                                  {0.035994147654418045, 0.022883317440744576},
                                  {-0.006508456737356488, 0.01547613173455323}};
  const auto number = [](double x) {
    std::string digits(32, '\0');
    digits.resize(static_cast<std::size_t>(std::snprintf(digits.data(), 32, "%.17g", x)));
    return digits.find_first_of(".e") == std::string::npos ? digits + ".0" : digits;
  };
  for (std::size_t r = 0; r < 4; ++r) {
    const std::string name(1, static_cast<char>('a' + r));
    text += make_rotor_text(
        name,
        "mass = 0.02, inertia = [2e-6, 2e-6, 3e-6], drive = { kind = \"torque\", torque = " +
            number(kTorques[r]) + ", initial_speed = " + number(r % 2 == 0 ? 500.0 : -500.0) + " }",
        "offset = [" + number(kPlaces[r][0]) + ", " + number(kPlaces[r][1]) + ", 0.05]");
  }
  for (std::size_t r = 0; r < 4; ++r) {
    const std::string name(1, static_cast<char>('a' + r));
    text += "[[subsystem]]\nname = \"blades_" + name + "\"\nrotor = \"" + name + "\"\n";
    for (const double sign : {1.0, -1.0}) {
      const std::string body = sign > 0.0 ? "one" : "other";
      text += "[[subsystem.body]]\nname = \"" + body +
              "\"\nkind = \"rigid\"\nmass = 0.006\ninertia = [1e-7, 8e-6, 8e-6]\ncenter = [" +
              number(0.05 * sign) +
              ", 0.0, 0.001]\n[[subsystem.joint]]\nparent = \"hub\"\nchild = "
              "\"" +
              body + "\"\nkind = \"revolute\"\naxis = [0.0, 1.0, 0.0]\nstiffness = 0.8\n" +
              "damping = 1e-4\noffset = [" + number(0.01 * sign) +
              ", 0.0, 0.0]\ninitial = " + number(kFlap[r][sign > 0.0 ? 0 : 1]) + "\n";
    }
  }
  constexpr std::array<double, 6> kFrame{1.1341642078466723, -1.0410243181563235,
                                         3.881058995334689,  -75.05386935038625,
                                         -67.22843224157818, 1.4650501578570783};
  constexpr std::array<std::array<double, 3>, 4> kJoints{
      {{320.00527652107314, 3304.1211892348833, -80.7746889877572},
       {-340.8844702256525, 5796.565333821046, 11433.648459927448},
       {306.18601892796147, -6846.531394340663, -10661.816676652104},
       {-322.68169915588885, 5985.273845267977, -9621.58090805985}}};
  for (const Formulation formulation : formulations()) {
    CAPTURE(name_of(formulation));
    SystemContext<Space> context;
    evaluate_start(text, formulation, context);
    constexpr double kScale = 11433.648459927448;
    for (std::size_t c = 0; c < 6; ++c)
      CHECK(std::abs(context.data.hub_solution.acceleration[static_cast<Eigen::Index>(c)] -
                     kFrame[c]) < 1e-11 * kScale);
    for (std::size_t r = 0; r < 4; ++r) {
      CHECK(std::abs(hub_of_rotor(context, r).joint.a_found[0] - kJoints[r][0]) < 1e-11 * kScale);
      for (std::size_t j = 0; j < 2; ++j)
        CHECK(std::abs(context.data.subsystems[r].bodies[j].joint.a_found[0] - kJoints[r][j + 1]) <
              1e-11 * kScale);
    }
  }
}
