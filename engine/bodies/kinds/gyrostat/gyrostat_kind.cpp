// The gyroscopic moment of what spins. It does no work: energies are those of a rigid body.

#include "engine/bodies/kinds/gyrostat/gyrostat_kind.h"

namespace spoke {

void GyrostatKind::calc_terms(const System<Space>& system, double t,
                              const space::ImplicitShares& shares, std::size_t j,
                              SubsystemData<Space>& data) const noexcept {
  RigidKind::calc_terms(system, t, shares, j, data);
  Data& body = data.bodies[j];
  angular(body.terms.Q) -= cross(angular(data.twists[j]), body.model->body->rigid()->spin);
}

space::Twist GyrostatKind::calc_momentum(const Data& body,
                                         const space::Twist& twist) const noexcept {
  return RigidKind::calc_momentum(body, twist) +
         space::make_twist(space::Position::Zero(), body.model->body->rigid()->spin);
}

}  // namespace spoke
