// A car on tyres of one's own drives over a bump: models/vehicle.toml, whose wheels hang on closed
// loops. A tyre is a spring and a damper under its wheel; each is a node of the step graph.

#include <spoke/spoke.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numbers>

constexpr double stiffness = 2e5, damping = 500.0, side = 3000.0;  // N/m, N s/m, N s/m
constexpr double radius = 0.3, ground = -0.5, height = 0.05, length = 2.0, begin = 20.0;  // m

double road(double x) {
  if (x < begin || x > begin + length) return ground;
  return ground + 0.5 * height * (1.0 - std::cos(2.0 * std::numbers::pi * (x - begin) / length));
}

std::shared_ptr<const spoke::Load> make_tyre(const spoke::Marker& wheel) {
  return spoke::make_load(
      "tyre", {wheel},
      [](double, std::span<const spoke::MarkerMotion> in, std::span<spoke::Wrench> out) {
        const Eigen::Vector3d &p = in[0].position, &v = in[0].velocity;
        const double deflection = road(p.x()) + radius - p.z();
        if (deflection < 0.0) return;  // off the ground
        out[0].force.z() = std::max(0.0, stiffness * deflection - damping * v.z());
        out[0].force.y() = -side * v.y();
      });
}

int main() {
  spoke::Scenario scenario = spoke::read_scenario(SPOKE_MODELS_DIR "/vehicle.toml");
  scenario.space->loads.clear();  // tyres carry it now
  spoke::Loads tyres;
  for (int i = 0; i < 4; ++i) tyres.push_back(make_tyre({i, 2}));  // wheels are third bodies
  spoke::Simulation car(scenario, {}, tyres);
  double rise = 0.0, low = 0.0;
  car.run_until(1.5);
  const double rest = car.marker({0, 2}).position.z();
  while (!car.done()) {
    car.run_until(car.time() + 0.01);
    rise = std::max(rise, car.marker({0, 2}).position.z() - rest);
  }
  for (int i = 0; i < 4; ++i) low += (ground + radius - car.marker({i, 2}).position.z()) / 4;
  const double weight = (1200.0 + 4 * 38.0) * 9.81;
  std::printf("the left front wheel rises by %.4f m; tyres give by %.5f m, by the weight %.5f m\n",
              rise, low, weight / 4 / stiffness);
  return std::abs(rise / height - 1.0) < 0.2 && std::abs(low * 4 * stiffness / weight - 1.0) < 1e-3
             ? 0
             : 1;
}
