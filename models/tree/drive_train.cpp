#include "models/tree/drive_train.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cassert>
#include <cstddef>
#include <variant>

namespace spoke::spatial {
namespace {

/// What the equations move from a body to a generator.
struct Share {
  double mass = 0.0;    ///< at the generator's place [kg]
  double across = 0.0;  ///< inertia about each axis across the generator's [kg m^2]
};

/// Chooses a share that leaves the giver an inertia: some hundredth of its mass, less far outside.
/// `place`: of the generator in its frame.
Share choose_share(const RigidBody& giver, const Vector& place) {
  constexpr double kShare = 1e-2;
  assert(giver.mass > 0.0);
  const double least = Eigen::SelfAdjointEigenSolver<Tensor>(giver.inertia).eigenvalues()[0];
  assert(least > 0.0);
  const double arm = (place - giver.center).squaredNorm();
  return {kShare * std::min(giver.mass, least / std::max(arm, least / giver.mass)), kShare * least};
}

/// Which body gives a generator its share, and where the generator is in that one's frame.
struct Giver {
  int body = -1;  ///< index in the tree; -1: the base
  Placement generator{};
};

/// Finds the giver: a carrier that is rigid; else the hub, which stands behind its generator in the
/// tree and has its origin there, and its axis.
Giver find_giver(const Tree& tree, std::size_t generator) {
  const TreeBody& own = tree.bodies[generator];
  const bool is_on_rigid =
      own.parent < 0 ||
      std::holds_alternative<RigidBody>(tree.bodies[static_cast<std::size_t>(own.parent)].shape);
  if (is_on_rigid) return {own.parent, own.placement};
  assert(tree.bodies[generator + 1].is_hub());
  return {static_cast<int>(generator) + 1, {}};
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

RigidBody with_share(const Tree& tree, std::size_t generator, const RigidBody& base) {
  assert(tree.bodies[generator].is_generator());
  const Giver giver = find_giver(tree, generator);
  const RigidBody& from =
      giver.body < 0 ? base
                     : std::get<RigidBody>(tree.bodies[static_cast<std::size_t>(giver.body)].shape);
  const Share share = choose_share(from, giver.generator.position);
  RigidBody made = std::get<RigidBody>(tree.bodies[generator].shape);
  made.mass = share.mass;
  made.inertia += Vector(share.across, share.across, 0.0).asDiagonal();
  return made;
}

RigidBody without_shares(const RigidBody& giver, const Tree& tree, int body) {
  RigidBody left = giver;
  Vector moment = giver.mass * giver.center;
  Tensor about_origin = giver.inertia + inertia_at(giver.mass, giver.center);
  for (std::size_t j = 0; j < tree.bodies.size(); ++j) {
    if (!tree.bodies[j].is_generator()) continue;
    const Giver found = find_giver(tree, j);
    if (found.body != body) continue;
    const Vector& place = found.generator.position;
    const Share share = choose_share(giver, place);
    const Vector axis = found.generator.rotation.col(2);
    left.mass -= share.mass;
    moment -= share.mass * place;
    about_origin -= inertia_at(share.mass, place) +
                    share.across * (Tensor::Identity() - axis * axis.transpose());
  }
  if (left.mass == giver.mass) return giver;
  left.center = moment / left.mass;
  left.inertia = about_origin - inertia_at(left.mass, left.center);
  return left;
}

}  // namespace spoke::spatial
