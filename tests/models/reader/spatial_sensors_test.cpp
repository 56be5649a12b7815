// Sensors on models in space: values read, and messages for invalid ones.

#include <doctest/doctest.h>

#include <string>

#include "models/scenario.h"
#include "tests/models/reader/spatial_texts.h"

using namespace spoke;
using spoke::test::check_edits;
using spoke::test::kBladeText;
using spoke::test::kTreeText;

namespace {

std::string with(const std::string& keys) { return "[[sensor]]\n" + keys + "\n[integration]\n"; }

}  // namespace

TEST_CASE("sensors of models in space are read and written back") {
  const std::string sensors =
      "[[sensor]]\nname = \"mid\"\nquantity = \"section_force\"\nblade = 2\nposition = 4.0\n"
      "frame = \"hub\"\n[[sensor]]\nquantity = \"joint_reaction\"\njoint = 3\n";
  const Scenario scenario = parse_scenario(kBladeText + sensors, "f.toml");
  REQUIRE(scenario.sensors.size() == 2);
  CHECK(scenario.sensors[0].position == 4.0);
  CHECK(scenario.sensors[0].blade.number() == 2);
  CHECK(scenario.sensors[0].frame == SensorFrame::hub);
  CHECK(scenario.sensors[1].joint->number() == 3);
  const Scenario tree = parse_scenario(
      kTreeText + "[[sensor]]\nquantity = \"velocity\"\nsubsystem = \"arm\"\nbody = \"mirror\"\n",
      "f.toml");
  CHECK(tree.sensors[0].subsystem == "arm");
  CHECK(tree.sensors[0].body == "mirror");
  CHECK(tree.to_json().find("\"body\": \"mirror\"") != std::string::npos);
}

TEST_CASE("sensors on blades in space that cannot be are refused") {
  const std::string at = "[integration]\n";
  check_edits(
      kBladeText,
      {
          {at, with("quantity = \"mass\""),
           "f.toml:34:12: sensor.1.quantity: is \"mass\", expected \"displacement\", \"velocity\", "
           "\"acceleration\", \"section_force\", \"joint_reaction\", \"hub_reaction\", "
           "\"momentum\", \"blade_momentum\", \"kinetic_energy\", \"loop_reaction\", "
           "\"loop_opening\", \"interface_force\", "
           "\"von_mises\", \"air_flow\", \"air_load\", \"strain_energy\", \"coupling_force\" or "
           "\"wind\""},
          {at, with("quantity = \"wind\""),
           "f.toml:34:12: sensor.1.quantity: is \"wind\", but there is no air, expected [air]"},
          {at, with("quantity = \"section_force\""),
           "f.toml:33:1: sensor.1.position: is missing, expected a distance from the root (m)"},
          {at, with("quantity = \"velocity\"\nposition = 8.5"),
           "f.toml:35:12: sensor.1.position: is 8.5, expected a number from 0 to 8 (m, from root "
           "to tip)"},
          {at, with("quantity = \"velocity\"\nblade = 4"),
           "f.toml:35:9: sensor.1.blade: is 4, expected a whole number from 1 to 3"},
          {at, with("quantity = \"velocity\"\nbody = \"boom\""),
           "f.toml:35:8: sensor.1.body: would be ignored, expected only along with subsystem"},
          {at, with("quantity = \"velocity\"\nsubsystem = \"arm\""),
           "f.toml:35:13: sensor.1.subsystem: is \"arm\", but there is no [[subsystem]]"},
          {at, with("quantity = \"joint_reaction\"\njoint = 99"),
           "f.toml:35:9: sensor.1.joint: is 99, expected a whole number from 1 to 6"},
          {at, with("quantity = \"velocity\"\nframe = \"section\""),
           "f.toml:35:9: sensor.1.frame: is \"section\", expected \"hub\", \"blade\" or "
           "\"inertial\""},
          {at, with("quantity = \"kinetic_energy\"\nname = \"flap\""),
           "f.toml:35:8: sensor.1.name: there is a column blade1.flap already, expected a name of "
           "its own"},
      });
}

TEST_CASE("sensors on subsystems that cannot be are refused") {
  const std::string at = "[integration]\n";
  const std::string arm = "subsystem = \"arm\"\n";
  check_edits(
      kTreeText,
      {
          {at, with("quantity = \"velocity\""),
           "f.toml:32:1: sensor.1: is on blades, of which there are none; expected subsystem and "
           "body"},
          {at, with(arm + "quantity = \"velocity\""),
           "f.toml:32:1: sensor.1.body: is missing, expected the name of one of the subsystem"},
          {at, with(arm + "quantity = \"velocity\"\nbody = \"bom\""),
           "f.toml:35:8: sensor.1.body: is \"bom\", did you mean \"boom\"?"},
          {at, with(arm + "quantity = \"section_force\"\nbody = \"mirror\"\nposition = 1.0"),
           "f.toml:35:8: sensor.1.body: is rigid, expected a beam"},
          {at, with(arm + "quantity = \"velocity\"\nbody = \"mirror\"\nposition = 1.0"),
           "f.toml:36:12: sensor.1.position: belongs to beams; of a rigid body it is the origin of "
           "its frame"},
          {at, with(arm + "quantity = \"joint_reaction\"\nbody = \"mirror\"\njoint = 1"),
           "f.toml:36:9: sensor.1.joint: belongs to blades; of a body it is the one that carries "
           "it"},
          {at, with(arm + "quantity = \"momentum\""),
           "f.toml:33:13: sensor.1.subsystem: does not belong to quantity \"momentum\", expected "
           "none"},
          {at, with(arm + "quantity = \"kinetic_energy\"\nbody = \"boom\""),
           "f.toml:35:8: sensor.1.body: does not belong to quantity \"kinetic_energy\", expected "
           "the subsystem alone"},
      });
}
