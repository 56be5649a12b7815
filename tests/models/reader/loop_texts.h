#pragma once

// Scenarios with closed loops that tests of the reader change line by line.

#include <string>

namespace spoke::test {

// Line numbers of messages refer to these texts.
inline const std::string kLoopText = R"(world = "space"
[hub]
radius = 0.1
[hub.drive]
kind = "constant"
speed = 4.0
[[anchor]]
name = "swashplate"
motion = { rotation = { constant = [0.1, 0, 0] } }
[[subsystem]]
name = "arm"
[[subsystem.body]]
name = "crank"
kind = "rigid"
mass = 1.0
inertia = 0.1
[[subsystem.body]]
name = "boom"
kind = "beam"
length = 4.0
[subsystem.body.sections]
mass_per_length = 1.0
axial_stiffness = 1e7
flap_stiffness = 1e3
lag_stiffness = 1e3
torsion_stiffness = 1e3
[[subsystem.joint]]
parent = "hub"
child = "crank"
kind = "revolute"
axis = [0, 1, 0]
[[subsystem.joint]]
parent = "crank"
child = "boom"
kind = "spherical"
[[subsystem.loop]]
name = "rod"
kind = "revolute"
from = { body = "boom", station = 3.0 }
to = { body = "hub", point = [1, 0, 0] }
axis = [0, 1, 0]
[integration]
duration = 20.0
)";

/// The blade of a helicopter with a pitch link.
inline const std::string kPitchLinkText = R"(world = "space"
[hub.drive]
kind = "constant"
speed = 4.0
[[anchor]]
name = "swashplate"
turns_with_hub = true
motion = { translation = { constant = [0, 0, -0.2] } }
[blade]
count = 3
length = 8.0
[blade.sections]
mass_per_length = 1.0
axial_stiffness = 1e7
flap_stiffness = 1e3
lag_stiffness = 1e4
torsion_stiffness = 1e3
[[blade.joint]]
name = "pitch"
station = 0.5
kind = "revolute"
axis = [1, 0, 0]
[[blade.loop]]
name = "pitch_link"
kind = "distance"
from = { station = 0.5, point = [0, 0.2, 0] }
to = { anchor = "swashplate", point = [0.5, 0.2, 0] }
[integration]
duration = 20.0
)";

inline const std::string kPlaneLoopText = R"([hub]
support = "axle"
[hub.drive]
kind = "free"
[[anchor]]
name = "cart"
motion = { translation = { rate = [0.1, 0] }, rotation = { constant = 0.2 } }
[blade]
count = 2
length = 8.0
density = 2766.67
area = 7.299e-5
second_moment = 8.214e-9
youngs_modulus = 6.895e10
[[blade.loop]]
name = "slider"
kind = "prismatic"
from = { station = 4.0 }
to = { anchor = "cart", point = [1, 2], orientation = 0.5 }
axis = [1, 0]
[integration]
duration = 20.0
)";

}  // namespace spoke::test
