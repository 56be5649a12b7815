// Rotors on what other rotors carry: the same machine in one tree, formulations, laws of
// conservation, executors, and what is drawn and measured.

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

/// What the machine stands on, and what is different about it.
struct LevelsCase {
  std::string support;         ///< table [support], whose body "stage" carries the first axle
  std::string loops{};         ///< closures of the innermost body, whose `to` ends with TO(...)
  std::string damping{};       ///< of hinges
  std::string drive = "free";  ///< of the middle hub
  std::string couplings{};     ///< of the innermost hinge, likewise
};

const std::string kStage =
    "body=[ { name='stage', kind='rigid', mass=9, center=[0.02,0.01,0.1], inertia=[0.4,0.5,0.6] }";
const std::string kOnBush = "[support]\n" + kStage;
const std::string kFlying =
    "[support]\nfrom='free'\nmass=30\ninertia=[2,3,4]\nangular_velocity=[0.1,-0.2,0.3]\n" + kStage;

std::string bush(const std::string& base) {
  return "{ name='bush', parent='" + base +
         "', child='stage', kind='bushing', offset=[0,0,0.3],"
         " stiffness=[4e3,5e3,6e3,2e3,2e3,3e3] }";
}

std::string rigid(const std::string& name, double mass) {
  const std::string size = std::to_string(0.02 * mass);
  return "{ name='" + name + "', kind='rigid', mass=" + std::to_string(mass) +
         ", center=[0.15,0.02,0.01], inertia=[" + size + ',' + size + ',' + size + "] }";
}

const std::string kBoom =
    "{ name='boom', kind='beam', length=1, bodies=1, elements=2, strain='nonlinear',"
    " sections={ mass_per_length=1.5, axial_stiffness=2e4, lag_stiffness=300, flap_stiffness=200,"
    " torsion_stiffness=150 } }";

/// A hinge; what is on the hub of a rotor hangs at 0.2 m from its axis.
std::string hinge(const std::string& parent, const std::string& child, const std::string& more) {
  return "{ name='" + child + "', parent='" + parent + "', child='" + child +
         "', offset=[0.2,0,0.05], " + more + " }";
}

/// The loads act on the innermost level, a sensor looks at it.
std::string finish(const std::string& weight, const std::string& subsystem) {
  return "[[load]]\nsubsystem='" + subsystem +
         "'\nbody='leaf'\nforce=[0,0.4,0.3]\nframe='inertial'\npoint=[0.1,0,0]\n" +
         "[[hub_load]]\nrotor='top'\nforce=[0,0.3,0]\nposition=[0.1,0,0]\n" + weight +
         "[[sensor]]\nname='watched'\nquantity='velocity'\nframe='inertial'\nsubsystem='" +
         subsystem + "'\nbody='leaf'\n[integration]\nstep=1e-3\nduration=1\n";
}

std::string replace(std::string text, const std::string& old, const std::string& made) {
  for (std::size_t at = text.find(old); at != std::string::npos; at = text.find(old, at))
    text.replace(at, old.size(), made);
  return text;
}

const std::string kWeight = "[gravity]\nacceleration=[0.3,0.2,-9.81]\n";

std::string hub(const std::string& name, const std::string& drive, const std::string& axle) {
  return "[[rotor]]\nname='" + name +
         "'\nhub={ mass=0.5, center=[0.02,0,0], inertia=0.3, drive={ " + drive + " } }\naxle={ " +
         axle + " }\n";
}

const std::string kOnStage = "body='stage', offset=[0,0.1,0.4], orientation=[0.2,0.1,0]";
const std::string kOnBoom = "body='boom', station=0.7, offset=[0,0,0.1], orientation=[0,0.4,0]";
const std::string kOnTwig = "body='twig', offset=[0.3,0,0], orientation=[0.5,0,0]";

/// Four levels: the support; an arm and a boom on the hub "main"; a twig on the hub "middle" of the
/// boom; a leaf on the hub "top" of the twig, which is fixed to it.
std::string make_levels(const LevelsCase& of, const std::string& base, const std::string& weight) {
  const auto name_ends = [](const std::string& text) {
    return replace(replace(text, "TO(", "subsystem='"), ")", "', ");
  };
  const std::string loops = name_ends(of.loops), couplings = name_ends(of.couplings);
  return "world='space'\n" + of.support + " ]\njoint=[ " + bush(base) + " ]\n" +
         hub("main", "kind='free', initial_speed=4", kOnStage) +
         hub("middle", "kind='" + of.drive + "'" + (of.drive == "free" ? ", initial_speed=-6" : ""),
             "subsystem='boom', " + kOnBoom) +
         hub("top", "kind='fixed'", "subsystem='twig', " + kOnTwig) +
         "[[subsystem]]\nname='arm'\nrotor='main'\nbody=[ " + rigid("arm", 2) + " ]\njoint=[ " +
         hinge("hub", "arm",
               "orientation=[0,0,2.5], kind='universal', axes=[[0,1,0],[0,0,1]], "
               "initial=[0.02,0.01]") +
         " ]\n[[subsystem]]\nname='boom'\nrotor='main'\nbody=[ " + kBoom + " ]\njoint=[ " +
         hinge("hub", "boom", "kind='fixed'") +
         " ]\n[[subsystem]]\nname='twig'\nrotor='middle'\nbody=[ " + rigid("twig", 1) +
         " ]\njoint=[ " + hinge("hub", "twig", "kind='revolute', axis=[0,1,0]" + of.damping) +
         " ]\n[[subsystem]]\nname='leaf'\nrotor='top'\nbody=[ " + rigid("leaf", 0.4) +
         " ]\njoint=[ " +
         hinge("hub", "leaf",
               "kind='revolute', axis=[0,0,1], initial=0.1, initial_speed=1.2" + of.damping) +
         " ]\n" + (loops.empty() ? "" : "loop=[ " + loops + " ]\n") +
         (couplings.empty() ? "" : "coupling=[ " + couplings + " ]\n") + finish(weight, "leaf");
}

/// The same machine as one tree, that of the support, whose rotor is a body of its own.
std::string make_one(const LevelsCase& of, const std::string& base, const std::string& weight) {
  std::string loops = of.loops, couplings = replace(of.couplings, ".axle", "axle");
  for (const char* name : {"boom", "arm", "twig", "support"})
    for (std::string* text : {&loops, &couplings})
      *text = replace(*text, "TO(" + std::string(name) + ")", "");
  const auto hub_body = [](const std::string& name) {
    return "{ name='" + name + "hub', kind='rigid', mass=0.5, center=[0.02,0,0], inertia=0.3 }";
  };
  const auto axle = [](const std::string& name, const std::string& kind, const std::string& place) {
    return "{ name='" + name + "axle', child='" + name + "hub', " + kind + ", " +
           replace(place, "body=", "parent=") + " }";
  };
  const std::string revolute = "kind='revolute', axis=[0,0,1], ";
  // The hub load of "top" turns with it.
  return "world='space'\n" + of.support + ", " + hub_body("main") + ", " + rigid("arm", 2) + ", " +
         kBoom + ", " + hub_body("middle") + ", " + rigid("twig", 1) + ", " + hub_body("top") +
         ", " + rigid("leaf", 0.4) + " ]\njoint=[ " + bush(base) + ", " +
         axle("main", revolute + "initial_speed=4", kOnStage) + ", " +
         hinge("mainhub", "arm",
               "orientation=[0,0,2.5], kind='universal', axes=[[0,1,0],[0,0,1]], "
               "initial=[0.02,0.01]") +
         ", " + hinge("mainhub", "boom", "kind='fixed'") + ", " +
         axle("middle", of.drive == "free" ? revolute + "initial_speed=-6" : "kind='fixed'",
              kOnBoom) +
         ", " + hinge("middlehub", "twig", "kind='revolute', axis=[0,1,0]" + of.damping) + ", " +
         axle("top", "kind='fixed'", kOnTwig) + ", " +
         hinge("tophub", "leaf",
               "kind='revolute', axis=[0,0,1], initial=0.1, initial_speed=1.2" + of.damping) +
         " ]\n" + (loops.empty() ? "" : "loop=[ " + loops + " ]\n") +
         (couplings.empty() ? "" : "coupling=[ " + couplings + " ]\n") +
         replace(
             finish(weight, "support"), "[[hub_load]]\nrotor='top'\nforce=[0,0.3,0]\nposition",
             "[[load]]\nsubsystem='support'\nbody='tophub'\nframe='body'\nforce=[0,0.3,0]\npoint");
}

/// A hub that adds nothing to speak of, as a model has one at least.
std::string with_dummy(const std::string& text) {
  const std::size_t at = text.find("[[load]]");
  return text.substr(0, at) +
         "[[rotor]]\nname='none'\nhub={ mass=1e-9, inertia=1e-9, drive={ kind='fixed' } }\n"
         "axle={ body='stage' }\n" +
         text.substr(at);
}

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
    const std::string levels = make_levels(of, base_of(of), kWeight);
    const spatial::Model apart = parse_model(levels);
    const spatial::Model together = parse_model(with_dummy(make_one(of, base_of(of), kWeight)));
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
    const System<Space> system = make_system(parse_model(make_levels(of, base_of(of), kWeight)));
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
      const std::string text = is_one ? with_dummy(make_one(of, base_of(of), kWeight))
                                      : make_levels(of, base_of(of), kWeight);
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
      hub("main", "kind='constant', speed=25", "body='post'");
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
