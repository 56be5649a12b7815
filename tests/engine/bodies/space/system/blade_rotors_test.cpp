// Rotors on blades: the same machine with a subsystem in place of the blade, formulations, laws of
// conservation, executors, and what is drawn and measured.

#include <doctest/doctest.h>

#include <Eigen/Core>
#include <cmath>
#include <string>
#include <vector>

#include "engine/equilibrium.h"
#include "engine/output/scene/frame.h"
#include "engine/output/scene/make_scene.h"
#include "engine/simulation.h"
#include "models/tree/tree.h"
#include "tests/contains.h"
#include "tests/engine/bodies/space/system/levels.h"
#include "tests/engine/bodies/space/system/runs.h"
#include "tests/engine/step/step_declarations.h"
#include "tests/message_of.h"

using namespace spoke;
using namespace spoke::test;

namespace {

const std::string kBeam =
    "length=1, bodies=2, elements=2, sections={ mass_per_length=1.5, axial_stiffness=2e4, "
    "lag_stiffness=300, flap_stiffness=200, torsion_stiffness=150 }";

/// What a machine has besides.
struct Machine {
  std::string support = kOnBush;
  std::string base = "ground";
  std::string drive = "kind='free', initial_speed=-6";
  std::string station = "station=0.7, ";  ///< of the axle
  std::string weight = kLevelsWeight;
  bool is_loaded = true;
};

/// A propeller of a hinged twig on a blade of a turning hub, or on a subsystem that is as the
/// blade.
std::string make_machine(const Machine& of, bool is_blade) {
  const std::string carrier = is_blade ? "blade=1" : "subsystem='boom', body='boom'";
  const std::string place = is_blade ? "blade=1" : "subsystem='boom'\nbody='boom'";
  std::string main = make_hub_of("main", "kind='free', initial_speed=4",
                                 "body='stage', offset=[0,0.1,0.4], orientation=[0.2,0.1,0]");
  main.insert(main.find("mass=0.5"), "radius=0.2, ");
  if (is_blade) main += "blade={ count=1, " + kBeam + " }\n";
  std::string text =
      "world='space'\n" + of.support + " ]\njoint=[ { name='bush', parent='" + of.base +
      "', child='stage', kind='bushing', offset=[0,0,0.3], stiffness=[4e3,5e3,6e3,2e3,2e3,3e3] } "
      "]\n" +
      main +
      make_hub_of("prop", of.drive,
                  carrier + ", " + of.station + "offset=[0,0,0.1], orientation=[0,0.4,0]");
  if (!is_blade)
    text += "[[subsystem]]\nname='boom'\nrotor='main'\nbody=[ { name='boom', kind='beam', " +
            kBeam +
            " } ]\njoint=[ { parent='hub', child='boom', kind='fixed', offset=[0.2,0,0] } ]\n";
  text +=
      "[[subsystem]]\nname='twig'\nrotor='prop'\nbody=[ { name='twig', kind='rigid', mass=1, "
      "center=[0.15,0.02,0.01], inertia=[0.02,0.03,0.04] } ]\njoint=[ { name='twig', "
      "parent='hub', child='twig', kind='revolute', axis=[0,1,0], offset=[0.2,0,0.05] } ]\n";
  if (of.is_loaded)
    text += "[[load]]\n" + place + "\nforce=[0,3,5]\n[[distributed_load]]\n" + place +
            "\nforce_per_length=[0,1,0]\n[[hub_load]]\nrotor='prop'\nforce=[0,0.3,0]\n";
  return text + of.weight + "[[sensor]]\nname='end'\nquantity='displacement'\n" + place +
         "\n[integration]\nstep=1e-3\nduration=1\n";
}

std::vector<Machine> list_machines() {
  return {{},
          {.support = kFlying, .base = "fuselage", .station = ""},
          {.drive = "kind='constant', speed=20"},
          {.support = kFlying, .base = "fuselage", .drive = "kind='fixed'"}};
}

}  // namespace

TEST_CASE("rotors on blades: bitwise the motion of the same on a subsystem, in all formulations") {
  for (const Machine& of : list_machines()) {
    CAPTURE(of.drive);
    const System<Space> blade = make_system(parse_model(make_machine(of, true)));
    const System<Space> subsystem = make_system(parse_model(make_machine(of, false)));
    for (const Method& method : {Method(make_generalized_alpha(0.8, 1e-3)), Method(Rk4{5e-4})}) {
      const auto run = check_formulations(blade, method, 40, 1e-10);
      Run<Space> same(subsystem, {method});
      same.advance(40);
      CHECK(largest_difference(*run, same) == 0.0);
      CHECK(deformations(same).norm() > 1e-3);
    }
  }
}

TEST_CASE("rotors on blades keep momentum, and energy by the method's order") {
  const Machine free{
      .support = kFlying, .base = "fuselage", .station = "", .weight = "", .is_loaded = false};
  check_conservation(make_system(parse_model(make_machine(free, true))), 0.1, 5e-4);
}

TEST_CASE("rotors on blades: equal bits on all executors, and kept declarations") {
  for (const Machine& of : list_machines()) {
    const System<Space> system = make_system(parse_model(make_machine(of, true)));
    check_equal_bits(system, make_generalized_alpha(0.8, 1e-3), 15);
    for (const Formulation formulation :
         {Formulation::structured, Formulation::subsystem, Formulation::augmented})
      check_step_declarations(system, formulation, make_generalized_alpha(0.8, 1e-3));
  }
}

TEST_CASE("rotors on blades are drawn and measured where they are on subsystems") {
  for (const Machine& of : list_machines()) {
    Simulation blade(parse_scenario(make_machine(of, true), "f"));
    Simulation subsystem(parse_scenario(make_machine(of, false), "f"));
    blade.run_until(0.03);
    subsystem.run_until(0.03);
    for (const std::string axis : {"x", "y", "z"}) {
      CHECK(blade.sensor("blade1.tip." + axis) == subsystem.sensor("boom.tip." + axis));
      CHECK(blade.sensor("blade1.end." + axis) == subsystem.sensor("boom.end." + axis));
      // The tip is that of the beam, not that of the propeller.
      CHECK(std::abs(blade.sensor("blade1.end." + axis) - blade.sensor("blade1.tip." + axis)) <
            1e-12);
      CHECK(blade.sensor("blade1.root.force." + axis) ==
            subsystem.sensor("boom.root.force." + axis));
    }
    CHECK(blade.sensor("prop.hub.angle") == subsystem.sensor("prop.hub.angle"));
    std::vector<scene::Frame> frames(2);
    std::vector<scene::Scene> scenes;
    for (const bool is_blade : {true, false}) {
      scenes.push_back(scene::make_scene(parse_scenario(make_machine(of, is_blade), "f"), 1000));
      scene::FrameReader reader(scenes.back());
      reader.read(is_blade ? blade : subsystem, frames[scenes.size() - 1]);
    }
    REQUIRE(scenes[0].nodes.size() == scenes[1].nodes.size());
    CHECK(scenes[0].tips == scenes[1].tips);
    for (std::size_t k = 0; k < scenes[0].nodes.size(); ++k)
      CHECK((frames[0].place(scenes[0], k) - frames[1].place(scenes[1], k)).norm() < 1e-12);
  }
}

TEST_CASE("rotors on blades rest, and have no steady motion while they turn") {
  Machine of{.drive = "kind='fixed'"};
  std::vector<std::string> texts{make_machine(of, true), make_machine(of, false)};
  std::vector<Eigen::Vector3d> tips;
  for (std::string& text : texts) {
    text = replace(text, "kind='free', initial_speed=4", "kind='fixed'");
    text = replace(text, "offset=[0.2,0,0.05] }", "offset=[0.2,0,0.05], stiffness=50 }");
    tips.push_back(solve_equilibrium(parse_scenario(text, "f"), {.speed = 0.0})
                       .blades.front()
                       .tip_displacement);
  }
  CHECK(tips[0].norm() > 1e-3);
  CHECK((tips[0] - tips[1]).norm() < 1e-9);
  CHECK(contains(
      message_of([&] { solve_equilibrium(parse_scenario(texts[0], "f"), {.speed = 3.0}); }),
      "rotor.2.axle.blade: is on blade 1, which another rotor carries"));
}

TEST_CASE("rotors on blades are written as they are read, and named in errors") {
  const std::string text = make_machine({}, true);
  const Scenario scenario = parse_scenario(text, "f.toml");
  const std::vector<spatial::Tree> trees = build_trees(*scenario.space);
  const spatial::BodyAt hub = find_hub(trees, 1);
  CHECK(trees[hub.tree].name == "blade 1");
  CHECK(trees[hub.tree].bodies[hub.body].name == "prop.hub");
  const auto message = [&text](const std::string& from, const std::string& to) {
    const std::string edited = replace(text, from, to);
    REQUIRE(edited != text);
    return message_of([&edited] { parse_scenario(edited, "f.toml"); });
  };
  CHECK(contains(message("blade=1, station", "blade=2, station"),
                 "rotor.2.axle.blade: is 2, expected a whole number from 1 to 1"));
  CHECK(contains(message("blade=1, station", "blade=0, station"), "rotor.2.axle.blade: is 0"));
  CHECK(contains(message("blade=1, station", "blade=1, subsystem='twig', station"),
                 "rotor.2.axle.blade: given along with subsystem"));
  CHECK(contains(message("blade=1, station", "subsystem='blade 1', station"),
                 "rotor.2.axle.subsystem: is \"blade 1\", expected letters"));
  CHECK(contains(message("blade=1, station", "blade=1, body='boom', station"),
                 "rotor.2.axle.body: is \"boom\", expected none on a blade"));
  CHECK(contains(message("station=0.7", "station=1.7"), "rotor.2.axle.station: is 1.7"));
  CHECK(contains(message("body='stage', offset", "blade=1, offset"),
                 "rotor.1.axle.blade: is 1, but the first rotor stands on the support"));
}
