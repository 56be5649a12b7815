#include "engine/integrator/time_stepper.h"

namespace spoke {

TimeStepper::TimeStepper(StepContext& context, graph::Executor& executor,
                         const IterationLimits& limits)
    : context_(context), executor_(executor), limits_(limits) {}

bool TimeStepper::pass(double time, int stage, bool implicit) {
  context_.data.control = {time, stage, implicit};
  executor_.run();
  ++evaluations_;
  return context_.data.report.failed == 0.0;
}

void TimeStepper::add_work(double duration, const PassReport& rates) {
  work_.by_drive_and_loads += duration * rates.power;
  work_.dissipated += duration * rates.dissipation;
}

StepOutcome TimeStepper::start() {
  const auto* alpha = std::get_if<GeneralizedAlpha>(&context_.method);
  StepData& data = context_.data;
  const auto each_block = [&](auto&& apply) {
    apply(data.hub_coordinates);
    for (SubsystemData& subsystem : data.subsystems)
      for (BodyData& body : subsystem.bodies) apply(body.coordinates);
  };
  if (alpha) each_block([](CoordinateBlock& block) { hold(block); });
  if (!pass(0.0, PassControl::kEvaluateOnly, false)) return StepOutcome::left_limits;
  if (alpha) each_block([&](CoordinateBlock& block) { spoke::start(*alpha, block); });
  return StepOutcome::done;
}

StepOutcome TimeStepper::step(double t, double t_next) {
  return std::holds_alternative<Rk4>(context_.method) ? step_rk4(t, t_next)
                                                      : step_generalized_alpha(t_next);
}

StepOutcome TimeStepper::step_generalized_alpha(double t_next) {
  const double h = std::get<GeneralizedAlpha>(context_.method).step;
  const PassReport before = context_.data.report;
  const int most = limits_.fixed > 0 ? limits_.fixed : limits_.most;
  for (int iteration = 0; iteration < most; ++iteration) {
    if (!pass(t_next, iteration, true)) return StepOutcome::left_limits;
    const bool is_last = limits_.fixed > 0 ? iteration + 1 == limits_.fixed
                                           : context_.data.report.change <= limits_.tolerance;
    if (!is_last) continue;
    // The trapezoidal rule: second order, as the method.
    add_work(0.5 * h, before);
    add_work(0.5 * h, context_.data.report);
    return StepOutcome::done;
  }
  return StepOutcome::not_converged;
}

StepOutcome TimeStepper::step_rk4(double t, double t_next) {
  const double h = std::get<Rk4>(context_.method).step;
  add_work(Rk4::weights[0] * h, context_.data.report);
  for (int stage = 1; stage < Rk4::kStages; ++stage) {
    const double time = Rk4::nodes[stage] == 1.0 ? t_next : t + Rk4::nodes[stage] * h;
    if (!pass(time, stage, false)) return StepOutcome::left_limits;
    add_work(Rk4::weights[stage] * h, context_.data.report);
  }
  return pass(t_next, 0, false) ? StepOutcome::done : StepOutcome::left_limits;
}

}  // namespace spoke
