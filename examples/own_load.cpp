// A load of one's own: the drag of still air on each strip of each blade. Each blade's load is a
// node of the step graph.

#include <spoke/spoke.h>

#include <cmath>
#include <cstdio>

constexpr double air = 1.225, chord = 0.05, drag_coefficient = 0.02;

/// Makes a load by strip theory on one blade of 4 bodies of 2 m: two strips of 1 m on each body.
std::shared_ptr<const spoke::Load> make_drag(int blade) {
  std::vector<spoke::Marker> strips;
  for (int body = 0; body < 4; ++body)
    for (const double station : {0.25, 0.75}) strips.push_back({blade, body, station});
  return spoke::make_load(
      "drag", strips,
      [](double, std::span<const spoke::MarkerMotion> in, std::span<spoke::Wrench> out) {
        for (std::size_t k = 0; k < in.size(); ++k) {
          const Eigen::Vector3d across = in[k].rotation.col(1);
          const double speed = across.dot(in[k].velocity);
          out[k].force = -0.5 * air * chord * drag_coefficient * std::abs(speed) * speed * across;
        }
      });
}

int main() {
  const spoke::Scenario scenario = spoke::parse_scenario(R"(
[hub]
drive = { kind = "spin_up", speed = 4.0, ramp = 15.0 }
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
duration = 25.0
)",
                                                         "own_load");
  spoke::Loads loads;
  for (int blade = 0; blade < 3; ++blade) loads.push_back(make_drag(blade));
  spoke::Simulation simulation(scenario, {}, loads);
  simulation.run_until(20.0);
  double torque = 0.0;  // mean over the last 5 s
  for (int k = 0; k < 100; ++k) {
    simulation.run_until(20.0 + 0.05 * (k + 1));
    torque += simulation.sensor("hub.torque") / 100;
  }
  // 3 blades, int_0^L 1/2 rho c C_d (w r)^2 r dr
  const double expected = 3 * 0.5 * air * chord * drag_coefficient * 16.0 * std::pow(8.0, 4) / 4;
  std::printf("torque against the drag %.2f N m, of a rigid rotor %.2f N m\n", torque, expected);
  return std::abs(torque / expected - 1.0) < 0.03 ? 0 : 1;
}
