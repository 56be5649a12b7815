// Makes matrices of a subsystem at the state in the table.

#include <cassert>
#include <utility>

#include "engine/bodies/kernels/hub_solve.h"
#include "engine/bodies/kernels/kinematics.h"
#include "engine/small_motions/steady/steady_system.h"
#include "engine/small_motions/steady/subsystem_access.h"
#include "engine/small_motions/steady/subsystem_forces.h"

namespace spoke::steady {

/// Returns the twists of the frames of bodies, below one another, in columns for the twist of the
/// hub and for velocities.
template <class World>
Eigen::MatrixXd SteadySystem<World>::calc_twists(std::size_t subsystem) {
  SubsystemData<World>& own = data(subsystem);
  const Subsystem<World>& model = context_.system.subsystems[subsystem];
  const Eigen::Index n = std::ssize(coordinates_[subsystem]);
  const auto bodies = static_cast<Eigen::Index>(own.bodies.size());
  Eigen::MatrixXd twists(World::kTwist * bodies, World::kTwist + n);
  const Eigen::VectorXd q = take_bodies(subsystem);
  Eigen::VectorXd v = Eigen::VectorXd::Zero(n);
  const PrescribedHub<World> kept = own.prescribed;
  const HubState<World>* const carrier = std::exchange(own.hub, &own.prescribed.state);
  own.prescribed.state = *carrier;
  for (Eigen::Index c = 0; c < twists.cols(); ++c) {
    const bool is_hub = c < World::kTwist;
    own.prescribed.state.twist = is_hub ? Twist(Twist::Unit(c)) : Twist(Twist::Zero());
    if (!is_hub) v[c - World::kTwist] = 1.0;
    put_bodies(subsystem, q, v);
    if (!is_hub) v[c - World::kTwist] = 0.0;
    calc_rotations(model, own);
    calc_velocities(model, own);
    for (Eigen::Index j = 0; j < bodies; ++j)
      twists.block(World::kTwist * j, c, World::kTwist, 1) =
          own.twists[static_cast<std::size_t>(j)];
  }
  own.hub = carrier;
  own.prescribed = kept;
  return twists;
}

namespace {

/// Returns what the modes of beams add to D of a subsystem's coordinates.
template <class World>
Eigen::MatrixXd calc_modal_damping(const Subsystem<World>& subsystem, Eigen::Index coordinates) {
  const auto modes = std::ssize(subsystem.modal_factors);
  Eigen::MatrixXd weights = Eigen::MatrixXd::Zero(coordinates, modes);
  Eigen::Index at = 0;
  for (const TreeBody<World>& body : subsystem.bodies) {
    at += count_joint_coordinates(body);
    const ModalShare& share = body.modal;
    if (!share.is_empty())
      weights.block(at, share.first, share.weights.rows(), share.weights.cols()) = share.weights;
    at += body.body->coordinates();
  }
  const auto factors = Eigen::Map<const Eigen::VectorXd>(subsystem.modal_factors.data(), modes);
  return weights * factors.asDiagonal() * weights.transpose();
}

}  // namespace

template <class World>
SubsystemMatrices SteadySystem<World>::matrices(std::size_t subsystem) {
  assert(subsystem < subsystems());
  constexpr Eigen::Index kHub = World::kTwist;
  SubsystemData<World>& own = data(subsystem);
  const Eigen::Index n = std::ssize(coordinates_[subsystem]);
  SubsystemMatrices result{Eigen::MatrixXd::Zero(kHub + n, kHub + n), Eigen::MatrixXd::Zero(n, n)};
  std::vector<Eigen::MatrixXd> masses;
  for (const BodyData<World>& body : own.bodies) masses.push_back(calc_body_mass(body));
  const auto stiffening = sum_stiffening<World>(own.bodies);
  const Eigen::MatrixXd twists = calc_twists(subsystem);
  Eigen::Index at = 0;
  for (std::size_t j = 0; j < masses.size(); ++j) {
    const BodyData<World>& body = own.bodies[j];
    const Eigen::Index nf = body.model->body->coordinates();
    at += count_joint_coordinates(*body.model);
    const auto T = twists.middleRows(kHub * static_cast<Eigen::Index>(j), kHub);
    const auto C = masses[j].topRightCorner(kHub, nf);
    result.mass += T.transpose() * masses[j].topLeftCorner(kHub, kHub) * T;
    result.mass.middleCols(kHub + at, nf) += T.transpose() * C;
    result.mass.middleRows(kHub + at, nf) += C.transpose() * T;
    result.mass.block(kHub + at, kHub + at, nf, nf) += masses[j].bottomRightCorner(nf, nf);
    if (nf > 0)
      result.damping.block(at, at, nf, nf) = calc_body_damping(context_.system.damping, body);
    at += nf;
  }
  const Subsystem<World>& model = context_.system.subsystems[subsystem];
  if (!model.modal_factors.empty()) result.damping += calc_modal_damping(model, n);
  TwistMatrixOf<World> hub = TwistMatrixOf<World>::Zero();
  rotary(hub) -= stiffening.inertia;
  result.mass.topLeftCorner(kHub, kHub) += hub;
  return result;
}

template <class World>
Eigen::MatrixXd SteadySystem<World>::twists(std::size_t subsystem, int body) {
  assert(subsystem < subsystems());
  return calc_twists(subsystem).middleRows(World::kTwist * body, World::kTwist);
}

template <class World>
Eigen::VectorXd SteadySystem<World>::momenta(std::size_t subsystem, const Eigen::VectorXd& v) {
  assert(subsystem < subsystems() && std::cmp_equal(v.size(), coordinates_[subsystem].size()));
  SubsystemData<World>& own = data(subsystem);
  const Subsystem<World>& model = context_.system.subsystems[subsystem];
  const PrescribedHub<World> kept = own.prescribed;
  const HubState<World>* const carrier = std::exchange(own.hub, &own.prescribed.state);
  own.prescribed.state = *carrier;
  own.prescribed.state.twist = Twist::Zero();
  put_bodies(subsystem, take_bodies(subsystem), v);
  calc_rotations(model, own);
  calc_velocities(model, own);
  own.hub = carrier;
  own.prescribed = kept;
  return calc_momenta(model, own, v);
}

template Eigen::MatrixXd SteadySystem<Plane>::calc_twists(std::size_t);
template SubsystemMatrices SteadySystem<Plane>::matrices(std::size_t);
template Eigen::MatrixXd SteadySystem<Plane>::twists(std::size_t, int);
template Eigen::VectorXd SteadySystem<Plane>::momenta(std::size_t, const Eigen::VectorXd&);
template Eigen::MatrixXd SteadySystem<Space>::calc_twists(std::size_t);
template SubsystemMatrices SteadySystem<Space>::matrices(std::size_t);
template Eigen::MatrixXd SteadySystem<Space>::twists(std::size_t, int);
template Eigen::VectorXd SteadySystem<Space>::momenta(std::size_t, const Eigen::VectorXd&);

}  // namespace spoke::steady
