// Sums of matrices by the loads of rotation and of gravity on a solid and on what it carries.

#include "models/system/solid_tension.h"

#include <Eigen/Geometry>
#include <cassert>

namespace spoke {
namespace {

/// Returns int r x (A r) dm.
space::Position calc_moment(const space::Matrix3& A, const space::Matrix3& second) {
  const space::Matrix3 N = A * second;
  return {N(2, 1) - N(1, 2), N(0, 2) - N(2, 0), N(1, 0) - N(0, 1)};
}

/// The force and moment on a place.
struct PlaceLoad {
  space::Position force = space::Position::Zero();
  space::Position moment = space::Position::Zero();
};

/// Adds the matrices of a load on a place.
template <class Matrices>
void add_place(const Matrices& of_place, const PlaceLoad& load, Eigen::MatrixXd& sum) {
  for (std::size_t c = 0; c < 3; ++c) {
    const auto i = static_cast<Eigen::Index>(c);
    sum += load.force[i] * of_place[c] + load.moment[i] * of_place[c + 3];
  }
}

/// `solid`: ReducedSolid or NodalSolid.
template <class Matrices>
std::shared_ptr<const space::SolidTension> combine(const Matrices& solid,
                                                   const space::SolidConstants& constants,
                                                   const space::Position& origin,
                                                   const std::vector<OutboardMass>& outboard) {
  const auto add_outboard = [&](const OutboardMass& mass, const PlaceLoad& load,
                                Eigen::MatrixXd& sum) {
    if (!constants.places[mass.place].is_fixed())
      add_place(solid.places[mass.place],
                {mass.of_force * load.force, mass.of_moment * load.moment}, sum);
  };
  auto made = std::make_shared<space::SolidTension>();
  for (std::size_t k = 0; k < made->spin.size(); ++k) {
    const space::Matrix3 A = space::spin_matrix(static_cast<int>(k));
    made->spin[k] = solid.own[k];
    const space::Position at = A * origin;
    for (std::size_t c = 0; c < 3; ++c)
      made->spin[k] += at[static_cast<Eigen::Index>(c)] * solid.translation[c];
    for (const OutboardMass& mass : outboard) {
      const space::Position p = origin + constants.places[mass.place].p, pull = A * mass.first;
      add_outboard(mass, {-pull, cross(p, pull) - calc_moment(A, mass.second)}, made->spin[k]);
    }
  }
  for (std::size_t c = 0; c < made->gravity.size(); ++c) {
    const space::Position field = space::Position::Unit(static_cast<Eigen::Index>(c));
    made->gravity[c] = -solid.translation[c];
    for (const OutboardMass& mass : outboard) {
      const space::Position p = origin + constants.places[mass.place].p;
      const space::Position arm = mass.first - mass.mass * p;
      add_outboard(mass, {mass.mass * field, cross(arm, field)}, made->gravity[c]);
    }
  }
  return made;
}

}  // namespace

void set_handed_on(const space::Joint& joint, OutboardMass& mass) {
  using Kind = space::JointPrimitive::Kind;
  for (const space::JointPrimitive& primitive : joint.sequence()) {
    if (primitive.is_driven) continue;
    if (primitive.kind == Kind::spherical) {
      mass.of_moment.setZero();
      continue;
    }
    space::Matrix3& handed_on = primitive.kind == Kind::revolute ? mass.of_moment : mass.of_force;
    // The component along the axis, as far as axes before have left it.
    const space::Position axis = handed_on * space::Position(joint.offset.R * primitive.axis);
    if (axis.norm() > 1e-9) handed_on -= axis * axis.transpose() / axis.squaredNorm();
  }
}

OutboardMass make_outboard_mass(std::size_t place, const spatial::MassProperties& mass,
                                const space::Rotation& to_axis, const space::Position& centre,
                                const space::Rotation& to_body) {
  const spatial::Tensor second =
      0.5 * mass.inertia.trace() * spatial::Tensor::Identity() - mass.inertia;
  const space::Position first = to_axis * space::Position(mass.first_moment);
  const space::Matrix3 about_hub = to_axis.axes * second * to_axis.axes.transpose();
  const space::Matrix3 mixed = first * centre.transpose();
  const space::Matrix3 about_centre =
      about_hub - mixed - mixed.transpose() + mass.mass * centre * centre.transpose();
  return {place, mass.mass, to_body * space::Position(first - mass.mass * centre),
          to_body.axes * about_centre * to_body.axes.transpose()};
}

std::shared_ptr<const space::SolidTension> make_solid_tension(
    const space::SolidConstants& constants, const space::Position& origin,
    const std::vector<OutboardMass>& outboard) {
  assert(constants.is_stiffened);
  if (const space::ReducedSolid* reduced = constants.reduced())
    return combine(*reduced, constants, origin, outboard);
  return combine(*constants.nodal(), constants, origin, outboard);
}

}  // namespace spoke
