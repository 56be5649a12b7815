// Decides at the end of a pass what the next one evaluates: another iteration or stage, or the next
// step.

#include "engine/step/integrator/step_control.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

#include "engine/step/integrator/foresight.h"
#include "engine/step/integrator/relaxation.h"

namespace spoke {
namespace {

const Rk4* as_rk4(const Integrator& integrator) { return std::get_if<Rk4>(&integrator.method); }

/// Sets the stage or iteration that comes next in the step.
void set_stage(const Integrator& integrator, int stage, StepProgress& progress) {
  assert(stage >= 0 && (!as_rk4(integrator) || stage < as_rk4(integrator)->passes()));
  const double h = step_size(integrator);
  progress.control.stage = stage;
  progress.control.time = static_cast<double>(progress.step) * h;
  progress.control.is_implicit = true;
  if (!as_rk4(integrator)) return;
  progress.control.is_implicit = false;
  const double node = stage < Rk4::kStages ? Rk4::nodes[static_cast<std::size_t>(stage)] : 1.0;
  if (stage != 0 && node != 1.0)
    progress.control.time = static_cast<double>(progress.step - 1) * h + node * h;
}

void add_work(double duration, const Power& power, StepProgress& progress) {
  progress.work += duration * power.applied;
  progress.dissipated += duration * power.dissipation;
}

void fail(StepOutcome outcome, StepProgress& progress) {
  progress.outcome = outcome;
  progress.is_halted = true;
}

/// Completes the step: makes its record, and begins the next step.
void complete_step(const Integrator& integrator, const Window& window, const PassReport& report,
                   StepProgress& progress, StepRecord& record) {
  record.passes = progress.passes;
  record.work = progress.work;
  record.dissipated = progress.dissipated;
  record.deflection = report.deflection;
  record.error = progress.error;
  record.loop = report.loop;
  // A restart shows nothing: its accelerations are those of the method, and no others are known.
  const bool is_restart = progress.control.stage == PassControl::kRestart;
  if (!is_restart) progress.completed = progress.step;
  if (is_restart) forget_accelerations(progress);
  progress.power = report.power;
  begin_step(integrator, progress.step + 1, progress);
  progress.is_halted = progress.step > window.last;
}

// Changes smaller than this are round-off.
constexpr double kRoundOff = 1e-14;

/// Takes how much the accelerations have changed in a step, and sets the tolerance.
void set_tolerance(const IterationLimits& limits, double step_change, StepProgress& progress) {
  // The error that is left in the accelerations may be so much of the effect of the step's own
  // error on the velocities (docs/formulation.md, section 5).
  constexpr double kLeft = 3e-5;
  // A step whose changes happen to be small among others leaves an error as small.
  constexpr double kFade = 0.99;
  progress.tolerance = limits.tolerance;
  if (!limits.follows_error) return;
  double& usual = progress.remembered.usual_change;
  usual = std::max(step_change, kFade * usual);
  progress.tolerance = std::min(limits.most_left, std::max(kRoundOff, kLeft * usual));
}

/// Whether what is left of a change, by the contraction, is within the tolerance. The power at the
/// end of the step is that of the state before the change: a first one is small beside that of the
/// accelerations, too.
bool leaves_little(const PassReport& report, const StepProgress& progress) {
  constexpr double kShare = 0.1;
  if (progress.passes == 1 && report.change > kShare * report.step_change) return false;
  const double r = foretell_contraction(progress);
  return r * report.change <= (1.0 - r) * progress.tolerance;
}

/// Whether a change is small by itself, and not by its own step alone; a first one within the
/// tolerance is, whatever the limits.
bool is_small_change(const IterationLimits& limits, double change, const StepProgress& progress) {
  const bool asks_tolerance_alone = !limits.follows_error || progress.passes == 1;
  if (asks_tolerance_alone && change <= progress.tolerance) return true;
  if (!limits.follows_error) return false;
  constexpr double kShare = 0.1;
  return change <=
         std::min(limits.tolerance, std::max(kRoundOff, kShare * progress.remembered.usual_change));
}

/// Whether the iteration has done what it can: by its tolerance, or since changes that the limits
/// allow hardly fall any more.
bool has_converged(const IterationLimits& limits, const PassReport& report,
                   const StepProgress& progress) {
  const double change = report.change;
  const bool leaves_open = change > limits.closing ||
                           (progress.control.relaxation < 1.0 && std::isfinite(limits.closing));
  if (leaves_open) return false;
  if (limits.follows_error && leaves_little(report, progress)) return true;
  if (is_small_change(limits, change, progress)) return true;
  if (progress.passes >= limits.most)
    return change <= std::max(limits.tolerance, progress.tolerance);
  const bool has_stalled = progress.passes > 1 && change > 0.5 * progress.change;
  return has_stalled && change <= limits.tolerance;
}

/// Returns the share that the next pass takes. The last that may be made is plain where loops are
/// to be closed: no other closes them.
double choose_next_share(const IterationLimits& limits, const StepProgress& progress) {
  if (!limits.relaxes || limits.fixed > 0) return 1.0;
  if (std::isfinite(limits.closing) && progress.passes + 1 >= limits.most) return 1.0;
  return choose_share(progress);
}

/// Whether the pass completes the step; else sets the next one.
bool end_iteration(const Integrator& integrator, const PassReport& report, StepProgress& progress) {
  const IterationLimits& limits = integrator.limits;
  const int done = progress.passes;
  if (done == 1) {
    progress.error = report.error;
    set_tolerance(limits, report.step_change, progress);
    learn_order(report.change, progress);
  }
  learn_contraction(report.change, progress);
  const bool is_last =
      limits.fixed > 0 ? done == limits.fixed : has_converged(limits, report, progress);
  progress.change = report.change;
  progress.share_before = progress.control.relaxation;
  if (is_last) {
    const bool is_plain = done == 1 && is_small_change(limits, report.change, progress);
    remember_step(is_plain, progress);
    // The trapezoidal rule: second order, as the method.
    add_work(0.5 * step_size(integrator), progress.power, progress);
    add_work(0.5 * step_size(integrator), report.power, progress);
    return true;
  }
  if (limits.fixed == 0 && done >= limits.most)
    fail(StepOutcome::not_converged, progress);
  else
    set_stage(integrator, done, progress);
  progress.control.relaxation = choose_next_share(limits, progress);
  return false;
}

bool end_stage(const Integrator& integrator, const PassReport& report, StepProgress& progress) {
  const int stage = progress.control.stage;
  if (stage == 0) return true;
  const double h = step_size(integrator);
  if (stage == 1) add_work(Rk4::weights[0] * h, progress.power, progress);
  if (stage < Rk4::kStages)
    add_work(Rk4::weights[static_cast<std::size_t>(stage)] * h, report.power, progress);
  set_stage(integrator, (stage + 1) % as_rk4(integrator)->passes(), progress);
  return false;
}

}  // namespace

double step_size(const Integrator& integrator) {
  return std::visit([](const auto& method) { return method.step; }, integrator.method);
}

StepProgress make_progress_between_steps(const Integrator& integrator, std::int64_t step,
                                         int stage) {
  assert(step >= 0 && (stage == PassControl::kEvaluateOnly || stage == PassControl::kRestart));
  StepProgress progress;
  progress.step = step;
  progress.control.stage = stage;
  progress.control.time = static_cast<double>(step) * step_size(integrator);
  progress.control.is_implicit = stage == PassControl::kRestart;
  return progress;
}

void begin_step(const Integrator& integrator, std::int64_t step, StepProgress& progress) noexcept {
  assert(step > 0 && step_size(integrator) > 0.0);
  progress.step = step;
  progress.passes = 0;
  progress.work = progress.dissipated = 0.0;
  progress.contraction = 0.0;
  progress.error = {};
  progress.share_before = progress.control.relaxation = 1.0;
  progress.control.order = choose_order(integrator.limits.highest_order, progress.remembered);
  set_stage(integrator, as_rk4(integrator) ? 1 : 0, progress);
}

void end_pass(const Integrator& integrator, const Window& window, const PassReport& report,
              StepProgress& progress, StepRecord& record) noexcept {
  assert(!progress.is_halted);
  progress.completed = StepProgress::kNone;
  ++progress.passes;
  if (report.failed) return fail(StepOutcome::left_limits, progress);
  const bool is_complete = progress.control.is_between_steps() ||
                           (as_rk4(integrator) ? end_stage(integrator, report, progress)
                                               : end_iteration(integrator, report, progress));
  if (is_complete) complete_step(integrator, window, report, progress, record);
}

int usual_passes(const Integrator& integrator) {
  if (const Rk4* rk4 = as_rk4(integrator)) return rk4->passes();
  return integrator.limits.fixed > 0 ? integrator.limits.fixed : 2;
}

int most_passes(const Integrator& integrator) {
  const IterationLimits& limits = integrator.limits;
  return as_rk4(integrator) || limits.fixed > 0 ? usual_passes(integrator) : limits.most;
}

}  // namespace spoke
