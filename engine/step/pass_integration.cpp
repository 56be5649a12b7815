// Begins blocks of coordinates, hands accelerations to the integrator, and sums the reports of
// bodies.

#include "engine/step/pass_integration.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "engine/kernels/deformation_limits.h"
#include "engine/kernels/hub_motion.h"
#include "engine/kernels/hub_solve.h"
#include "engine/kernels/kinematics.h"

namespace spoke {
namespace {

/// Sum of the squares of a body's coordinates.
double sum_squares(const BodyData& body) {
  const double* q = body.coordinates.q;
  Double2 sum{};
  body.coordinates.for_parts([&](int first, int n) {
    for (int i = first; i < first + n; i += 2) sum += load_aligned(q + i) * load_aligned(q + i);
  });
  return total(sum);
}

/// Whether a body surely is within its limits: one comparison, which NaN and infinity fail as well.
bool is_small(double squares, const BodyData& body) {
  const double limit = std::min(body.model->body->length, std::numbers::pi);
  return squares <= limit * limit;
}

bool is_finite(const Twist& X) { return std::isfinite(X[0] + X[1] + X[2]); }

void add_reports(const SubsystemData& subsystem, PassReport& sum) {
  for (const BodyData& body : subsystem.bodies) {
    sum.power.applied += body.terms.load_power;
    sum.power.dissipation += body.terms.dissipation;
    sum.change = std::max(sum.change, body.report.change);
    sum.failed |= body.report.failed;
  }
}

/// Adds the deflections of subsystem `i`.
void add_deflections(const SubsystemData& subsystem, int i, LargeDeflection& largest) {
  for (std::size_t j = 0; j < subsystem.bodies.size(); ++j) {
    const double ratio = subsystem.bodies[j].report.deflection;
    if (ratio > largest.ratio) largest = {ratio, i, static_cast<int>(j)};
  }
}

/// Adds what blade `blade` did.
void add_record(const StepRecord& record, int blade, StepRecord& sum) {
  sum.passes = std::max(sum.passes, record.passes);
  sum.work += record.work;
  sum.dissipated += record.dissipated;
  sum.reaction += record.reaction;
  if (record.deflection.ratio > sum.deflection.ratio)
    sum.deflection = {record.deflection.ratio, blade, record.deflection.body};
}

/// On the hub's own inertia, which turns faster [J].
double work_on_hub(const System& system, double speed_before, double speed) {
  return 0.5 * system.hub.inertia * (speed * speed - speed_before * speed_before);
}

/// Sets the hub's free coordinates; those that are prescribed follow.
void begin_block(const Method& method, const PassControl& control, CoordinateBlock& block) {
  if (control.is_between_steps()) return;
  if (const auto* alpha = std::get_if<GeneralizedAlpha>(&method)) {
    if (control.stage == 0) predict(*alpha, block);
  } else {
    advance(std::get<Rk4>(method), control.stage, block);
  }
}

Twist position_of(const CoordinateBlock& hub) { return {hub.q[0], hub.q[1], hub.q[2]}; }
Twist velocity_of(const CoordinateBlock& hub) { return {hub.v[0], hub.v[1], hub.v[2]}; }

}  // namespace

void begin_bodies(const Method& method, SubsystemData& subsystem) noexcept {
  const PassControl& control = subsystem.progress->control;
  if (control.is_between_steps()) return;
  if (const auto* alpha = std::get_if<GeneralizedAlpha>(&method)) {
    if (control.stage == 0) predict(*alpha, subsystem.bodies);
    return;
  }
  for (BodyData& body : subsystem.bodies)
    advance(std::get<Rk4>(method), control.stage, body.coordinates);
}

bool is_at_new_time(const Method& method, const PassControl& control) noexcept {
  if (control.is_between_steps()) return true;
  if (!std::holds_alternative<Rk4>(method)) return control.stage == 0;
  const auto stage = static_cast<std::size_t>(control.stage);
  // Stage 0 stands where stage 3 stood, at the end of the step.
  return stage != 0 && Rk4::nodes[stage] != Rk4::nodes[stage - 1];
}

void begin_hub(const System& system, const Method& method, StepData& data) noexcept {
  const PassControl& control = data.progress[0].control;
  begin_block(method, control, data.hub_coordinates);
  impose_hub_motion(system, control.time, data.hub_coordinates);
  data.hub = calc_hub_state(data.hub_coordinates);
}

void complete_body(const Method& method, const PassControl& control, BodyData& body) noexcept {
  body.report.change = 0.0;
  double squares = 0.0;
  if (const auto* alpha = std::get_if<GeneralizedAlpha>(&method)) {
    if (control.stage == PassControl::kEvaluateOnly) {
      body.coordinates.for_parts([&body](int first, int n) {
        std::copy_n(body.a_found + first, n, body.coordinates.a + first);
      });
    } else if (control.stage == PassControl::kRestart) {
      complete_restart(*alpha, body.a_found, body.coordinates);
    } else {
      const Correction correction = correct(*alpha, body.a_found, body.coordinates);
      body.report.change = correction.change;
      squares = correction.squares;
    }
  } else if (control.stage == 0) {
    squares = sum_squares(body);
  }
  // Whatever is wrong with the deformation's accelerations is wrong with the frame's, too. Limits
  // are those of states: rk4's stages within a step are none.
  const bool is_fine =
      is_finite(body.X) && (is_small(squares, body) || find_limit_violation(body).coordinate < 0);
  body.report.failed = !is_fine;
  body.report.deflection = squares <= body.surely_linear ? 0.0 : find_large_deflection(body);
}

void complete_hub(const System& system, const Method& method, StepData& data) noexcept {
  CoordinateBlock& hub = data.hub_coordinates;
  const Twist found = calc_inertial_acceleration(system, data.progress[0].control.time, data.hub,
                                                 data.hub_solution);
  double change = 0.0;
  const auto* alpha = std::get_if<GeneralizedAlpha>(&method);
  const PassControl& control = data.progress[0].control;
  for (int c = 0; c < kTwist; ++c) {
    if (is_prescribed(system.hub, c)) continue;
    CoordinateBlock component = hub.component(c);
    if (alpha && !control.is_between_steps())
      change = std::max(change, correct(*alpha, &found[c], component).change);
    else if (control.stage == PassControl::kRestart)
      complete_restart(*alpha, &found[c], component);
    else
      hub.a[c] = found[c];
  }
  data.hub_solution.change = change;
}

void finish_subsystem(const Integrator& integrator, const Window& window,
                      SubsystemData& subsystem) noexcept {
  StepProgress& progress = *subsystem.progress;
  const Twist reaction = calc_reaction(subsystem);
  PassReport report;
  report.power.applied = reaction[kRotation] * subsystem.hub->twist[kRotation];
  add_reports(subsystem, report);
  add_deflections(subsystem, -1, report.deflection);
  StepRecord& record = of_step(subsystem.records, progress.step);
  record.reaction = reaction;
  end_pass(integrator, window, report, progress, record);
}

void finish_system(const System& system, const Integrator& integrator, StepData& data) noexcept {
  StepProgress& progress = data.progress[0];
  const HubSolution& hub = data.hub_solution;
  PassReport report;
  // Of a prescribed rotation the step's work on the hub's own inertia is known.
  const bool is_turned = is_prescribed(system.hub, kRotation);
  const double known = is_turned ? system.hub.inertia * hub.acceleration[kRotation] : 0.0;
  report.power.applied =
      (hub.reaction[kRotation] - known + hub.applied_torque) * data.hub.twist[kRotation];
  report.power.applied += hub.load.dot(data.hub.twist);
  if (system.gravity_ramp > 0.0) {
    const Position gravity = data.hub.R.inverse() * system.gravity_at(progress.control.time);
    report.power.applied += system.hub.mass * gravity.dot(data.hub.twist.head<kPosition>());
  }
  report.change = hub.change;
  report.failed = !is_finite(hub.acceleration);
  for (std::size_t i = 0; i < data.subsystems.size(); ++i) {
    add_reports(data.subsystems[i], report);
    add_deflections(data.subsystems[i], static_cast<int>(i), report.deflection);
  }
  SystemRecord& record = of_step(data.records, progress.step);
  end_pass(integrator, data.window, report, progress, record.step);
  if (progress.completed < 0) return;
  if (is_turned && progress.completed > 0) {
    const double before = static_cast<double>(progress.completed - 1) * step_size(integrator);
    record.step.work += work_on_hub(system, calc_motion(system.hub.drive, before).speed,
                                    data.hub_coordinates.v[kRotation]);
  }
  record.step.reaction = hub.reaction;
  record.applied_torque = hub.applied_torque;
  record.position = position_of(data.hub_coordinates);
  record.velocity = velocity_of(data.hub_coordinates);
}

void record_reactions(const System& system, const Integrator& integrator, StepData& data) noexcept {
  const double h = step_size(integrator);
  const std::int64_t last = std::min(last_complete_step(data), data.window.last);
  const bool needs_rotation = system.gravity != Position::Zero() || !system.hub_loads.empty();
  CoordinateBlock& hub = data.hub_coordinates;
  for (std::int64_t step = data.window.first; step <= last; ++step) {
    SystemRecord record;
    const double speed_before = hub.v[kRotation];
    const double t = static_cast<double>(step) * h;
    impose_hub_motion(system, t, hub);
    record.position = position_of(hub);
    record.velocity = velocity_of(hub);
    // Its own inertia takes what the subsystems leave of the drive's work.
    if (step > 0) record.step.work = work_on_hub(system, speed_before, hub.v[kRotation]);
    const Rotation R = needs_rotation ? Rotation::from_angle(hub.q[kRotation]) : Rotation{};
    const Twist a = calc_prescribed_acceleration(system, t, R, hub.a[kRotation]);
    record.step.reaction =
        Twist(system.hub.mass, system.hub.mass, system.hub.inertia).cwiseProduct(a) -
        calc_hub_load(system, t, {Position::Zero(), R, record.velocity});
    for (std::size_t i = 0; i < data.subsystems.size(); ++i)
      add_record(of_step(data.subsystems[i].records, step), static_cast<int>(i), record.step);
    of_step(data.records, step) = record;
  }
}

std::int64_t last_complete_step(const StepData& data) noexcept {
  std::int64_t first_open = data.progress[0].step;
  for (const StepProgress& progress : data.progress)
    first_open = std::min(first_open, progress.step);
  return first_open - 1;
}

}  // namespace spoke
