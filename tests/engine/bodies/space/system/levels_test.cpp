// Rotors on what other rotors carry: the same machine in one tree, formulations, laws of
// conservation, executors, and what is drawn and measured.

#include "tests/engine/bodies/space/system/levels.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "engine/output/scene/frame.h"
#include "engine/output/scene/make_scene.h"
#include "engine/simulation.h"
#include "engine/step/step_graph_builder.h"
#include "models/tree/tree.h"
#include "tests/engine/bodies/space/system/runs.h"
#include "tests/engine/step/step_declarations.h"

using namespace spoke;
using namespace spoke::test;

namespace {

std::vector<LevelsCase> list_cases() {
  const std::string rod =
      "{ name='rod', kind='distance', from={ body='leaf', point=[0.2,0,0] }, to={ TO(arm)"
      "body='arm', point=[0.2,0,0.1] } }";
  const std::string springs =
      "{ name='s', from={ body='leaf', point=[0.2,0,0] }, to={ TO(boom)body='boom', station=0.4 },"
      " kind='spherical', stiffness=80, damping=1 }, { name='t', from={ body='leaf' }, to={"
      " TO(twig)body='twig', point=[0.1,0.2,0] }, kind='distance', stiffness=60 }, { name='u',"
      " from={ body='leaf', point=[0,0.1,0] }, to={ TO(support)body='stage', point=[0,0,0.3] },"
      " kind='distance', stiffness=40, damping=2 }";
  const std::string gear =
      "{ name='gear', joints=[ { joint='leaf', ratio=1 }, { TO(arm)joint='arm', coordinate=2,"
      " ratio=0.5 }, { TO(boom)joint='middle.axle', ratio=0.2 } ]";
  return {{.support = kOnBush, .damping = ", damping=0.5"},
          {.support = kFlying, .damping = ", damping=0.5", .drive = "fixed"},
          {.support = kOnBush, .loops = rod},
          {.support = kFlying, .loops = springs + ", " + rod},
          {.support = kFlying, .couplings = gear + " }"},
          {.support = kOnBush, .loops = rod, .couplings = gear + ", stiffness=50, damping=1 }"}};
}

std::string base_of(const LevelsCase& of) { return of.support == kFlying ? "fuselage" : "ground"; }

/// A name of a body without the points; that of the first rotor's hub as others are.
std::string name_of(const spatial::TreeBody& body, const spatial::Model& model) {
  return body.name == "hub" ? model.hub.name + "hub" : replace(body.name, ".", "");
}

/// The joints that carry bodies, by the names of these.
std::map<std::string, const CoordinateBlock*> find_joints(const spatial::Model& model,
                                                          const Run<Space>& run) {
  std::map<std::string, const CoordinateBlock*> joints;
  const std::vector<spatial::Tree> trees = build_trees(model);
  for (std::size_t i = 0; i < trees.size(); ++i)
    for (std::size_t j = 0; j < trees[i].bodies.size(); ++j)
      joints[name_of(trees[i].bodies[j], model)] =
          &run.context.data.subsystems[i].bodies[j].joint.coordinates;
  return joints;
}

}  // namespace

TEST_CASE("rotors on what rotors carry: in all formulations the motion of the same in one tree") {
  for (const LevelsCase& of : list_cases()) {
    CAPTURE(of.support);
    CAPTURE(of.loops);
    const std::string levels = make_levels(of, base_of(of), kLevelsWeight);
    const spatial::Model apart = parse_model(levels);
    const spatial::Model together =
        parse_model(with_dummy(make_one_level(of, base_of(of), kLevelsWeight)));
    for (const Method& method : {Method(make_generalized_alpha(0.8, 1e-3)), Method(Rk4{1e-3})}) {
      const auto run = check_formulations(make_system(apart), method, 40, 1e-10);
      Run<Space> one(make_system(together), {method});
      one.advance(40);
      CHECK(std::abs(calc_energy(*run) - calc_energy(one)) < 1e-6);  // of some 1e2 J
      const auto own = find_joints(apart, *run), same = find_joints(together, one);
      int compared = 0;
      for (const auto& joint : same) {
        const std::string& name = joint.first;
        const CoordinateBlock* coordinates = joint.second;
        const auto at = own.find(name);
        if (at == own.end()) continue;
        CAPTURE(name);
        REQUIRE((at->second->size == coordinates->size || coordinates->size == 0));
        for (int c = 0; c < coordinates->size; ++c, ++compared) {
          CHECK(std::abs(at->second->q[c] - coordinates->q[c]) < 1e-9);
          CHECK(std::abs(at->second->v[c] - coordinates->v[c]) < 1e-7);
        }
      }
      CHECK(compared >= 11);
    }
  }
}

TEST_CASE("rotors on what rotors carry keep momentum, and energy by the method's order") {
  const std::string springs =
      "{ name='s', from={ body='leaf', point=[0.2,0,0] }, to={ TO(arm)body='arm' },"
      " kind='distance', stiffness=80 }";
  std::string text = make_levels({.support = kFlying, .loops = springs}, "fuselage", "");
  text.erase(text.find("[[load]]"), text.find("[[sensor]]") - text.find("[[load]]"));
  check_conservation(make_system(parse_model(text)), 0.1, 5e-4);
}

TEST_CASE("rotors on what rotors carry: equal bits on all executors, and kept declarations") {
  for (const LevelsCase& of : list_cases()) {
    const System<Space> system =
        make_system(parse_model(make_levels(of, base_of(of), kLevelsWeight)));
    check_equal_bits(system, make_generalized_alpha(0.8, 1e-3), 15);
    for (const Formulation formulation :
         {Formulation::structured, Formulation::subsystem, Formulation::augmented})
      check_step_declarations(system, formulation, make_generalized_alpha(0.8, 1e-3));
  }
}

TEST_CASE("rotors on what rotors carry are drawn and measured where the same in one tree is") {
  // By the names of their bodies, where nodes are in space.
  const auto place_nodes = [](const scene::Scene& drawn, const scene::Frame& frame,
                              const spatial::Model& model) {
    const std::vector<spatial::Tree> trees = build_trees(model);
    std::map<std::string, spatial::Vector> places;
    for (std::size_t k = 0; k < drawn.sources.size(); ++k) {
      const scene::NodeSource& source = drawn.sources[k];
      const spatial::TreeBody& body = trees[static_cast<std::size_t>(source.subsystem)]
                                          .bodies[static_cast<std::size_t>(source.body)];
      places[name_of(body, model) + std::to_string(source.node)] =
          frame.hub.position + frame.hub.rotation * frame.place(drawn, k);
    }
    return places;
  };
  for (const LevelsCase& of : list_cases()) {
    std::vector<std::map<std::string, spatial::Vector>> places;
    std::vector<Eigen::Vector3d> velocities;
    for (const bool is_one : {false, true}) {
      const std::string text = is_one ? with_dummy(make_one_level(of, base_of(of), kLevelsWeight))
                                      : make_levels(of, base_of(of), kLevelsWeight);
      const Scenario scenario = parse_scenario(text, "f");
      const scene::Scene drawn = scene::make_scene(scenario, 1000);
      places.push_back(
          place_nodes(drawn, scene::make_first_frame(scenario, drawn), *scenario.space));
      Simulation simulation(scenario);
      simulation.run_until(0.03);
      scene::FrameReader reader(drawn);
      scene::Frame frame;
      reader.read(simulation, frame);
      places.push_back(place_nodes(drawn, frame, *scenario.space));
      const std::string sensor = is_one ? "support.watched." : "leaf.watched.";
      velocities.emplace_back(simulation.sensor(sensor + "x"), simulation.sensor(sensor + "y"),
                              simulation.sensor(sensor + "z"));
    }
    CHECK((velocities[0] - velocities[1]).norm() < 1e-6);
    for (const std::size_t when : {0, 1}) {
      int compared = 0;
      for (const auto& node : places[when]) {
        const std::string& name = node.first;
        const auto same = places[when + 2].find(name);
        if (same == places[when + 2].end()) continue;
        CAPTURE(name);
        CHECK((node.second - same->second).norm() < 1e-8);
        ++compared;
      }
      CHECK(compared >= 7);
    }
  }
}

TEST_CASE("a gondola that turns back as fast as its arm hangs from a circle: the ride's pendulum") {
  Simulation simulation(read_model("fairground_ride.toml"));
  simulation.run_until(52.0);
  double swing = 0.0, acceleration = 0.0;
  for (double t = 52.0; t <= 60.0; t += 0.1) {  // a turn takes 7.9 s
    simulation.run_until(t);
    swing = std::max(swing, simulation.sensor("seat_a1.swing"));
    acceleration = std::max(acceleration, simulation.sensor("seat_a1.motion.x"));
  }
  const double radius = 4.5, speed = 0.8, length = 0.8 + 8.0 / (90.0 * 0.8);
  CHECK(acceleration == doctest::Approx(radius * speed * speed).epsilon(1e-3));
  const double small = radius * speed * speed / (9.81 - length * speed * speed);
  CHECK(swing < small);
  CHECK(swing > 0.96 * small);  // damped, and beyond small angles
}

TEST_CASE("what is welded to a beam by a fixed hub pulls at it where it stands") {
  // Strains are linear, so that the tension is that of the masses beyond, at rest.
  const std::string head =
      "world='space'\n[support]\nbody=[ { name='post', kind='rigid', mass=1, inertia=1 } ]\n"
      "joint=[ { parent='ground', child='post', kind='fixed' } ]\n" +
      make_hub_of("main", "kind='constant', speed=25", "body='post'");
  const std::string boom = replace(kBoom, "strain='nonlinear'", "strain='linear'");
  const std::string mass = "{ name='m', kind='rigid', mass=2, center=[0.1,0.3,0.2], inertia=1e-9 }";
  const std::string joint = "{ parent='hub', child='boom', kind='fixed', orientation=[0,0.1,0] }";
  const std::string tail =
      "[[load]]\nsubsystem='s'\nbody='boom'\nforce=[0,3,5]\n[integration]\nduration=1\n";
  const std::string as_one = head + "[[subsystem]]\nname='s'\nrotor='main'\nbody=[ " + boom + ", " +
                             mass + " ]\njoint=[ " + joint +
                             ", { parent='boom', child='m', kind='fixed' } ]\n" + tail;
  const std::string as_two =
      head +
      "[[rotor]]\nname='weld'\nhub={ inertia=1e-7, drive={ kind='fixed' } }\n"
      "axle={ subsystem='s', body='boom' }\n[[subsystem]]\nname='s'\nrotor='main'\nbody=[ " +
      boom + " ]\njoint=[ " + joint + " ]\n[[subsystem]]\nname='m'\nrotor='weld'\nbody=[ " + mass +
      " ]\njoint=[ { parent='hub', child='m', kind='fixed' } ]\n" + tail;
  const auto find = [](const std::string& text) {
    Run<Space> run(make_system(parse_model(text)), {Rk4{2e-4}});
    run.advance(200);
    return deformations(run);  // of the beam: nothing else moves freely
  };
  const Eigen::VectorXd one = find(as_one), two = find(as_two);
  CHECK(one.norm() > 1e-3);
  CHECK((one - two).norm() < 1e-5 * one.norm());  // the inertia of the hub, which is not none
}
