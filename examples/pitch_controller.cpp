// A controller of the program's own: every 20 ms it sets the pitch of each blade, by a servo, and
// the torque of the generator. A controller that a scenario can say is [control.pitch].

#include <spoke/spoke.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>

namespace {

// Blades as plates, which a constant lift turns while their pitch is small.
const std::string kRotor = R"(
world = "space"
[hub]
inertia = [8.0, 8.0, 10.0]
drive = { kind = "torque", torque = 0.0, initial_speed = 1.5 }
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
motion = { by = "program", initial = -0.4 }
[[load]]
subsystem = "vane"
body = "plate"
frame = "body"
force = [0.0, 0.0, 3.0]
[integration]
step = 0.005
duration = 30.0
)";

/// Returns the generator's torque at a speed [N m]: rated power above 2 rad/s.
double generator_torque(double speed) { return -4.0 / std::max(speed, 1.0); }

/// Moves a joint towards an angle [rad], as a servo of 8 rad/s.
void steer(spoke::Simulation& simulation, int blade, double wanted) {
  constexpr double frequency = 8.0;
  const int joint = simulation.joint_index(blade, "pitch");
  spoke::CoordinateMotion motion = simulation.joint_motion(blade, joint);
  motion.acceleration = frequency * (frequency * (wanted - motion.value) - 2.0 * motion.velocity);
  simulation.set_joint_motion(blade, joint, 0, motion);
}

}  // namespace

int main() {
  constexpr double target = 2.0, period = 0.02;         // rad/s, s
  constexpr double proportional = 0.8, integral = 0.4;  // s, rad/rad
  const spoke::Scenario scenario = spoke::parse_scenario(kRotor, "pitch_controller");
  spoke::Simulation simulation(scenario);
  const std::size_t speed_sensor = simulation.sensor_index("hub.speed");
  double demand = -0.4;
  while (!simulation.done()) {
    const double speed = simulation.sensor_values()[speed_sensor];
    demand = std::clamp(demand + integral * period * (speed - target), -0.5, 0.5);
    const double collective = std::clamp(demand + proportional * (speed - target), -0.5, 0.5);
    const double azimuth = simulation.sensor("hub.angle");
    for (int blade = 0; blade < 3; ++blade)  // and a cyclic part by the blade's azimuth
      steer(simulation, blade, collective + 0.02 * std::cos(azimuth + 2.0944 * blade));
    simulation.set_drive(spoke::TorqueDrive{spoke::Curve(generator_torque(speed))});
    simulation.run_until(simulation.time() + period);
    if (std::fmod(simulation.time() + 0.001, 5.0) < period)
      std::printf("t = %4.1f s: %.4f rad/s, pitch %+.4f rad\n", simulation.time(),
                  simulation.sensor("hub.speed"), simulation.sensor("vane1.pitch"));
  }
  return std::abs(simulation.sensor("hub.speed") - target) < 0.02 * target ? 0 : 1;
}
