// Carries motion from a support to its rotor's hub, and inertia back.

#include "engine/bodies/kernels/space/supported_rotor.h"

#include <cassert>

#include "engine/bodies/kernels/kinematics.h"
#include "engine/bodies/kernels/loops/anchor_motion.h"
#include "engine/bodies/kernels/loops/loop_motion.h"
#include "engine/bodies/kernels/loops/loop_readings.h"
#include "engine/bodies/kernels/marker_motion.h"
#include "engine/bodies/kernels/samples.h"
#include "engine/bodies/kernels/space/relative_motion.h"
#include "engine/bodies/kernels/space/table_terms.h"
#include "models/system/spatial_system.h"

namespace spoke {
namespace {

/// Returns the turn of a hub about the axle that carries it.
DriveMotion calc_turn(const BodyData<Space>& hub) {
  const space::JointData& axle = hub.joint;
  if (hub.model->joint.joint.driven == 0)
    return {axle.coordinates.q[0], axle.coordinates.v[0], axle.coordinates.a[0]};
  return {axle.driven[0].value, axle.driven[0].rate, axle.driven[0].acceleration};
}

}  // namespace

void place_rotor(const System<Space>& system, std::size_t r, double t, bool is_implicit,
                 StepData<Space>& data) noexcept {
  assert(r < system.rotors.size() && r < data.rotors.size());
  const SupportedRotor& model = system.rotors[r];
  const auto i = static_cast<std::size_t>(model.subsystem);
  const auto j = static_cast<std::size_t>(model.body);
  const SubsystemData<Space>& support = data.subsystems[i];
  RotorData<Space>& rotor = data.rotors[r];
  const HubState<Space>& base = *support.hub;
  const space::Pose pose = calc_pose_in_hub(system.subsystems[i], support, model.body);
  rotor.hub = {base.p + base.R * pose.p, base.R * pose.R, support.twists[j]};
  rotor.turn = calc_turn(support.bodies[j]);
  if (is_implicit || model.is_moved)
    rotor.acceleration = calc_frame_acceleration(
        system.subsystems[i], support, calc_hub_acceleration(system, i, data, t), rotor.path);
}

PartList parts_of_rotor_place(const System<Space>& system, std::size_t r, bool has_implicit,
                              const StepData<Space>& data) {
  const SupportedRotor& model = system.rotors[r];
  const SubsystemParts& support = data.subsystems[static_cast<std::size_t>(model.subsystem)].parts;
  PartList list{support.rotations, support.twists, support.hub_state};
  graph::add_to(list, support.all(&BodyParts::coordinates), support.all(&BodyParts::accelerations));
  if (has_implicit || model.is_moved) list.push_back(data.parts.hub_coordinates);
  return list;
}

void sum_rotor(const System<Space>& system, std::size_t r, bool is_condensed,
               StepData<Space>& data) noexcept {
  assert(r < system.rotors.size() && r < data.rotors.size());
  const SupportedRotor& model = system.rotors[r];
  const auto i = static_cast<std::size_t>(model.subsystem);
  RotorData<Space>& rotor = data.rotors[r];
  const BodyData<Space>& hub = data.subsystems[i].bodies[static_cast<std::size_t>(model.body)];
  space::TwistMatrix mass = hub.blocks[0]->rigid->mass.matrix();
  space::Twist force = space::Twist::Zero();
  space::HubStiffening stiffening;
  for (std::size_t k = 0; k < system.subsystems.size(); ++k) {
    if (system.subsystems[k].rotor != static_cast<int>(r)) continue;
    const SubsystemData<Space>& subsystem = data.subsystems[k];
    if (is_condensed) {
      mass += subsystem.effective.mass;
      force += subsystem.effective.force;
      stiffening += subsystem.effective.stiffening;
    } else {
      for (const BodyData<Space>& body : subsystem.bodies) stiffening += body.terms.stiffening;
    }
  }
  rotary(mass) -= stiffening.inertia;
  angular(force) += calc_stiffening_moment(stiffening, angular(rotor.hub.twist));
  rotor.carried.mass = {0.5 * (mass + mass.transpose())};
  rotor.carried.force = force;
  if (is_condensed) rotor.carried.inverse = invert(rotor.carried.mass);
}

PartList parts_of_rotor_sum(std::size_t r, bool is_condensed, const StepData<Space>& data) {
  PartList list{data.parts.rotors[r].hub};
  for (const SubsystemData<Space>& subsystem : data.subsystems) {
    if (subsystem.rotor != static_cast<int>(r)) continue;
    if (is_condensed)
      list.push_back(subsystem.parts.effective);
    else
      graph::add_to(list, subsystem.parts.all(&BodyParts::terms));
  }
  return list;
}

void update_rotors(const System<Space>& system, double t, StepData<Space>& data) noexcept {
  for (std::size_t r = 0; r < system.rotors.size(); ++r) {
    const auto i = static_cast<std::size_t>(system.rotors[r].subsystem);
    prescribe_joints(system, t, i, data);
    update_kinematics(system.subsystems[i], data.subsystems[i]);
    place_rotor(system, r, t, true, data);
  }
}

const HubState<Space>& shown_hub(const StepData<Space>& data) noexcept {
  return data.rotors.empty() ? data.hub : data.rotors.front().hub;
}

namespace {

/// Returns what anchors beside the axle of a rotor take up at time t [s], about the origin of its
/// hub. They stand on what carries the axle, not on the hub, on which the loops' rows have them;
/// but for the moment about the axis of one that turns with the hub, which the hub drives.
space::Twist sum_beside_axle(const System<Space>& system, std::size_t r, double t,
                             const StepData<Space>& data) {
  space::Twist sum = space::Twist::Zero();
  for (std::size_t i = 0; i < system.subsystems.size(); ++i) {
    if (system.subsystems[i].rotor != static_cast<int>(r)) continue;
    const SubsystemData<Space>& own = data.subsystems[i];
    for (std::size_t k = 0; k < system.subsystems[i].loops.size(); ++k) {
      const LoopModel& loop = system.subsystems[i].loops[k];
      if (!stands_beside_axle(system, loop.to)) continue;
      const space::Position p = calc_place_motion(system, i, loop.from, t, data).p;
      const space::Twist force =
          calc_loop_reaction(system, i, k, t, data, own.loops.multipliers).in_hub;
      const CarriedPlace plate = calc_carried_place(system, *own.hub, own.axle, loop.to, t);
      sum -= translate(p, force);
      const space::Twist about = translate(space::Position(p - plate.pivot_place), force);
      sum[Space::kAxial] += plate.pivot.dot(angular(about));
    }
  }
  return sum;
}

}  // namespace

void record_rotors(const System<Space>& system, double t, std::int64_t step,
                   StepData<Space>& data) noexcept {
  for (std::size_t r = 0; r < system.rotors.size(); ++r) {
    const SupportedRotor& model = system.rotors[r];
    RotorData<Space>& rotor = data.rotors[r];
    const SubsystemData<Space>& support =
        data.subsystems[static_cast<std::size_t>(model.subsystem)];
    const auto j = static_cast<std::size_t>(model.body);
    const space::Angular w = angular(rotor.hub.twist);
    RotorRecord<Space>& made = of_step(rotor.records, step);
    made.position = space::make_twist(rotor.hub.p, space::Angular(0.0, 0.0, rotor.turn.angle));
    made.velocity = space::make_twist(rotor.hub.R * space::Position(linear(rotor.hub.twist)),
                                      space::Angular(w.x(), w.y(), rotor.turn.speed));
    made.rotation = {rotor.hub.R, w.z() - rotor.turn.speed};
    made.reaction = support.wrenches[j].inboard + sum_beside_axle(system, r, t, data);
    made.applied_torque = 0.0;
    const Drive& drive = drive_of(system, static_cast<int>(r));
    // With a coupling the wrench has all that turns the hub.
    if (prescribes_motion(drive) || model.is_coupled) continue;
    made.reaction[Space::kAxial] = 0.0;
    made.applied_torque =
        calc_torque(drive, t, rotor.turn.speed) + support.bodies[j].model->joint.course.added[0];
  }
}

}  // namespace spoke
