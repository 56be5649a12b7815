#pragma once

// FMUs for the tests: made of the text of a scenario, and unpacked.

#include <filesystem>
#include <string>
#include <vector>

#include "engine/simulation.h"
#include "models/scenario.h"
#include "program/fmu/model_description.h"

namespace spoke::test {

/// A rotor in space with two blades that the program pitches, a torque, and loads on blade and hub.
inline const std::string kPitchedRotor = R"(
title = "A rotor with pitch & gusts"
world = "space"
[hub]
axis = [0.2, 0.3, 1.0]
radius = 0.1
mass = 2.0
inertia = 0.5
drive = { kind = "torque", torque = 3.0, initial_speed = 4.0 }
[gravity]
acceleration = [0.5, 1.0, -9.81]
[blade]
count = 2
length = 2.0
bodies = 2
elements = 2
[blade.sections]
mass_per_length = 1.0
axial_stiffness = 2e4
lag_stiffness = 40.0
flap_stiffness = 30.0
torsion_stiffness = 30.0
[[blade.joint]]
name = "pitch"
station = 1.0
kind = "revolute"
axis = [1.0, 0.0, 0.0]
motion = { by = "program", initial = 0.1 }
[[load]]
name = "gust"
force = [0.0, 1.0, 2.0]
[[hub_load]]
name = "brake"
torque = [0.0, 0.0, -1.0]
[damping]
stiffness_factor = 0.002
[limits]
deflection = 0
step_error = 0
[integration]
step = 0.004
duration = 0.8
)";

/// A rotor in the plane whose hub is driven.
inline const std::string kDrivenRotor = R"(
title = "A driven rotor"
[hub]
inertia = 5.0
drive = { kind = "spin_up", speed = 3.0, ramp = 1.0 }
[blade]
count = 3
length = 8.0
bodies = 2
elements = 2
density = 2766.67
area = 7.299e-5
second_moment = 8.214e-9
youngs_modulus = 6.895e10
[integration]
step = 0.01
duration = 2.0
)";

/// A rotor in sheared wind, 10 m over the ground, whose blades the program pitches.
inline const std::string kBlownRotor = R"(
title = "A rotor in wind"
world = "space"
[hub]
axis = [1.0, 0.0, 0.0]
radius = 0.1
mass = 2.0
inertia = 0.5
drive = { kind = "torque", torque = -3.0, initial_speed = 12.0 }
[blade]
count = 2
length = 2.0
bodies = 1
elements = 2
[blade.sections]
mass_per_length = 1.0
axial_stiffness = 2e5
lag_stiffness = 4e3
flap_stiffness = 3e3
torsion_stiffness = 3e2
[[blade.joint]]
name = "pitch"
station = 0.0
kind = "revolute"
axis = [1.0, 0.0, 0.0]
motion = { by = "program" }
[blade.aerodynamics]
station = [0.2, 1.0, 2.0]
chord = [0.3, 0.25, 0.15]
twist = [-0.4, -0.2, -0.05]
airfoil = ["wing", "wing", "wing"]
[[airfoil]]
name = "wing"
angle = [-3.141592653589793, -1.5, -0.3, 0.0, 0.3, 1.5, 3.141592653589793]
lift = [0.0, 0.0, -1.2, 0.1, 1.4, 0.0, 0.0]
drag = [0.02, 1.5, 0.1, 0.01, 0.1, 1.5, 0.02]
[air]
[wind]
velocity = [8.0, 0.0, 0.0]
shear_exponent = 0.25
reference_height = 10.0
ground = -10.0
[[sensor]]
name = "outer"
quantity = "air_flow"
blade = 1
position = 1.5
[limits]
deflection = 0
step_error = 0
[integration]
step = 0.00390625
duration = 1.0
)";

/// Returns the simulation of the text of a scenario.
Simulation simulate(const std::string& text, const Overrides& overrides = {});

/// A folder with an FMU of a scenario, removed at the end.
class UnpackedFmu {
 public:
  /// `names`: of inputs, of outputs; none: all.
  explicit UnpackedFmu(const std::string& scenario, const std::vector<std::string>& inputs = {},
                       const std::vector<std::string>& outputs = {},
                       const Overrides& overrides = {},
                       fmu::FmiVersion version = fmu::FmiVersion::three);
  ~UnpackedFmu();
  UnpackedFmu(const UnpackedFmu&) = delete;
  UnpackedFmu& operator=(const UnpackedFmu&) = delete;

  const std::filesystem::path& folder() const { return folder_; }

 private:
  std::filesystem::path folder_;
};

/// Unpacks the bytes of an archive to a folder.
void unpack(const std::string& archive, const std::filesystem::path& folder);

}  // namespace spoke::test
