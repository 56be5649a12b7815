#pragma once

// A scenario of blades in air that tests of the reader change line by line.

#include <string>

namespace spoke::test {

// Line numbers of messages refer to this text.
inline const std::string kAirText = R"(world = "space"
[hub]
radius = 0.5
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
[blade.aerodynamics]
station = [1.0, 4.0, 8.0]
chord = [0.6, 0.5, 0.3]
twist = [0.2, 0.1, 0.0]
center = [0.0, 0.01, 0.02]
airfoil = ["thick", "plate", "plate"]
leading_edge = "+y"
[[airfoil]]
name = "thick"
angle = [-3.141592653589793, 0.0, 3.141592653589793]
lift = [0.0, 0.0, 0.0]
drag = [0.5, 0.5, 0.5]
[[airfoil]]
name = "plate"
[[airfoil.polar]]
reynolds = 1e5
angle = [-3.141592653589793, -1.0, 0.0, 1.0, 3.141592653589793]
lift = [0.0, -1.0, 0.0, 1.0, 0.0]
drag = [0.02, 1.0, 0.01, 1.0, 0.02]
moment = [0.0, 0.1, 0.0, -0.1, 0.0]
[[airfoil.polar]]
reynolds = 1e6
angle = [-3.141592653589793, -1.0, 0.0, 1.0, 3.141592653589793]
lift = [0.0, -1.2, 0.0, 1.2, 0.0]
drag = [0.02, 1.0, 0.01, 1.0, 0.02]
[air]
density = 1.2
viscosity = 1.5e-5
[wind]
velocity = [0.0, 0.0, 8.0]
[aerodynamics]
induction = "momentum"
inflow = "dynamic"
stall = "dynamic"
[[sensor]]
name = "mid"
quantity = "air_flow"
blade = 1
position = 4.0
[integration]
duration = 20.0
)";

}  // namespace spoke::test
