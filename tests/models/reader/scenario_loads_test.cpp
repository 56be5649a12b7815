// Tables of loads, and kinds of drives: values read, and faults refused in one line with their
// place.

#include "models/reader/scenario_loads.h"

#include <doctest/doctest.h>

#include <nlohmann/json.hpp>

#include "models/scenario.h"
#include "spoke/error.h"
#include "tests/message_of.h"

using namespace spoke;
using spoke::test::message_of;

namespace {

const std::string kFreeHub = R"(title = "t"
[hub]
radius = 0.1
[hub.drive]
kind = "free"
[blade]
count = 3
length = 8.0
density = 2766.67
area = 7.299e-5
second_moment = 8.214e-9
youngs_modulus = 6.895e10
[integration]
duration = 0.1
)";

Scenario parse_loads(const std::string& text, const Overrides& overrides = {}) {
  return parse_scenario(text, "f.toml", overrides);
}

struct LoadCase {
  std::string addition;
  std::string message;
};

void check_refused_loads(const std::vector<LoadCase>& cases) {
  for (const LoadCase& c : cases)
    CHECK(message_of<InputError>([&] { parse_loads(kFreeHub + c.addition + '\n'); }) == c.message);
}

/// Returns the text with another drive.
std::string with_drive(const std::string& drive) {
  const std::string free = "kind = \"free\"";
  std::string text = kFreeHub;
  return text.replace(text.find(free), free.size(), drive);
}

}  // namespace

TEST_CASE("loads of every kind are read, and written back as they were") {
  const std::string loads =
      "[gravity]\nacceleration = [0, -9.81]\nramp = 2\n"
      "[[load]]\nposition = 2.3\nforce = [0, 1]\nramp = 0.5\n"
      "[[distributed_load]]\nblade = 2\nfrom = 1\nto = 3.5\nframe = 'section'\n"
      "force_per_length = [1, 2]\nmoment_per_length = 3\nramp = 4\ntime = [0, 1]\nfactor = [1, 2]\n"
      "[[drag]]\nrelative_to = 'hub'\nlinear = 1\nquadratic = 2\nposition = 5\n"
      "[[drag]]\nlinear_per_length = 3\nquadratic_per_length = 4\nfrom = 2\n"
      "[[hub_load]]\nposition = [1, 2]\nframe = 'inertial'\nforce = [3, 4]\ntorque = 5\nramp = 6\n";
  const Rotor rotor = parse_loads(kFreeHub + loads).rotor;
  CHECK(rotor.gravity_ramp == 2.0);
  CHECK(rotor.loads.at(0).position == 2.3);
  CHECK(rotor.loads[0].ramp == 0.5);
  const DistributedLoad& distributed = rotor.distributed_loads.at(0);
  CHECK(distributed.blade.number() == 2);
  CHECK(distributed.from == 1.0);
  CHECK(distributed.to == 3.5);
  CHECK(distributed.frame == LoadFrame::section);
  CHECK(distributed.force_per_length == Position(1.0, 2.0));
  CHECK(distributed.moment_per_length == 3.0);
  CHECK(distributed.ramp == 4.0);
  CHECK(distributed.factor.value(1.0) == 2.0);
  const Drag& point = rotor.drags.at(0);
  CHECK(point.blade.is_all());
  CHECK(point.relative_to == DragFrame::hub);
  CHECK(point.linear == 1.0);
  CHECK(point.quadratic == 2.0);
  CHECK(point.position == 5.0);
  const Drag& along = rotor.drags.at(1);
  CHECK(along.relative_to == DragFrame::inertial);
  CHECK(along.linear_per_length == 3.0);
  CHECK(along.quadratic_per_length == 4.0);
  CHECK(along.from == 2.0);
  CHECK_FALSE(along.to.has_value());
  const HubLoad& hub = rotor.hub_loads.at(0);
  CHECK(hub.position == Position(1.0, 2.0));
  CHECK(hub.frame == LoadFrame::inertial);
  CHECK(hub.force == Position(3.0, 4.0));
  CHECK(hub.torque == 5.0);
  CHECK(hub.ramp == 6.0);

  const auto json = nlohmann::json::parse(parse_loads(kFreeHub + loads).to_json());
  CHECK(json["gravity"]["ramp"] == 2.0);
  CHECK(json["load"][0]["position"] == 2.3);
  CHECK(json["distributed_load"][0]["to"] == 3.5);
  CHECK(json["drag"][0]["position"] == 5.0);
  CHECK(json["drag"][1]["quadratic_per_length"] == 4.0);
  CHECK(json["hub_load"][0]["torque"] == 5.0);
}

TEST_CASE("what has no new loads is written as before") {
  const auto json =
      nlohmann::json::parse(parse_loads(kFreeHub + "[[load]]\nmoment = 1\n").to_json());
  for (const char* key : {"distributed_load", "drag", "hub_load"}) CHECK_FALSE(json.contains(key));
  CHECK_FALSE(json["gravity"].contains("ramp"));
  CHECK_FALSE(json["load"][0].contains("ramp"));
}

TEST_CASE("keys of loads are overridden on the command line") {
  const Scenario scenario =
      parse_loads(kFreeHub + "[[drag]]\nlinear = 1\n",
                  {"drag.1.linear=2", "distributed_load.1.force_per_length=[0,3]", "gravity.ramp=4",
                   "hub_load.1={torque=5, ramp=6}", "hub.drive={kind=\"constant\", speed=7}"});
  CHECK(scenario.rotor.drags.at(0).linear == 2.0);
  CHECK(scenario.rotor.distributed_loads.at(0).force_per_length.y() == 3.0);
  CHECK(scenario.rotor.gravity_ramp == 4.0);
  CHECK(scenario.rotor.hub_loads.at(0).ramp == 6.0);
  CHECK(std::get<ConstantSpeed>(scenario.rotor.hub.drive).speed == 7.0);
}

TEST_CASE("drives that stand, turn evenly or have a torque by speed are read") {
  CHECK(std::holds_alternative<FixedDrive>(
      parse_loads(with_drive("kind = 'fixed'")).rotor.hub.drive));
  const Scenario motor = parse_loads(with_drive(
      "kind = 'torque_by_speed'\nspeed = [-1, 3]\ntorque = [8, 0]\ninitial_speed = 2\nramp = 5"));
  const auto drive = std::get<TorqueBySpeed>(motor.rotor.hub.drive);
  CHECK(drive.torque.value(1.0) == 4.0);
  CHECK(drive.initial_speed == 2.0);
  CHECK(drive.ramp == 5.0);
  const auto json = nlohmann::json::parse(motor.to_json())["hub"]["drive"];
  CHECK(json["kind"] == "torque_by_speed");
  CHECK(json["speed"] == nlohmann::json({-1.0, 3.0}));
  CHECK(json["torque"] == nlohmann::json({8.0, 0.0}));
}

TEST_CASE("distributed loads with more points than a machine could hold are refused") {
  CHECK(message_of<InputError>([] {
          parse_loads(kFreeHub + "[[distributed_load]]\nforce_per_length = [0, 1]\n",
                      {"blade.bodies=50000"});
        }) ==
        "f.toml:15:1: distributed_load.1: makes 2400003 points (loads x blades x times) with "
        "those before it, expected at most 2000000");
}

TEST_CASE("bad tables of gravity's ramp and point loads are refused") {
  check_refused_loads({
      {"[gravity]\nramp = -1",
       "f.toml:16:8: gravity.ramp: is -1, expected a number of 0 or more (s)"},
      {"[gravity]\nramp = \"slow\"",
       "f.toml:16:8: gravity.ramp: is \"slow\", expected a number of 0 or more (s)"},
      {"[gravity]\nrmap = 1", "f.toml:16:1: gravity.rmap: unknown key, did you mean \"ramp\"?"},
      {"[[load]]\nforce=[0,1]\nramp = -2",
       "f.toml:17:8: load.1.ramp: is -2, expected a number of 0 or more (s)"},
      {"[[load]]\nforce=[0,1]\nramp = inf",
       "f.toml:17:8: load.1.ramp: is inf, expected a finite number (s)"},
      {"[[load]]\nforce=[0,1]\npositon=3",
       "f.toml:17:1: load.1.positon: unknown key, did you mean \"position\"?"},
      {"[[load]]\nforce=[0,1]\nblade=0",
       "f.toml:17:7: load.1.blade: is 0, expected a whole number from 1 to 3"},
      {"[[load]]\nforce=[0,1]\nblade=-1",
       "f.toml:17:7: load.1.blade: is -1, expected a whole number from 1 to 3"},
      {"[[load]]\nforce=[0,1]\nblade=1.0",
       "f.toml:17:7: load.1.blade: is 1.0, expected a whole number from 1 to 3"},
  });
}

TEST_CASE("bad tables of loads per length are refused") {
  check_refused_loads({
      {"[[distributed_load]]\n",
       "f.toml:15:1: distributed_load.1: has neither force_per_length nor moment_per_length, "
       "expected force_per_length = [x, y] or moment_per_length = M"},
      {"[[distributed_load]]\nforce_per_length = 3",
       "f.toml:16:20: distributed_load.1.force_per_length: is 3, expected an array of 2 numbers "
       "(N/m)"},
      {"[[distributed_load]]\nforce=[0,1]",
       "f.toml:16:1: distributed_load.1.force: unknown key, expected \"from\", \"to\", \"frame\", "
       "\"force_per_length\", \"moment_per_length\", \"blade\", \"name\", \"ramp\", \"time\" or "
       "\"factor\""},
      {"[[distributed_load]]\nforce_per_length=[0,1]\nfrom=9",
       "f.toml:17:6: distributed_load.1.from: is 9, expected a number from 0 to 8 (m, from root to "
       "tip of the blade)"},
      {"[[distributed_load]]\nforce_per_length=[0,1]\nfrom=-1",
       "f.toml:17:6: distributed_load.1.from: is -1, expected a number from 0 to 8 (m, from root "
       "to tip of the blade)"},
      {"[[distributed_load]]\nforce_per_length=[0,1]\nfrom=8",
       "f.toml:17:6: distributed_load.1.from: is 8, expected less than the blade's length, 8 (m)"},
      {"[[distributed_load]]\nforce_per_length=[0,1]\nfrom=4\nto=4",
       "f.toml:18:4: distributed_load.1.to: is 4, expected a number greater than 4 and at most 8 "
       "(m, beyond from, up to the blade's tip)"},
      {"[[distributed_load]]\nforce_per_length=[0,1]\nfrom=4\nto=3",
       "f.toml:18:4: distributed_load.1.to: is 3, expected a number greater than 4 and at most 8 "
       "(m, beyond from, up to the blade's tip)"},
      {"[[distributed_load]]\nforce_per_length=[0,1]\nto=8.1",
       "f.toml:17:4: distributed_load.1.to: is 8.1, expected a number greater than 0 and at most 8 "
       "(m, beyond from, up to the blade's tip)"},
      {"[[distributed_load]]\nforce_per_length=[0,1]\nto=0",
       "f.toml:17:4: distributed_load.1.to: is 0, expected a number greater than 0 and at most 8 "
       "(m, beyond from, up to the blade's tip)"},
      {"[[distributed_load]]\nforce_per_length=[0,1]\nframe=\"blade\"",
       "f.toml:17:7: distributed_load.1.frame: is \"blade\", expected \"inertial\", \"hub\" or "
       "\"section\""},
      {"[[distributed_load]]\nforce_per_length=[0,1e31]",
       "f.toml:16:21: distributed_load.1.force_per_length.2: is 1e+31, expected 0 or a magnitude "
       "from 1e-40 to 1e+30 (N/m)"},
      {"[[distributed_load]]\nmoment_per_length=nan",
       "f.toml:16:19: distributed_load.1.moment_per_length: is nan, expected a finite number (N)"},
      {"[[distributed_load]]\nforce_per_length=[0,1]\nposition=3",
       "f.toml:17:1: distributed_load.1.position: unknown key, expected \"from\", \"to\", "
       "\"frame\", \"force_per_length\", \"moment_per_length\", \"blade\", \"name\", \"ramp\", "
       "\"time\" or "
       "\"factor\""},
      {"[[distributed_load]]\nforce_per_length=[0,1]\nfactor=[1,2]",
       "f.toml:15:1: distributed_load.1.time: is missing, expected an array of numbers (s)"},
      {"[[distributed_load]]\nforce_per_length=[0,1]\nfactor=[1,2]\ntime=[0,1,2]",
       "f.toml:17:8: distributed_load.1.factor: has 2 numbers, expected 3, one for each of "
       "distributed_load.1.time"},
      {"[distributed_load]\nforce_per_length=[0,1]",
       "f.toml:15:1: distributed_load: is a table, expected tables headed [[distributed_load]]"},
      {"[[distributed_loads]]\nforce_per_length=[0,1]",
       "f.toml:15:3: distributed_loads: unknown key, did you mean \"distributed_load\"?"},
  });
}

TEST_CASE("bad tables of drag are refused") {
  check_refused_loads({
      {"[[drag]]",
       "f.toml:15:1: drag.1: has no coefficient, expected \"linear\", \"quadratic\", "
       "\"linear_per_length\" or \"quadratic_per_length\""},
      {"[[drag]]\nlinear=-1",
       "f.toml:16:8: drag.1.linear: is -1, expected a number of 0 or more (N s/m)"},
      {"[[drag]]\nquadratic=\"x\"",
       "f.toml:16:11: drag.1.quadratic: is \"x\", expected a number of 0 or more (N s^2/m^2)"},
      {"[[drag]]\nlinear=1\nfrom=2",
       "f.toml:17:6: drag.1.from: would be ignored, expected only with \"linear_per_length\" or "
       "\"quadratic_per_length\""},
      {"[[drag]]\nlinear=1\nto=2",
       "f.toml:17:4: drag.1.to: would be ignored, expected only with \"linear_per_length\" or "
       "\"quadratic_per_length\""},
      {"[[drag]]\nlinear_per_length=1\nposition=2",
       "f.toml:17:10: drag.1.position: would be ignored, expected only with \"linear\" or "
       "\"quadratic\""},
      {"[[drag]]\nlinear=1\nposition=8.5",
       "f.toml:17:10: drag.1.position: is 8.5, expected a number from 0 to 8 (m, from root to tip "
       "of the blade)"},
      {"[[drag]]\nlinear=1\nrelative_to=\"air\"",
       "f.toml:17:13: drag.1.relative_to: is \"air\", expected \"inertial\" or \"hub\""},
      {"[[drag]]\nlinear=1\nblade=\"both\"",
       "f.toml:17:7: drag.1.blade: is \"both\", expected \"all\""},
      {"[[drag]]\nqadratic=1",
       "f.toml:16:1: drag.1.qadratic: unknown key, did you mean \"quadratic\"?"},
      {"[[drag]]\nquadratic_per_length=1\nfrom=5\nto=2",
       "f.toml:18:4: drag.1.to: is 2, expected a number greater than 5 and at most 8 (m, beyond "
       "from, up to the blade's tip)"},
      {"[[drag]]\nlinear=1\nframe=\"hub\"",
       "f.toml:17:1: drag.1.frame: unknown key, did you mean \"from\"?"},
  });
}

TEST_CASE("bad tables of loads on the hub are refused") {
  check_refused_loads({
      {"[[hub_load]]",
       "f.toml:15:1: hub_load.1: has neither force nor torque, expected force = [x, y] or torque = "
       "M"},
      {"[[hub_load]]\nforce=[1]",
       "f.toml:16:7: hub_load.1.force: is an array (1), expected an array of 2 numbers (N)"},
      {"[[hub_load]]\nforce=[1,0]\nframe=\"section\"",
       "f.toml:17:7: hub_load.1.frame: is \"section\", expected \"hub\" or \"inertial\""},
      {"[[hub_load]]\ntorque=1\nposition=[0,1]",
       "f.toml:17:10: hub_load.1.position: would be ignored, expected only with \"force\""},
      {"[[hub_load]]\ntorque=[1,2]",
       "f.toml:16:8: hub_load.1.torque: is an array (2), expected a number (N m)"},
      {"[[hub_load]]\nforce=[1,0]\nposition=1",
       "f.toml:17:10: hub_load.1.position: is 1, expected an array of 2 numbers (m)"},
      {"[[hub_load]]\nmoment=2",
       "f.toml:16:1: hub_load.1.moment: unknown key, expected \"name\", \"position\", \"frame\", "
       "\"force\", "
       "\"torque\", \"ramp\", \"time\" or \"factor\""},
      {"[[hub_load]]\ntorque=2\nblade=1",
       "f.toml:17:1: hub_load.1.blade: unknown key, expected \"name\", \"position\", \"frame\", "
       "\"force\", "
       "\"torque\", \"ramp\", \"time\" or \"factor\""},
      {"[[hub_load]]\ntorque=2\nramp=-0.1",
       "f.toml:17:6: hub_load.1.ramp: is -0.1, expected a number of 0 or more (s)"},
      {"[[hub_load]]\ntorque=2\ntime=[1,1]\nfactor=[1,1]",
       "f.toml:17:9: hub_load.1.time.2: is 1, expected more than the value before it, 1"},
  });
}

TEST_CASE("bad drives are refused") {
  const std::vector<LoadCase> cases{
      {"kind=\"fixed\"\nspeed=1",
       "f.toml:6:7: hub.drive.speed: does not belong to kind \"fixed\", expected only with kind "
       "\"spin_up\", \"spin_up_hold_spin_down\", \"table\", \"constant\" or \"torque_by_speed\""},
      {"kind=\"fixd\"",
       "f.toml:5:6: hub.drive.kind: is \"fixd\", expected \"spin_up\", \"spin_up_hold_spin_down\", "
       "\"torque\", \"free\", \"table\", \"fixed\", \"constant\" or \"torque_by_speed\""},
      {"kind=\"constant\"", "f.toml:4:1: hub.drive.speed: is missing, expected a number (rad/s)"},
      {"kind=\"constant\"\nspeed=\"fast\"",
       "f.toml:6:7: hub.drive.speed: is \"fast\", expected a number (rad/s)"},
      {"kind=\"constant\"\nspeed=1\nramp=2",
       "f.toml:7:6: hub.drive.ramp: does not belong to kind \"constant\", expected only with kind "
       "\"spin_up\", \"spin_up_hold_spin_down\" or \"torque_by_speed\""},
      {"kind=\"torque_by_speed\"",
       "f.toml:4:1: hub.drive.speed: is missing, expected an array of numbers (rad/s)"},
      {"kind=\"torque_by_speed\"\nspeed=[0,1]",
       "f.toml:4:1: hub.drive.torque: is missing, expected an array of numbers (N m)"},
      {"kind=\"torque_by_speed\"\nspeed=[0,1]\ntorque=[1]",
       "f.toml:7:8: hub.drive.torque: has 1 number, expected 2, one for each of hub.drive.speed"},
      {"kind=\"torque_by_speed\"\nspeed=[1,0]\ntorque=[1,2]",
       "f.toml:6:10: hub.drive.speed.2: is 0, expected more than the value before it, 1"},
      {"kind=\"torque_by_speed\"\nspeed=[0,1]\ntorque=3",
       "f.toml:7:8: hub.drive.torque: is 3, expected an array of numbers (N m)"},
      {"kind=\"torque_by_speed\"\nspeed=[0,1]\ntorque=[1,2]\ntime=[0,1]",
       "f.toml:8:6: hub.drive.time: does not belong to kind \"torque_by_speed\", expected only "
       "with kind \"torque\" or \"table\""},
      {"kind=\"torque_by_speed\"\nspeed=[0,1]\ntorque=[1,nan]",
       "f.toml:7:11: hub.drive.torque.2: is nan, expected a finite number (N m)"},
      {"kind=\"torque_by_speed\"\nspeed=[0,1]\ntorque=[1,2]\nramp=-1",
       "f.toml:8:6: hub.drive.ramp: is -1, expected a number of 0 or more (s)"},
      {"kind=\"torque\"\ntorque=1\nramp=1",
       "f.toml:7:6: hub.drive.ramp: does not belong to kind \"torque\", expected only with kind "
       "\"spin_up\", \"spin_up_hold_spin_down\" or \"torque_by_speed\""},
      {"kind=\"constant\"\nspeed=1\ninitial_speed=1",
       "f.toml:7:15: hub.drive.initial_speed: does not belong to kind \"constant\", expected only "
       "with kind \"torque\", \"free\" or \"torque_by_speed\""},
  };
  for (const LoadCase& c : cases)
    CHECK(message_of<InputError>([&] { parse_loads(with_drive(c.addition)); }) == c.message);
}
