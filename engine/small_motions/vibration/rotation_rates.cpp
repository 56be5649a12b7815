// Maps the rates of rotation vectors, and differentiates these maps.

#include "engine/small_motions/vibration/rotation_rates.h"

#include "engine/small_motions/steady/differences.h"
#include "engine/small_motions/steady/steady_model.h"
#include "models/space/rotation_vector.h"

namespace spoke::vibration {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::Vector3d;
using Eigen::VectorXd;

/// Returns the velocity, and below it the acceleration, of a rotation vector.
VectorXd move_rotation(double sense, const Vector3d& theta, const Vector3d& rate,
                       const Vector3d& second) {
  const space::RotationVectorMotion motion =
      space::calc_rotation_vector_motion(sense * theta, sense * rate);
  VectorXd both(6);
  both << sense * motion.velocity, motion.H * second + sense * motion.convective;
  return both;
}

}  // namespace

std::vector<RotationAt> list_rotations(const PeriodicSystem& mean,
                                       const steady::SteadyModel& model) {
  std::vector<RotationAt> list;
  for (std::size_t i = 0; i < model.subsystems(); ++i) {
    const std::vector<steady::SubsystemCoordinate>& coordinates = model.coordinates(i);
    for (std::size_t k = 0; k < coordinates.size(); ++k) {
      if (coordinates[k].sense == 0) continue;
      list.push_back(
          {mean.starts[i] + static_cast<Index>(k), static_cast<double>(coordinates[k].sense)});
      k += 2;
    }
  }
  return list;
}

TurnMotion find_velocities(const TurnMotion& rates, const std::vector<RotationAt>& rotations) {
  TurnMotion motion = rates;
  for (const RotationAt& own : rotations)
    for (Index l = 0; l < rates.parts(); ++l) {
      const VectorXd both =
          move_rotation(own.sense, rates.x.col(l).segment<3>(own.at),
                        rates.v.col(l).segment<3>(own.at), rates.a.col(l).segment<3>(own.at));
      motion.v.col(l).segment<3>(own.at) = both.head<3>();
      motion.a.col(l).segment<3>(own.at) = both.tail<3>();
    }
  return motion;
}

RateMaps find_rate_maps(const TurnMotion& rates, Index l, const std::vector<RotationAt>& rotations,
                        Index hub, Index at, Index count) {
  constexpr double kStep = 1e-3;  // [rad], of differences of fourth order
  const MatrixXd zero = MatrixXd::Zero(hub + count, hub + count);
  RateMaps maps{zero, MatrixXd::Identity(hub + count, hub + count), zero, zero};
  for (const RotationAt& own : rotations) {
    if (own.at < at || own.at >= at + count) continue;
    const Vector3d theta = rates.x.col(l).segment<3>(own.at);
    const Vector3d rate = rates.v.col(l).segment<3>(own.at);
    const Vector3d second = rates.a.col(l).segment<3>(own.at);
    const Index to = hub + own.at - at;
    for (Index k = 0; k < 3; ++k) {
      const auto put = [&](const VectorXd& slope, MatrixXd& v, MatrixXd& a) {
        v.block<3, 1>(to, to + k) = slope.head<3>();
        a.block<3, 1>(to, to + k) = slope.tail<3>();
      };
      put(steady::differ_finely(kStep,
                                [&](double angle) {
                                  const Vector3d moved = theta + angle * Vector3d::Unit(k);
                                  return move_rotation(own.sense, moved, rate, second);
                                }),
          maps.v_by_x, maps.a_by_x);
      // They are of second degree in rates, so that any step is exact.
      put(steady::differ(1.0,
                         [&](double more) {
                           const Vector3d faster = rate + more * Vector3d::Unit(k);
                           return move_rotation(own.sense, theta, faster, second);
                         }),
          maps.v_by_rate, maps.a_by_rate);
    }
  }
  return maps;
}

}  // namespace spoke::vibration
