// Messages for places of controllers from outside, [control.library] and [control.program].

#include <doctest/doctest.h>

#include <fstream>
#include <string>

#include "models/reader/scenario_check.h"
#include "tests/message_of.h"
#include "tests/models/inline_toml.h"
#include "tests/models/reader/spatial_texts.h"
#include "tests/temporary_folder.h"

using namespace spoke;
using spoke::test::check_edits;
using spoke::test::document_of;
using spoke::test::message_of;

namespace {

// Line numbers of messages refer to this text.
const std::string kProgramText = R"(world = "space"
[hub]
inertia = [2.0, 2.0, 3.0]
[hub.drive]
kind = "torque"
torque = 4.0
[[subsystem]]
name = "vane"
count = 4
[[subsystem.body]]
name = "plate"
kind = "rigid"
mass = 0.5
inertia = 0.5
[[subsystem.joint]]
name = "pitch"
parent = "hub"
child = "plate"
kind = "revolute"
axis = [1, 0, 0]
motion = { constant = 0.0 }
[control.program]
joint = "pitch"
initial = 0.1
sign = -1
direction = -1
brake_torque = 5.0
brake_speed = 0.02
period = 0.0125
[integration]
duration = 20.0
)";

/// Returns the text with a library and its input, which are there.
std::string with_library(const spoke::test::TemporaryFolder& folder, const std::string& keys) {
  for (const char* name : {"controller.so", "DISCON.IN"}) std::ofstream(folder / name) << "x\n";
  std::string text = kProgramText;
  text.replace(text.find("[control.program]"), 17,
               "[control.library]\nfile = \"" + (folder / "controller.so").string() +
                   "\"\ninput = \"" + (folder / "DISCON.IN").string() + "\"\n" + keys);
  return text;
}

}  // namespace

TEST_CASE("what a controller of the program's cannot be given is refused") {
  check_edits(
      kProgramText,
      {
          {"joint = \"pitch\"", "joint = \"pitsh\"",
           "f.toml:23:9: control.program.joint: is \"pitsh\", did you mean \"pitch\"?"},
          {"joint = \"pitch\"", "joints = [\"pitch\", \"pitch\"]",
           "f.toml:23:20: control.program.joints.2: is \"pitch\" as another one, expected each "
           "name once"},
          {"joint = \"pitch\"\n", "", "no error"},
          {"sign = -1", "sign = 0", "f.toml:25:8: control.program.sign: is 0, expected 1 or -1"},
          {"direction = -1", "direction = 0",
           "f.toml:26:13: control.program.direction: is 0, expected 1 or -1"},
          {"brake_torque = 5.0", "brake_torque = -5.0",
           "f.toml:27:16: control.program.brake_torque: is -5.0, expected a number of 0 or more "
           "(N m)"},
          {"brake_speed = 0.02", "brake_speed = 0",
           "f.toml:28:15: control.program.brake_speed: is 0, expected a number greater than 0 "
           "(rad/s)"},
          {"period = 0.0125", "period = 0",
           "f.toml:29:10: control.program.period: is 0, expected a number greater than 0 (s)"},
          {"sign = -1", "yaw_joint = \"yaw\"",
           "f.toml:25:13: control.program.yaw_joint: is \"yaw\", but there is no [support]"},
          {"kind = \"torque\"\ntorque = 4.0", "kind = \"constant\"\nspeed = 4.0",
           "f.toml:22:1: control.program: sets the torque of a drive, but hub.drive.kind is "
           "\"constant\", expected \"torque\""},
          {"[control.program]", "[control]\npitch = {}\n[control.program]",
           "f.toml:24:1: control.program: given along with pitch, expected only one of them"},
      });
}

TEST_CASE("what a library cannot be given is refused") {
  const spoke::test::TemporaryFolder folder;
  const auto refusal = [&](const std::string& keys) {
    const std::string message =
        message_of([&] { parse_scenario(with_library(folder, keys), "f.toml"); });
    const std::size_t key = message.find("control.library");
    return key == std::string::npos ? message : message.substr(key);
  };
  CHECK(refusal("") == "no error");
  CHECK(refusal("individual_pitch = true\n") ==
        "control.library.individual_pitch: is true of 4 blades and subsystems, expected at most 3");
  CHECK(refusal("gear_ratio = 0\n") ==
        "control.library.gear_ratio: is 0, expected a number greater than 0");
  CHECK(refusal("record = [{ number = 0, sensor = \"hub.speed\" }]\n") ==
        "control.library.record.1.number: is 0, expected a whole number from 1 to 10000");
  CHECK(refusal("record = [{ number = 53 }]\n") ==
        "control.library.record.1.sensor: is missing, expected the name of a sensor");
  CHECK(refusal("record = [{ number = 53, sensor = \"a\" }, { number = 53, sensor = \"b\" }]\n") ==
        "control.library.record.2.number: is 53 as of another record, expected each number once");
  std::string text = with_library(folder, "");
  text.replace(text.find("DISCON.IN"), 9, "DISCON.NO");
  CHECK(message_of([&] {
          parse_scenario(text, "f.toml");
        }).ends_with(", expected the file that the library reads"));
  text = with_library(folder, "");
  text.erase(text.find("file = "), text.find("input = ") - text.find("file = "));
  CHECK(message_of([&] { parse_scenario(text, "f.toml"); }) ==
        "f.toml:22:1: control.library.file: is missing, expected a shared library with the "
        "function DISCON");
}

TEST_CASE("controllers from outside are written as they are read") {
  const spoke::test::TemporaryFolder folder;
  for (const std::string& text :
       {kProgramText,
        with_library(folder,
                     "name = \"run1\"\ngear_ratio = 97.0\nefficiency = 0.9\nrecord = [{ number "
                     "= 53, sensor = \"hub.speed\", factor = 2.0 }]\n")}) {
    const Scenario scenario = parse_scenario(text, "f.toml");
    const OuterControl& control = *scenario.space->outer_control;
    CHECK(control.joints == std::vector<std::string>{"pitch"});
    CHECK(control.sign == -1.0);
    CHECK(control.direction == -1.0);
    CHECK(control.brake_speed == 0.02);
    CHECK(*control.period == 0.0125);
    if (control.is_library()) {
      CHECK(*control.gear_ratio == 97.0);
      CHECK(control.name == "run1");
      CHECK(control.records.at(0).number == 53);
      CHECK(control.records.at(0).factor == 2.0);
    }
    const std::string json = scenario.to_json();
    CHECK(parse_scenario(document_of(json), "f.toml").to_json() == json);
  }
}

TEST_CASE("a controller from outside that a program fills in is checked as one of a file") {
  Scenario scenario = parse_scenario(kProgramText, "f.toml");
  scenario.space->pitch_control = PitchControl{
      .joints = {"pitch"}, .speed = 1.0, .proportional = 1.0, .minimum = 0.0, .maximum = 1.0};
  CHECK(message_of([&] { check_scenario(scenario); }) ==
        "control.program: given along with control.pitch, expected only one of them");
  scenario.space->pitch_control.reset();
  scenario.space->outer_control->yaw_joint = "yaw";
  CHECK(message_of([&] { check_scenario(scenario); }) ==
        "control.program.yaw_joint: is \"yaw\", but there is no [support]");
}
