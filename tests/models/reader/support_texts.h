#pragma once

// Scenarios with a support that tests of the reader change line by line.

#include <string>

namespace spoke::test {

// Line numbers of messages refer to these texts.
inline const std::string kSupportText = R"(world = "space"
[hub]
mass = 10.0
inertia = [2.0, 2.0, 3.0]
[hub.drive]
kind = "constant"
speed = 4.0
[blade]
count = 3
length = 8.0
[blade.sections]
mass_per_length = 2.0
axial_stiffness = 2e7
flap_stiffness = 2e3
lag_stiffness = 2e4
torsion_stiffness = 2e3
[support]
from = "ground"
[[support.body]]
name = "tower"
kind = "beam"
length = 20.0
[support.body.sections]
mass_per_length = 30.0
axial_stiffness = 1e8
flap_stiffness = 1e6
lag_stiffness = 1e6
torsion_stiffness = 1e6
[[support.body]]
name = "nacelle"
kind = "rigid"
mass = 50.0
inertia = [5.0, 6.0, 7.0]
[[support.joint]]
child = "tower"
kind = "fixed"
orientation = [0, -1.5708, 0]
[[support.joint]]
name = "yaw"
parent = "tower"
child = "nacelle"
kind = "revolute"
axis = [1, 0, 0]
stiffness = 4e4
[support.axle]
body = "nacelle"
offset = [0.0, 0.0, 2.0]
[integration]
duration = 20.0
)";

inline const std::string kFuselageText = R"(world = "space"
[hub]
mass = 10.0
inertia = [2.0, 2.0, 3.0]
[hub.drive]
kind = "constant"
speed = 30.0
[support]
from = "free"
mass = 500.0
inertia = [200.0, 900.0, 800.0]
position = [0.0, 0.0, 100.0]
attitude = [0.0, 0.1, 0.0]
velocity = [30.0, 0.0, 0.0]
[support.axle]
offset = [0.0, 0.0, 1.2]
[integration]
duration = 2.0
)";

inline const std::string kSuspensionText = R"(world = "space"
[hub]
mass = 10.0
inertia = [2.0, 2.0, 3.0]
[hub.drive]
kind = "constant"
speed = 4.0
[hub.suspension]
stiffness = [2e4, 1e4, 0, 0, 0, 0]
damping = [20.0, 10.0, 0, 0, 0, 5.0]
mass = 40.0
inertia = 3.0
[integration]
duration = 2.0
)";

}  // namespace spoke::test
