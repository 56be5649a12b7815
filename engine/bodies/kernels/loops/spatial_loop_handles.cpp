// Handles of bodies in space as the loops see them, and the accelerations of frames.

#include <cassert>
#include <utility>

#include "engine/bodies/kernels/loops/loop_motion.h"
#include "engine/bodies/kernels/space/relative_motion.h"

namespace spoke {

LoopHandle calc_loop_handle(const SubsystemData<Space>& data, int body, int handle) noexcept {
  assert(body >= 0 && std::cmp_less(body, data.loops.poses.size()));
  const auto j = static_cast<std::size_t>(body);
  const space::Pose& pose = data.loops.poses[j];
  const space::HandleMotion& motion = data.bodies[j].work.handles[handle];
  return {pose.p + pose.R * motion.s, pose.R * motion.turn.R,
          pose.R * space::Twist(motion.carry(data.twists[j]) + motion.twist())};
}

space::Twist turn_to_body(const SubsystemData<Space>& data, int body,
                          const space::Twist& wrench) noexcept {
  assert(body >= 0 && std::cmp_less(body, data.loops.poses.size()));
  return data.loops.poses[static_cast<std::size_t>(body)].R.inverse() * wrench;
}

space::Twist calc_loop_hub_acceleration(const System<Space>& system, std::size_t i, double t,
                                        const StepData<Space>& data) noexcept {
  return calc_hub_acceleration(system, i, data, t);
}

void calc_loop_accelerations(const Subsystem<Space>& subsystem, const space::Twist& hub,
                             SubsystemData<Space>& data) noexcept {
  assert(data.loops.accelerations.size() == data.bodies.size());
  for (std::size_t j = 0; std::cmp_less_equal(j, data.loops.last_body); ++j) {
    const int parent = subsystem.bodies[j].parent;
    const space::Twist& X =
        parent < 0 ? hub : data.loops.accelerations[static_cast<std::size_t>(parent)];
    data.loops.accelerations[j] = calc_next_acceleration(subsystem.bodies[j], j, data, X);
  }
}

space::Twist calc_loop_acceleration(const SubsystemData<Space>& data, int body,
                                    int handle) noexcept {
  assert(body >= 0 && std::cmp_less(body, data.loops.accelerations.size()));
  const auto j = static_cast<std::size_t>(body);
  return calc_handle_acceleration(data, j, handle, data.loops.accelerations[j]);
}

}  // namespace spoke
