// Clones from one state: what does a rotor do if its torque stays, and if it fails? Both at once.

#include <spoke/spoke.h>

#include <cstdio>
#include <thread>

int main() {
  const spoke::Scenario scenario = spoke::parse_scenario(R"(
[hub]
drive = { kind = "torque", torque = 20.0 }
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
duration = 20.0
)",
                                                         "clones");
  spoke::Simulation simulation(scenario);
  simulation.run_until(5.0);

  spoke::Simulation failing = simulation.clone();
  failing.set_drive(spoke::TorqueDrive{spoke::Curve(0.0)});
  std::thread other([&] { failing.run_until(8.0); });
  simulation.run_until(8.0);
  other.join();
  const double driven = simulation.sensor("hub.speed"), free = failing.sensor("hub.speed");
  std::printf("after 3 s more %.4f rad/s, without torque %.4f rad/s\n", driven, free);
  return driven > free && free > 0.0 ? 0 : 1;
}
