// Messages for the laws of [control.turbine], and that what is read is written.

#include <doctest/doctest.h>

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include "models/scenario.h"
#include "tests/contains.h"
#include "tests/message_of.h"
#include "tests/models/inline_toml.h"

using namespace spoke;
using spoke::test::document_of;
using spoke::test::message_of;

namespace {

// Line numbers of messages refer to this text.
const std::string kTurbineText = R"(world = "space"
[hub]
inertia = [2.0, 2.0, 3.0]
[hub.drive]
kind = "torque"
torque = 4.0
[[subsystem]]
name = "vane"
count = 3
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
[control.turbine]
joint = "pitch"
[control.turbine.filter]
frequency = 1.5
[control.turbine.torque]
square = 2.0
speed = 3.0
rated = 24.0
[control.turbine.pitch]
speed = 3.1
angle = [0.0, 0.2]
proportional = [0.5, -0.1]
integral = [0.2, 0.1]
maximum = 1.5
[control.turbine.schedule]
wind = [5.0, 10.0]
angle = [0.0, 0.1]
[control.turbine.smoothing]
torque_gain = 1.0
filter = 0.6
[control.turbine.individual]
integral = -1e-8
maximum = 0.2
[control.turbine.actuator]
frequency = 3.0
damping = 0.7
[integration]
duration = 20.0
)";

/// A change of the text, and what the message has in it.
struct Edit {
  std::string from, to, message;
};

/// Returns the text with the first of `from` replaced.
std::string edited(const Edit& edit) {
  std::string text = kTurbineText;
  const std::size_t at = text.find(edit.from);
  REQUIRE(at != std::string::npos);
  return text.replace(at, edit.from.size(), edit.to);
}

}  // namespace

TEST_CASE("laws of turbines: bad values are refused with their place") {
  const std::vector<Edit> edits = {
      {"frequency = 1.5", "frequency = 0.0",
       "25:13: control.turbine.filter.frequency: is 0.0, expected"},
      {"square = 2.0", "square = 0.0",
       "control.turbine.torque.square: is 0, expected more, or table_speed and table_torque"},
      {"square = 2.0", "square = 2.0\ntable_speed = [0.0, 1.0]\ntable_torque = [0.0, 1.0]",
       "control.turbine.torque.square: given along with table_speed"},
      {"square = 2.0", "table_speed = [0.0, 1.0]\ntable_torque = [1.0]",
       "control.turbine.torque.table_torque: has 1 numbers, expected as many as table_speed has, "
       "2"},
      {"square = 2.0", "table_speed = [0.0, 0.0]\ntable_torque = [1.0, 2.0]",
       "control.turbine.torque.table_speed: is 0 after 0, expected each greater"},
      {"rated = 24.0", "rated = 24.0\ntransition = 3.5",
       "control.turbine.torque.transition: is 3.5, expected less than speed, 3 (rad/s)"},
      {"rated = 24.0", "rated = 24.0\ntransition = 2.5\nintegral = 1.0",
       "control.turbine.torque.transition: given along with gains"},
      {"rated = 24.0", "rated = 24.0\nminimum = 1.0",
       "control.turbine.torque.minimum: given without gains"},
      {"rated = 24.0", "rated = 24.0\nabove = \"speed\"", "expected \"power\" or \"torque\""},
      {"integral = [0.2, 0.1]", "integral = [0.2]",
       "control.turbine.pitch.integral: has 1 numbers, expected as many as angle has, 2"},
      {"proportional = [0.5, -0.1]\nintegral = [0.2, 0.1]", "",
       "control.turbine.pitch.integral: is missing, as proportional is"},
      {"maximum = 1.5", "maximum = -1.5",
       "control.turbine.pitch.maximum: is -1.5, expected more than minimum, 0 (rad)"},
      {"joint = \"pitch\"", "joint = \"pitch\"\ninitial = -0.1",
       "control.turbine.pitch.minimum: is 0 and maximum 1.5, expected initial between them, -0.1"},
      {"joint = \"pitch\"\n", "",
       "control.turbine.pitch: is given without joint, expected the name of the joint"},
      {"wind = [5.0, 10.0]\n", "", "control.turbine.schedule.wind: is missing, expected"},
      {"angle = [0.0, 0.1]", "angle = [0.0]",
       "control.turbine.schedule.angle: has 1 numbers, expected as many as wind has, 2"},
      {"maximum = 0.2", "maximum = 0.2\nwind_from = 5.0",
       "control.turbine.individual.wind_from: is given alone"},
      {"maximum = 0.2", "maximum = 0.2\nwind_from = 5.0\nwind_to = 4.0",
       "control.turbine.individual.wind_to: is 4, expected more than wind_from, 5 (m/s)"},
      {"[integration]", "[control.turbine.yaw]\nrate = 0.01\nerror = 0.1\n[integration]",
       "control.turbine.yaw: is given without yaw_joint"},
      {"kind = \"torque\"\ntorque = 4.0", "kind = \"constant\"\nspeed = 2.0",
       "control.turbine: sets the torque of a drive, but hub.drive.kind is \"constant\""},
      {"[control.turbine.actuator]", "[control.turbine.actor]", "unknown key"}};
  for (const Edit& edit : edits) {
    const std::string message = message_of([&] { parse_scenario(edited(edit), "f.toml"); });
    CAPTURE(message);
    CHECK(message.starts_with("f.toml:"));
    CHECK(spoke::test::contains(message, edit.message));
  }
}

TEST_CASE("laws of turbines: a drive may hold the speed where they leave the torque alone") {
  std::string text = kTurbineText;
  for (const auto& [from, to] :
       {std::pair<std::string, std::string>{"[control.turbine.torque]\nsquare = 2.0\nspeed = 3.0\n"
                                            "rated = 24.0\n",
                                            ""},
        {"[control.turbine.smoothing]\ntorque_gain = 1.0\nfilter = 0.6\n", ""},
        {"kind = \"torque\"\ntorque = 4.0", "kind = \"constant\"\nspeed = 2.0"}})
    text.replace(text.find(from), from.size(), to);
  CHECK_FALSE(parse_scenario(text, "turbine.toml").space->outer_control->sets_torque());
}

TEST_CASE("laws of turbines: what is read is written") {
  const Scenario scenario = parse_scenario(kTurbineText, "turbine.toml");
  const TurbineLaws& laws = *scenario.space->outer_control->laws;
  CHECK(laws.pitch->proportional == std::vector<double>{0.5, -0.1});
  CHECK(laws.torque->above == AboveRated::power);
  const std::string json = scenario.to_json();
  const Scenario again = parse_scenario(document_of(json), "written.toml");
  CHECK(again.to_json() == json);
  CHECK(again.space->outer_control->laws->individual->integral == -1e-8);
}
