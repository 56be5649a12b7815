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

/// Whether a body surely is within its limits: one sum, which NaN and infinity fail as well.
bool is_small(const BodyData& body) {
  const double* q = body.coordinates.q;
  Pair first{}, second{};
  for (int i = 0, n = body.layout.size(); i < n; i += 4) {  // all its sizes are multiples of 4
    first += load_aligned(q + i) * load_aligned(q + i);
    second += load_aligned(q + i + 2) * load_aligned(q + i + 2);
  }
  const double limit = std::min(body.model->body->length, std::numbers::pi);
  return total(first + second) <= limit * limit;
}

/// Whether the pass evaluates a state in which a step may end.
bool is_end_of_step(const Method& method, const PassControl& control) {
  return control.stage == 0 ||
         (control.stage > 0 && std::holds_alternative<GeneralizedAlpha>(method));
}

bool is_finite(const Twist& X) { return std::isfinite(X[0] + X[1] + X[2]); }

}  // namespace

void begin_block(const Method& method, const PassControl& control,
                 CoordinateBlock& block) noexcept {
  if (control.stage == PassControl::kEvaluateOnly) return;
  if (const auto* alpha = std::get_if<GeneralizedAlpha>(&method)) {
    if (control.stage == 0) predict(*alpha, block);
  } else {
    advance(std::get<Rk4>(method), control.stage, block);
  }
}

void begin_hub(const System& system, const Method& method, StepData& data) noexcept {
  begin_block(method, data.control, data.hub_coordinates);
  impose_hub_motion(system, data.control.time, data.hub_coordinates);
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
  const bool is_fine =
      is_finite(body.X) && (!is_state || is_small(body) || find_excess(body).coordinate < 0);
  body.report.failed = is_fine ? 0.0 : 1.0;
}

void impose_hub_motion(const System& system, double t, CoordinateBlock& hub) noexcept {
  for (int c = 0; c < kPosition; ++c)
    if (is_prescribed(system.hub, c)) hub.q[c] = hub.v[c] = hub.a[c] = 0.0;
  if (!is_prescribed(system.hub, kRotation)) return;
  const DriveMotion motion = calc_motion(system.hub.drive, t);
  hub.q[kRotation] = motion.angle;
  hub.v[kRotation] = motion.speed;
  hub.a[kRotation] = motion.acceleration;
}

void complete_hub(const System& system, const Method& method, StepData& data) noexcept {
  CoordinateBlock& hub = data.hub_coordinates;
  const Twist found = calc_inertial_acceleration(system, data.hub, data.hub_solution);
  double change = 0.0;
  const auto* alpha = std::get_if<GeneralizedAlpha>(&method);
  const bool corrects = alpha && data.control.stage != PassControl::kEvaluateOnly;
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

PassReport sum_reports(const StepData& data) noexcept {
  PassReport sum{};
  const HubSolution& hub = data.hub_solution;
  const double torque = hub.reaction[kRotation] + hub.applied_torque;
  sum.power = torque * data.hub.twist[kRotation];
  sum.change = hub.change;
  sum.failed = hub.acceleration.allFinite() ? 0.0 : 1.0;
  for (const SubsystemData& subsystem : data.subsystems)
    for (const BodyData& body : subsystem.bodies) {
      sum.power += body.terms.load_power;
      sum.dissipation += body.terms.dissipation;
      sum.change = std::max(sum.change, body.report.change);
      sum.failed = std::max(sum.failed, body.report.failed);
    }
  return sum;
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
