#include "tests/engine/bodies/air/rigid_blade.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace spoke::test {

using Eigen::AngleAxisd;
using Eigen::Matrix3d;
using Eigen::Vector3d;

std::vector<MarkerMotion> move_blade(const BladePlace& place, const std::vector<double>& stations) {
  // Azimuth 0: x along z, y along -y (the way of a positive turn about x), z along x.
  Matrix3d upright;
  upright << 0.0, 0.0, 1.0, 0.0, -1.0, 0.0, 1.0, 0.0, 0.0;
  const Matrix3d rotation =
      AngleAxisd(place.azimuth, Vector3d::UnitX()).toRotationMatrix() *
      AngleAxisd(place.cone, Vector3d::UnitY()).toRotationMatrix() * upright *
      AngleAxisd(place.backward ? -place.pitch : place.pitch, Vector3d::UnitX()).toRotationMatrix();
  const Vector3d outward = rotation.col(0);
  const double pitch_rate = place.backward ? -place.pitch_rate : place.pitch_rate;
  std::vector<MarkerMotion> motion;
  for (const double station : stations) {
    MarkerMotion& section = motion.emplace_back();
    section.position = (place.hub_radius + station) * outward;
    section.rotation = rotation;
    section.angular_velocity = place.speed * Vector3d::UnitX() + pitch_rate * outward;
    section.velocity = section.angular_velocity.cross(section.position);
  }
  return motion;
}

AirRun::AirRun(const air::BladeAir& made)
    : blade(made), state(made.state_size()), loads(made.count()), seen(made.count()) {}

void AirRun::go(const BladePlace& place, const Vector3d& wind, double elapsed, bool held) {
  const air::RotorPlace rotor{Vector3d::Zero(), Vector3d::UnitX(), Vector3d::Zero(), place.speed,
                              wind};
  const std::vector<Vector3d> winds(blade.count(), wind);
  blade.evaluate(rotor, move_blade(place, blade.stations()), winds, elapsed, state.data(),
                 state.data(), loads, seen, held);
}

Vector3d AirRun::force() const {
  Vector3d sum = Vector3d::Zero();
  for (const Wrench& load : loads) sum += load.force;
  return sum;
}

Vector3d AirRun::moment(const BladePlace& place) const {
  const std::vector<MarkerMotion> motion = move_blade(place, blade.stations());
  Vector3d sum = Vector3d::Zero();
  for (std::size_t i = 0; i < loads.size(); ++i)
    sum += motion[i].position.cross(loads[i].force) + loads[i].moment;
  return sum;
}

spatial::Airfoil make_airfoil(const std::string& name, const std::function<double(double)>& lift,
                              double drag, double moment) {
  constexpr int rows = 1440;
  spatial::Airfoil airfoil;
  airfoil.name = name;
  spatial::Polar& polar = airfoil.polars.emplace_back();
  for (int i = 0; i <= rows; ++i) {
    polar.angle.push_back((2.0 * i / rows - 1.0) * std::numbers::pi);
    polar.lift.push_back(lift(polar.angle.back()));
    polar.drag.push_back(drag);
    polar.moment.push_back(moment);
  }
  polar.angle.back() = std::numbers::pi;
  polar.lift.back() = polar.lift.front();
  return airfoil;
}

double plate_lift(double angle) {
  const double size = std::abs(std::sin(angle));
  const double attached = 2.0 * std::numbers::pi * std::sin(angle);
  const double separated = std::sin(2.0 * angle);
  const double share = std::clamp((size - std::sin(0.17)) / (0.5 - std::sin(0.17)), 0.0, 1.0);
  return std::cos(angle) < 0.0 ? separated : (1.0 - share) * attached + share * separated;
}

spatial::Air steady_air(std::vector<spatial::Airfoil> airfoils) {
  spatial::Air air;
  air.inflow = spatial::Inflow::quasi_steady;
  air.stall = spatial::Stall::steady;
  air.airfoils = std::move(airfoils);
  return air;
}

spatial::BladeAerodynamics make_blade(const std::vector<double>& stations,
                                      const std::string& airfoil,
                                      const std::function<double(double)>& chord,
                                      const std::function<double(double)>& twist) {
  spatial::BladeAerodynamics blade;
  blade.station = stations;
  for (const double station : stations) {
    blade.chord.push_back(chord(station));
    blade.twist.push_back(twist(station));
    blade.center.push_back(0.0);
    blade.airfoil.push_back(airfoil);
  }
  return blade;
}

std::vector<double> spread(double first, double last, int count) {
  std::vector<double> numbers;
  for (int i = 0; i < count; ++i) numbers.push_back(first + (last - first) * i / (count - 1));
  return numbers;
}

}  // namespace spoke::test
