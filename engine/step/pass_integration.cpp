// Hands accelerations to the integrator, and sums the reports of bodies.

#include "engine/step/pass_integration.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numbers>

#include "engine/bodies/kernels/deformation_limits.h"
#include "engine/bodies/kernels/hub_motion.h"
#include "engine/bodies/kernels/hub_solve.h"
#include "engine/bodies/kernels/kinematics.h"
#include "engine/step/integrator/relaxation.h"
#include "engine/step/step_errors.h"

namespace spoke {
namespace {

/// Returns the sum of the squares of a body's coordinates, which are even in number or followed by
/// a zero.
double sum_squares(const CoordinateBlock& coordinates) {
  assert(coordinates.margin % 2 == 0 && coordinates.gap_end % 2 == 0);
  const double* q = coordinates.q;
  Double2 sum{};
  coordinates.for_parts([&](int first, int n) {
    for (int i = first; i < first + n; i += 2) sum += load_aligned(q + i) * load_aligned(q + i);
  });
  return total(sum);
}

/// Returns a value that all coordinates of a body may have [m, rad].
double limit_of(const plane::FlexibleBody& body) { return std::min(body.length, std::numbers::pi); }
double limit_of(const space::Body& body) { return body.coordinate_limit(); }

/// Whether a body surely is within its limits: one comparison, which NaN and infinity fail as well.
template <class World>
bool is_small(double squares, const BodyData<World>& body) {
  const double limit = limit_of(*body.model->body);
  return squares <= limit * limit;
}

Correction correct_by_share(const GeneralizedAlpha& method, double share, const double* found,
                            CoordinateBlock& block) {
  return share == 1.0 ? correct(method, found, block)
                      : correct_relaxed(method, share, found, block);
}

/// Hands the accelerations that a pass has found to the integrator.
Correction take_accelerations(const Method& method, const PassControl& control, const double* found,
                              CoordinateBlock& block) {
  const auto* alpha = std::get_if<GeneralizedAlpha>(&method);
  if (!alpha) return {};  // rk4 finds them in the block itself
  if (control.stage == PassControl::kEvaluateOnly) {
    block.for_parts([&](int first, int n) { std::copy_n(found + first, n, block.a + first); });
    return {};
  }
  if (control.stage != PassControl::kRestart)
    return correct_by_share(*alpha, control.relaxation, found, block);
  complete_restart(*alpha, found, block);
  return {};
}

template <class Vector>
bool is_finite(const Vector& X) {
  return std::isfinite(X.sum());
}

template <class World>
void add_reports(const SubsystemData<World>& subsystem, PassReport& sum) {
  for (const BodyData<World>& body : subsystem.bodies) {
    sum.power.applied += body.terms.load_power;
    if constexpr (tree::kHasJointCoordinates<World>) sum.power.applied += body.report.drive_power;
    sum.power.dissipation += body.terms.dissipation;
    sum.change = std::max(sum.change, body.report.change);
    sum.step_change = std::max(sum.step_change, body.report.step_change);
    sum.failed |= body.report.failed;
  }
  if (subsystem.loops.is_empty()) return;
  const LoopReport& loops = subsystem.loops.report;
  sum.power.applied += loops.power;
  sum.power.dissipation += loops.dissipation;
  sum.failed |= has_lost_loop(loops);
}

/// Adds the deflections and errors of subsystem `i`.
template <class World>
void add_largest(const SubsystemData<World>& subsystem, int i, PassReport& sum) {
  for (std::size_t j = 0; j < subsystem.bodies.size(); ++j) {
    const BodyReport& report = subsystem.bodies[j].report;
    const int body = static_cast<int>(j);
    if (report.deflection > sum.deflection.ratio) sum.deflection = {report.deflection, i, body};
    if (report.error.size > sum.error.size)
      sum.error = {report.error.size, i, body, report.error.place};
  }
  if (subsystem.loops.is_empty()) return;
  const LoopReport& loops = subsystem.loops.report;
  if (loops.least_pivot < sum.loop.left) sum.loop = {loops.least_pivot, i, loops.row};
}

/// Adds the record of subsystem `i`.
template <class World>
void add_record(const ReactionRecord<World>& record, int i, SystemRecord<World>& sum) {
  StepRecord& step = sum.step;
  step.passes = std::max(step.passes, record.step.passes);
  step.work += record.step.work;
  step.dissipated += record.step.dissipated;
  sum.reaction += record.reaction;
  const LargeDeflection& deflection = record.step.deflection;
  if (deflection.ratio > step.deflection.ratio)
    step.deflection = {deflection.ratio, i, deflection.body};
  const StepError& error = record.step.error;
  if (error.size > step.error.size) step.error = {error.size, i, error.body, error.place};
  const LoopNearness& loop = record.step.loop;
  if (loop.left < step.loop.left) step.loop = {loop.left, i, loop.row};
}

/// Returns the work on the hub's own inertia, which turns faster [J].
template <class World>
double work_on_hub(const System<World>& system, double speed_before, double speed) {
  return 0.5 * axial_inertia(system.hub) * (speed * speed - speed_before * speed_before);
}

/// Returns the power of gravity on the hub itself [W]; hub frame.
double gravity_power(const Hub& hub, const Position& gravity, const Twist& twist) {
  return hub.mass * gravity.dot(linear(twist));
}
double gravity_power(const space::Hub& hub, const space::Position& gravity,
                     const space::Twist& twist) {
  const space::Twist momentum = hub.inertia * twist;
  return gravity.dot(linear(momentum));
}

bool has_mount(const Hub&) { return false; }
bool has_mount(const space::Hub& hub) { return hub.mount.has_value(); }

/// Returns the power of a moving mount on the hub besides turning it about the axle [W].
double mount_power(const Hub&, const Twist&, const Twist&) { return 0.0; }
double mount_power(const space::Hub& hub, const space::Twist& reaction, const space::Twist& twist) {
  if (!hub.mount) return 0.0;
  return reaction.head<Space::kAxial>().dot(twist.head<Space::kAxial>());
}

/// Returns the energy of a hub alone: kinetic, less the work of gravity, which is that of a load if
/// it rises [J].
double mechanical_energy(const System<Space>& system, const HubState<Space>& hub) {
  const double kinetic = 0.5 * hub.twist.dot(system.hub.inertia * hub.twist);
  if (system.gravity_ramp > 0.0) return kinetic;
  const space::Matrix3 rt = system.hub.inertia.rt();
  const space::Position moment(rt(2, 1), rt(0, 2), rt(1, 0));
  return kinetic - system.gravity.dot(system.hub.mass * hub.p + hub.R * moment);
}

/// Returns the work on a hub whose whole motion is prescribed in a step, besides that on its
/// subsystems [J].
double work_in_step(const System<Plane>& system, double, double speed_before,
                    const StepData<Plane>& data) {
  return work_on_hub(system, speed_before, data.hub_coordinates.v[Plane::kAxial]);
}
double work_in_step(const System<Space>& system, double t_before, double,
                    const StepData<Space>& data) {
  return mechanical_energy(system, calc_hub_state(data)) -
         mechanical_energy(system, calc_prescribed_motion(system, t_before).state);
}

/// Returns the wrench that the hub's own inertia takes at its present acceleration.
template <class World>
TwistOf<World> wrench_on_hub(const System<World>& system, const StepData<World>& data) {
  HubSolution<World> none{};
  none.load.setZero();
  return calc_hub_mass(system.hub) * data.hub_solution.acceleration -
         calc_hub_force<World>(system.hub, data.hub, none);
}

/// Records place, velocity and orientation of the hub at the end of a step.
template <class World>
void record_hub(const StepData<World>& data, SystemRecord<World>& record) {
  record.position = Eigen::Map<const TwistOf<World>>(data.hub_coordinates.q);
  record.velocity = Eigen::Map<const TwistOf<World>>(data.hub_coordinates.v);
  if constexpr (tree::kHasJointCoordinates<World>)
    record.hub_rotation = {calc_hub_state(data).R, data.hub_attitude.mount_spin};
}

// Coordinates of the joints that carry the bodies; planar joints have none.

double complete_joint(const Method&, const PassControl&, BodyData<Plane>&) { return 0.0; }
double complete_joint(const Method& method, const PassControl& control, BodyData<Space>& body) {
  CoordinateBlock& block = body.joint.coordinates;
  if (block.size == 0) return 0.0;
  return take_accelerations(method, control, body.joint.a_found, block).change;
}

double joint_step_change(const GeneralizedAlpha&, const BodyData<Plane>&) { return 0.0; }
double joint_step_change(const GeneralizedAlpha& method, const BodyData<Space>& body) {
  const CoordinateBlock& block = body.joint.coordinates;
  return block.size == 0 ? 0.0 : calc_step_change(method, body.joint.a_found, block);
}

}  // namespace

template <class World>
void complete_body(const Method& method, const PassControl& control,
                   BodyData<World>& body) noexcept {
  const auto* alpha = control.stage == 0 ? std::get_if<GeneralizedAlpha>(&method) : nullptr;
  StepError error{};
  double step_change = 0.0;
  if (alpha) {
    error = estimate_joint_error(*alpha, body);
    step_change = calc_step_change(*alpha, body.a_found, body.coordinates);
    const StepError own = estimate_deformation_error(*alpha, step_change, body);
    if (own.size > error.size) error = own;
    step_change = std::max(step_change, joint_step_change(*alpha, body));
  }
  const Correction correction = take_accelerations(method, control, body.a_found, body.coordinates);
  body.report.change = std::max(correction.change, complete_joint(method, control, body));
  body.report.step_change = step_change;
  body.report.error = error;
  const bool is_rk4_step = std::holds_alternative<Rk4>(method) && control.stage == 0;
  const double squares = is_rk4_step ? sum_squares(body.coordinates) : correction.squares;
  // An error in the deformation's accelerations is one in the frame's, too. Limits are those of
  // states: rk4's stages within a step are none.
  const bool is_fine = is_finite(body.X) && (is_small(squares, body) || !has_left_limits(body));
  body.report.failed = !is_fine;
  body.report.deflection = squares <= body.surely_linear ? 0.0 : find_large_deflection(body);
}

template <class World>
void complete_hub(const System<World>& system, const Method& method,
                  StepData<World>& data) noexcept {
  CoordinateBlock& hub = data.hub_coordinates;
  const TwistOf<World> found = calc_inertial_acceleration(system, data.progress[0].control.time,
                                                          data.hub, data.hub_solution);
  double change = 0.0, step_change = 0.0;
  const auto* alpha = std::get_if<GeneralizedAlpha>(&method);
  const PassControl& control = data.progress[0].control;
  data.hub_solution.error = {};
  if (alpha && control.stage == 0)
    data.hub_solution.error = estimate_hub_error(system, *alpha, found, data);
  for (int c = 0; c < World::kTwist; ++c) {
    if (is_prescribed(system.hub, c)) continue;
    CoordinateBlock component = hub.component(c);
    if (alpha && control.stage == 0)
      step_change = std::max(step_change, calc_step_change(*alpha, &found[c], component));
    if (alpha && !control.is_between_steps())
      change = std::max(change,
                        correct_by_share(*alpha, control.relaxation, &found[c], component).change);
    else if (control.stage == PassControl::kRestart)
      complete_restart(*alpha, &found[c], component);
    else
      hub.a[c] = found[c];
  }
  data.hub_solution.change = change;
  data.hub_solution.step_change = step_change;
}

template <class World>
PartList parts_of_completed_hub(const System<World>& system, const Method& method,
                                const StepData<World>& data) {
  PartList list{data.parts.hub_state, data.parts.hub_coordinates};
  if (std::holds_alternative<GeneralizedAlpha>(method) && !is_prescribed(system))
    list.push_back(data.parts.hub_history);
  return list;
}

template <class World>
void finish_subsystem(const typename World::Hub& hub, const Integrator& integrator,
                      const Window& window, SubsystemData<World>& subsystem) noexcept {
  StepProgress& progress = *subsystem.progress;
  const TwistOf<World> reaction = calc_reaction(subsystem);
  PassReport report;
  report.power.applied = reaction[World::kAxial] * subsystem.hub->twist[World::kAxial];
  report.power.applied += mount_power(hub, reaction, subsystem.hub->twist);
  add_reports(subsystem, report);
  add_largest(subsystem, -1, report);
  ReactionRecord<World>& record = of_step(subsystem.records, progress.step);
  record.reaction = reaction;
  end_pass(integrator, window, report, progress, record.step);
}

template <class World>
void finish_system(const System<World>& system, const Integrator& integrator,
                   StepData<World>& data) noexcept {
  StepProgress& progress = data.progress[0];
  const HubSolution<World>& hub = data.hub_solution;
  PassReport report;
  // The work on the inertia of a hub is known where its motion is: from the whole of it, or from
  // its rotation.
  const bool is_given = is_prescribed(system);
  const bool is_turned =
      !is_given && is_prescribed(system.hub, World::kAxial) && !has_mount(system.hub);
  TwistOf<World> reaction = hub.reaction;
  if (is_given) reaction -= wrench_on_hub(system, data);
  if (is_turned)
    reaction[World::kAxial] -= axial_inertia(system.hub) * hub.acceleration[World::kAxial];
  report.power.applied =
      (reaction[World::kAxial] + hub.applied_torque) * data.hub.twist[World::kAxial];
  report.power.applied += mount_power(system.hub, reaction, data.hub.twist);
  report.power.applied += hub.load.dot(data.hub.twist);
  if (system.gravity_ramp > 0.0 && !is_given) {
    const PositionOf<World> gravity =
        data.hub.R.inverse() * system.gravity_at(progress.control.time);
    report.power.applied += gravity_power(system.hub, gravity, data.hub.twist);
  }
  report.change = hub.change;
  report.step_change = hub.step_change;
  report.error = hub.error;
  report.failed = !is_finite(hub.acceleration);
  for (std::size_t i = 0; i < data.subsystems.size(); ++i) {
    add_reports(data.subsystems[i], report);
    add_largest(data.subsystems[i], static_cast<int>(i), report);
  }
  SystemRecord<World>& record = of_step(data.records, progress.step);
  end_pass(integrator, data.window, report, progress, record.step);
  if (progress.completed < 0) return;
  if ((is_given || is_turned) && progress.completed > 0) {
    const double before = static_cast<double>(progress.completed - 1) * step_size(integrator);
    const double speed_before = calc_motion(system.hub.drive, before).speed;
    record.step.work +=
        is_given ? work_in_step(system, before, speed_before, data)
                 : work_on_hub(system, speed_before, data.hub_coordinates.v[World::kAxial]);
  }
  record.reaction = hub.reaction;
  record.applied_torque = hub.applied_torque;
  record_hub(data, record);
}

namespace {

/// Returns the hub at the end of a step; in the plane its orientation, where anything depends on
/// it.
HubState<Plane> state_in_record(const System<Plane>& system, const StepData<Plane>& data) {
  const CoordinateBlock& hub = data.hub_coordinates;
  const bool needs_rotation = system.gravity != Position(0.0, 0.0) || !system.hub_loads.empty();
  return {Position::Zero(),
          needs_rotation ? rotation_of(system.hub, hub.q[kRotation]) : plane::Rotation{},
          Twist::Map(hub.v)};
}
HubState<Space> state_in_record(const System<Space>&, const StepData<Space>& data) {
  return calc_hub_state(data);
}

}  // namespace

template <class World>
void record_reactions(const System<World>& system, const Integrator& integrator,
                      StepData<World>& data) noexcept {
  const double h = step_size(integrator);
  const std::int64_t last = std::min(last_complete_step(data), data.window.last);
  CoordinateBlock& hub = data.hub_coordinates;
  for (std::int64_t step = data.window.first; step <= last; ++step) {
    SystemRecord<World> record;
    const double speed_before = hub.v[World::kAxial];
    const double t = static_cast<double>(step) * h;
    impose_hub_motion(system, t, hub);
    place_axle(system, t, data.hub_attitude);
    record_hub(data, record);
    // Support and drive do work on the hub's own inertia besides that on the subsystems.
    if (step > 0) record.step.work = work_in_step(system, t - h, speed_before, data);
    const HubState<World> state = state_in_record(system, data);
    HubSolution<World> applied{};
    applied.load = calc_hub_load(system, t, state);
    record.reaction = calc_hub_mass(system.hub) *
                          calc_prescribed_acceleration(system, t, state, hub.a[World::kAxial]) -
                      calc_hub_force<World>(system.hub, state, applied);
    for (std::size_t i = 0; i < data.subsystems.size(); ++i)
      add_record(of_step(data.subsystems[i].records, step), static_cast<int>(i), record);
    of_step(data.records, step) = record;
  }
}

std::int64_t last_complete_step(const StepTable& data) noexcept {
  std::int64_t first_open = data.progress[0].step;
  for (const StepProgress& progress : data.progress)
    first_open = std::min(first_open, progress.step);
  return first_open - 1;
}

template void complete_body(const Method&, const PassControl&, BodyData<Plane>&) noexcept;
template void complete_hub(const System<Plane>&, const Method&, StepData<Plane>&) noexcept;
template PartList parts_of_completed_hub(const System<Plane>&, const Method&,
                                         const StepData<Plane>&);
template void finish_subsystem(const Hub&, const Integrator&, const Window&,
                               SubsystemData<Plane>&) noexcept;
template void finish_system(const System<Plane>&, const Integrator&, StepData<Plane>&) noexcept;
template void record_reactions(const System<Plane>&, const Integrator&, StepData<Plane>&) noexcept;
template void complete_body(const Method&, const PassControl&, BodyData<Space>&) noexcept;
template void complete_hub(const System<Space>&, const Method&, StepData<Space>&) noexcept;
template PartList parts_of_completed_hub(const System<Space>&, const Method&,
                                         const StepData<Space>&);
template void finish_subsystem(const space::Hub&, const Integrator&, const Window&,
                               SubsystemData<Space>&) noexcept;
template void finish_system(const System<Space>&, const Integrator&, StepData<Space>&) noexcept;
template void record_reactions(const System<Space>&, const Integrator&, StepData<Space>&) noexcept;

}  // namespace spoke
