// A controller: every 20 ms a PI law sets the torque that brings the hub to its speed.

#include <spoke/spoke.h>

#include <cmath>
#include <cstdio>

int main() {
  const spoke::Scenario scenario = spoke::parse_scenario(R"(
[hub]
inertia = 5.0
drive = { kind = "torque", torque = 0.0 }
[blade]
count = 3
length = 8.0
bodies = 4
elements = 4
density = 2766.67
area = 7.299e-5
second_moment = 8.214e-9
youngs_modulus = 6.895e10
[integration]
step = 0.005
duration = 40.0
)",
                                                         "controlled_hub");
  spoke::Simulation simulation(scenario);
  constexpr double target = 2.0, period = 0.02;          // rad/s, s
  constexpr double proportional = 40.0, integral = 4.0;  // N m s, N m
  double error_sum = 0.0;
  while (!simulation.done()) {
    const double error = target - simulation.sensor("hub.speed");
    error_sum += error * period;
    const double torque = proportional * error + integral * error_sum;
    simulation.set_drive(spoke::TorqueDrive{spoke::Curve(torque)});
    simulation.run_until(simulation.time() + period);
    if (std::fmod(simulation.time() + 0.001, 5.0) < period)
      std::printf("t = %4.1f s: %.4f rad/s by %.3f N m\n", simulation.time(),
                  simulation.sensor("hub.speed"), torque);
  }
  return std::abs(simulation.sensor("hub.speed") - target) < 0.02 * target ? 0 : 1;
}
