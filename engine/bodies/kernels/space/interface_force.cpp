// Sums what joints, loops and loads exert at one place.

#include "engine/bodies/kernels/space/interface_force.h"

#include <cassert>

#include "engine/bodies/kernels/loops/loop_motion.h"
#include "engine/bodies/kernels/loops/loop_readings.h"
#include "engine/bodies/kernels/space/table_access.h"

namespace spoke {
namespace {

/// Returns the wrenches of the bodies that the solid carries at a place, about it, in B.
space::Twist sum_children(const TreeBody<Space>& model, const SubsystemData<Space>& data,
                          int place) {
  const BodyView<Space>& solid = kind_of(*model.body);
  space::Twist sum = space::Twist::Zero();
  for (std::size_t h = 1; h <= model.children.size(); ++h) {
    if (solid.place_of_handle(*model.body, h) != place) continue;
    const auto child = static_cast<std::size_t>(model.children[h - 1]);
    const space::JointMotion& joint = data.joints[child];
    sum -= translate(joint.p, joint.R * data.joint_loads[child]);
  }
  return sum;
}

/// Returns the wrenches of loads on a place, about it, in B.
space::Twist sum_loads(const SubsystemData<Space>& data, const BodyData<Space>& body,
                       const space::Rotation& R_HB, double t, int place) {
  space::Twist sum = space::Twist::Zero();
  for (const auto& load : body.loads)
    for (std::size_t k = 0; k < load.places.size(); ++k)
      if (load.places[k].place_number == place)
        sum += calc_load_wrench(*load.load, k, t, R_HB, data.hub->R,
                                motion_at(body, load.places[k]).turn.R);
  for (const AppliedWrench<Space>& at : body.applied)
    if (at.section->place_number == place) sum += make_wrench(at.wrench->force, at.wrench->moment);
  return sum;
}

/// Returns the wrench of the share of another subsystem's loop on its place on body j, in H.
space::Twist sum_share(const SubsystemData<Space>& own, std::size_t k, int j) {
  const LoopPath& path = own.loops.paths[k];
  space::Twist wrench = space::Twist::Zero();
  for (int row = path.first_row; row < path.first_row + path.rows; ++row) {
    const auto r = static_cast<std::size_t>(row);
    wrench += own.loops.kept_multipliers[r] * own.loops.states[r].from;
  }
  return own.loops.poses[static_cast<std::size_t>(j)].R * wrench;
}

/// Returns the wrenches of loops on a place of body j, about it, in H. p: the place, in H.
space::Twist sum_loops(const System<Space>& system, std::size_t i, double t, int j, int place,
                       const space::Position& p, const StepData<Space>& data) {
  const Subsystem<Space>& subsystem = system.subsystems[i];
  const space::Body& body = *subsystem.bodies[static_cast<std::size_t>(j)].body;
  const auto is_here = [&](const LoopPlaceModel& end) {
    return end.body == j &&
           kind_of(body).place_of_handle(body, static_cast<std::size_t>(end.handle)) == place;
  };
  space::Twist sum = space::Twist::Zero();
  for (std::size_t k = 0; k < subsystem.loops.size(); ++k) {
    const LoopModel& loop = subsystem.loops[k];
    if (loop.is_coupling() || (!is_here(loop.from) && !is_here(loop.to))) continue;
    if (loop.is_share) {
      sum += sum_share(data.subsystems[i], k, j);
      continue;
    }
    // What acts on `from` at its place acts on `to` there with the other sign.
    const space::Twist wrench = translate(
        calc_place_motion(system, i, loop.from, t, data).p - p,
        calc_loop_reaction(system, i, k, t, data, data.subsystems[i].loops.kept_multipliers)
            .in_hub);
    if (is_here(loop.from)) sum += wrench;
    if (is_here(loop.to)) sum -= wrench;
  }
  return sum;
}

}  // namespace

space::Twist calc_interface_force(const System<Space>& system, std::size_t i, double t,
                                  const Reading<Space>& reading,
                                  const StepData<Space>& data) noexcept {
  const SubsystemData<Space>& own = data.subsystems[i];
  const int place = reading.section.place_number;
  const auto j = static_cast<std::size_t>(reading.body());
  assert(place >= 0);
  const BodyData<Space>& body = own.bodies[j];
  const space::Pose& X_HB = own.poses[j];
  const space::Position p = X_HB.p + X_HB.R * motion_at(body, reading.section).s;
  space::Twist sum = sum_children(*body.model, own, place) +
                     sum_loads(own, body, X_HB.R, t, place) +
                     X_HB.R.inverse() * sum_loops(system, i, t, reading.body(), place, p, data);
  if (place == 0) sum += own.joint_loads[j];
  return sum;
}

}  // namespace spoke
