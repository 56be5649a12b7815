#include "engine/integrator/step_control.h"

namespace spoke {
namespace {

const Rk4* as_rk4(const Integrator& integrator) { return std::get_if<Rk4>(&integrator.method); }

/// Sets the stage or iteration that comes next in the clock's step.
void set_stage(const Integrator& integrator, int stage, Clock& clock) {
  const double h = step_size(integrator);
  clock.control.stage = stage;
  clock.control.time = clock.step * h;
  clock.control.implicit = 1.0;
  if (!as_rk4(integrator)) return;
  clock.control.implicit = 0.0;
  const double node = Rk4::nodes[static_cast<std::size_t>(stage)];
  if (stage != 0 && node != 1.0) clock.control.time = (clock.step - 1.0) * h + node * h;
}

void add_work(double duration, const Power& power, Clock& clock) {
  clock.work += duration * power.applied;
  clock.dissipated += duration * power.dissipation;
}

void fail(StepOutcome outcome, Clock& clock) {
  clock.outcome = static_cast<double>(static_cast<int>(outcome));
  clock.halted = 1.0;
}

/// The step's end is reached: its record, and the start of the next step.
void complete_step(const Integrator& integrator, const Window& window, const PassReport& report,
                   Clock& clock, StepRecord& record) {
  record.passes = clock.passes;
  record.work = clock.work;
  record.dissipated = clock.dissipated;
  record.bend = report.bend;
  clock.completed = clock.step;
  clock.power = report.power;
  begin_step(integrator, static_cast<std::int64_t>(clock.step) + 1, clock);
  clock.halted = clock.step > static_cast<double>(window.last) ? 1.0 : 0.0;
}

/// Whether the pass completes the step; else sets the next one.
bool end_iteration(const Integrator& integrator, const PassReport& report, Clock& clock) {
  const IterationLimits& limits = integrator.limits;
  const int done = static_cast<int>(clock.passes);
  clock.change = report.change;
  const bool is_last = limits.fixed > 0 ? done == limits.fixed : report.change <= limits.tolerance;
  if (is_last) {
    // The trapezoidal rule: second order, as the method.
    add_work(0.5 * step_size(integrator), clock.power, clock);
    add_work(0.5 * step_size(integrator), report.power, clock);
    return true;
  }
  if (limits.fixed == 0 && done >= limits.most)
    fail(StepOutcome::not_converged, clock);
  else
    set_stage(integrator, done, clock);
  return false;
}

bool end_stage(const Integrator& integrator, const PassReport& report, Clock& clock) {
  const int stage = static_cast<int>(clock.control.stage);
  if (stage == 0) return true;
  const double h = step_size(integrator);
  if (stage == 1) add_work(Rk4::weights[0] * h, clock.power, clock);
  add_work(Rk4::weights[static_cast<std::size_t>(stage)] * h, report.power, clock);
  set_stage(integrator, (stage + 1) % Rk4::kStages, clock);
  return false;
}

}  // namespace

double step_size(const Integrator& integrator) {
  return std::visit([](const auto& method) { return method.step; }, integrator.method);
}

Clock make_start_clock() { return {}; }

void begin_step(const Integrator& integrator, std::int64_t step, Clock& clock) noexcept {
  clock.step = static_cast<double>(step);
  clock.passes = clock.work = clock.dissipated = 0.0;
  set_stage(integrator, as_rk4(integrator) ? 1 : 0, clock);
}

void end_pass(const Integrator& integrator, const Window& window, const PassReport& report,
              Clock& clock, StepRecord& record) noexcept {
  clock.completed = -1.0;
  ++clock.passes;
  if (report.failed != 0.0) return fail(StepOutcome::left_limits, clock);
  const bool is_complete = clock.control.stage == PassControl::kEvaluateOnly ||
                           (as_rk4(integrator) ? end_stage(integrator, report, clock)
                                               : end_iteration(integrator, report, clock));
  if (is_complete) complete_step(integrator, window, report, clock, record);
}

int usual_passes(const Integrator& integrator) {
  if (as_rk4(integrator)) return Rk4::kStages;
  return integrator.limits.fixed > 0 ? integrator.limits.fixed : 2;
}

int most_passes(const Integrator& integrator) {
  const IterationLimits& limits = integrator.limits;
  return as_rk4(integrator) || limits.fixed > 0 ? usual_passes(integrator) : limits.most;
}

}  // namespace spoke
