#include "models/tree/drive_train.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cassert>

namespace spoke::spatial {
namespace {

/// What the equations move from a carrier to its generator.
struct Share {
  double mass = 0.0;    ///< at the generator's place [kg]
  double across = 0.0;  ///< inertia about each axis across the generator's [kg m^2]
};

/// Chooses a share that leaves the carrier an inertia: some hundredth of its mass, less far
/// outside.
Share choose_share(const RigidBody& carrier, const TreeBody& generator) {
  constexpr double kShare = 1e-2;
  assert(carrier.mass > 0.0);
  const double least = Eigen::SelfAdjointEigenSolver<Tensor>(carrier.inertia).eigenvalues()[0];
  assert(least > 0.0);
  const double arm = (generator.placement.position - carrier.center).squaredNorm();
  return {kShare * std::min(carrier.mass, least / std::max(arm, least / carrier.mass)),
          kShare * least};
}

/// Returns the inertia of a mass at a place about the origin.
Tensor inertia_at(double mass, const Vector& place) {
  return mass * (place.squaredNorm() * Tensor::Identity() - place * place.transpose());
}

}  // namespace

RigidBody make_generator(const DriveTrain& train) {
  RigidBody made;
  made.inertia(2, 2) = train.generator_inertia;
  return made;
}

Coupling make_shaft(const DriveTrain& train, const std::string& prefix) {
  Coupling shaft;
  shaft.name = prefix + "shaft";
  shaft.joints = {{prefix + "axle", 1, 1.0},
                  {prefix + std::string(kGeneratorName), 1, -1.0 / train.gear_ratio}};
  shaft.stiffness = train.stiffness;
  shaft.damping = train.damping;
  return shaft;
}

RigidBody with_share(const TreeBody& generator, const RigidBody& carrier) {
  assert(generator.is_generator());
  const Share share = choose_share(carrier, generator);
  RigidBody made = std::get<RigidBody>(generator.shape);
  made.mass = share.mass;
  made.inertia += Vector(share.across, share.across, 0.0).asDiagonal();
  return made;
}

RigidBody without_shares(const RigidBody& carrier, const Tree& tree, int body) {
  RigidBody left = carrier;
  Vector moment = carrier.mass * carrier.center;
  Tensor about_origin = carrier.inertia + inertia_at(carrier.mass, carrier.center);
  for (const TreeBody& generator : tree.bodies) {
    if (!generator.is_generator() || generator.parent != body) continue;
    const Share share = choose_share(carrier, generator);
    const Vector& place = generator.placement.position;
    const Vector axis = generator.placement.rotation.col(2);
    left.mass -= share.mass;
    moment -= share.mass * place;
    about_origin -= inertia_at(share.mass, place) +
                    share.across * (Tensor::Identity() - axis * axis.transpose());
  }
  if (left.mass == carrier.mass) return carrier;
  left.center = moment / left.mass;
  left.inertia = about_origin - inertia_at(left.mass, left.center);
  return left;
}

}  // namespace spoke::spatial
