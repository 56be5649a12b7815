#include "engine/step/integrator/step_control.h"

#include <doctest/doctest.h>

#include <vector>

#include "tests/approx.h"

using namespace spoke;
using spoke::testing::approx;

namespace {

constexpr double kStep = 0.1;

Integrator implicit_integrator(IterationLimits limits) {
  return {make_generalized_alpha(0.8, kStep), limits};
}

PassReport report_of(double change, double power = 0.0) {
  PassReport report;
  report.change = report.step_change = change;
  report.power = {power, 0.5 * power};
  return report;
}

/// Progress at the first pass of step 1, where the power was `power`.
StepProgress progress_at_first_step(const Integrator& integrator, double power = 0.0) {
  StepProgress progress;
  StepRecord record;
  end_pass(integrator, {0, 100, false}, report_of(0.0, power), progress, record);
  REQUIRE(progress.completed == 0);
  REQUIRE(progress.step == 1);
  return progress;
}

}  // namespace

TEST_CASE("the start is one pass that only evaluates") {
  const Integrator integrator = implicit_integrator({});
  StepProgress progress;
  CHECK(progress.control.stage == PassControl::kEvaluateOnly);
  CHECK_FALSE(progress.is_halted);
  StepRecord record;
  end_pass(integrator, {0, 0, false}, report_of(0.0, 3.0), progress, record);
  CHECK(record.passes == 1);
  CHECK(record.work == 0.0);
  CHECK(progress.power.applied == 3.0);
  CHECK(progress.is_halted);  // at the end of the window
}

TEST_CASE("rk4 goes through its stages, at their times, and adds up the work by their weights") {
  const Integrator integrator{Rk4{kStep}, {}};
  StepProgress progress = progress_at_first_step(integrator, 6.0);
  StepRecord record;
  const std::vector<int> stages{1, 2, 3, 0};
  const std::vector<double> times{0.05, 0.05, 0.1, 0.1}, powers{12, 18, 24, 99};
  for (std::size_t k = 0; k < stages.size(); ++k) {
    CHECK(progress.control.stage == stages[k]);
    CHECK(progress.control.time == approx(times[k]));
    CHECK_FALSE(progress.control.is_implicit);
    CHECK(progress.completed != 1);
    end_pass(integrator, {1, 100, false}, report_of(0.0, powers[k]), progress, record);
  }
  CHECK(progress.completed == 1);
  CHECK(progress.step == 2);
  CHECK(progress.control.stage == 1);
  CHECK(record.passes == 4);
  CHECK(record.work == approx(kStep * (6.0 / 6 + 12.0 / 3 + 18.0 / 3 + 24.0 / 6)));
  CHECK(record.dissipated == approx(0.5 * record.work));
  CHECK(usual_passes(integrator) == 4);
}

TEST_CASE("an iteration ends when the last change is within the tolerance") {
  const Integrator integrator = implicit_integrator({1e-6, 0, 30});
  StepProgress progress = progress_at_first_step(integrator, 2.0);
  StepRecord record;
  for (const double change : {1.0, 1e-3, 1.1e-6}) {
    end_pass(integrator, {1, 100, false}, report_of(change, 4.0), progress, record);
    CHECK(progress.completed == -1);
    CHECK(progress.step == 1);
    CHECK(progress.control.time == kStep);
    CHECK(progress.control.is_implicit);
  }
  CHECK(progress.control.stage == 3);
  end_pass(integrator, {1, 100, false}, report_of(1e-6, 4.0), progress, record);
  CHECK(progress.completed == 1);
  CHECK(progress.control.stage == 0);
  CHECK(progress.control.time == 2.0 * kStep);
  CHECK(record.passes == 4);
  CHECK(record.work == approx(0.5 * kStep * (2.0 + 4.0)));
}

TEST_CASE("an iteration to the step's own error ends at a share of its first change") {
  IterationLimits limits{1e-10, 0, 30};
  limits.follows_error = true;
  const Integrator integrator = implicit_integrator(limits);
  /// Passes of a step with these changes, of a progress that has seen others.
  const auto count = [&](const std::vector<double>& changes, StepProgress& progress) {
    StepRecord record;
    for (const double change : changes) {
      end_pass(integrator, {1, 100, false}, report_of(change), progress, record);
      if (progress.completed >= 0) return static_cast<int>(record.passes);
    }
    return 0;
  };
  // 3e-5 of the first change may be left, which a contraction by 0.005 leaves of the second, by
  // 0.01 of the third, and by 0.1 of the fifth.
  StepProgress progress = progress_at_first_step(integrator);
  CHECK(count({1e-3, 5e-6, 2e-8}, progress) == 2);
  CHECK(count({1e-3, 1e-5, 1e-7, 1e-9}, progress) == 3);
  CHECK(count({1e-3, 1e-4, 1e-5, 1e-6, 1e-7, 1e-8}, progress) == 5);
  // The slowest part of the error shows last.
  CHECK(count({1e-3, 1e-5, 5e-6, 2.5e-8, 1e-8}, progress) == 4);
  // A small change among large ones is left, and steps that have become small are not.
  CHECK(count({2e-8, 1e-14}, progress) == 1);
  progress = progress_at_first_step(integrator);
  CHECK(count({2e-8, 2e-9, 1e-11, 1e-14}, progress) == 3);
  // When changes are below the tolerance, a decrease to a tenth of the first is enough.
  progress = progress_at_first_step(integrator);
  CHECK(count({0.9e-10, 1.2e-11, 1e-14}, progress) == 3);
  CHECK(count({0.9e-10, 8e-12, 1e-14}, progress) == 2);
  // Accelerations that were predicted well need no second look.
  progress = progress_at_first_step(integrator);
  StepRecord predicted;
  PassReport report = report_of(8e-12);
  report.step_change = 0.9e-10;
  end_pass(integrator, {1, 100, false}, report, progress, predicted);
  CHECK(progress.completed == 1);
  // Round-off ends it, and what no longer falls.
  CHECK(count({1e-14}, progress) == 1);
  CHECK(count({0.9e-10, 3e-11, 2.5e-11, 1e-12}, progress) == 3);
  progress = progress_at_first_step(integrator);
  StepRecord record;
  for (int k = 0; k < 30; ++k)
    end_pass(integrator, {1, 100, false}, report_of(1.1e-10), progress, record);
  CHECK(progress.outcome == StepOutcome::not_converged);
}

TEST_CASE("a change within the tolerance is converged when no more passes may be made") {
  IterationLimits limits{1e-10, 0, 12};
  limits.follows_error = true;
  // Tolerance of the step: 3e-5 of its first change, 3e-8. The second change doubles, so that the
  // contraction seen, 2, promises nothing.
  const auto outcome_of = [](const Integrator& integrator, double last) {
    StepProgress progress = progress_at_first_step(integrator);
    StepRecord record;
    for (int k = 0; k < 11; ++k)
      end_pass(integrator, {1, 100, false}, report_of(k == 1 ? 2e-3 : 1e-3), progress, record);
    CHECK(progress.completed != 1);
    end_pass(integrator, {1, 100, false}, report_of(last), progress, record);
    return progress;
  };
  CHECK(outcome_of(implicit_integrator(limits), 2.9e-8).completed == 1);
  CHECK(outcome_of(implicit_integrator(limits), 3.1e-8).outcome == StepOutcome::not_converged);
  // Loops close with plain passes alone, the last of which is one, to what they ask for.
  limits.relaxes = true;
  limits.closing = 1e-8;
  CHECK(outcome_of(implicit_integrator(limits), 0.9e-8).completed == 1);
  const StepProgress open = outcome_of(implicit_integrator(limits), 1.1e-8);
  CHECK(open.outcome == StepOutcome::not_converged);
  CHECK(open.share_before == 1.0);
}

TEST_CASE("an iteration to the step's own error leaves no more than it is told") {
  IterationLimits limits{1e-9, 0, 30};
  limits.follows_error = true;
  limits.most_left = 1.1e-9;
  const Integrator integrator = implicit_integrator(limits);
  StepProgress progress = progress_at_first_step(integrator);
  StepRecord record;
  // Where 3e-8 might be left.
  for (const double change : {1e-3, 1e-5, 1e-7}) {
    CHECK(progress.completed != 1);
    end_pass(integrator, {1, 100, false}, report_of(change), progress, record);
  }
  CHECK(progress.completed == 1);
  CHECK(record.passes == 3);
}

TEST_CASE("the error of a step is that of its first iteration") {
  const Integrator integrator = implicit_integrator({1e-6, 0, 30});
  StepProgress progress = progress_at_first_step(integrator);
  StepRecord record;
  PassReport report = report_of(1.0);
  report.error = {0.5, 1, 2, CoordinatePlace::joint};
  end_pass(integrator, {1, 100, false}, report, progress, record);
  end_pass(integrator, {1, 100, false}, report_of(1e-7), progress, record);
  CHECK(progress.completed == 1);
  CHECK(record.error.size == 0.5);
  CHECK(record.error.body == 2);
  CHECK(record.error.place == CoordinatePlace::joint);
  end_pass(integrator, {2, 100, false}, report_of(1e-7), progress, record);
  CHECK(record.error.size == 0.0);
}

TEST_CASE("a fixed number of iterations is kept, whatever the change") {
  const Integrator integrator = implicit_integrator({1e-6, 2, 30});
  StepProgress progress = progress_at_first_step(integrator);
  StepRecord record;
  end_pass(integrator, {1, 100, false}, report_of(0.0), progress, record);
  CHECK(progress.completed == -1);
  end_pass(integrator, {1, 100, false}, report_of(1.0), progress, record);
  CHECK(progress.completed == 1);
  CHECK(usual_passes(integrator) == 2);
}

TEST_CASE("an iteration that does not end halts the progress at its step") {
  const Integrator integrator = implicit_integrator({1e-6, 0, 3});
  StepProgress progress = progress_at_first_step(integrator);
  StepRecord record;
  for (int k = 0; k < 3; ++k)
    end_pass(integrator, {1, 100, false}, report_of(0.5), progress, record);
  CHECK(progress.outcome == StepOutcome::not_converged);
  CHECK(progress.is_halted);
  CHECK(progress.step == 1);
  CHECK(progress.change == 0.5);
}

TEST_CASE("a state beyond its limits halts the progress at its step") {
  const Integrator integrator{Rk4{kStep}, {}};
  StepProgress progress = progress_at_first_step(integrator);
  StepRecord record;
  PassReport report;
  report.failed = 1.0;
  end_pass(integrator, {1, 100, false}, report, progress, record);
  CHECK(progress.outcome == StepOutcome::left_limits);
  CHECK(progress.is_halted);
  CHECK(progress.completed == -1);
}

TEST_CASE("a progress halts behind the last step of its window") {
  const Integrator integrator = implicit_integrator({1e-6, 1, 30});
  StepProgress progress = progress_at_first_step(integrator);
  StepRecord record;
  const Window window{1, 3, false};
  for (const double step : {1.0, 2.0, 3.0}) {
    CHECK_FALSE(progress.is_halted);
    end_pass(integrator, window, report_of(0.0), progress, record);
    CHECK(progress.completed == step);
  }
  CHECK(progress.is_halted);
  CHECK(progress.outcome == StepOutcome::done);
}
