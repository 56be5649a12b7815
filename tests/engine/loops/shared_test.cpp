// Loops between subsystems: the same machine as one subsystem, formulations, laws of conservation,
// a closed form, the start, and how they are called.

#include <doctest/doctest.h>

#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "engine/simulation.h"
#include "engine/step/step_graph_builder.h"
#include "tests/contains.h"
#include "tests/engine/bodies/space/system/runs.h"
#include "tests/engine/loops/mechanisms.h"
#include "tests/engine/loops/tied_arms.h"
#include "tests/engine/solids/solid_models.h"
#include "tests/engine/step/step_declarations.h"
#include "tests/message_of.h"

using namespace spoke;
using namespace spoke::test;

namespace {

System<Space> make(const std::string& text) { return make_system(parse_model(text)); }

/// A fuselage with two rotors of two arms each, one of them behind a sprung mast, with a spring
/// between the rotors, one across the axle, and a rigid rod between arms of one rotor.
std::string make_two_rotors(bool is_lossless) {
  // Of rods the closing passes of rk4 are not of its order.
  const std::string rod = is_lossless ? "kind='distance', stiffness=4000" : "kind='distance'";
  const std::string soft = is_lossless ? "kind='spherical', stiffness=300"
                                       : "kind='spherical', stiffness=300, damping=4";
  const auto rotor = [](const std::string& name, const std::string& rest) {
    return "[[rotor]]\nname='" + name +
           "'\nhub={ mass=2, inertia=0.5, drive={ kind='free', initial_speed=3 } }\n" + rest;
  };
  const auto arm = [](const std::string& name, const std::string& rotor, double azimuth,
                      const std::string& loops) {
    return "[[subsystem]]\nname='" + name + "'\nrotor='" + rotor + "'\nazimuth=" + number(azimuth) +
           "\nbody=[ { name='arm', kind='rigid', mass=1.5, center=[0.4,0.02,0.01],"
           " inertia=[0.02,0.1,0.11] } ]\njoint=[ { name='hinge', parent='hub', child='arm',"
           " offset=[0.2,0,0], kind='universal', axes=[[0,-1,0],[0,0,1]], initial=[0.02,0.01] } ]"
           "\n" +
           (loops.empty() ? "" : "loop=[" + loops + "]\n");
  };
  return "world='space'\n[support]\nfrom='free'\nmass=30\ninertia=[2,3,4]\n"
         "angular_velocity=[0.1,-0.2,0.3]\n"
         "body=[ { name='mast', kind='rigid', mass=3, center=[0,0,0.2], inertia=[0.1,0.1,0.05] } "
         "]\n"
         "joint=[ { name='pivot', parent='fuselage', child='mast', kind='universal',"
         " axes=[[1,0,0],[0,1,0]], offset=[0.8,0,0.3], stiffness=[900,700] } ]\n" +
         rotor("main", "axle={ body='mast', offset=[0,0,0.5] }\n") +
         rotor("tail", "axle={ body='fuselage', offset=[-1,0.1,0.4], orientation=[0.3,0,0] }\n") +
         arm("m1", "main", 0.0,
             "{ name='brace', from={ body='arm', point=[0.5,0,0] }, to={ subsystem='m2',"
             " body='arm', point=[0.3,0.2,0] }, " +
                 rod +
                 " }, { name='rope', from={ body='arm', point=[0.6,0,0] }, to={ subsystem='t1',"
                 " body='arm', point=[0.5,0,0] }, " +
                 soft + " }") +
         arm("m2", "main", 3.0,
             "{ name='spring', from={ body='arm', point=[0.1,0,0] }, to={ subsystem='support',"
             " body='mast', point=[0,0,0.1] }, " +
                 soft + " }") +
         arm("t1", "tail", 0.5, "") + arm("t2", "tail", 2.5, "") + kOfASecond;
}

}  // namespace

TEST_CASE(
    "loops and couplings between subsystems: in all formulations the motion of the same as one "
    "subsystem") {
  const std::vector<std::string> ties{"kind='distance'",
                                      "kind='distance', stiffness=3e4, damping=400",
                                      "kind='bearing', axis=[0,0.2,1], "
                                      "stiffness=[[3e3,800],[-500,2e3]], damping=[[30,4],[-4,20]]",
                                      "coupling", "coupling, stiffness=80, damping=2"};
  for (const HubCase& hub : kHubs)
    for (const std::string& tie : ties) {
      CAPTURE(hub.name);
      CAPTURE(tie);
      // A ring of rods is another machine; of others one tie may be missing.
      const bool is_rigid = tie == ties[0] || tie == "coupling";
      const int count = is_rigid ? kArms - 2 : tie == ties[1] ? kArms - 1 : kArms;
      for (const Method& method : {Method(make_generalized_alpha(0.8, 1e-3)), Method(Rk4{1e-3})}) {
        const auto apart =
            check_formulations(make(make_tied_arms(hub.text, true, tie, count)), method, 30, 1e-10);
        Run<Space> one(make(make_tied_arms(hub.text, false, tie, count)), {method});
        one.advance(30);
        CHECK(std::abs(calc_energy(*apart) - calc_energy(one)) < 1e-6);  // of some 1e3 J
        const auto& bodies = one.context.data.subsystems[0].bodies;
        for (std::size_t i = 0; i < kArms; ++i)
          for (std::size_t j = 0; j < 2; ++j) {
            const CoordinateBlock& own =
                apart->context.data.subsystems[i].bodies[j].joint.coordinates;
            const CoordinateBlock& same = bodies[2 * i + j].joint.coordinates;
            for (int c = 0; c < own.size; ++c) {
              CHECK(std::abs(own.q[c] - same.q[c]) < 1e-10);
              CHECK(std::abs(own.v[c] - same.v[c]) < 1e-8);
            }
          }
      }
    }
}

TEST_CASE("loops between rotors and across an axle: all formulations agree") {
  for (const Method& method : {Method(make_generalized_alpha(0.8, 1e-3)), Method(Rk4{1e-3})})
    check_formulations(make(make_two_rotors(false)), method, 80, 1e-10);
}

TEST_CASE("a loop may be given from either of its ends") {
  const std::string hub = kHubs[3].text, ground = "subsystem='support', body='stage'";
  const std::string arm =
      "[[subsystem]]\nname='a'\nbody=[ { name='arm', kind='rigid', mass=5, center=[0.5,0,0],"
      " inertia=[0.1,0.6,0.7] } ]\njoint=[ { parent='hub', child='arm', offset=[0.3,0,0],"
      " kind='universal', axes=[[0,-1,0],[0,0,1]] } ]\n";
  const std::string spring = ", kind='distance', stiffness=800, damping=5 }]\n";
  const std::string from_arm = "loop=[{ name='s', from={ body='arm', point=[0.2,0,0] }, to={ " +
                               ground + ", point=[0,0,0.1] }" + spring;
  const std::string from_stage =
      "loop=[{ name='s', from={ body='stage', point=[0,0,0.1] }, to={ subsystem='a', body='arm',"
      " point=[0.2,0,0] }" +
      spring;
  const std::string head = "world='space'\n";
  Run<Space> a(make(head + hub + arm + from_arm + kOfASecond), {Rk4{1e-3}});
  Run<Space> b(make(head + hub + from_stage + arm + kOfASecond), {Rk4{1e-3}});
  a.advance(200);
  b.advance(200);
  CHECK(largest_difference(a, b) < 1e-12);
  CHECK(std::abs(calc_energy(a) - calc_energy(b)) < 1e-10);
}

TEST_CASE("the force on an interface of a solid has that of a loop from elsewhere") {
  const auto find_force = [](bool is_of_solid) {
    Scenario scenario;
    scenario.space = make_solid_trees(HubSupport::axle, spatial::SolidCoordinates::reduced);
    spatial::Model& model = *scenario.space;
    model.hub.drive = ConstantSpeed{2.0};
    spatial::Subsystem& mass = model.subsystems.emplace_back();
    mass.name = "mass";
    mass.azimuth = 0.7;
    mass.bodies = {make_rod("rod", 1.0, 0.4)};
    mass.joints = {make_hinge("hub", "rod", {0.3, 0.0, 0.2}, 0.2)};
    Loop spring;
    spring.name = "spring";
    spring.stiffness = {50.0, 50.0, 50.0};
    LoopPlace on_solid{.name = "arm", .interface = "tip"}, on_rod = on_body("rod", {0.2, 0.0, 0.1});
    spring.from = is_of_solid ? on_solid : on_rod;
    spring.to = is_of_solid ? on_rod : on_solid;
    spring.to.carrier = LoopPlace::Carrier::elsewhere;
    spring.to.subsystem = is_of_solid ? "mass" : "pair";
    spring.to.orientation = spatial::Vector::Zero();
    const auto pair = std::find_if(model.subsystems.begin(), model.subsystems.end(),
                                   [](const auto& subsystem) { return subsystem.name == "pair"; });
    (is_of_solid ? *pair : mass).loops.push_back(spring);
    Sensor& sensor = scenario.sensors.emplace_back();
    sensor.quantity = SensorQuantity::interface_force;
    sensor.subsystem = "pair";
    sensor.body = "arm";
    sensor.interface = "tip";
    scenario.integration = {.method = IntegrationMethod::rk4, .step = 2e-5, .duration = 2e-3};
    Simulation simulation(scenario);
    simulation.run_until(2e-3);
    Eigen::Vector3d force;
    int c = 0;
    for (const std::string& name : simulation.sensor_names())
      if (contains(name, "interface_force") && contains(name, "force.") && c < 3)
        force[c++] = simulation.sensor(name);
    REQUIRE(c == 3);
    return force;
  };
  // An isotropic spring, whose axes those of `to` are, is the same from both ends.
  const Eigen::Vector3d from_solid = find_force(true), to_solid = find_force(false);
  CHECK(from_solid.norm() > 1.0);
  CHECK((from_solid - to_solid).norm() < 1e-9 * from_solid.norm());
}

TEST_CASE("what flies with loops between rotors keeps momentum, and energy by the method's order") {
  check_conservation(make(make_two_rotors(true)), 0.1, 5e-4);
}

TEST_CASE("loops between subsystems: equal bits on all executors, and kept declarations") {
  for (const std::string& text :
       {make_tied_arms(kHubs[0].text, true, "kind='distance'", 2),
        make_tied_arms(kHubs[3].text, true, "coupling", 2), make_two_rotors(false)}) {
    const System<Space> system = make(text);
    check_equal_bits(system, make_generalized_alpha(0.8, 1e-3), 20);
    check_equal_bits(system, Rk4{1e-3}, 10);
    for (const Formulation formulation :
         {Formulation::structured, Formulation::subsystem, Formulation::augmented})
      check_step_declarations(system, formulation, make_generalized_alpha(0.8, 1e-3));
  }
}

TEST_CASE("two masses on rails of a hub at rest with a spring between them: the reduced mass") {
  const auto mass = [](const std::string& name, double m, const std::string& loop) {
    return "[[subsystem]]\nname='" + name +
           "'\nbody=[ { name='m', kind='rigid', mass=" + number(m) +
           ", inertia=1 } ]\njoint=[ { parent='hub', child='m', kind='prismatic',"
           " axis=[1,0,0], initial=" +
           number(name == "a" ? 0.0 : 1.0) + ", initial_speed=" + number(name == "a" ? 0.1 : 0.0) +
           " } ]\n" + loop;
  };
  const double k = 50.0, ma = 2.0, mb = 3.0;
  const std::string text =
      "world='space'\n[hub]\ninertia=1\n[hub.drive]\nkind='constant'\nspeed=0\n" +
      mass("a", ma,
           "loop=[ { name='s', kind='distance', length=1, stiffness=50, from={ body='m' },"
           " to={ subsystem='b', body='m' } } ]\n") +
      mass("b", mb, "") + kOfASecond;
  Run<Space> run(make(text), {Rk4{1e-3}});
  run.advance(700);
  const double w = std::sqrt(k * (1.0 / ma + 1.0 / mb)), t = 0.7, mean = 0.1 * ma / (ma + mb);
  const double a = run.context.data.subsystems[0].bodies[0].joint.coordinates.q[0];
  CHECK(std::abs(a - (mean * t + 0.1 * mb / (ma + mb) * std::sin(w * t) / w)) < 1e-10);
}

TEST_CASE("the start closes loops between subsystems by all joints, and drops what is redundant") {
  const std::string rod =
      "{ name='more', kind='distance', length=1.0, from={ body='arm', point=[0.3,0.1,0] },"
      " to={ subsystem='arm1', body='flap', point=[0,0.1,0.05] } }";
  std::string text = make_tied_arms(kHubs[0].text, true, "kind='distance', length=1.0", 1);
  const std::string key = "loop=[";
  text.insert(text.find(key) + key.size(), rod + ", ");
  Run<Space> run(make(text), {make_generalized_alpha(0.8, 1e-3)});
  const LoopStart& start = run.context.loop_start;
  REQUIRE(start.dropped.size() == 1);
  CHECK(start.dropped[0].subsystem == 0);
  bool moves_second = false;
  for (const LoopMove& move : start.moves) moves_second |= move.subsystem == 1;
  CHECK(moves_second);
  run.advance(50);
  CHECK(run.context.data.subsystems[0].loops.report.opening < 1e-12);
}

TEST_CASE("sensors, clones and states know loops between subsystems") {
  const std::string text =
      make_tied_arms(kHubs[3].text, true, "kind='distance', stiffness=3e4, damping=400", kArms) +
      "[[sensor]]\nquantity='loop_reaction'\nsubsystem='arm1'\nloop='tie'\n";
  const Scenario scenario = parse_scenario(text, "f");
  Simulation simulation(scenario);
  simulation.run_until(0.05);
  Simulation clone = simulation.clone();
  Simulation again(scenario);
  again.restore(simulation.save());
  for (Simulation* made : {&simulation, &clone, &again}) made->run_until(0.1);
  double largest = 0.0;
  for (const std::string& column : simulation.sensor_names()) {
    const double value = simulation.sensor(column);
    CHECK(value == clone.sensor(column));
    CHECK(value == again.sensor(column));
    if (contains(column, "loop_reaction")) largest = std::max(largest, std::abs(value));
  }
  CHECK(largest > 1.0);
  CHECK(simulation.state_hash() == clone.state_hash());
  CHECK(simulation.state_hash() == again.state_hash());
}

TEST_CASE("a ring of dampers acts on the cyclic pattern of lag as dampers of the hinges do") {
  // Of N blades with a rate c between neighbours pattern n has 2 c (1 - cos(2 pi n/N)) at each
  // hinge; dampers d between places at the radius a from the hinges have c = d a^2 cos^2(pi/N), if
  // hinges are on the axis. In the pattern cos, sin of four blades, n = 1.
  const double a = 0.8, d = 900.0, at_hinge = 2.0 * d * a * a * 0.5;
  const auto make_rotor = [&](double hinge, double ring) {
    return "world='space'\n[hub]\nmass=100\ninertia=5\n[hub.drive]\nkind='constant'\nspeed=20\n"
           "[hub.suspension]\nmass=500\ninertia=100\nstiffness=[2e5,1.4e5,0,0,0,0]\n"
           "damping=[2000,1500,0,0,0,0]\n[[subsystem]]\nname='blade'\ncount=4\n"
           "body=[ { name='rod', kind='rigid', mass=20, center=[2.5,0,0],"
           " inertia=[0.2,41.6667,41.6667] } ]\njoint=[ { name='lag', parent='hub', child='rod',"
           " kind='revolute', axis=[0,0,1], stiffness=4000, damping=" +
           number(hinge) +
           " } ]\nloop=[ { name='damper', kind='distance', stiffness=1e-9, damping=" +
           number(ring) + ", from={ body='rod', point=[" + number(a) +
           ",0,0] }, to={ subsystem='next', body='rod', point=[" + number(a) + ",0,0] } } ]\n" +
           kOfASecond;
  };
  const auto run = [&](const std::string& text) {
    System<Space> system = make(text);
    const double pattern[] = {1e-5, 0.0, -1e-5, 0.0};
    for (std::size_t i = 0; i < 4; ++i)
      system.subsystems[i].bodies[0].joint.course.initial[0] = pattern[i];
    auto made = std::make_unique<Run<Space>>(system, RunSetup{.method = Rk4{1e-3}});
    made->advance(400);
    return made;
  };
  const auto ring = run(make_rotor(0.0, d)), hinges = run(make_rotor(at_hinge, 1e-9)),
             none = run(make_rotor(0.0, 1e-9));
  CHECK(largest_difference(*ring, *hinges) < 1e-9);
  CHECK(largest_difference(*ring, *none) > 1e-6);
}

namespace {

/// Returns the growth of the slowest motion, from the state at whole turns: its components follow
/// x(k + 2) = s x(k + 1) - p x(k), p = exp(2 T growth).
double find_growth(const std::string& text, double speed) {
  constexpr int kStepsOfTurn = 300, kCalm = 20, kTurns = 6;
  const double turn = 2.0 * std::numbers::pi / speed;
  Run<Space> run(make(text), {.method = Rk4{turn / kStepsOfTurn}});
  run.advance(kCalm * kStepsOfTurn);
  std::vector<Eigen::VectorXd> states;
  for (int k = 0; k <= kTurns; ++k) {
    states.push_back(deformations(run));
    run.advance(kStepsOfTurn);
  }
  Eigen::Matrix2d normal = Eigen::Matrix2d::Zero();
  Eigen::Vector2d right = Eigen::Vector2d::Zero();
  for (std::size_t k = 0; k + 2 < states.size(); ++k) {
    Eigen::MatrixXd before(states[k].size(), 2);
    before << states[k + 1], states[k];
    before /= states[k].norm();
    normal += before.transpose() * before;
    right += before.transpose() * (states[k + 2] / states[k].norm());
  }
  return std::log(-normal.ldlt().solve(right)[1]) / (2.0 * turn);
}

}  // namespace

TEST_CASE("Hammond's rotor with a ring of dampers, and with one of it missing: growth by Floquet") {
  const double speed = 200.0 * std::numbers::pi / 30.0;
  // What is left of faster motions, and the step, are some 1e-4.
  CHECK(std::abs(find_growth(make_hammond(speed, 0), speed) + 1.0494524) < 1e-3);
  CHECK(std::abs(find_growth(make_hammond(speed, 1), speed) + 0.5608588) < 1e-3);
}
