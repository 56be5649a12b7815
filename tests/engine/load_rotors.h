#pragma once

// Rotors and loads that the tests of loads, markers and reactions share.

#include "engine/simulation.h"
#include "tests/engine/rotors.h"

namespace spoke::test {

/// Makes two soft blades of two bodies; rk4 is stable with steps of 2e-4 s.
inline Rotor soft_rotor() {
  Blade blade;
  blade.length = 2.0;
  blade.bodies = 2;
  blade.elements = 2;
  blade.density = 1000.0;
  blade.area = 1e-4;
  blade.second_moment = 1e-8;
  blade.youngs_modulus = 2e8;
  Rotor rotor = make_rotor(blade, 2);
  rotor.blades[1].reference_frame = ReferenceFrame::chord;
  rotor.hub.radius = 0.1;
  rotor.hub.mass = 0.3;
  rotor.hub.drive = SpinUp{3.0, 0.2};
  return rotor;
}

inline Scenario soft_scenario(IntegrationMethod method, double duration, double step = 2e-4) {
  Scenario scenario;
  scenario.rotor = soft_rotor();
  scenario.integration.method = method;
  scenario.integration.duration = duration;
  scenario.integration.step = step;
  return scenario;
}

/// Makes a constant force in the inertial frame.
inline std::shared_ptr<const Load> steady_load(const Marker& marker, double x, double y,
                                               double moment) {
  return make_load("steady", {marker},
                   [x, y, moment](double, std::span<const MarkerMotion>, std::span<Wrench> out) {
                     out[0] = {{x, y, 0.0}, {0.0, 0.0, moment}};
                   });
}

/// Makes a force that follows the section, and a moment.
inline std::shared_ptr<const Load> follower(const Marker& marker, double force, double moment) {
  return make_load(
      "follower", {marker},
      [force, moment](double, std::span<const MarkerMotion> in, std::span<Wrench> out) {
        out[0].force = in[0].rotation * Eigen::Vector3d(0.0, force, 0.0);
        out[0].moment.z() = moment;
      });
}

/// Makes a load that depends on all that a load may depend on, at two markers.
inline std::shared_ptr<const Load> demanding_load(int blade) {
  return make_load("demanding", {{blade, 0, 0.3}, {blade, 1, 0.8}},
                   [](double t, std::span<const MarkerMotion> in, std::span<Wrench> out) {
                     out[0].force = -0.01 * in[1].velocity + 0.001 * t * in[1].position;
                     out[1].force =
                         in[0].rotation * Eigen::Vector3d(0.0, 0.02, 0.0) - 0.02 * in[0].position;
                     out[1].moment = -0.001 * in[1].angular_velocity;
                   });
}

/// Makes this load at markers of two blades.
inline std::shared_ptr<const Load> demanding_load_between() {
  return make_load("between", {{1, 0, 0.4}, {0, 1, 0.7}},
                   [](double t, std::span<const MarkerMotion> in, std::span<Wrench> out) {
                     out[0].force = -0.01 * in[1].velocity + 0.001 * t * in[1].position;
                     out[0].moment = -0.001 * in[1].angular_velocity;
                     out[1].force = in[0].rotation * Eigen::Vector3d(0.0, 0.02, 0.0) +
                                    0.02 * (in[0].position - in[1].position);
                     out[1].moment = -0.002 * in[0].angular_velocity;
                   });
}

/// Makes a spring [N/m] and a damper [N s/m] between two markers, on the line through them.
inline std::shared_ptr<const Load> spring(const Marker& a, const Marker& b, double length,
                                          double stiffness, double damping) {
  return make_load("spring", {a, b},
                   [=](double, std::span<const MarkerMotion> in, std::span<Wrench> out) {
                     const Eigen::Vector3d line = in[1].position - in[0].position;
                     const Eigen::Vector3d along = line.normalized();
                     const double speed = along.dot(in[1].velocity - in[0].velocity);
                     out[0].force = (stiffness * (line.norm() - length) + damping * speed) * along;
                     out[1].force = -out[0].force;
                   });
}

}  // namespace spoke::test
