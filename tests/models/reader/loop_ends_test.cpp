// Loops that end on another blade or subsystem: read, written again and refused.

#include "models/reader/spatial/loop_ends.h"

#include <doctest/doctest.h>

#include <string>

#include "models/reader/scenario_check.h"
#include "models/system/spatial_system.h"
#include "models/tree/tree.h"
#include "tests/message_of.h"
#include "tests/models/inline_toml.h"

using namespace spoke;
using spoke::test::document_of;
using spoke::test::message_of;

namespace {

const std::string kThreeBlades =
    "world='space'\n[hub]\ninertia=1\n[hub.drive]\nkind='constant'\nspeed=1\n"
    "[blade]\ncount=3\nlength=2\nbodies=1\nelements=2\nsections={ mass_per_length=1,"
    " axial_stiffness=1e4, flap_stiffness=50, lag_stiffness=80, torsion_stiffness=50,"
    " flap_inertia=1e-3, lag_inertia=1e-3 }\n";
const std::string kTwoArms =
    "[[subsystem]]\nname='arm'\ncount=2\nbody=[ { name='rod', kind='rigid', mass=1, inertia=1 } ]\n"
    "joint=[ { parent='hub', child='rod', kind='revolute', axis=[0,0,1] } ]\n";
const std::string kShort = "[integration]\nduration=1\n";

/// The blades with a loop of each to a place, on line 17.
std::string with_end_at(const std::string& to) {
  return kThreeBlades + "[[blade.loop]]\nname='tie'\nkind='distance'\nfrom={ station=1 }\nto={ " +
         to + " }\n" + kTwoArms + kShort;
}

Scenario read_end(const std::string& to) { return parse_scenario(with_end_at(to), "f.toml"); }
const LoopPlace& end_of_blade(const Scenario& scenario, std::size_t blade) {
  return scenario.space->blades.at(blade).loops.at(0).to;
}

std::string error_at_end(const std::string& to) {
  return message_of([&] { read_end(to); });
}

}  // namespace

TEST_CASE("the next blade is a number, behind the last the first") {
  const Scenario scenario = read_end("blade='next', station=0.5, point=[0,0.1,0]");
  for (std::size_t i = 0; i < 3; ++i) {
    const LoopPlace& to = end_of_blade(scenario, i);
    CHECK(to.carrier == LoopPlace::Carrier::elsewhere);
    CHECK(to.blade == static_cast<int>((i + 1) % 3 + 1));
    CHECK(to.station == 0.5);
    CHECK(to.point == spatial::Vector(0, 0.1, 0));
  }
}

TEST_CASE("an end on a subsystem is by its name, and 'next' that of the copies of a count") {
  CHECK(end_of_blade(read_end("subsystem='arm2', body='rod', point=[1,0,0]"), 0).subsystem ==
        "arm2");
  const std::string ring =
      kThreeBlades + kTwoArms +
      "loop=[ { name='tie', kind='distance', from={ body='rod', point=[1,0,0] },"
      " to={ subsystem='next', body='rod', point=[0.5,0,0] } } ]\n" +
      kShort;
  const Scenario scenario = parse_scenario(ring, "f");
  CHECK(scenario.space->subsystems.at(0).loops.at(0).to.subsystem == "arm2");
  CHECK(scenario.space->subsystems.at(1).loops.at(0).to.subsystem == "arm1");
}

TEST_CASE("ends elsewhere are written, and read as they were") {
  for (const char* to : {"blade='next', station=0.5, point=[0,0.1,0]", "blade='next'",
                         "subsystem='arm1', body='rod', point=[1,0,0]"}) {
    CAPTURE(to);
    const Scenario scenario = read_end(to);
    const std::string document = document_of(scenario.to_json());
    CHECK(document_of(parse_scenario(document, "again").to_json()) == document);
  }
}

TEST_CASE("an end elsewhere makes a node there, and a share of the loop") {
  const Scenario scenario = read_end("blade='next', station=0.7, point=[0,0.1,0]");
  const std::vector<spatial::Tree> trees = build_trees(*scenario.space);
  REQUIRE(trees.at(1).ends.size() == 1);
  CHECK(trees[1].ends[0].tree == 0);
  const auto& part = std::get<spatial::FlexibleBody>(trees[1].bodies[0].shape);
  CHECK(part.nodes.at(trees[1].ends[0].place.node) == 0.7);
  const System<Space> system = make_system(*scenario.space, trees);
  REQUIRE(system.shared_loops.size() == 3);
  CHECK(system.shared_loops[0].own.subsystem == 0);
  CHECK(system.shared_loops[0].ends.front().subsystem == 1);
  CHECK(system.subsystems[1].loops.at(1).is_share);
  CHECK(system.subsystems[1].loops.at(1).name == "blade 1 / tie");
}

TEST_CASE("bad ends elsewhere are told with their place") {
  CHECK(error_at_end("blade=4") ==
        "f.toml:17:12: blade.loop.1.to.blade: is 4, expected a whole number from 1 to 3, or "
        "\"next\"");
  CHECK(error_at_end("blade='last'") ==
        "f.toml:17:12: blade.loop.1.to.blade: is \"last\", expected \"next\"");
  CHECK(error_at_end("blade=2, subsystem='arm1'") ==
        "f.toml:17:12: blade.loop.1.to.blade: given along with subsystem, expected only one of "
        "them");
  CHECK(error_at_end("blade=2, anchor='a'") ==
        "f.toml:17:22: blade.loop.1.to.anchor: given along with blade, expected only one of them");
  CHECK(error_at_end("blade=2, station=3") ==
        "f.toml:17:23: blade.loop.1.to.station: is 3, expected a number from 0 to 2 (m, from "
        "root to tip)");
  CHECK(error_at_end("blade=2, point=[0,1,0]") ==
        "f.toml:17:21: blade.loop.1.to.point: is on a beam, expected station along with it, from "
        "whose axis it is");
  CHECK(error_at_end("subsystem='leg', body='rod'") ==
        "f.toml:17:16: blade.loop.1.to.subsystem: is \"leg\", expected \"arm1\" or \"arm2\"");
  CHECK(error_at_end("subsystem='arm1', body='bar'") ==
        "f.toml:17:29: blade.loop.1.to.body: is \"bar\", expected \"rod\"");
}

TEST_CASE("an end on a subsystem names a body") {
  CHECK(error_at_end("subsystem='arm1'") ==
        "f.toml:17:4: blade.loop.1.to.body: is missing, expected the name of one of the subsystem");
}

TEST_CASE("models filled in code: an end on the tree itself, and a loop that begins elsewhere") {
  Scenario scenario = read_end("blade='next'");
  scenario.space->blades[0].loops[0].to.blade = 1;
  CHECK(message_of([&] { check_scenario(scenario); }) ==
        "blades.1.loop.1.to.blade: is that of the loop itself, expected none");
  scenario = read_end("blade='next'");
  scenario.space->blades[2].loops[0].from.carrier = LoopPlace::Carrier::elsewhere;
  CHECK(message_of([&] { check_scenario(scenario); }) ==
        "blades.3.loop.1.from: is on no body, expected a place on one; what carries the other end "
        "belongs to \"to\"");
}
