#pragma once

// Rotors of three vanes for controllers from outside.

#include <string>

namespace spoke::test {

inline constexpr double kVaneInertia = 17.5;  // about the axle [kg m^2]: 10, and 3 (0.5 2^2 + 0.5)

/// Returns a rotor of three rigid vanes of pitch joints, turned by a torque. `control`: tables;
/// `more`: further keys, at the end.
inline std::string make_vanes(const std::string& control, const std::string& more = {}) {
  return R"(world = "space"
[integration]
step = 0.005
duration = 10.0
[hub]
inertia = [8.0, 8.0, 10.0]
[hub.drive]
kind = "torque"
torque = 0.0
initial_speed = 2.0
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
offset = [2.0, 0.0, 0.0]
axis = [1.0, 0.0, 0.0]
motion = { constant = 0.0 }
)" + control +
         more;
}

/// A force along the vanes, which turns with their pitch: a torque on the hub of -18 sin(pitch).
inline const std::string kLift = R"(
[[load]]
subsystem = "vane"
body = "plate"
frame = "body"
force = [0.0, 0.0, 3.0]
)";

}  // namespace spoke::test
