// Strip aerodynamics in space: a hovering rotor of three twisted blades. Each blade's air loads are
// a load of its own, by a lift and drag polar and a steady inflow. The inflow is set, strip by
// strip, so that the momentum of the air agrees with the thrust; the rotor's thrust and torque are
// then compared with blade-element momentum theory in closed form.

#include <spoke/spoke.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numbers>

namespace {

constexpr int blades = 3, strips = 24;
constexpr double air = 1.225, chord = 0.12, speed = 60.0;         // kg/m^3, m, rad/s
constexpr double hub_radius = 0.3, length = 1.7, radius = 2.0;    // m
constexpr double root_twist = 0.26, tip_twist = 0.10;             // rad
constexpr double lift_slope = 5.7, drag_0 = 0.011, drag_2 = 0.4;  // cd = drag_0 + drag_2 alpha^2
constexpr double width = length / strips;                         // width of a strip [m]

double radius_of(double strip) { return hub_radius + (strip + 0.5) * width; }
double twist_at(double r) {
  return root_twist + (tip_twist - root_twist) * (r - hub_radius) / length;
}

/// Downwash by strip [m/s].
using Inflow = std::vector<double>;

/// Returns the force of the air on a strip whose section moves as given. The section's y axis leads
/// to the leading edge, and its twist is in its frame: alpha is the rest of the pitch.
Eigen::Vector3d strip_force(const spoke::MarkerMotion& section, double downwash) {
  const Eigen::Vector3d wind = Eigen::Vector3d(0.0, 0.0, -downwash) - section.velocity;
  const Eigen::Vector3d y = section.rotation.col(1), z = section.rotation.col(2);
  const double u_y = wind.dot(y), u_z = wind.dot(z);
  const double squared = u_y * u_y + u_z * u_z;
  if (squared == 0.0) return Eigen::Vector3d::Zero();
  const double alpha = std::atan2(u_z, -u_y);
  const Eigen::Vector3d drag = (u_y * y + u_z * z) / std::sqrt(squared);
  const Eigen::Vector3d lift = (u_z * y - u_y * z) / std::sqrt(squared);
  return 0.5 * air * chord * width * squared *
         (lift_slope * alpha * lift + (drag_0 + drag_2 * alpha * alpha) * drag);
}

/// Makes the air loads of a blade, which rise over a tenth of a second.
std::shared_ptr<const spoke::Load> make_air(const std::vector<spoke::Marker>& markers,
                                            const Inflow& inflow) {
  return spoke::make_load(
      "air", markers,
      [inflow](double t, std::span<const spoke::MarkerMotion> in, std::span<spoke::Wrench> out) {
        const double rise = std::min(t / 0.1, 1.0);
        for (std::size_t k = 0; k < in.size(); ++k)
          out[k].force = rise * strip_force(in[k], inflow[k]);
      });
}

/// The state in which momentum and blade elements agree, for small angles: the thrust of a ring of
/// width dr, 4 pi air v^2 r dr, is that of the strips. With x = r/R, the solidity s = blades
/// chord/(pi R) and the slope a,  v/(speed R) = s a/16 [(1 + 32 twist x/(s a))^1/2 - 1].
struct Hover {
  double thrust = 0.0;  ///< [N]
  double torque = 0.0;  ///< [N m]
};
Hover momentum_theory() {
  constexpr double sa = blades * chord / (std::numbers::pi * radius) * lift_slope;
  constexpr int points = 10000;
  constexpr double dr = length / points;
  Hover hover;
  for (int k = 0; k < points; ++k) {
    const double r = hub_radius + (k + 0.5) * dr;
    const double lambda = sa / 16.0 * (std::sqrt(1.0 + 32.0 * twist_at(r) * r / radius / sa) - 1.0);
    const double v = lambda * speed * radius, alpha = twist_at(r) - v / (speed * r);
    const double thrust = 4.0 * std::numbers::pi * air * v * v * r * dr;
    const double profile = 0.5 * air * chord * speed * speed * r * r * dr * blades;
    hover.thrust += thrust;
    hover.torque += thrust * v / speed + profile * (drag_0 + drag_2 * alpha * alpha) * r;
  }
  return hover;
}

spoke::Scenario make_scenario() {
  return spoke::parse_scenario(R"(
world = "space"
[hub]
radius = 0.3
drive = { kind = "constant", speed = 60.0 }
[blade]
count = 3
length = 1.7
bodies = 3
elements = 2
[blade.sections]
mass_per_length = 1.2
axial_stiffness = 5e6
flap_stiffness = 1e4
lag_stiffness = 4e4
torsion_stiffness = 1e4
twist = [0.26, 0.10]
[damping]
stiffness_factor = 1e-3
[integration]
step = 0.002
duration = 1.5
)",
                               "blade_element");
}

}  // namespace

int main() {
  const spoke::Scenario scenario = make_scenario();
  std::vector<double> places;
  for (int k = 0; k < strips; ++k) places.push_back(radius_of(k) - hub_radius);

  Inflow inflow(strips, 5.0);
  std::vector<std::vector<spoke::Marker>> markers;
  spoke::Loads loads;
  for (int blade = 0; blade < blades; ++blade) {
    markers.push_back(markers_at(scenario, blade, places));
    loads.push_back(make_air(markers.back(), inflow));
  }
  spoke::Simulation simulation(scenario, {}, loads);

  // The momentum of the air follows the thrust of each ring, halfway each time.
  for (double t = 0.2; t < 1.2; t += 0.05) {
    simulation.run_until(t);
    for (std::size_t k = 0; k < inflow.size(); ++k) {
      const double thrust = strip_force(simulation.marker(markers[0][k]), inflow[k]).z() * blades;
      const double ring = 4.0 * std::numbers::pi * air * radius_of(static_cast<double>(k)) * width;
      inflow[k] = 0.5 * (inflow[k] + std::sqrt(std::max(thrust, 0.0) / ring));
    }
    for (int blade = 0; blade < blades; ++blade)
      simulation.set_load(blade, make_air(markers[static_cast<std::size_t>(blade)], inflow));
  }
  simulation.run_until(1.5);

  const Hover expected = momentum_theory();
  const double thrust = -simulation.hub_reaction().force.z();  // the support holds the hub down
  const double torque = simulation.sensor("hub.torque");
  std::printf("thrust %.1f N, by blade-element momentum theory %.1f N\n", thrust, expected.thrust);
  std::printf("torque %.2f N m, by blade-element momentum theory %.2f N m\n", torque,
              expected.torque);
  const bool agrees = std::abs(thrust / expected.thrust - 1.0) < 0.005 &&
                      std::abs(torque / expected.torque - 1.0) < 0.01;
  return agrees ? 0 : 1;
}
