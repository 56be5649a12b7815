// Picks what kernels read from the table.

#include "engine/bodies/kernels/space/table_access.h"

#include <cassert>

#include "models/space/mount.h"

namespace spoke {

bool has_nonlinear_strain(const BodyData<Space>& body) {
  return body.kind->has_nonlinear_strain(*body.model->body);
}

space::BodyState body_state_of(const BodyData<Space>& body) {
  return {body.coordinates.q, body.coordinates.v, body.q_elastic, body.v_elastic};
}

space::Twist calc_load_wrench(const BodyLoad<Space>& load, std::size_t k, double t,
                              const space::Rotation& R_HB, const space::Rotation& R_0,
                              const space::Rotation& section) noexcept {
  assert(k < load.points.size() && load.course);
  const double size = load.course->value(t) * load.points[k].weight;
  const space::Rotation R = resolve_load(load.frame, R_HB, R_0, section);
  return size * (R * make_wrench(load.force, load.moment));
}

space::JointState joint_state_of(const BodyData<Space>& body) {
  return {body.joint.coordinates.q, body.joint.coordinates.v, &body.joint.rotation->reference,
          body.joint.driven};
}

space::BodyMotion body_motion_of(const System<Space>& system, double t, std::size_t j,
                                 const SubsystemData<Space>& data) noexcept {
  return {angular(data.twists[j]), angular(data.hub->twist), calc_tension_field(system, t, data)};
}

void add_hub_moment(const space::Angular& moment, const HubState<Space>& hub,
                    space::BodyTerms& terms) noexcept {
  terms.stiffening.moment += moment;
  terms.load_power += moment.dot(space::Angular(angular(hub.twist)));
}

space::Rotation resolve_load(spatial::LoadFrame frame, const space::Rotation& R_HB,
                             const space::Rotation& R_0, const space::Rotation& section) noexcept {
  switch (frame) {
    case spatial::LoadFrame::inertial:
      return (R_0 * R_HB).inverse();
    case spatial::LoadFrame::hub:
      return R_HB.inverse();
    case spatial::LoadFrame::body:
      return {};
    case spatial::LoadFrame::section:
      break;
  }
  return section;
}

space::Position calc_tension_field(const System<Space>& system, double t,
                                   const SubsystemData<Space>& data) noexcept {
  if (data.moved_acceleration) return -linear(*data.moved_acceleration);
  if (system.hub.support == HubSupport::free)
    return data.flight_acceleration ? space::Position(-*data.flight_acceleration)
                                    : space::Position::Zero();
  space::Position field = system.gravity_at(t);
  if (system.hub.mount) field -= calc_axle_motion(system.hub, t).a;
  return data.hub->R.inverse() * field;
}

}  // namespace spoke
