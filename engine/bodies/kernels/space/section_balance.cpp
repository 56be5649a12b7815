// Sums the momentum over the bodies of a subsystem.

#include "engine/bodies/kernels/space/section_balance.h"

#include <cassert>

#include "engine/bodies/table/body_kind.h"

namespace spoke {

space::Twist calc_momentum(const SubsystemData<Space>& data) noexcept {
  assert(data.poses.size() == data.bodies.size());
  const HubState<Space>& hub = *data.hub;
  space::Twist sum = space::Twist::Zero();
  for (std::size_t j = 0; j < data.bodies.size(); ++j) {
    const BodyData<Space>& body = data.bodies[j];
    const space::Pose& X_HB = data.poses[j];
    const space::Position origin = hub.p + hub.R * X_HB.p;
    sum += translate(origin, hub.R * (X_HB.R * body.kind->calc_momentum(body, data.twists[j])));
    if (!body.model->stiffening) continue;
    angular(sum) -= hub.R * body.kind->calc_stiffening_momentum(body, angular(hub.twist));
  }
  return sum;
}

}  // namespace spoke
