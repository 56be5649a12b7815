#pragma once

// A scenario with a solid that tests change line by line.

#include <string>

namespace spoke::test {

inline const std::string kMeshes = std::string(SPOKE_MODELS_DIR) + "/meshes/";
inline const std::string kBracket = kMeshes + "bracket.msh";

inline const std::string kRoot = R"([[subsystem.body.interface]]
name = "root"
nodes = "ROOT"
)";
inline const std::string kInterfaces = kRoot + R"([[subsystem.body.interface]]
name = "tip"
nodes = "TIP"
kind = "average"
)";

/// An L-bracket of 0.4 m on the hub, with a rotor at its tip. Line numbers of messages refer to it.
inline const std::string kSolidText = R"(world = "space"
[hub.drive]
kind = "constant"
speed = 4.0
[[subsystem]]
name = "arm"
[[subsystem.body]]
name = "bracket"
kind = "solid"
mesh = ")" + kBracket + R"("
scale = { length = 1e-3 }
material = { youngs_modulus = 7e10, poissons_ratio = 0.33, density = 2700 }
modes = 4
damping = 0.01
)" + kInterfaces + R"([[subsystem.body]]
name = "rotor"
kind = "rigid"
mass = 2.0
inertia = [0.1, 0.1, 0.2]
[[subsystem.joint]]
parent = "hub"
child = "bracket"
kind = "fixed"
[[subsystem.joint]]
parent = "bracket"
child = "rotor"
kind = "revolute"
axis = [1, 0, 0]
[[load]]
subsystem = "arm"
body = "bracket"
nodes = "TIP"
traction = [0, 0, 100.0]
[[sensor]]
quantity = "displacement"
subsystem = "arm"
body = "bracket"
[integration]
duration = 1.0
)";

}  // namespace spoke::test
