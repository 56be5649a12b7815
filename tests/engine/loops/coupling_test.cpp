// Couplings of joints: closed forms of gears, racks and springs between them, and what holds of
// any.

#include <doctest/doctest.h>

#include <array>
#include <cmath>
#include <memory>
#include <numbers>
#include <string>

#include "engine/equilibrium.h"
#include "engine/modes.h"
#include "engine/simulation.h"
#include "engine/step/step_graph_builder.h"
#include "graph/executor.h"
#include "tests/contains.h"
#include "tests/engine/bodies/space/system/runs.h"
#include "tests/engine/step/step_declarations.h"
#include "tests/message_of.h"

using namespace spoke;
using namespace spoke::test;

namespace {

const std::string kAtRest =
    "world='space'\n[hub]\ninertia=1.0\n[hub.drive]\nkind='constant'\nspeed=0\n";
const std::string kSteps = "[integration]\nstep=1e-3\nduration=1\n";

constexpr Formulation kFormulations[] = {Formulation::structured, Formulation::subsystem,
                                         Formulation::augmented};

std::string make_wheel(const std::string& name, double inertia) {
  return "{ name='" + name + "', kind='rigid', mass=1, inertia=" + std::to_string(inertia) + " }";
}
std::string make_axle(const std::string& name, const std::string& more = "") {
  return "{ name='" + name + "', parent='hub', child='" + name +
         "', kind='revolute', axis=[0,0,1]" + more + " }";
}

/// Two wheels, 0.3 and 0.05 kg m^2, of which the second turns four times as fast, backwards.
std::string make_pair(const std::string& first, const std::string& second,
                      const std::string& spring = "") {
  return kAtRest + "[[subsystem]]\nname='g'\nbody=[ " + make_wheel("a", 0.3) + ", " +
         make_wheel("b", 0.05) + " ]\njoint=[ " + make_axle("a", first) + ", " +
         make_axle("b", second) +
         " ]\ncoupling=[ { name='gear', joints=[{ joint='a', ratio=4 }, { joint='b', ratio=1 }]" +
         spring + " } ]\n" + kSteps;
}

/// An epicyclic gear: sun of 24 teeth, three planets of 30, a ring of 84 that is held. Module 5 mm.
std::string make_epicyclic() {
  std::string bodies = make_wheel("sun", 0.02) + ", " + make_wheel("carrier", 0.1);
  std::string joints = make_axle("sun", ", torque=10") + ", " + make_axle("carrier"), couplings;
  for (int k = 1; k <= 3; ++k) {
    const std::string n = std::to_string(k), planet = "planet" + n;
    const double angle = 2.0 * std::numbers::pi * k / 3.0, radius = 0.0025 * (24 + 30);
    bodies += ", { name='" + planet + "', kind='rigid', mass=0.8, inertia=0.003 }";
    joints += ", { name='" + planet + "', parent='carrier', child='" + planet +
              "', kind='revolute', axis=[0,0,1], offset=[" +
              std::to_string(radius * std::cos(angle)) + "," +
              std::to_string(radius * std::sin(angle)) + ",0] }";
    couplings += (k > 1 ? ", " : "") + std::string("{ name='sun") + n +
                 "', joints=[{ joint='sun', ratio=24 }, { joint='carrier', ratio=-24 }, "
                 "{ joint='" +
                 planet + "', ratio=30 }] }, { name='ring" + n +
                 "', joints=[{ joint='carrier', ratio=84 }, { joint='" + planet +
                 "', ratio=30 }] }";
  }
  return kAtRest + "[[subsystem]]\nname='gear'\nbody=[ " + bodies + " ]\njoint=[ " + joints +
         " ]\ncoupling=[ " + couplings + " ]\n" + kSteps;
}

/// Two arms, one of them elastic if wanted, on a hub that is free, with couplings of joints of
/// several coordinates across them; `rod`: a closed loop between their tips, too.
std::string make_arms(bool is_elastic, bool has_rod, const std::string& hub) {
  const std::string lower =
      is_elastic ? "kind='beam', length=1, bodies=1, elements=2, sections={ mass_per_length=1,"
                   " axial_stiffness=1e4, flap_stiffness=50, lag_stiffness=80,"
                   " torsion_stiffness=50, flap_inertia=1e-3, lag_inertia=1e-3 }"
                 : "kind='rigid', mass=1, center=[0.5,0.1,0], inertia=[0.02,0.1,0.11]";
  return "world='space'\n" + hub +
         "[[subsystem]]\nname='arms'\n"
         "body=[ { name='a', kind='rigid', mass=2, center=[0.5,0,0.1], inertia=[0.1,0.2,0.25] },"
         " { name='b', " +
         lower +
         " },"
         " { name='c', kind='rigid', mass=1.5, center=[0.4,0.1,0], inertia=[0.1,0.2,0.15] },"
         " { name='d', kind='rigid', mass=0.5, center=[0.1,0,0.1], inertia=0.02 } ]\n"
         "joint=[ { name='ja', parent='hub', child='a', kind='universal', axes=[[0,1,0],[0.1,0,1]],"
         " initial=[0.4,0.1], initial_speed=[1,-0.5], stiffness=[2,3] },"
         " { name='jb', parent='a', child='b', kind='revolute', axis=[0,1,0.2], offset=[1,0,0.1],"
         " initial_speed=2 },"
         " { name='jc', parent='hub', child='c', kind='cylindrical', axis=[0,0.3,1],"
         " offset=[0,0.6,0], initial=[0.2,0.05], stiffness=[0,40] },"
         " { name='jd', parent='b', child='d', kind='prismatic', axis=[1,0.2,0], stiffness=30" +
         std::string(is_elastic ? "" : ", offset=[1,0,0]") +
         " } ]\n"
         "coupling=[ { name='one', joints=[{ joint='ja', coordinate=2, ratio=1.5 },"
         " { joint='jb', ratio=-2 }, { joint='jd', ratio=3 }] },"
         " { name='two', joints=[{ joint='jc', coordinate=2, ratio=2 },"
         " { joint='ja', coordinate=1, ratio=0.5 }] },"
         " { name='soft', joints=[{ joint='jb', ratio=1 }, { joint='jc', ratio=0.7 }],"
         " stiffness=25 } ]\n" +
         (has_rod ? std::string("loop=[ { name='rod', kind='distance', from={ body='c', "
                                "point=[0.8,0,0] }, to={ body='a', point=[0.9,0,0] } } ]\n")
                  : std::string()) +
         kSteps;
}

const std::string kFreeHub =
    "[hub]\nsupport='free'\nmass=3\ninertia=[0.4,0.5,0.6]\nangular_velocity=[0.5,-0.4,1]\n";
const std::string kTurningHub =
    "[hub]\ninertia=1\n[hub.drive]\nkind='constant'\nspeed=2\n[gravity]\nacceleration=[0,0,-9.81]"
    "\n";

const CoordinateBlock& joint_of_body(const Run<Space>& run, std::size_t body) {
  return run.context.data.subsystems[0].bodies[body].joint.coordinates;
}

}  // namespace

TEST_CASE("an epicyclic gear: ratios and acceleration by the teeth, two rows of six redundant") {
  for (const Formulation formulation : kFormulations)
    for (const Method& method : {Method(make_generalized_alpha(0.8, 1e-3)), Method(Rk4{1e-3})}) {
      Run<Space> run(make_system(parse_model(make_epicyclic())),
                     {.method = method, .formulation = formulation});
      const LoopFreedoms& freedoms = run.context.loop_start.freedoms[0];
      CHECK(freedoms.rows == 6);
      CHECK(freedoms.mobility() == 1);
      CHECK(run.context.loop_start.dropped.size() == 2);
      run.advance(100);
      const double sun = joint_of_body(run, 0).v[0];
      CHECK(std::abs(sun / (0.1 * 350.40664474823) - 1.0) < 1e-6);  // places are of six digits
      CHECK(std::abs(joint_of_body(run, 1).v[0] / sun - 24.0 / 108.0) < 1e-12);
      for (std::size_t k = 2; k < 5; ++k)
        CHECK(std::abs(joint_of_body(run, k).v[0] / sun + 28.0 / 45.0) < 1e-12);
    }
}

TEST_CASE("a pair of gears has the reduced inertia, and its force is that of the teeth") {
  const double acceleration = 6.0 / (0.3 + 16.0 * 0.05);
  for (const Formulation formulation : kFormulations) {
    Run<Space> run(make_system(parse_model(make_pair(", torque=6", ""))),
                   {.method = make_generalized_alpha(0.8, 1e-3), .formulation = formulation});
    run.advance(200);
    CHECK(std::abs(joint_of_body(run, 0).v[0] - 0.2 * acceleration) < 1e-12);
    CHECK(std::abs(joint_of_body(run, 1).q[0] + 4.0 * joint_of_body(run, 0).q[0]) < 1e-14);
    const double force = run.context.data.subsystems[0].loops.kept_multipliers[0];
    CHECK(std::abs(force + 0.05 * 4.0 * acceleration) < 1e-10);
  }
  std::string text = make_pair(", torque=6", "");
  text += "[[sensor]]\nquantity='coupling_force'\nsubsystem='g'\ncoupling='gear'\n";
  Simulation simulation(parse_scenario(text, "f"));
  simulation.run_until(0.1);
  const double shown = simulation.sensor("g.coupling_force");
  CHECK(std::abs(shown + 0.05 * 4.0 * acceleration) < 1e-10);
}

TEST_CASE("a rack falls by its weight and the inertia of its pinion") {
  const std::string text =
      kAtRest + "[gravity]\nacceleration=[0,0,-9.81]\n[[subsystem]]\nname='r'\nbody=[ " +
      make_wheel("pinion", 0.02) +
      ", { name='rack', kind='rigid', mass=3, inertia=0.1 } ]\njoint=[ " + make_axle("pinion") +
      ", { name='rack', parent='hub', child='rack', kind='prismatic', axis=[0,0,1] } ]\n"
      "coupling=[ { name='teeth', joints=[{ joint='pinion', ratio=0.05 }, { joint='rack', "
      "ratio=-1 }] } ]\n" +
      kSteps;
  Run<Space> run(make_system(parse_model(text)), {Rk4{1e-3}});
  run.advance(100);
  const double expected = -9.81 * 3.0 / (3.0 + 0.02 / (0.05 * 0.05));
  CHECK(std::abs(joint_of_body(run, 1).v[0] - 0.1 * expected) < 1e-12);
  CHECK(std::abs(calc_energy(run)) < 1e-12);
}

TEST_CASE("modes of gears: the reduced inertia on a spring, and a spring between the teeth") {
  const ModesResult rigid = solve_modes(parse_scenario(make_pair(", stiffness=50", ""), "f"), {});
  REQUIRE(rigid.modes.size() == 1);
  CHECK(std::abs(std::abs(rigid.modes[0].eigenvalue) - std::sqrt(50.0 / (0.3 + 16.0 * 0.05))) <
        1e-9);
  // J q'' = -k c (c . q): the square is k (c_1^2/J_1 + c_2^2/J_2), damped by d likewise.
  const ModesResult sprung =
      solve_modes(parse_scenario(make_pair("", "", ", stiffness=70, damping=0.02"), "f"), {});
  const double by_inertia = 16.0 / 0.3 + 1.0 / 0.05;
  double largest = 0.0, decay = 0.0;
  for (const Mode& mode : sprung.modes)
    if (std::abs(mode.eigenvalue) > largest) {
      largest = std::abs(mode.eigenvalue);
      decay = mode.eigenvalue.real();
    }
  CHECK(std::abs(largest - std::sqrt(70.0 * by_inertia)) < 1e-8);
  CHECK(std::abs(decay + 0.01 * by_inertia) < 1e-8);
}

TEST_CASE("gears stand where the torque on one balances the spring of the other") {
  const EquilibriumResult found =
      solve_equilibrium(parse_scenario(make_pair(", stiffness=50", ", torque=0.25"), "f"), {});
  REQUIRE(found.blades.size() == 1);
  REQUIRE(found.blades[0].joints.size() == 2);
  // As a turns, b turns back four times as far.
  CHECK(std::abs(found.blades[0].joints[0].value + 4.0 * 0.25 / 50.0) < 1e-10);
  CHECK(std::abs(found.blades[0].joints[1].value - 16.0 * 0.25 / 50.0) < 1e-10);
}

TEST_CASE("a gear follows what is prescribed, and its drive does the work") {
  std::string text = make_pair(", motion={ time=[0,1], value=[0,0.5] }", ", initial=0.3");
  Run<Space> run(make_system(parse_model(text)), {make_generalized_alpha(0.8, 1e-3)});
  const double before = calc_energy(run);
  run.advance(300);
  CHECK(std::abs(joint_of_body(run, 1).q[0] - (0.3 - 4.0 * 0.15)) < 1e-13);
  CHECK(std::abs(calc_energy(run) - before - run.work) < 1e-9);
}

TEST_CASE("axles of a support are ends of couplings: a generator behind a gear") {
  const std::string support =
      "[support]\nbody=[ { name='nacelle', kind='rigid', mass=50, inertia=20 }, " +
      make_wheel("generator", 0.05) +
      " ]\njoint=[ { parent='ground', child='nacelle', kind='fixed' }, { name='generator', "
      "parent='nacelle', child='generator', kind='revolute', axis=[0,0,1] } ]\n"
      "coupling=[ { name='gear', joints=[{ joint='axle', ratio=10 }, { joint='generator', "
      "ratio=-1 }] } ]\n[support.axle]\nbody='nacelle'\n" +
      kSteps;
  const auto write = [&support](const std::string& drive) {
    return "world='space'\n[hub]\nmass=1\ninertia=2\n[hub.drive]\n" + drive + support;
  };
  const auto make = [&write](const std::string& drive) { return parse_model(write(drive)); };
  CHECK(contains(message_of([&write] {
                   solve_modes(parse_scenario(write("kind='torque'\ntorque=14\n"), "f"),
                               {.state = {.speed = 0.0}});
                 }),
                 "hub.drive: is a torque"));
  for (const Formulation formulation : kFormulations) {
    Run<Space> run(make_system(make("kind='torque'\ntorque=14\n")),
                   {.method = make_generalized_alpha(0.8, 1e-3), .formulation = formulation});
    run.advance(100);  // 14 N m on 2 + 100 0.05 kg m^2
    CHECK(std::abs(joint_of_body(run, 2).v[0] - 0.2) < 1e-12);
    CHECK(std::abs(joint_of_body(run, 1).v[0] - 2.0) < 1e-11);
    Run<Space> driven(make_system(make("kind='constant'\nspeed=3\n")),
                      {.method = make_generalized_alpha(0.8, 1e-3), .formulation = formulation});
    driven.advance(100);
    CHECK(std::abs(joint_of_body(driven, 1).q[0] - 3.0) < 1e-12);
  }
}

TEST_CASE("a coupling in each blade ties its pitch to its flap") {
  const std::string text =
      "world='space'\n[hub]\ninertia=1\n[hub.drive]\nkind='constant'\nspeed=20\n"
      "[blade]\ncount=2\nlength=2\nbodies=1\nelements=2\n"
      "sections={ mass_per_length=2, axial_stiffness=4e5, flap_stiffness=1e3, lag_stiffness=2e3,"
      " torsion_stiffness=800, flap_inertia=1e-3, lag_inertia=3e-3 }\n"
      "joint=[ { name='flap', station=0.1, kind='revolute', axis=[0,-1,0], initial=0.1 },"
      " { name='pitch', station=0.3, kind='revolute', axis=[1,0,0] } ]\n"
      "coupling=[ { name='delta3', joints=[{ joint='flap', ratio=0.5 }, { joint='pitch', ratio=1 "
      "}] } ]\n" +
      kSteps;
  const System<Space> system = make_system(parse_model(text));
  const auto structured = check_formulations(system, make_generalized_alpha(0.8, 1e-3), 60, 1e-10);
  for (const SubsystemData<Space>& blade : structured->context.data.subsystems) {
    const double flap = blade.bodies[1].joint.coordinates.q[0];
    CHECK(std::abs(flap - 0.1) > 0.05);
    CHECK(std::abs(blade.bodies[2].joint.coordinates.q[0] + 0.5 * (flap - 0.1)) < 1e-13);
  }
}

TEST_CASE("formulations agree on couplings, of rigid and elastic bodies, with loops and without") {
  for (const bool is_elastic : {false, true})
    for (const bool has_rod : {false, true})
      for (const std::string& hub : {kFreeHub, kTurningHub})
        for (const Method& method :
             {Method(make_generalized_alpha(0.8, 1e-3)), Method(Rk4{1e-4})}) {
          CAPTURE(is_elastic);
          CAPTURE(has_rod);
          CAPTURE(hub);
          const System<Space> system =
              make_system(parse_model(make_arms(is_elastic, has_rod, hub)));
          const auto structured = check_formulations(system, method, 100, 1e-10);
          CHECK(structured->context.data.subsystems[0].loops.report.opening < 1e-12);
        }
}

TEST_CASE("a coupling of a bushing's directions is that of a joint of these freedoms") {
  // A screw: what turns about z moves along it, against a wheel beside.
  const auto make = [](const std::string& joint, int along, int about) {
    return "world='space'\n" + kTurningHub +
           "[[subsystem]]\nname='screw'\nbody=[ { name='nut', kind='rigid', mass=2,"
           " center=[0.1,0,0.2], inertia=[0.1,0.2,0.25] }, " +
           make_wheel("wheel", 0.05) + " ]\njoint=[ { name='nut', parent='hub', child='nut', " +
           joint + " }, " + make_axle("wheel", ", offset=[0.4,0,0]") +
           " ]\ncoupling=[ { name='thread', joints=[{ joint='nut', coordinate=" +
           std::to_string(about) +
           ", ratio=0.05 }, { joint='nut', coordinate=" + std::to_string(along) +
           ", ratio=-1 }] }, { name='belt', stiffness=40, joints=[{ joint='nut', coordinate=" +
           std::to_string(about) + ", ratio=1 }, { joint='wheel', ratio=-2 }] } ]\n" + kSteps;
  };
  const std::string cylinder =
      make("kind='cylindrical', axis=[0,0,1], stiffness=[3,200], initial_speed=[4,0.2]", 2, 1);
  const std::string bushing =
      make("kind='bushing', stiffness=[0,0,200,0,0,3], initial_speed=[0,0,0.2,0,0,4]", 3, 6);
  for (const Formulation formulation : kFormulations) {
    const RunSetup setup{.method = make_generalized_alpha(0.8, 1e-3), .formulation = formulation};
    Run<Space> one(make_system(parse_model(cylinder)), setup);
    Run<Space> other(make_system(parse_model(bushing)), setup);
    one.advance(200);
    other.advance(200);
    const CoordinateBlock &nut = joint_of_body(one, 0), &same = joint_of_body(other, 0);
    REQUIRE(std::abs(nut.q[0]) > 0.1);
    CHECK(std::abs(nut.q[1] - 0.05 * nut.q[0]) < 1e-13);
    CHECK(std::abs(same.q[0] - nut.q[1]) < 1e-12);
    CHECK(std::abs(same.q[1] - nut.q[0]) < 1e-12);
    CHECK(std::abs(joint_of_body(other, 1).q[0] - joint_of_body(one, 1).q[0]) < 1e-12);
  }
  const SteadyState turning{.speed = 2.0};
  const ModesResult first = solve_modes(parse_scenario(cylinder, "f"), {.state = turning});
  const ModesResult second = solve_modes(parse_scenario(bushing, "f"), {.state = turning});
  REQUIRE(first.modes.size() == 2);
  REQUIRE(second.modes.size() == 2);
  for (std::size_t k = 0; k < 2; ++k)
    CHECK(std::abs(first.modes[k].eigenvalue - second.modes[k].eigenvalue) < 1e-8);
}

TEST_CASE("couplings keep momentum and energy by the method's order") {
  for (const bool is_elastic : {false, true}) {
    CAPTURE(is_elastic);
    check_conservation(make_system(parse_model(make_arms(is_elastic, true, kFreeHub))), 0.1, 4e-4);
  }
}

TEST_CASE("couplings have equal bits on executors, threads and windows") {
  for (const std::string& hub : {kFreeHub, kTurningHub})
    for (const Method& method : {Method(make_generalized_alpha(0.8, 1e-3)), Method(Rk4{1e-4})})
      check_equal_bits(make_system(parse_model(make_arms(true, true, hub))), method, 40);
}

TEST_CASE("nodes of couplings declare what they read and write") {
  for (const bool is_elastic : {false, true})
    for (const Formulation formulation : kFormulations)
      for (const Method& method : {Method(make_generalized_alpha(0.8, 1e-3)), Method(Rk4{1e-3})})
        check_step_declarations(make_system(parse_model(make_arms(is_elastic, true, kTurningHub))),
                                formulation, method);
}
