// Local errors of orientations, joints and the hub, and the lengths by which they are measured.

#include "engine/step/step_errors.h"

#include <algorithm>
#include <cmath>

#include "engine/bodies/kernels/hub_motion.h"
#include "engine/bodies/table/body_kind.h"

namespace spoke {
namespace {

/// Returns the error of an orientation with velocity w and accelerations a before, and a + change
/// after [rad].
double calc_turn_error(const GeneralizedAlpha& method, const space::Angular& w,
                       const space::Angular& a, const space::Angular& change,
                       space::TurnFrame frame) {
  const double h = method.step, sign = frame == space::TurnFrame::child ? -1.0 : 1.0;
  const double c = method.error_share * method.position_gain;
  return (c * change + sign * h * h * h / 12.0 * cross(w, space::Angular(a + change))).norm();
}

space::Angular angular_at(const double* values) { return {values[0], values[1], values[2]}; }

/// Returns the error of coordinate `c` of a block that finds accelerations `found` [m, rad].
double calc_error(const GeneralizedAlpha& method, const double* found, int c,
                  const CoordinateBlock& block) {
  return method.error_share * method.position_gain *
         std::abs(found[c] - block.history[GeneralizedAlpha::last_a][c]);
}

double length_of(const TreeBody<Plane>& body) { return body.body->length; }
/// Returns 0 for a rigid body.
double length_of(const TreeBody<Space>& body) { return kind_of(*body.body).length(*body.body); }
/// Returns the size of a body's deformation coordinates: of a solid that of its modes.
double size_of_coordinates(const TreeBody<Plane>& body) { return length_of(body); }
double size_of_coordinates(const TreeBody<Space>& body) {
  return kind_of(*body.body).coordinate_size(*body.body);
}

double reach_of(const TreeBody<Plane>&) { return 0.0; }
double reach_of(const TreeBody<Space>& body) { return kind_of(*body.body).reach(*body.body); }

template <class World>
double rotation_error(const GeneralizedAlpha& method, const TwistOf<World>& found,
                      const CoordinateBlock& hub, bool is_free) {
  if constexpr (World::kTwist == space::kTwist) {
    if (is_free) {
      const space::Angular a = angular_at(hub.history[GeneralizedAlpha::last_a] + space::kPosition);
      const space::Angular change = space::Angular(angular(found)) - a;
      return calc_turn_error(method, angular_at(hub.v + space::kPosition), a, change,
                             space::TurnFrame::child);
    }
  }
  return calc_error(method, found.data(), World::kAxial, hub);
}

}  // namespace

StepError estimate_joint_error(const GeneralizedAlpha& method,
                               const BodyData<Space>& body) noexcept {
  const CoordinateBlock& block = body.joint.coordinates;
  const double* found = body.joint.a_found;
  double largest = 0.0;
  int c = 0;
  for (const space::JointPrimitive& primitive : body.model->joint.joint.sequence()) {
    if (primitive.is_driven) continue;
    double error = 0.0;
    if (primitive.kind == space::JointPrimitive::Kind::spherical) {
      const space::Angular a = angular_at(block.history[GeneralizedAlpha::last_a] + c);
      error = calc_turn_error(method, angular_at(block.v + c), a, angular_at(found + c) - a,
                              primitive.frame);
    } else {
      error = calc_error(method, found, c, block);
      if (primitive.kind == space::JointPrimitive::Kind::prismatic) error /= body.length;
    }
    largest = std::max(largest, error);
    c += primitive.components();
  }
  return {largest, -1, -1, CoordinatePlace::joint};
}

template <class World>
StepError estimate_hub_error(const System<World>& system, const GeneralizedAlpha& method,
                             const TwistOf<World>& found, const StepData<World>& data) noexcept {
  const CoordinateBlock& hub = data.hub_coordinates;
  double place = 0.0;
  for (int c = 0; c < World::kPosition; ++c)
    if (!is_prescribed(system.hub, c))
      place = std::max(place, calc_error(method, found.data(), c, hub) / data.length);
  double turn = 0.0;
  if (!is_prescribed(system.hub, World::kAxial))
    turn = rotation_error<World>(method, found, hub, system.hub.support == HubSupport::free);
  if (place > turn) return {place, -1, -1, CoordinatePlace::hub_position};
  return {turn, -1, -1, CoordinatePlace::hub_rotation};
}

template <class World>
void set_lengths(StepData<World>& data) {
  double longest = 0.0, farthest = 0.0;
  for (SubsystemData<World>& subsystem : data.subsystems)
    for (BodyData<World>& body : subsystem.bodies) {
      longest = std::max(longest, length_of(*body.model));
      farthest = std::max(farthest, reach_of(*body.model));
    }
  data.length = longest > 0.0 ? longest : farthest > 0.0 ? farthest : 1.0;
  for (SubsystemData<World>& subsystem : data.subsystems)
    for (BodyData<World>& body : subsystem.bodies) {
      const double own = size_of_coordinates(*body.model);
      body.length = own > 0.0 ? own : data.length;
    }
}

template StepError estimate_hub_error(const System<Plane>&, const GeneralizedAlpha&,
                                      const TwistOf<Plane>&, const StepData<Plane>&) noexcept;
template StepError estimate_hub_error(const System<Space>&, const GeneralizedAlpha&,
                                      const TwistOf<Space>&, const StepData<Space>&) noexcept;
template void set_lengths(StepData<Plane>&);
template void set_lengths(StepData<Space>&);

}  // namespace spoke
