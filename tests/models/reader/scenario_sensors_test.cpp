// Reading of [[sensor]] tables, and messages for invalid ones.

#include "models/reader/scenario_sensors.h"

#include <doctest/doctest.h>

#include <string>
#include <vector>

#include "models/error.h"

using namespace spoke;

namespace {

const std::string kBeforeSensors = R"([hub.drive]
kind = "free"
[blade]
length = 8.0
density = 2766.67
area = 7.299e-5
second_moment = 8.214e-9
youngs_modulus = 6.895e10
[[blades]]
[[blades]]
length = 6.0
bodies = 3
[integration]
duration = 1.0
)";

Scenario read_sensors(const std::string& sensors, const Overrides& overrides = {}) {
  return parse_scenario(kBeforeSensors + sensors, "f.toml", overrides);
}

std::string error_of_sensors(const std::string& sensors, const Overrides& overrides = {}) {
  try {
    read_sensors(sensors, overrides);
  } catch (const InputError& error) {
    return error.what();
  }
  return "accepted";
}

}  // namespace

TEST_CASE("sensors are read with their defaults") {
  const Scenario scenario = read_sensors(R"([[sensor]]
quantity = "velocity"
[[sensor]]
name = "mid-span"
quantity = "section_force"
blade = 2
position = 3
[[sensor]]
quantity = "joint_reaction"
blade = "all"
joint = 2
frame = "inertial"
)");
  REQUIRE(scenario.sensors.size() == 3);
  const Sensor& velocity = scenario.sensors[0];
  CHECK(velocity.quantity == SensorQuantity::velocity);
  CHECK(velocity.name == "velocity");
  CHECK(velocity.blade.is_all());
  CHECK(!velocity.position);
  CHECK(frame_of(velocity) == SensorFrame::hub);
  const Sensor& force = scenario.sensors[1];
  CHECK(force.blade.number() == 2);
  CHECK(force.position == 3.0);
  CHECK(frame_of(force) == SensorFrame::section);
  CHECK(prefix_of(force, 1) == "blade2.mid-span");
  CHECK(scenario.sensors[2].joint->number() == 2);
  CHECK(frame_of(scenario.sensors[2]) == SensorFrame::inertial);
}

TEST_CASE("keys of sensors can be overridden, and stand in the JSON of the scenario") {
  const Scenario scenario = read_sensors("[[sensor]]\nquantity = \"displacement\"\n",
                                         {"sensor.1.position=2.5", "sensor.1.blade=1",
                                          "sensor.2={quantity=\"momentum\", name=\"whole\"}"});
  REQUIRE(scenario.sensors.size() == 2);
  CHECK(scenario.sensors[0].position == 2.5);
  CHECK(scenario.sensors[0].blade.number() == 1);
  const std::string json = scenario.to_json();
  CHECK(json.find(R"("name": "displacement",
      "quantity": "displacement",
      "blade": 1,
      "position": 2.5,
      "frame": "hub")") != std::string::npos);
  CHECK(json.find(R"("name": "whole",
      "quantity": "momentum"
    })") != std::string::npos);
}

TEST_CASE("bad sensors are refused in one line that says where and why") {
  const std::string at = "f.toml:15:1: sensor.1", first = "[[sensor]]\n";
  const std::vector<std::pair<std::string, std::string>> cases{
      {"", at + ".quantity: is missing, expected what is measured, as quantity = \"velocity\""},
      {"quantity = \"speed\"\n",
       "f.toml:16:12: sensor.1.quantity: is \"speed\", expected \"displacement\", \"velocity\", "
       "\"acceleration\", \"section_force\", \"joint_reaction\", \"hub_reaction\", \"momentum\", "
       "\"blade_momentum\", \"kinetic_energy\", \"loop_reaction\", \"loop_opening\" or "
       "\"strain_energy\""},
      {"quantity = \"velocity\"\npositon = 2\n",
       "f.toml:17:1: sensor.1.positon: unknown key, did you mean \"position\"?"},
      {"quantity = \"velocity\"\nposition = 7\n",
       "f.toml:17:12: sensor.1.position: is 7, expected a number from 0 to 6 (m, from root to tip "
       "of the blade)"},
      {"quantity = \"velocity\"\nblade = 3\n",
       "f.toml:17:9: sensor.1.blade: is 3, expected a whole number from 1 to 2"},
      {"quantity = \"velocity\"\nframe = \"section\"\n",
       "f.toml:17:9: sensor.1.frame: is \"section\", expected \"hub\", \"blade\" or \"inertial\""},
      {"quantity = \"velocity\"\njoint = 1\n",
       "f.toml:17:9: sensor.1.joint: does not belong to quantity \"velocity\", expected only with "
       "quantity \"joint_reaction\""},
      {"quantity = \"momentum\"\nblade = 1\n",
       "f.toml:17:9: sensor.1.blade: does not belong to quantity \"momentum\", expected only with "
       "quantity \"displacement\", \"velocity\", \"acceleration\", \"section_force\", "
       "\"joint_reaction\", \"blade_momentum\", \"kinetic_energy\", \"loop_reaction\", "
       "\"loop_opening\" or \"strain_energy\""},
      {"quantity = \"section_force\"\n",
       at + ".position: is missing, expected a number from 0 to 6 (m, from root to tip of the "
            "blade)"},
      {"quantity = \"joint_reaction\"\njoint = 4\n",
       "f.toml:17:9: sensor.1.joint: is 4, expected a whole number from 1 to 3"},
      {"quantity = \"velocity\"\nname = \"a b\"\n",
       "f.toml:17:8: sensor.1.name: is \"a b\", expected letters, digits, \"_\", \"-\" and \".\", "
       "1 to 64 of them"},
      {"quantity = \"displacement\"\nname = \"tip\"\n",
       "f.toml:17:8: sensor.1.name: there is a column blade1.tip.x already, expected a name of its "
       "own"},
      {"quantity = \"velocity\"\n[[sensor]]\nquantity = \"velocity\"\nblade = 2\n",
       "f.toml:17:1: sensor.2: there is a column blade2.velocity.x already, expected a name of its "
       "own"}};
  for (const auto& [text, expected] : cases) CHECK(error_of_sensors(first + text) == expected);
  CHECK(error_of_sensors("[sensor]\nquantity = \"velocity\"\n") ==
        "f.toml:15:1: sensor: is a table, expected tables headed [[sensor]]");
}

TEST_CASE("a system's column can be taken only once as well") {
  CHECK(error_of_sensors("[[sensor]]\nquantity = \"hub_reaction\"\nname = \"hub\"\n") ==
        "f.toml:17:8: sensor.1.name: there is a column hub.x already, expected a name of its own");
  CHECK(error_of_sensors("[[sensor]]\nquantity = \"hub_reaction\"\nname = \"blade1.velocity\"\n"
                         "[[sensor]]\nquantity = \"kinetic_energy\"\nname = \"velocity.x\"\n") ==
        "f.toml:20:8: sensor.2.name: there is a column blade1.velocity.x already, expected a name "
        "of its own");
}
