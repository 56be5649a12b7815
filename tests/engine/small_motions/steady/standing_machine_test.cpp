// Machines at rest as a whole: the same as one tree, and as rotors and support that are taken
// apart.

#include "engine/small_motions/steady/standing_machine.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "engine/equilibrium.h"
#include "engine/linearize.h"
#include "engine/modes.h"
#include "engine/simulation.h"
#include "engine/small_motions/steady/linear_model.h"
#include "engine/small_motions/steady/linear_support.h"
#include "engine/small_motions/steady/supported_model.h"
#include "engine/small_motions/vibration/coupled_roots.h"
#include "tests/engine/bodies/space/system/levels.h"
#include "tests/engine/loops/tied_arms.h"
#include "tests/engine/small_motions/vibration/rotors_on_carrier.h"
#include "tests/message_of.h"

namespace spoke {
namespace {

using doctest::Approx;
using test::LevelsCase;
using test::make_levels;
using test::make_one_level;
using test::message_of;
using test::with_dummy;

const std::string kArmSprings = ", stiffness=[60,50], damping=[1,1]";
const std::string kHingeSprings = ", stiffness=40, damping=0.5";

/// Cases on a bushing whose hinges have springs.
std::vector<LevelsCase> list_standing() {
  const LevelsCase plain{.support = test::kOnBush,
                         .damping = kHingeSprings,
                         .drive = "fixed",
                         .is_at_rest = true,
                         .arm = kArmSprings};
  std::vector<LevelsCase> cases(5, plain);
  cases[1].loops =
      "{ name='rod', kind='distance', from={ body='leaf', point=[0.2,0,0] }, to={ TO(arm)"
      "body='arm', point=[0.2,0,0.1] } }";
  cases[2].loops =
      "{ name='s', from={ body='leaf', point=[0.2,0,0] }, to={ TO(boom)body='boom', station=0.4 },"
      " kind='spherical', stiffness=80, damping=1 }, { name='u', from={ body='leaf',"
      " point=[0,0.1,0] }, to={ TO(support)body='stage', point=[0,0,0.3] },"
      " kind='distance', stiffness=40, damping=2 }";
  cases[3].couplings =
      "{ name='gear', joints=[ { joint='leaf', ratio=1 }, { TO(arm)joint='arm', coordinate=2,"
      " ratio=0.5 }, { TO(twig)joint='twig', ratio=0.2 } ] }";
  cases[4].loops = cases[1].loops;
  cases[4].couplings =
      cases[3].couplings.substr(0, cases[3].couplings.size() - 2) + ", stiffness=50, damping=1 }";
  return cases;
}

std::vector<std::complex<double>> list_roots(const ModesResult& found) {
  std::vector<std::complex<double>> list;
  for (const Mode& mode : found.modes) list.push_back(mode.eigenvalue);
  return list;
}

}  // namespace

TEST_CASE("a machine at rest: equilibrium and modes of levels are those of the same in one tree") {
  for (const LevelsCase& of : list_standing()) {
    CAPTURE(of.loops);
    CAPTURE(of.couplings);
    const Scenario apart =
        parse_scenario(make_levels(of, "ground", test::kLevelsWeight), "levels.toml");
    const Scenario together =
        parse_scenario(with_dummy(make_one_level(of, "ground", test::kLevelsWeight)), "one.toml");
    const EquilibriumResult found = solve_equilibrium(apart, {});
    const EquilibriumResult expected = solve_equilibrium(together, {});
    REQUIRE(found.blades.size() == 5);
    REQUIRE(found.rotors.size() == 3);
    CHECK(found.rotors[1].name == "middle");
    // The leaf's hinge, the first of its subsystem, is one of many in the tree.
    const auto leaf =
        std::find_if(expected.blades.back().joints.begin(), expected.blades.back().joints.end(),
                     [](const JointPosition& joint) { return joint.name == "leaf"; });
    REQUIRE(leaf != expected.blades.back().joints.end());
    CHECK(found.blades[3].joints[0].value == Approx(leaf->value).epsilon(1e-8).scale(1e-2));
    CHECK(std::abs(leaf->value) > 1e-3);
    const auto roots = list_roots(solve_modes(apart, {.count = 12}));
    const auto same = list_roots(solve_modes(together, {.count = 12}));
    REQUIRE(roots.size() == same.size());
    for (std::size_t k = 0; k < roots.size(); ++k) {
      CAPTURE(k);
      CHECK(std::abs(roots[k] - same[k]) < 1e-5 * (1.0 + std::abs(same[k])));
    }
  }
}

TEST_CASE("a machine at rest: what hubs bear is what a run at rest shows") {
  LevelsCase of = list_standing()[2];
  const std::string text = make_levels(of, "ground", test::kLevelsWeight);
  const EquilibriumResult found = solve_equilibrium(parse_scenario(text, "levels.toml"), {});
  Simulation run(parse_scenario(text + "[initial]\nstate='equilibrium'\n[[sensor]]\nname='reaction'"
                                       "\nquantity='hub_reaction'\nframe='hub'\n",
                                "levels.toml"));
  for (int k = 0; k < 20; ++k) run.step();
  for (int c = 0; c < 3; ++c) {
    const std::string axis(1, static_cast<char>('x' + c));
    CAPTURE(axis);
    CHECK(found.hub_force[c] ==
          Approx(run.sensor("reaction.force." + axis)).epsilon(1e-5).scale(1.0));
    CHECK(found.hub_moment[c] ==
          Approx(run.sensor("reaction.moment." + axis)).epsilon(1e-5).scale(1.0));
  }
}

TEST_CASE("a machine at rest: as a whole it has the modes of rotors and support taken apart") {
  using test::RotorText;
  for (const std::string& drive :
       {std::string("{ kind = \"fixed\" }"), std::string("{ kind = \"free\" }")}) {
    CAPTURE(drive);
    const Scenario scenario = test::make_on_carrier(
        test::kSprings,
        {{.name = "left", .place = "[0.5, 0, 0.3]", .blades = 3, .drive = drive},
         {.name = "right", .place = "[-0.5, 0.2, 0.3]", .blades = 2, .drive = drive}},
        "[gravity]\nacceleration = [0.0, 0.0, -9.81]\n");
    const ModesResult apart = solve_modes(scenario, {.count = 14, .frame = ModeFrame::turning});
    const auto whole = steady::make_standing(scenario, {}, {});
    REQUIRE(whole->subsystems() == 1);
    const steady::Equilibrium equilibrium = steady::find_equilibrium(*whole);
    const steady::LinearModel linear = steady::linearize(equilibrium, *whole);
    const vibration::Pencil pencil(linear, {0});
    const std::vector<vibration::Root> roots = vibration::find_roots(pencil, 14);
    REQUIRE(roots.size() == 14);
    for (std::size_t k = 0; k < roots.size(); ++k) {
      CAPTURE(k);
      CHECK(std::abs(roots[k].s.imag()) ==
            Approx(apart.modes[k].frequency).epsilon(1e-6).scale(1.0));
    }
  }
}

TEST_CASE("a machine at rest: a swashplate beside the axle, and a coupling on it") {
  // A blade is held by a rod to an anchor beside its axle: with a spring in the flap hinge of k and
  // a stiff rod at the arm a, the hinge's stiffness is k + s a^2.
  const double inertia = 0.2, spring = 50.0, rod = 4e4, arm = 0.1;
  const auto make = [&](const std::string& frame, double stiffness) {
    return parse_scenario(
        "world='space'\n[hub]\ninertia=1\n[hub.drive]\nkind='fixed'\n[support]\n"
        "body=[ { name='mast', kind='rigid', mass=50, inertia=[5,5,5] } ]\n"
        "joint=[ { parent='ground', child='mast', kind='fixed' } ]\naxle={ body='mast' }\n"
        "[[anchor]]\nname='plate'\nframe='" +
            frame +
            "'\n[[subsystem]]\nname='blade'\nbody=[ { name='rod', kind='rigid', mass=1e-9,"
            " inertia=[0.2,0.2,0.2] } ]\njoint=[ { name='flap', parent='hub', child='rod',"
            " kind='revolute', axis=[0,1,0], stiffness=50 } ]\nloop=[ { name='link',"
            " kind='distance', stiffness=" +
            test::number(stiffness) +
            ", from={ body='rod', point=[0.1,0,0] }, to={ anchor='plate', point=[0.1,0,-0.4] } } ]"
            "\n[integration]\nduration=1.0\n",
        "plate.toml");
  };
  for (const std::string frame : {"axle", "hub"}) {
    CAPTURE(frame);
    const ModesResult found = solve_modes(make(frame, rod), {.count = 1});
    CHECK(found.modes[0].frequency ==
          Approx(std::sqrt((spring + rod * arm * arm) / inertia)).epsilon(1e-6));
  }
  // Two free hubs whose axles are geared turn by one spring.
  const std::string geared =
      "world='space'\n[support]\nbody=[ { name='box', kind='rigid', mass=50, inertia=[5,5,5] } ]\n"
      "joint=[ { parent='ground', child='box', kind='fixed' } ]\n"
      "coupling=[ { name='gear', joints=[ { joint='axle', ratio=1 }, { joint='b.axle', ratio=-2 } ]"
      " }, { name='spring', stiffness=30, joints=[ { joint='axle', ratio=1 }, { joint='b.axle',"
      " ratio=1 } ] } ]\n"
      "[[rotor]]\nname='a'\nhub={ mass=1, inertia=0.4, drive={ kind='free' } }\n"
      "axle={ body='box' }\n[[rotor]]\nname='b'\nhub={ mass=1, inertia=0.1, drive={ kind='free' }"
      " }\naxle={ body='box', offset=[0.3,0,0] }\n[integration]\nduration=1.0\n";
  const ModesResult found = solve_modes(parse_scenario(geared, "gear.toml"), {.count = 1});
  REQUIRE(found.modes.size() == 1);
  // The second hub turns by half of the first one's angle.
  CHECK(found.modes[0].frequency ==
        Approx(std::sqrt(30.0 * 1.5 * 1.5 / (0.4 + 0.1 / 4.0))).epsilon(1e-6));
}

TEST_CASE("a machine with tied hubs that turns, or is held by a torque, has no steady state") {
  LevelsCase of = list_standing()[0];
  std::string text = make_levels(of, "ground", test::kLevelsWeight);
  const auto with_drive = [&text](const std::string& drive) {
    return test::replace(text,
                         "name='main'\nhub={ mass=0.5, center=[0.02,0,0], inertia=0.3, "
                         "drive={ kind='fixed' }",
                         "name='main'\nhub={ mass=0.5, center=[0.02,0,0], inertia=0.3, "
                         "drive={ " +
                             drive + " }");
  };
  CHECK(message_of([&] {
          solve_equilibrium(parse_scenario(with_drive("kind='constant', speed=3"), "l.toml"), {});
        }) ==
        "rotor.2.axle.subsystem: is \"boom\", which another rotor carries: while hubs turn it "
        "changes with their azimuths, and a steady state is constant; runs have it, and steady "
        "states at rest");
  CHECK(message_of([&] {
          solve_equilibrium(parse_scenario(with_drive("kind='torque', torque=3"), "l.toml"),
                            {.speed = 0.0});
        }) ==
        "hub.drive: is a torque, expected one that prescribes the motion, or none: nothing says "
        "which torque holds a machine at rest whose hubs are tied");
}

}  // namespace spoke
