// Several rotors on a support: what files say of them, and what is refused.

#include <doctest/doctest.h>

#include <string>

#include "models/reader/spatial/model_check.h"
#include "models/tree/tree.h"
#include "tests/models/inline_toml.h"
#include "tests/models/reader/check_message.h"
#include "tests/models/reader/spatial_texts.h"
#include "tests/models/space_model.h"

using namespace spoke;
using spoke::test::check_edits;

namespace {

// Line numbers of messages refer to this text.
const std::string kRotorsText = R"(world = "space"
[support]
from = "free"
mass = 5.0
inertia = 1.0
[[support.body]]
name = "boom"
kind = "rigid"
mass = 1.0
inertia = 0.1
[[support.joint]]
name = "root"
child = "boom"
kind = "fixed"
[[rotor]]
name = "main"
[rotor.hub]
mass = 1.0
drive = { kind = "constant", speed = 30.0 }
[rotor.axle]
body = "fuselage"
offset = [0.0, 0.0, 1.0]
[rotor.blade]
count = 3
length = 8.0
[rotor.blade.sections]
mass_per_length = 2.0
axial_stiffness = 2e7
flap_stiffness = 2e3
lag_stiffness = 2e4
torsion_stiffness = 2e3
[[rotor]]
name = "tail"
[rotor.hub]
axis = [0.0, 1.0, 0.0]
mass = 0.5
drive = { kind = "free", initial_speed = 100.0 }
[rotor.axle]
body = "boom"
offset = [-6.0, 0.0, 0.5]
[[subsystem]]
name = "paddle"
rotor = "tail"
[[subsystem.body]]
name = "one"
kind = "rigid"
mass = 0.2
inertia = 0.1
[[subsystem.joint]]
parent = "hub"
child = "one"
kind = "fixed"
[[hub_load]]
rotor = "tail"
force = [0.0, 9.0, 0.0]
[integration]
duration = 20.0
)";

/// Checks the message of a model filled in code that `change` spoils.
template <class Change>
void check_model_message(const Change& change, const std::string& expected) {
  spatial::Model model = test::space_model(kRotorsText);
  change(model);
  test::check_message(test::message_of([&] { spatial::check_model(model); }), expected);
}

}  // namespace

TEST_CASE("rotors have their hubs, axles, blades, subsystems and loads") {
  const spatial::Model model = test::space_model(kRotorsText);
  CHECK_NOTHROW(spatial::check_model(model));
  REQUIRE(count_rotors(model) == 2);
  CHECK(hub_of(model, 0).name == "main");
  CHECK(hub_of(model, 1).axis == spatial::Vector::UnitY());
  CHECK(axle_of(model, 0).body.empty());
  CHECK(axle_of(model, 1).offset == spatial::Vector(-6.0, 0.0, 0.5));
  CHECK(model.blades.size() == 3);
  for (const spatial::Blade& blade : model.blades) CHECK(blade.rotor == 0);
  CHECK(model.subsystems[0].rotor == 1);
  CHECK(model.hub_loads[0].rotor == 1);
}

TEST_CASE("a support's tree ends with the hubs of its rotors, on their axles") {
  const std::vector<spatial::Tree> trees = build_trees(test::space_model(kRotorsText));
  REQUIRE(trees.size() == 5);
  CHECK(trees[3].rotor == 1);
  const spatial::Tree& support = trees.back();
  REQUIRE(support.bodies.size() == 3);
  CHECK(find_hub(support, 0) == 1);
  CHECK(support.bodies[1].name == "hub");
  CHECK(support.bodies[1].joint.name == "axle");
  CHECK(support.bodies[1].parent == -1);
  CHECK(find_hub(support, 1) == 2);
  CHECK(support.bodies[2].name == "tail.hub");
  CHECK(support.bodies[2].joint.name == "tail.axle");
  CHECK(support.bodies[2].parent == 0);
}

TEST_CASE("what a scenario with rotors says, written and read again, is the same") {
  const Scenario scenario = parse_scenario(kRotorsText, "f.toml");
  const std::string json = scenario.to_json();
  CHECK(json.find("\"tail\"") != std::string::npos);
  CHECK(parse_scenario(test::document_of(json), scenario.name).to_json() == json);
}

TEST_CASE("rotors that cannot be are refused") {
  check_edits(
      kRotorsText,
      {
          {"world = \"space\"\n", "world = \"space\"\nhub = { inertia = 1.0 }\n",
           "f.toml:2:7: hub: given along with [[rotor]], expected only one of them"},
          {"[integration]", "[blade]\nlength = 1.0\n[integration]",
           "f.toml:56:1: blade: given along with [[rotor]], expected only one of them"},
          {"[[rotor]]\nname = \"main\"", "[support.axle]\n[[rotor]]\nname = \"main\"",
           "f.toml:15:1: support.axle: given along with [[rotor]], expected [rotor.axle]"},
          {"name = \"tail\"", "name = \"main\"",
           "f.toml:33:8: rotor.2.name: is \"main\" as another rotor's, expected a name of its own"},
          {"name = \"tail\"\n", "", "f.toml:32:1: rotor.2.name: is missing, expected a name"},
          {"body = \"boom\"", "body = \"bom\"",
           "f.toml:39:8: rotor.2.axle.body: is \"bom\", did you mean \"boom\"?"},
          {"mass = 0.5", "mass = -0.5",
           "f.toml:36:8: rotor.2.hub.mass: is -0.5, expected a number of 0 or more (kg)"},
          {"mass = 0.5", "mass = 0.5\nmount = { translation = { rate = [1.0, 0.0, 0.0] } }",
           "f.toml:37:9: rotor.2.hub.mount: moves the ground, expected none of a support that is "
           "free"},
          {"rotor = \"tail\"\n[[subsystem.body]]", "rotor = \"tale\"\n[[subsystem.body]]",
           "f.toml:43:9: subsystem.1.rotor: is \"tale\", did you mean \"tail\"?"},
          {"rotor = \"tail\"\nforce", "rotor = \"third\"\nforce",
           "f.toml:54:9: hub_load.1.rotor: is \"third\", expected \"main\" or \"tail\""},
          {"[[hub_load]]",
           "[[subsystem.loop]]\nname = \"link\"\nkind = \"distance\"\nfrom = { body = \"one\" }\n"
           "to = { anchor = \"plate\" }\n[[anchor]]\nname = \"plate\"\nframe = "
           "\"hub\"\n[[hub_load]]",
           "f.toml:57:17: subsystem.1.loop.1.to.anchor: is \"plate\", an anchor of another "
           "rotor; expected one of its own, \"hub\" or a body"},
          {"[[hub_load]]",
           "[[anchor]]\nname = \"plate\"\nframe = \"hub\"\nrotor = \"tale\"\n[[hub_load]]",
           "f.toml:56:9: anchor.1.rotor: is \"tale\", did you mean \"tail\"?"},
          {"[[hub_load]]",
           "[[anchor]]\nname = \"plate\"\nframe = \"axle\"\nrotor = \"tail\"\n[[hub_load]]",
           "f.toml:55:9: anchor.1.frame: is \"axle\", but no drive prescribes the hub's angle, so "
           "that its forces would turn the hub; expected a drive that does, or \"hub\""},
          {"name = \"root\"", "name = \"tail.axle\"",
           "f.toml:12:8: support.joint.1.name: is \"tail.axle\", which is the axle of a rotor; "
           "expected another name"},
      });
}

TEST_CASE("a rotor is named only where there are several") {
  std::string text = kRotorsText.substr(0, kRotorsText.find("[[rotor]]"));
  text += "[support.axle]\nbody = \"boom\"\n[hub]\nmass = 1.0\ndrive = { kind = \"fixed\" }\n" +
          kRotorsText.substr(kRotorsText.find("[[hub_load]]"));
  check_edits(text, {{"force = [0.0, 9.0, 0.0]", "force = [0.0, 8.0, 0.0]",
                      "f.toml:21:9: hub_load.1.rotor: is \"tail\", but there is no [[rotor]]"}});
}

TEST_CASE("rotors filled in code are checked by their keys") {
  check_model_message(
      [](spatial::Model& model) { model.rotors[0].hub.name.clear(); },
      "rotor.2.name: is \"\", expected letters, digits, \"_\", \"-\" and \".\", 1 to 64 of them");
  check_model_message([](spatial::Model& model) { model.blades[1].rotor = 2; },
                      "blades.2.rotor: is 2, expected a whole number from 0 to 1");
  check_model_message([](spatial::Model& model) { model.subsystems[0].rotor = -1; },
                      "subsystem.1.rotor: is -1, expected a whole number from 0 to 1");
  check_model_message(
      [](spatial::Model& model) {
        model.rotors[0].hub.mass = 0.0;
        model.subsystems[0].rotor = 0;
      },
      "rotor.2.hub.mass: is 0, expected a number greater than 0 (kg) of a hub that moves on a "
      "support and carries nothing");
}

namespace {

/// A third rotor, on what the second one carries.
const std::string kNestedText = [] {
  std::string text = kRotorsText;
  return text.insert(text.find("[[hub_load]]"), R"([[rotor]]
name = "top"
hub = { inertia = 1e-6, drive = { kind = "fixed" } }
axle = { subsystem = "paddle", body = "one", offset = [0.0, 0.2, 0.0] }
[[subsystem]]
name = "leaf"
rotor = "top"
body = [ { name = "two", kind = "rigid", mass = 0.2, inertia = 0.1 } ]
joint = [ { parent = "hub", child = "two", kind = "fixed" } ]
)");
}();

}  // namespace

TEST_CASE("a rotor may stand on a subsystem of one before it") {
  const Scenario scenario = parse_scenario(kNestedText, "f.toml");
  const spatial::Model& model = *scenario.space;
  CHECK(axle_of(model, 2).subsystem == "paddle");
  CHECK(find_rotors_on(model, "support") == std::vector{0, 1});
  CHECK(find_rotors_on(model, "paddle") == std::vector{2});
  const std::vector<spatial::Tree> trees = build_trees(model);
  const spatial::BodyAt hub = find_hub(trees, 2);
  CHECK(trees[hub.tree].name == "paddle");
  CHECK(trees[hub.tree].bodies[hub.body].name == "top.hub");
  CHECK(trees[hub.tree].bodies[hub.body].joint.name == "top.axle");
  // The tail's axle is at (-6, 0, 0.5); its hub's frame has z along y.
  const spatial::Placement placed = find_hub_placement(model, trees, 2);
  CHECK((placed.position - spatial::Vector(-6.0, 0.2, 0.5)).norm() < 1e-12);
  const std::string json = scenario.to_json();
  CHECK(parse_scenario(test::document_of(json), scenario.name).to_json() == json);
}

TEST_CASE("rotors on subsystems that cannot be are refused") {
  check_edits(
      kNestedText,
      {
          {"subsystem = \"paddle\"", "subsystem = \"padle\"",
           "f.toml:56:22: rotor.3.axle.subsystem: is \"padle\", did you mean \"paddle\"?"},
          {"subsystem = \"paddle\", body = \"one\"", "subsystem = \"leaf\", body = \"two\"",
           "f.toml:56:22: rotor.3.axle.subsystem: is \"leaf\", which the hub of \"top\" carries; "
           "expected a subsystem of a rotor before this one"},
          {"body = \"one\", offset", "offset",
           "f.toml:56:8: rotor.3.axle.body: is missing, expected the name of the body that carries "
           "the axle"},
          {"body = \"one\", offset", "body = \"fuselage\", offset",
           "f.toml:56:39: rotor.3.axle.body: is \"fuselage\", expected \"one\""},
          {"body = \"fuselage\"\n", "subsystem = \"paddle\"\nbody = \"one\"\n",
           "f.toml:21:13: rotor.1.axle.subsystem: is \"paddle\", but the first rotor stands on the "
           "support; expected none"},
          {"inertia = 1e-6, ", "",
           "f.toml:55:7: rotor.3.hub.inertia: is missing, expected that of a hub on a subsystem "
           "(kg "
           "m^2); of one that is but a place next to none, as 1e-6"},
          {"[integration]",
           "[[load]]\nsubsystem = \"paddle\"\nbody = \"top.hub\"\nforce = [1, 0, 0]\n[integration]",
           "f.toml:67:8: load.1.body: is \"top.hub\", expected a body of the subsystem; "
           "[[hub_load]] "
           "acts on the hub"},
          {"[integration]",
           "[[support.coupling]]\nname = \"c\"\njoints = [{ joint = \"tail.axle\", ratio = 1 }, { "
           "blade "
           "= \"next\", joint = \"b\", ratio = 1 }]\n[integration]",
           "f.toml:67:57: support.coupling.1.joints.2.blade: is \"next\", but no blade comes "
           "before "
           "it; expected a whole number from 1 to 3"},
          {"child = \"one\"\n", "child = \"one\"\nname = \"top.axle\"\n",
           "f.toml:52:8: subsystem.1.joint.1.name: is \"top.axle\", which is the axle of a rotor; "
           "expected another name"},
      });
  check_model_message(
      [](spatial::Model& model) { model.support->axle.subsystem = "paddle"; },
      "support.axle.subsystem: is \"paddle\", but the first rotor stands on the support; expected "
      "none");
}
