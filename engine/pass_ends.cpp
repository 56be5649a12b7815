#include "engine/pass_ends.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "engine/hub.h"
#include "engine/kinematics.h"

namespace spoke {
namespace {

double limit_of(const FlexibleBody& body, int coordinate) {
  const bool is_displacement = coordinate < body.axial() || [&] {
    // Bending coordinates alternate v, psi; a chord frame's begin with psi_0 and end with psi_E.
    const int at = coordinate - body.axial();
    if (body.reference_frame == ReferenceFrame::clamped) return at % 2 == 0;
    return at % 2 == 1 && at != body.bending() - 1;
  }();
  return is_displacement ? body.length : std::numbers::pi;
}

/// Sum of the squares of a body's coordinates.
double sum_squares(const BodyData& body) {
  const double* q = body.coordinates.q;
  Pair first{}, second{};
  for (int i = 0, n = body.layout.size(); i < n; i += 4) {  // all its sizes are multiples of 4
    first += load_aligned(q + i) * load_aligned(q + i);
    second += load_aligned(q + i + 2) * load_aligned(q + i + 2);
  }
  return total(first + second);
}

/// Whether a body surely is within its limits: one comparison, which NaN and infinity fail as well.
bool is_small(double squares, const BodyData& body) {
  const double limit = std::min(body.model->body->length, std::numbers::pi);
  return squares <= limit * limit;
}

/// Whether the pass evaluates a state in which a step may end.
bool is_end_of_step(const Method& method, const PassControl& control) {
  return control.stage == 0 ||
         (control.stage > 0 && std::holds_alternative<GeneralizedAlpha>(method));
}

bool is_finite(const Twist& X) { return std::isfinite(X[0] + X[1] + X[2]); }

void add_reports(const SubsystemData& subsystem, PassReport& sum) {
  for (const BodyData& body : subsystem.bodies) {
    sum.power.applied += body.terms.load_power;
    sum.power.dissipation += body.terms.dissipation;
    sum.change = std::max(sum.change, body.report.change);
    sum.failed = std::max(sum.failed, body.report.failed);
  }
}

/// Adds the bends of subsystem `i`.
void add_bends(const SubsystemData& subsystem, double i, Bend& largest) {
  for (std::size_t j = 0; j < subsystem.bodies.size(); ++j) {
    const double ratio = subsystem.bodies[j].report.bend;
    if (ratio > largest.ratio) largest = {ratio, i, static_cast<double>(j)};
  }
}

/// Adds what blade `blade` did.
void add_record(const StepRecord& record, double blade, StepRecord& sum) {
  sum.passes = std::max(sum.passes, record.passes);
  sum.work += record.work;
  sum.dissipated += record.dissipated;
  sum.reaction += record.reaction;
  if (record.bend.ratio > sum.bend.ratio) sum.bend = {record.bend.ratio, blade, record.bend.body};
}

/// On the hub's own inertia, which turns faster [J].
double work_on_hub(const System& system, double speed_before, double speed) {
  return 0.5 * system.hub.inertia * (speed * speed - speed_before * speed_before);
}

Twist position_of(const CoordinateBlock& hub) { return {hub.q[0], hub.q[1], hub.q[2]}; }
Twist velocity_of(const CoordinateBlock& hub) { return {hub.v[0], hub.v[1], hub.v[2]}; }

}  // namespace

void begin_block(const Method& method, const PassControl& control,
                 CoordinateBlock& block) noexcept {
  if (control.stage == PassControl::kEvaluateOnly) return;
  if (const auto* alpha = std::get_if<GeneralizedAlpha>(&method)) {
    if (control.stage == 0) predict(*alpha, block);
  } else {
    advance(std::get<Rk4>(method), static_cast<int>(control.stage), block);
  }
}

bool is_at_new_time(const Method& method, const PassControl& control) noexcept {
  if (control.stage == PassControl::kEvaluateOnly) return true;
  if (!std::holds_alternative<Rk4>(method)) return control.stage == 0;
  const auto stage = static_cast<std::size_t>(control.stage);
  // Stage 0 stands where stage 3 stood, at the end of the step.
  return stage != 0 && Rk4::nodes[stage] != Rk4::nodes[stage - 1];
}

void begin_hub(const System& system, const Method& method, StepData& data) noexcept {
  const PassControl& control = data.clocks[0].control;
  begin_block(method, control, data.hub_coordinates);
  impose_hub_motion(system, control.time, data.hub_coordinates);
  data.hub = calc_hub_state(data.hub_coordinates);
}

void complete_body(const Method& method, const PassControl& control, BodyData& body) noexcept {
  body.report.change = 0.0;
  if (const auto* alpha = std::get_if<GeneralizedAlpha>(&method)) {
    if (control.stage == PassControl::kEvaluateOnly)
      std::copy_n(body.a_found, body.coordinates.size, body.coordinates.a);
    else
      body.report.change = correct(*alpha, body.a_found, body.coordinates);
  }
  // Whatever is wrong with the deformation's accelerations is wrong with the frame's, too. Limits
  // are those of states: rk4's stages within a step are none.
  const bool is_state = is_end_of_step(method, control);
  const double squares = is_state ? sum_squares(body) : 0.0;
  const bool is_fine =
      is_finite(body.X) && (is_small(squares, body) || find_excess(body).coordinate < 0);
  body.report.failed = is_fine ? 0.0 : 1.0;
  body.report.bend = squares <= body.surely_linear ? 0.0 : find_bend(body);
}

void complete_hub(const System& system, const Method& method, StepData& data) noexcept {
  CoordinateBlock& hub = data.hub_coordinates;
  const Twist found = calc_inertial_acceleration(system, data.hub, data.hub_solution);
  double change = 0.0;
  const auto* alpha = std::get_if<GeneralizedAlpha>(&method);
  const bool corrects = alpha && data.clocks[0].control.stage != PassControl::kEvaluateOnly;
  for (int c = 0; c < kTwist; ++c) {
    if (is_prescribed(system.hub, c)) continue;
    CoordinateBlock component = hub.component(c);
    if (corrects)
      change = std::max(change, correct(*alpha, &found[c], component));
    else
      hub.a[c] = found[c];
  }
  data.hub_solution.change = change;
}

void finish_subsystem(const Integrator& integrator, const Window& window,
                      SubsystemData& subsystem) noexcept {
  Clock& clock = *subsystem.clock;
  const Twist reaction = calc_reaction(subsystem);
  PassReport report;
  report.power.applied = reaction[kRotation] * subsystem.hub->twist[kRotation];
  add_reports(subsystem, report);
  add_bends(subsystem, -1.0, report.bend);
  StepRecord& record = of_step(subsystem.records, static_cast<std::int64_t>(clock.step));
  record.reaction = reaction;
  end_pass(integrator, window, report, clock, record);
}

void finish_system(const System& system, const Integrator& integrator, StepData& data) noexcept {
  Clock& clock = data.clocks[0];
  const HubSolution& hub = data.hub_solution;
  PassReport report;
  // Of a prescribed rotation the step's work on the hub's own inertia is known.
  const bool is_turned = is_prescribed(system.hub, kRotation);
  const double known = is_turned ? system.hub.inertia * hub.acceleration[kRotation] : 0.0;
  report.power.applied =
      (hub.reaction[kRotation] - known + hub.applied_torque) * data.hub.twist[kRotation];
  report.change = hub.change;
  report.failed = is_finite(hub.acceleration) ? 0.0 : 1.0;
  for (std::size_t i = 0; i < data.subsystems.size(); ++i) {
    add_reports(data.subsystems[i], report);
    add_bends(data.subsystems[i], static_cast<double>(i), report.bend);
  }
  SystemRecord& record = of_step(data.records, static_cast<std::int64_t>(clock.step));
  end_pass(integrator, data.window, report, clock, record.step);
  if (clock.completed < 0.0) return;
  if (is_turned && clock.completed > 0.0) {
    const double before = (clock.completed - 1.0) * step_size(integrator);
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
  const bool has_gravity = system.gravity != Position::Zero();
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
    const Rotation R = has_gravity ? Rotation::from_angle(hub.q[kRotation]) : Rotation{};
    const Twist a = calc_prescribed_acceleration(system, R, hub.a[kRotation]);
    record.step.reaction =
        Twist(system.hub.mass, system.hub.mass, system.hub.inertia).cwiseProduct(a);
    for (std::size_t i = 0; i < data.subsystems.size(); ++i)
      add_record(of_step(data.subsystems[i].records, step), static_cast<double>(i), record.step);
    of_step(data.records, step) = record;
  }
}

std::int64_t last_complete_step(const StepData& data) noexcept {
  double first_open = data.clocks[0].step;
  for (const Clock& clock : data.clocks) first_open = std::min(first_open, clock.step);
  return static_cast<std::int64_t>(first_open - 1.0);
}

double find_bend(const BodyData& body) noexcept {
  const FlexibleBody& model = *body.model->body;
  const double l = model.length / model.elements;
  const auto at = [&](int node, int c) {
    return body.coordinates.q[body.layout.place(model.coordinate(node, c))];
  };
  double largest = 0.0;
  for (int node = 1; node <= model.elements; ++node) {
    const double before = at(node - 1, 1), after = at(node, 1);
    const double turned = at(node - 1, kRotation) - at(node, kRotation);
    const double between = 0.5 * (before + after) + 0.125 * l * turned;
    largest = std::max({largest, std::abs(after), std::abs(between)});
  }
  return largest > body.linear_range ? largest / model.length : 0.0;
}

Excess find_excess(const BodyData& body) {
  const FlexibleBody& model = *body.model->body;
  Excess worst;
  for (int k = 0; k < model.coordinates(); ++k) {
    const double value = body.coordinates.q[body.layout.place(k)];
    const double limit = limit_of(model, k);
    if (!std::isfinite(value)) return {k, value, limit};
    const bool is_worst =
        worst.coordinate < 0 || std::abs(value) / limit > std::abs(worst.value) / worst.limit;
    if (std::abs(value) > limit && is_worst) worst = {k, value, limit};
  }
  return worst;
}

}  // namespace spoke
