// Couplings of joints as files have them: what is read, written again and refused.

#include <doctest/doctest.h>

#include <string>

#include "models/scenario.h"
#include "models/system/spatial_system.h"
#include "tests/contains.h"
#include "tests/models/inline_toml.h"
#include "tests/models/reader/spatial_texts.h"

using namespace spoke;
using namespace spoke::test;

namespace {

const std::string kGears = R"(world = "space"
[hub.drive]
kind = "fixed"
[[subsystem]]
name = "gears"
body = [
  { name = "a", kind = "rigid", mass = 1, inertia = 1 },
  { name = "b", kind = "rigid", mass = 1, inertia = 1 },
  { name = "c", kind = "rigid", mass = 1, inertia = 1 },
  { name = "d", kind = "rigid", mass = 1, inertia = 1 },
]
joint = [
  { name = "ja", parent = "hub", child = "a", kind = "cylindrical", axis = [0, 0, 1] },
  { name = "jb", parent = "hub", child = "b", kind = "revolute", axis = [0, 0, 1] },
  { name = "ball", parent = "hub", child = "c", kind = "spherical" },
  { name = "pad", parent = "hub", child = "d", kind = "bushing", stiffness = [9, 0, 0, 0, 0, 9] },
]
[[subsystem.coupling]]
name = "screw"
stiffness = 100.0
damping = 2.0
[[subsystem.coupling.joints]]
joint = "ja"
coordinate = 2
ratio = 1.0
[[subsystem.coupling.joints]]
joint = "jb"
ratio = -0.02
[[sensor]]
quantity = "coupling_force"
subsystem = "gears"
coupling = "screw"
[integration]
duration = 1.0
)";

}  // namespace

TEST_CASE("a coupling is read, and written as JSON that reads the same") {
  const Scenario scenario = parse_scenario(kGears, "f");
  const Coupling& screw = scenario.space->subsystems[0].couplings.at(0);
  CHECK(screw.name == "screw");
  CHECK(screw.stiffness == 100.0);
  CHECK(screw.damping == 2.0);
  REQUIRE(screw.joints.size() == 2);
  CHECK(screw.joints[0].joint == "ja");
  CHECK(screw.joints[0].coordinate == 2);
  CHECK(screw.joints[1].coordinate == 1);
  CHECK(screw.joints[1].ratio == -0.02);
  CHECK(scenario.sensors.at(0).coupling == "screw");
  const std::string json = scenario.to_json();
  CHECK(contains(json, "\"coupling\": \"screw\""));
  CHECK(contains(json, "\"ratio\": -0.02"));
}

TEST_CASE("couplings that cannot be are refused") {
  const std::string blade_sensor =
      "[[sensor]]\nquantity = \"velocity\"\nsubsystem = \"gears\"\nbody = \"a\"\ncoupling = "
      "\"screw\"\n[integration]";
  check_edits(
      kGears,
      {
          {"joint = \"jb\"\n", "joint = \"jc\"\n",
           "f.toml:27:9: subsystem.1.coupling.1.joints.2.joint: is \"jc\", did you mean \"ja\"?"},
          {"joint = \"jb\"\n", "",
           "f.toml:26:1: subsystem.1.coupling.1.joints.2.joint: is missing, expected a name"},
          {"joint = \"jb\"\n", "joint = \"ball\"\n",
           "f.toml:27:9: subsystem.1.coupling.1.joints.2.joint: is \"ball\", of kind "
           "\"spherical\", expected one whose coordinates are angles about axes, or ways"},
          {"joint = \"jb\"\n", "joint = \"pad\"\ncoordinate = 2\n",
           "f.toml:28:14: subsystem.1.coupling.1.joints.2.coordinate: is 2, which joint \"pad\" "
           "holds, expected a direction in which the bushing moves"},
          {"coordinate = 2", "coordinate = 3",
           "f.toml:24:14: subsystem.1.coupling.1.joints.1.coordinate: is 3, expected 1 to 2, the "
           "coordinates of joint \"ja\""},
          {"ratio = -0.02", "ratio = 0.0",
           "f.toml:28:9: subsystem.1.coupling.1.joints.2.ratio: is 0, expected a number other than "
           "0"},
          {"ratio = -0.02", "",
           "f.toml:26:1: subsystem.1.coupling.1.joints.2.ratio: is missing, expected a number (1, "
           "1/rad, 1/m)"},
          {"joint = \"jb\"\n", "joint = \"ja\"\ncoordinate = 2\n",
           "f.toml:27:9: subsystem.1.coupling.1.joints.2.joint: is the same coordinate as another "
           "one of the coupling"},
          {"[[subsystem.coupling.joints]]\njoint = \"jb\"\nratio = -0.02\n", "",
           "f.toml:22:1: subsystem.1.coupling.1.joints: has 1 of the two or more coordinates that "
           "it is to couple"},
          {"stiffness = 100.0\n", "",
           "f.toml:20:11: subsystem.1.coupling.1.damping: is given without stiffness, expected "
           "both "
           "or none"},
          {"stiffness = 100.0", "stiffness = -1",
           "f.toml:20:13: subsystem.1.coupling.1.stiffness: is -1, expected a number of 0 or more "
           "(N "
           "m/rad, N/m)"},
          {"name = \"screw\"\n", "",
           "f.toml:18:1: subsystem.1.coupling.1.name: is missing, expected a name"},
          {"coupling = \"screw\"", "coupling = \"skrew\"",
           "f.toml:32:12: sensor.1.coupling: is \"skrew\", did you mean \"screw\"?"},
          {"coupling = \"screw\"\n", "",
           "f.toml:29:1: sensor.1.coupling: is missing, expected the name of a coupling"},
          {"[integration]", blade_sensor,
           "f.toml:37:12: sensor.2.coupling: does not belong to quantity \"velocity\", expected "
           "only "
           "with quantity \"coupling_force\""},
      });
}

TEST_CASE(
    "couplings whose coordinates are all prescribed, and rigid ones at high radii, are refused") {
  const std::string driven = "motion = { time = [0, 1], value = [0, 1] }";
  const std::string both = edited(
      edited(kGears, "kind = \"revolute\", axis = [0, 0, 1]",
             "kind = \"revolute\", axis = [0, 0, 1], " + driven),
      "kind = \"cylindrical\", axis = [0, 0, 1]",
      "kind = \"cylindrical\", axis = [0, 0, 1], motion = [{}, { time = [0, 1], value = [0, 1] }]");
  CHECK(contains(message_of([&both] { parse_scenario(both, "f"); }),
                 "subsystem.1.coupling.1.joints: are all prescribed, expected one that is free"));
  const std::string rigid = edited(edited(kGears, "stiffness = 100.0\ndamping = 2.0\n", ""),
                                   "duration = 1.0", "duration = 1.0\nspectral_radius = 1.0");
  CHECK(contains(message_of([&rigid] { parse_scenario(rigid, "f"); }),
                 "expected at most 0.95 with rigid couplings"));
}

namespace {

/// A second subsystem, whose coupling has a joint of the first one.
const std::string kAcross = [] {
  std::string text = kGears;
  return text.insert(text.find("[[sensor]]"), R"([[subsystem]]
name = "shaft"
body = [ { name = "s", kind = "rigid", mass = 1, inertia = 1 } ]
joint = [ { name = "js", parent = "hub", child = "s", kind = "revolute", axis = [0, 0, 1] } ]
coupling = [ { name = "mesh", joints = [ { joint = "js", ratio = 1 },
  { subsystem = "gears", joint = "jb", ratio = -3 } ] } ]
)");
}();

}  // namespace

TEST_CASE("a coupling may have joints of other subsystems") {
  const Scenario scenario = parse_scenario(kAcross, "f");
  const Coupling& mesh = scenario.space->subsystems[1].couplings.at(0);
  CHECK(mesh.joints[0].subsystem.empty());
  CHECK(mesh.joints[1].subsystem == "gears");
  const System<Space> system = make_system(*scenario.space);
  REQUIRE(system.shared_loops.size() == 1);
  CHECK(system.shared_loops[0].own.subsystem == 1);
  REQUIRE(system.shared_loops[0].ends.size() == 1);
  const LoopModel& share = system.subsystems[0].loops.at(1);
  CHECK(share.is_share);
  CHECK(share.coupled.at(0).ratio == -3.0);
  CHECK(share.name == "shaft / mesh");
  const std::string json = scenario.to_json();
  CHECK(parse_scenario(document_of(json), scenario.name).to_json() == json);
}

TEST_CASE("couplings with joints of other subsystems that cannot be are refused") {
  check_edits(
      kAcross,
      {
          {"subsystem = \"gears\", joint", "subsystem = \"gear\", joint",
           "f.toml:34:17: subsystem.2.coupling.1.joints.2.subsystem: is \"gear\", did you mean "
           "\"gears\"?"},
          {"subsystem = \"gears\", joint", "subsystem = \"shaft\", joint",
           "f.toml:34:17: subsystem.2.coupling.1.joints.2.subsystem: is that of the coupling "
           "itself, expected none"},
          {"subsystem = \"gears\", joint", "blade = 1, joint",
           "f.toml:34:13: subsystem.2.coupling.1.joints.2.blade: is given, but there are no "
           "blades"},
          {"subsystem = \"gears\", joint", "blade = \"next\", joint",
           "f.toml:34:13: subsystem.2.coupling.1.joints.2.blade: is given, but there are no "
           "blades"},
          {"joint = \"jb\", ratio = -3", "joint = \"jd\", ratio = -3",
           "f.toml:34:34: subsystem.2.coupling.1.joints.2.joint: is \"jd\", did you mean \"ja\"?"},
          {"{ joint = \"js\", ratio = 1 }", "{ subsystem = \"gears\", joint = \"ja\", ratio = 1 }",
           "f.toml:33:40: subsystem.2.coupling.1.joints: are all elsewhere, expected one of the "
           "blade or subsystem itself"},
      });
}
