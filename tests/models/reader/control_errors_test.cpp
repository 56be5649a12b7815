// Messages for invalid controllers, from files and from code.

#include <doctest/doctest.h>

#include <limits>
#include <string>

#include "models/reader/scenario_check.h"
#include "tests/message_of.h"
#include "tests/models/inline_toml.h"
#include "tests/models/reader/spatial_texts.h"

using namespace spoke;
using spoke::test::check_edits;
using spoke::test::document_of;
using spoke::test::message_of;

namespace {

// Line numbers of messages refer to this text.
const std::string kControlText = R"(world = "space"
[hub]
mass = 10.0
inertia = [2.0, 2.0, 3.0]
[hub.drive]
kind = "torque"
torque = 4.0
[blade]
count = 3
length = 8.0
[blade.sections]
mass_per_length = 2.0
axial_stiffness = 2e7
flap_stiffness = 2e3
lag_stiffness = 2e4
torsion_stiffness = 2e3
[[blade.joint]]
name = "pitch"
station = 0.0
kind = "revolute"
axis = [1, 0, 0]
motion = { constant = 0.0 }
[[blade.joint]]
name = "flap"
station = 0.5
kind = "revolute"
axis = [0, -1, 0]
stiffness = 4e4
[control.pitch]
joint = "pitch"
speed = 1.2671
proportional = 1.8262
integral = 0.78266
half_gain_angle = 0.11
minimum = 0.0
maximum = 1.5708
rate = 0.1396
filter = 1.57
initial = 0.1
sign = -1
period = 0.0125
[integration]
duration = 20.0
)";

}  // namespace

TEST_CASE("a table of controllers without one is none") {
  const std::string rotor = kControlText.substr(0, kControlText.find("[control.pitch]"));
  CHECK(!parse_scenario(rotor + "[control]\n[integration]\nduration = 1\n", "f.toml")
             .space->pitch_control);
  CHECK(parse_scenario(kControlText, "f.toml").space->pitch_control);
}

TEST_CASE("numbers of a controller that cannot be are refused") {
  check_edits(
      kControlText,
      {
          {"speed = 1.2671\n", "",
           "f.toml:29:1: control.pitch.speed: is missing, expected a number (rad/s)"},
          {"speed = 1.2671", "speed = 0",
           "f.toml:31:9: control.pitch.speed: is 0, expected the set point of a hub that turns "
           "(rad/s)"},
          {"speed = 1.2671", "speed = \"rated\"",
           "f.toml:31:9: control.pitch.speed: is \"rated\", expected a number (rad/s)"},
          {"proportional = 1.8262", "proportional = -1.8",
           "f.toml:32:16: control.pitch.proportional: is -1.8, expected a number of 0 or more (s)"},
          {"proportional = 1.8262\n", "",
           "f.toml:29:1: control.pitch.proportional: is missing, expected a number of 0 or more "
           "(s)"},
          {"integral = 0.78266", "integral = inf",
           "f.toml:33:12: control.pitch.integral: is inf, expected a finite number (rad/rad)"},
          {"proportional = 1.8262\nintegral = 0.78266", "proportional = 0\nintegral = 0",
           "f.toml:33:12: control.pitch.integral: is 0, as proportional is, expected that one of "
           "them is not"},
          {"half_gain_angle = 0.11", "half_gain_angle = 0",
           "f.toml:34:19: control.pitch.half_gain_angle: is 0, expected a number greater than 0 "
           "(rad)"},
          {"minimum = 0.0", "minimum = -0.2",
           "f.toml:34:19: control.pitch.half_gain_angle: is 0.11, expected more than -minimum, "
           "0.2 (rad), at which gains would be infinite"},
          {"minimum = 0.0\n", "",
           "f.toml:29:1: control.pitch.minimum: is missing, expected a number (rad)"},
          {"maximum = 1.5708\n", "",
           "f.toml:29:1: control.pitch.maximum: is missing, expected a number (rad)"},
          {"maximum = 1.5708", "maximum = -0.1",
           "f.toml:36:11: control.pitch.maximum: is -0.1, expected more than minimum, 0 (rad)"},
          {"maximum = 1.5708", "maximum = 90.0", "no error"},
          {"rate = 0.1396", "rate = -0.1396",
           "f.toml:37:8: control.pitch.rate: is -0.1396, expected a number greater than 0 (rad/s)"},
          {"filter = 1.57", "filter = 0",
           "f.toml:38:10: control.pitch.filter: is 0, expected a number greater than 0 (rad/s)"},
          {"initial = 0.1", "initial = 1.6",
           "f.toml:39:11: control.pitch.initial: is 1.6, expected minimum to maximum, 0 to 1.5708 "
           "(rad)"},
          {"sign = -1", "sign = 0", "f.toml:40:8: control.pitch.sign: is 0, expected 1 or -1"},
          {"sign = -1", "sign = -2",
           "f.toml:40:8: control.pitch.sign: is -2, expected a whole number from -1 to 1"},
          {"sign = -1", "sign = \"feather\"",
           "f.toml:40:8: control.pitch.sign: is \"feather\", expected a whole number from -1 to 1"},
          {"period = 0.0125", "period = 0",
           "f.toml:41:10: control.pitch.period: is 0, expected a number greater than 0 (s)"},
      });
}

TEST_CASE("schedules of gains that cannot be are refused") {
  const std::string old = "half_gain_angle = 0.11";
  check_edits(
      kControlText,
      {
          {old, old + "\nschedule = { angle = [0.0, 0.2], factor = [1.0, 0.5] }",
           "f.toml:35:12: control.pitch.schedule: given along with half_gain_angle, expected only "
           "one of them"},
          {old, "schedule = { angle = [0.0, 0.2, 0.1], factor = [1.0, 0.5, 0.4] }",
           "f.toml:34:33: control.pitch.schedule.angle.3: is 0.1, expected more than the value "
           "before it, 0.2"},
          {old, "schedule = { angle = [0.0, 0.2], factor = [1.0] }",
           "f.toml:34:43: control.pitch.schedule.factor: has 1 number, expected 2, one for each "
           "of control.pitch.schedule.angle"},
          {old, "schedule = { angle = [0.0, 0.2], factor = [1.0, 0.0] }",
           "f.toml:34:49: control.pitch.schedule.factor.2: is 0.0, expected a number greater than "
           "0"},
          {old, "schedule = { angle = [0.0, 0.2] }",
           "f.toml:34:12: control.pitch.schedule.factor: is missing, expected an array of numbers"},
          {old, "schedule = { angles = [0.0, 0.2] }",
           "f.toml:34:14: control.pitch.schedule.angles: unknown key, did you mean \"angle\"?"},
      });
}

TEST_CASE("joints that a controller cannot move are refused") {
  check_edits(
      kControlText,
      {
          {"joint = \"pitch\"\n", "",
           "f.toml:29:1: control.pitch.joint: is missing, expected the name of the joint that it "
           "moves on each blade"},
          {"joint = \"pitch\"\n", "joint = \"pich\"\n",
           "f.toml:30:9: control.pitch.joint: is \"pich\", did you mean \"pitch\"?"},
          {"joint = \"pitch\"\n", "joint = \"flap\"\n",
           "f.toml:30:9: control.pitch.joint: names a joint that turns freely on blade 1, expected "
           "one whose motion is prescribed, as by motion = { constant = 0.0 }, to which the angle "
           "is added"},
          {"joint = \"pitch\"\n", "joint = 1\n",
           "f.toml:30:9: control.pitch.joint: is 1, expected text in quotes"},
          {"joint = \"pitch\"\n", "joints = \"pitch\"\n",
           "f.toml:30:10: control.pitch.joints: is \"pitch\", expected an array of values"},
          {"joint = \"pitch\"\n", "joints = [1]\n",
           "f.toml:30:10: control.pitch.joints: is an array (1), expected an array of names of "
           "joints"},
          {"joint = \"pitch\"\n", "joints = [\"pitch\", \"pitch\"]\n",
           "f.toml:30:20: control.pitch.joints.2: is \"pitch\" as another one, expected each name "
           "once"},
          {"joint = \"pitch\"\n", "joint = \"pitch\"\njoints = [\"flap\"]\n",
           "f.toml:31:10: control.pitch.joints: given along with joint, expected only one of "
           "them"},
          {"name = \"pitch\"\n", "",
           "f.toml:29:9: control.pitch.joint: is \"pitch\", expected \"flap\""},
          {"kind = \"revolute\"\naxis = [1, 0, 0]", "kind = \"prismatic\"\naxis = [1, 0, 0]",
           "f.toml:30:9: control.pitch.joint: names a joint of kind \"prismatic\" on blade 1, "
           "expected one of kind \"revolute\""},
          {"motion = { constant = 0.0 }", "motion = { by = \"program\" }",
           "f.toml:30:9: control.pitch.joint: names a joint that the program moves on blade 1, "
           "expected one whose motion is constant, a table or by the azimuth"},
          {"[control.pitch]\njoint = \"pitch\"",
           "[support]\n[[support.body]]\nname = \"nacelle\"\nkind = \"rigid\"\nmass = 5\n"
           "inertia = 1\n[[support.joint]]\nname = \"yaw\"\nchild = \"nacelle\"\nkind = "
           "\"revolute\"\naxis = [0, 0, 1]\nmotion = { constant = 0 }\n[support.axle]\nbody = "
           "\"nacelle\"\n[control.pitch]\njoint = \"yaw\"",
           "f.toml:44:9: control.pitch.joint: is \"yaw\", a joint of the support, expected one on "
           "the hub"},
      });
}

TEST_CASE("tables of controllers that there are not are refused") {
  check_edits(kControlText,
              {
                  {"[control.pitch]", "[control.yaw]",
                   "f.toml:29:10: control.yaw: unknown key, expected \"pitch\", \"library\", "
                   "\"program\" or \"turbine\""},
                  {"[control.pitch]", "[[control.pitch]]",
                   "f.toml:29:1: control.pitch: is an array of tables (1), expected a table "
                   "[control.pitch]"},
                  {"period = 0.0125", "perod = 0.0125",
                   "f.toml:41:1: control.pitch.perod: unknown key, did you mean \"period\"?"},
                  {"world = \"space\"\n", "world = \"plane\"\n",
                   "f.toml:29:1: control: belongs to another world, expected world = \"space\""},
              });
}

TEST_CASE("a controller that a program fills in is checked as one of a file") {
  const Scenario good = parse_scenario(kControlText, "f.toml");
  const auto message = [&](auto&& change) {
    Scenario scenario = good;
    change(*scenario.space->pitch_control);
    return message_of([&] { check_scenario(scenario); });
  };
  CHECK(message([](PitchControl&) {}) == "no error");
  CHECK(message([](PitchControl& c) { c.joints.clear(); }) ==
        "control.pitch.joints: is empty, expected names of joints");
  CHECK(message([](PitchControl& c) {
          c.joints = {"flap"};
        }).starts_with("control.pitch.joints.1: names a joint that turns freely on blade 1"));
  CHECK(message([](PitchControl& c) { c.sign = 0.5; }) ==
        "control.pitch.sign: is 0.5, expected 1 or -1");
  CHECK(message([](PitchControl& c) { c.rate = 0.0; }) ==
        "control.pitch.rate: is 0, expected a number greater than 0 (rad/s)");
  CHECK(message([](PitchControl& c) {
          c.maximum = std::numeric_limits<double>::quiet_NaN();
        }).starts_with("control.pitch.maximum: is nan"));
  CHECK(message([](PitchControl& c) {
          c.schedule = Curve({0.0, 1.0}, {1.0, 0.5});
        }) ==
        "control.pitch.schedule: given along with half_gain_angle, expected only one of them");
}

TEST_CASE("a controller is written as it is read") {
  const Scenario scenario = parse_scenario(kControlText, "f.toml");
  const PitchControl& control = *scenario.space->pitch_control;
  CHECK(control.joints == std::vector<std::string>{"pitch"});
  CHECK(control.speed == 1.2671);
  CHECK(control.half_gain_angle == 0.11);
  CHECK(control.sign == -1.0);
  const std::string json = scenario.to_json();
  CHECK(parse_scenario(document_of(json), "f.toml").to_json() == json);
  // What is left out is not there, or the default.
  std::string least = kControlText;
  least.erase(least.find("half_gain_angle"), 23);
  for (const char* key : {"rate = 0.1396\n", "filter = 1.57\n", "initial = 0.1\n", "sign = -1\n",
                          "period = 0.0125\n"})
    least.erase(least.find(key), std::string(key).size());
  const Scenario plain = parse_scenario(least, "f.toml");
  const PitchControl& defaults = *plain.space->pitch_control;
  CHECK_FALSE((defaults.rate || defaults.filter || defaults.period || defaults.half_gain_angle));
  CHECK(defaults.initial == 0.0);
  CHECK(defaults.sign == 1.0);
  CHECK(parse_scenario(document_of(plain.to_json()), "f.toml").to_json() == plain.to_json());
  // A schedule, and several joints.
  std::string other = kControlText;
  other.replace(other.find("half_gain_angle = 0.11"), 22,
                "schedule = { angle = [0.0, 0.2], factor = [1.0, 0.5] }");
  other.replace(other.find("joint = \"pitch\""), 15, "joints = [\"pitch\", \"flap\"]");
  other.replace(other.find("stiffness = 4e4"), 15, "motion = { cosine = 0.1 }");
  const Scenario both = parse_scenario(other, "f.toml");
  CHECK(both.space->pitch_control->joints == std::vector<std::string>{"pitch", "flap"});
  CHECK(calc_gain_factor(*both.space->pitch_control, 0.1) == 0.75);
  CHECK(parse_scenario(document_of(both.to_json()), "f.toml").to_json() == both.to_json());
}

TEST_CASE("an override takes a controller away") {
  const Scenario none = parse_scenario(kControlText, "f.toml", {"control={}"});
  CHECK_FALSE(none.space->pitch_control);
  CHECK(message_of([&] {
          parse_scenario(kControlText, "f.toml", {"control={pich={}}"});
        }).find("control.pich: unknown key, did you mean \"pitch\"?") != std::string::npos);
}
