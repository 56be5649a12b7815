#pragma once

// Models in space that several tests run, as scenario files.

#include <string>

#include "models/scenario.h"

namespace spoke::test {

/// A hub free in space, which spins and moves.
inline const std::string kFlyingHub = R"(
[hub]
support = "free"
mass = 3.0
center = [0.05, -0.02, 0.1]
inertia = [0.4, 0.5, 0.6]
velocity = [0.3, -0.2, 0.5]
angular_velocity = [1.5, -1.0, 2.5]
)";

/// A hub on an axle that is tilted against gravity and turns as prescribed.
inline const std::string kDrivenHub = R"(
[hub]
axis = [0.2, 0.3, 1.0]
radius = 0.1
mass = 2.0
center = [0.03, 0.02, 0.0]
inertia = 0.5
[hub.drive]
kind = "spin_up"
speed = 8.0
ramp = 1.0
)";

/// The hub of kDrivenHub, turned by a torque.
inline const std::string kTurnedHub = R"(
[hub]
axis = [0.2, 0.3, 1.0]
radius = 0.1
mass = 2.0
center = [0.03, 0.02, 0.0]
inertia = 0.5
[hub.drive]
kind = "torque"
torque = 3.0
initial_speed = 4.0
)";

inline const std::string kGravity = R"(
[gravity]
acceleration = [0.5, 1.0, -9.81]
)";

/// Gravity that sets in over a while.
inline const std::string kRisingGravity = R"(
[gravity]
acceleration = [0.5, 1.0, -9.81]
ramp = 0.5
)";

/// Two soft beams of 2 m, straight and without joints. What follows is of the blades.
/// Returns blades as kBooms with this strain.
inline std::string with_strain(std::string blades, const std::string& strain) {
  const std::string head = "[blade]\n";
  return blades.insert(blades.find(head) + head.size(), "strain = \"" + strain + "\"\n");
}

inline const std::string kBooms = R"(
[blade]
count = 2
length = 2.0
bodies = 2
elements = 2
precone = 0.1
[blade.sections]
mass_per_length = 1.0
axial_stiffness = 2e4
lag_stiffness = 40.0
flap_stiffness = 30.0
torsion_stiffness = 30.0
)";

/// The joints of an articulated blade: flap and lag with springs, dampers and a stop.
inline const std::string kHinges = R"(
[[blade.joint]]
name = "hinges"
station = 0.0
kind = "universal"
axes = [[0.0, -1.0, 0.0], [0.0, 0.0, 1.0]]
stiffness = [30.0, 20.0]
damping = [0.4, 0.6]
initial_speed = [0.5, 0.2]
stop = [{ lower = -0.02, upper = 0.5, stiffness = 300.0, damping = 0.5, width = 0.02 }, {}]
)";

/// A pitch bearing in the middle, which follows the azimuth.
inline const std::string kPitch = R"(
[[blade.joint]]
name = "pitch"
station = 1.0
kind = "revolute"
axis = [1.0, 0.0, 0.0]
motion = { mean = 0.14, cosine = 0.1, sine = -0.15 }
)";

/// A pitch joint under control, which samples every 4 ms and comes to its limits.
inline const std::string kControlledPitch = R"(
[[blade.joint]]
name = "pitch"
station = 1.0
kind = "revolute"
axis = [1.0, 0.0, 0.0]
motion = { time = [0.0, 0.5], value = [0.1, 0.2] }
[control.pitch]
joint = "pitch"
speed = 3.5
proportional = 0.2
integral = 0.5
half_gain_angle = 0.2
minimum = -0.1
maximum = 0.3
rate = 2.0
filter = 40.0
initial = 0.05
sign = -1
period = 0.004
)";

/// A tree with joints of every kind, on beams and on rigid bodies, without what drives or damps.
/// Air around kBooms, in wind along and across the axis of kDrivenHub. Behind [blade].
inline const std::string kAir = R"(
[blade.aerodynamics]
station = [0.4, 0.9, 1.0, 1.5, 2.0]
chord = [0.2, 0.22, 0.2, 0.15, 0.1]
twist = [0.1, 0.05, 0.05, 0.02, 0.0]
center = 0.01
airfoil = ["thick", "wing", "wing", "wing", "wing"]
[[airfoil]]
name = "thick"
angle = [-3.141592653589793, 0.0, 3.141592653589793]
lift = [0.0, 0.0, 0.0]
drag = [0.5, 0.5, 0.5]
[[airfoil]]
name = "wing"
angle = [-3.141592653589793, -1.5, -0.3, 0.0, 0.3, 1.5, 3.141592653589793]
lift = [0.0, 0.0, -1.2, 0.1, 1.4, 0.0, 0.0]
drag = [0.02, 1.5, 0.1, 0.01, 0.1, 1.5, 0.02]
moment = [0.0, 0.3, 0.05, -0.02, -0.05, -0.3, 0.0]
[air]
[wind]
velocity = [0.5, 3.0, 1.0]
)";

inline const std::string kTree = R"(
[[subsystem]]
name = "arm"
[[subsystem.body]]
name = "boom"
kind = "beam"
length = 2.0
bodies = 1
elements = 2
[subsystem.body.sections]
mass_per_length = 1.0
axial_stiffness = 2e4
lag_stiffness = 40.0
flap_stiffness = 30.0
torsion_stiffness = 30.0
[[subsystem.body]]
name = "bracket"
kind = "rigid"
mass = 0.5
center = [0.0, 0.1, 0.05]
inertia = [0.02, 0.01, 0.02]
[[subsystem.body]]
name = "mirror"
kind = "rigid"
mass = 0.8
center = [0.1, 0.0, 0.1]
inertia = [0.03, 0.05, 0.04]
[[subsystem.body]]
name = "slider"
kind = "rigid"
mass = 0.4
center = [0.0, 0.0, 0.1]
inertia = [0.01, 0.02, 0.02]
[[subsystem.body]]
name = "whip"
kind = "beam"
length = 1.0
bodies = 1
elements = 2
reference_frame = "chord"
[subsystem.body.sections]
mass_per_length = 0.6
axial_stiffness = 1e4
lag_stiffness = 20.0
flap_stiffness = 15.0
torsion_stiffness = 12.0
[[subsystem.body]]
name = "screw"
kind = "rigid"
mass = 0.3
center = [0.05, 0.05, 0.0]
inertia = [0.01, 0.01, 0.02]
[[subsystem.joint]]
parent = "hub"
child = "boom"
kind = "universal"
axes = [[0.0, -1.0, 0.0], [0.0, 0.0, 1.0]]
offset = [0.3, 0.1, 0.0]
orientation = [0.3, 0.1, 0.4]
stiffness = [40.0, 30.0]
initial_speed = [0.5, -0.4]
[[subsystem.joint]]
parent = "boom"
station = 1.0
child = "bracket"
kind = "revolute"
axis = [1.0, 1.0, 0.0]
stiffness = 5.0
initial = 0.3
initial_speed = 1.0
[[subsystem.joint]]
parent = "boom"
child = "mirror"
kind = "spherical"
stiffness = 3.0
initial = [0.2, -0.3, 0.1]
initial_speed = [1.0, 2.0, -1.5]
[[subsystem.joint]]
parent = "bracket"
child = "slider"
kind = "prismatic"
offset = [0.0, 0.2, 0.0]
axis = [0.0, 1.0, 0.5]
stiffness = 60.0
initial_speed = 0.4
[[subsystem.joint]]
parent = "mirror"
child = "whip"
kind = "fixed"
offset = [0.1, 0.0, 0.2]
orientation = [0.0, 0.4, 0.0]
[[subsystem.joint]]
parent = "bracket"
child = "screw"
kind = "cylindrical"
offset = [0.0, 0.2, 0.1]
axis = [0.0, 0.0, 1.0]
stiffness = [4.0, 50.0]
initial_speed = [-2.0, 0.3]
)";

/// Trees of one subsystem on the hub, likewise conservative: one with a beam on a ball, a rigid
/// body that is fixed and carries another one, and a beam that is fixed.
inline const std::string kForest = R"(
[[subsystem]]
name = "forest"
[[subsystem.body]]
name = "ball"
kind = "rigid"
mass = 0.8
center = [0.2, 0.0, 0.1]
inertia = [0.03, 0.05, 0.04]
[[subsystem.body]]
name = "rod"
kind = "beam"
length = 1.5
bodies = 1
elements = 2
[subsystem.body.sections]
mass_per_length = 0.8
axial_stiffness = 2e4
lag_stiffness = 40.0
flap_stiffness = 30.0
torsion_stiffness = 30.0
[[subsystem.body]]
name = "lump"
kind = "rigid"
mass = 0.7
center = [-0.3, 0.1, 0.0]
inertia = [0.02, 0.03, 0.02]
[[subsystem.body]]
name = "slider"
kind = "rigid"
mass = 0.4
center = [0.0, 0.0, 0.1]
inertia = [0.01, 0.02, 0.02]
[[subsystem.body]]
name = "whip"
kind = "beam"
length = 1.0
bodies = 1
elements = 2
reference_frame = "chord"
[subsystem.body.sections]
mass_per_length = 0.6
axial_stiffness = 1e4
lag_stiffness = 20.0
flap_stiffness = 15.0
torsion_stiffness = 12.0
[[subsystem.joint]]
parent = "hub"
child = "ball"
kind = "spherical"
offset = [0.2, 0.1, 0.0]
stiffness = 30.0
initial = [0.1, -0.2, 0.1]
initial_speed = [1.0, 0.5, -1.0]
[[subsystem.joint]]
parent = "hub"
child = "lump"
kind = "fixed"
offset = [-0.2, 0.0, 0.1]
[[subsystem.joint]]
parent = "hub"
child = "whip"
kind = "fixed"
offset = [0.0, 0.3, 0.0]
orientation = [0.0, 0.3, 1.5]
[[subsystem.joint]]
parent = "lump"
child = "slider"
kind = "prismatic"
offset = [-0.4, 0.0, 0.0]
axis = [1.0, 0.3, 0.5]
stiffness = 60.0
initial_speed = 0.4
[[subsystem.joint]]
parent = "ball"
child = "rod"
kind = "revolute"
axis = [0.0, 1.0, 0.3]
offset = [0.4, 0.0, 0.1]
stiffness = 8.0
initial_speed = 1.0
)";

/// A pendulum on a driven hinge and on one with a motor and a damper.
inline const std::string kMotors = R"(
[[subsystem]]
name = "motors"
[[subsystem.body]]
name = "link"
kind = "rigid"
mass = 1.0
center = [0.3, 0.0, 0.05]
inertia = [0.02, 0.05, 0.05]
[[subsystem.body]]
name = "boom"
kind = "beam"
length = 1.0
bodies = 1
elements = 2
[subsystem.body.sections]
mass_per_length = 1.0
axial_stiffness = 2e4
lag_stiffness = 40.0
flap_stiffness = 30.0
torsion_stiffness = 30.0
[[subsystem.body]]
name = "ball"
kind = "rigid"
mass = 0.5
center = [0.1, 0.0, 0.0]
inertia = [0.01, 0.02, 0.02]
[[subsystem.joint]]
parent = "hub"
child = "link"
kind = "universal"
axes = [[0.0, 1.0, 0.0], [0.0, 0.0, 1.0]]
offset = [0.2, 0.0, 0.1]
motion = [{ time = [0.0, 0.2, 0.5, 0.9], value = [0.1, 0.3, -0.2, 0.1] }, {}]
damping = [0.0, 0.3]
torque = [0.0, 1.5]
[[subsystem.joint]]
parent = "link"
child = "boom"
kind = "cylindrical"
axis = [0.0, 1.0, 0.0]
offset = [0.6, 0.0, 0.0]
damping = [0.2, 0.0]
stiffness = [5.0, 0.0]
force = 0.0
motion = [{}, { time = [0.0, 0.4, 0.8], value = [0.0, 0.1, 0.0] }]
[[subsystem.joint]]
parent = "boom"
child = "ball"
kind = "spherical"
stiffness = 2.0
damping = 0.1
torque = [0.3, -0.2, 0.5]
initial_speed = [0.5, 0.4, -0.6]
)";

/// The whole file: a hub, what hangs on it, and what else there is.
inline std::string make_text(const std::string& hub, const std::string& bodies,
                             const std::string& more = "") {
  return "world = \"space\"\n" + hub + bodies + more + "[integration]\nduration = 1.0\n";
}

/// The scenario of such a text, with steps of `step` to the time `duration` [s]; deflections may be
/// as large as they like.
inline Scenario make_scenario(const std::string& text, double step, double duration,
                              IntegrationMethod method = IntegrationMethod::rk4) {
  Scenario scenario = parse_scenario(text, "test.toml");
  scenario.integration.step = step;
  scenario.integration.duration = duration;
  scenario.integration.method = method;
  scenario.limits.deflection = 0.0;
  return scenario;
}

/// A hub and a fuselage that are one rigid body.
inline const std::string kFuselageHub = R"(
[hub]
mass = 1.0
inertia = [0.1, 0.2, 0.3]
[hub.drive]
kind = "fixed"
[support]
from = "free"
mass = 2.0
inertia = [0.3, 0.3, 0.3]
velocity = [0.3, -0.2, 0.5]
angular_velocity = [1.5, -1.0, 2.5]
)";

/// A support: a beam with a nacelle on a yaw spring.
inline const std::string kTower = R"(
[support]
from = "ground"
[[support.body]]
name = "tower"
kind = "beam"
length = 2.0
bodies = 1
elements = 2
[support.body.sections]
mass_per_length = 1.0
axial_stiffness = 2e4
lag_stiffness = 400.0
flap_stiffness = 300.0
torsion_stiffness = 300.0
[[support.body]]
name = "nacelle"
kind = "rigid"
mass = 1.5
center = [0.1, 0.0, 0.05]
inertia = [0.05, 0.06, 0.07]
[[support.joint]]
parent = "ground"
child = "tower"
kind = "fixed"
[[support.joint]]
parent = "tower"
child = "nacelle"
kind = "revolute"
axis = [1.0, 0.0, 0.0]
stiffness = 40.0
damping = 0.1
[support.axle]
body = "nacelle"
offset = [0.1, 0.0, 0.2]
)";

/// Returns a scenario whose beams, those of the blades included, have strains of second order.
inline std::string with_nonlinear_strains(std::string text) {
  for (const std::string& head : {std::string("\n[blade]\n"), std::string("\nkind = \"beam\"\n")})
    for (std::size_t at = 0; (at = text.find(head, at)) != std::string::npos; at += head.size())
      text.insert(at + head.size(), "strain = \"nonlinear\"\n");
  return text;
}

}  // namespace spoke::test
