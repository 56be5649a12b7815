// Weighs the motions of a support by where their energies are.

#include "engine/small_motions/vibration/support_names.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cassert>
#include <map>

#include "engine/small_motions/steady/supported_model.h"

namespace spoke::vibration {
namespace {

using Eigen::Index;
using Eigen::Matrix3d;
using Eigen::MatrixXd;
using Eigen::Vector3cd;
using Eigen::Vector3d;
using Eigen::VectorXcd;

/// Returns the part of a support that has most of an energy z^H A z / 2, positive, or none.
std::string find_part(const VectorXcd& z, const MatrixXd& A, const std::vector<std::string>& of) {
  const VectorXcd force = A * z;
  std::map<std::string, double> energies;
  double all = 0.0;
  for (Index k = 0; k < z.size(); ++k) {
    const double energy = (std::conj(z[k]) * force[k]).real();
    energies[of[static_cast<std::size_t>(k)]] += energy;
    all += energy;
  }
  std::string part;
  double most = 1e-9 * std::abs(all);
  for (const auto& [name, energy] : energies) {
    if (energy <= most) continue;
    most = energy;
    part = name;
  }
  return part;
}

/// The directions in which a support is seen, as columns: fore-aft, side-side, vertical; in the
/// frame of the base.
Matrix3d find_directions(const Vector3d& axle) {
  constexpr double kLevel = 0.1;  // least horizontal part of an axle that gives fore and aft
  const Vector3d level(axle.x(), axle.y(), 0.0);
  Matrix3d directions;
  directions.col(0) = level.norm() > kLevel ? Vector3d(level.normalized()) : Vector3d::UnitX();
  directions.col(2) = Vector3d::UnitZ();
  directions.col(1) = directions.col(2).cross(directions.col(0));
  return directions;
}

/// Kinetic energies of a mode by direction: of the plane of fore and aft, of the one across it, and
/// along and about the vertical.
struct Energies {
  std::array<double, 4> directions{};
  double whirl[2] = {};   ///< of rotors that turn, across their axles, as they go round with them
                          ///< and against them
  std::string axle;       ///< the one about which a rotor has most, besides its carrier
  double of_axle = 0.0;   ///< that energy
  double of_axles = 0.0;  ///< of all rotors about their axles

  double sum() const { return directions[0] + directions[1] + directions[2] + directions[3]; }
};

/// Adds the energies of a rotor as a rigid body.
void add_rotor(std::size_t r, const VectorXcd& z, const Matrix3d& directions, const Linearised& all,
               Energies& energies) {
  const steady::LinearSupport& support = *all.linear.support;
  const steady::SupportedModel& machine = *all.model.on_support();
  const auto at = 6 * static_cast<Index>(r);
  const MatrixXd mass = support.rotor_mass.block<6, 6>(at, at);
  const VectorXcd hub = support.J.middleRows<6>(at) * z;
  const Matrix3d seen = directions.transpose() * machine.hub_place(r).axes;
  const Matrix3d inertia = seen * mass.bottomRightCorner<3, 3>() * seen.transpose();
  const Vector3cd moved = seen * hub.head<3>(), turned = seen * hub.tail<3>();
  const auto moves = [&](Index k) { return mass(0, 0) * std::norm(moved[k]); };
  const auto turns = [&](Index k) { return inertia(k, k) * std::norm(turned[k]); };
  energies.directions[0] += moves(0) + turns(1);
  energies.directions[1] += moves(1) + turns(0);
  energies.directions[2] += moves(2);
  energies.directions[3] += turns(2);
  constexpr std::complex<double> kI(0.0, 1.0);
  const double speed = machine.parts(r).speed;
  for (const int against : {0, 1}) {
    if (speed == 0.0) break;
    const std::complex<double> i = (against == 1) == (speed > 0.0) ? -kI : kI;
    energies.whirl[against] += 0.5 * mass(0, 0) * std::norm(hub[0] + i * hub[1]) +
                               0.5 * mass(3, 3) * std::norm(hub[3] + i * hub[4]);
  }
  if (!support.axles[r]) return;
  const double of_axle = mass(5, 5) * std::norm(z[*support.axles[r]]);
  energies.of_axles += of_axle;
  if (of_axle <= energies.of_axle) return;
  energies.of_axle = of_axle;
  energies.axle = machine.parts(r).prefix + "axle";
}

/// Adds the energies of the support's own bodies.
void add_support(const VectorXcd& z, const Matrix3d& directions, const Linearised& all,
                 Energies& energies) {
  const std::size_t i = all.model.on_support()->support_index();
  const SubsystemShape shape =
      calc_subsystem_shape(i, all.equilibrium.q[i], all.linear.support->motion * z, all.model);
  const auto places = all.model.places(i);
  for (std::size_t k = 0; k < places.size(); ++k) {
    const Vector3cd moved = directions.transpose() * shape.nodes[k];
    for (std::size_t c = 0; c < 3; ++c)
      energies.directions[c] += places[k].mass * std::norm(moved[static_cast<Index>(c)]);
  }
}

/// Returns the direction in which a mode moves.
std::string find_direction(const Energies& energies) {
  constexpr double kRound = 0.25;  // largest energy of one sense by that of the other
  const double with = energies.whirl[0], against = energies.whirl[1];
  const bool is_round = std::min(with, against) < kRound * std::max(with, against) &&
                        with + against > 0.5 * energies.sum();
  if (is_round) return with > against ? "forward whirl" : "backward whirl";
  static constexpr const char* kNames[] = {"fore-aft", "side-side", "vertical", "yaw"};
  const auto& shares = energies.directions;
  return kNames[std::max_element(shares.begin(), shares.end()) - shares.begin()];
}

}  // namespace

std::string name_support_motion(const VectorXcd& z, const Linearised& all) {
  assert(all.linear.support);
  const steady::LinearSupport& support = *all.linear.support;
  const steady::SupportedModel& machine = *all.model.on_support();
  const Matrix3d directions = find_directions(machine.hub_place(0).axes.col(2));
  Energies energies;
  for (std::size_t r = 0; r < machine.rotors(); ++r) add_rotor(r, z, directions, all, energies);
  if (energies.of_axles > 0.5 * energies.sum()) return energies.axle;
  add_support(z, directions, all, energies);
  std::string part = find_part(z, support.K, support.of);
  if (part.empty()) part = find_part(z, support.M, support.of);
  return part + ' ' + find_direction(energies);
}

}  // namespace spoke::vibration
