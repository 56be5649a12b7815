#include "engine/step/integrator/foresight.h"

#include <doctest/doctest.h>

#include <cmath>
#include <limits>
#include <vector>

#include "engine/step/integrator/step_control.h"

using namespace spoke;

namespace {

constexpr double kForesightStep = 0.01;

/// Steps whose first change is that of a prediction of `order` and whose iteration contracts by a
/// given factor; limits are those of "error".
struct ForetoldSteps {
  Integrator integrator{make_generalized_alpha(0.8, kForesightStep), {1e-10, 0, 30}};
  StepProgress progress;
  int last_order = 0;

  ForetoldSteps() {
    integrator.limits.follows_error = true;
    begin_step(integrator, 1, progress);
  }
  /// Makes one, with accelerations that change by `step_change`; returns its passes.
  template <class ChangeOfOrder>
  int make(double step_change, double contraction, const ChangeOfOrder& change_of_order) {
    last_order = progress.control.order;
    PassReport report;
    report.step_change = step_change;
    report.change = change_of_order(last_order);
    StepRecord record;
    const Window window{1, std::numeric_limits<std::int64_t>::max(), false};
    for (;;) {
      end_pass(integrator, window, report, progress, record);
      if (progress.completed >= 0) return static_cast<int>(record.passes);
      report.change *= contraction;
    }
  }
};

}  // namespace

TEST_CASE("foresight: a step whose change will contract to little is not confirmed") {
  ForetoldSteps steps;
  const auto change = [](int) { return 1e-6; };
  // 3e-8 may be left: of 1e-6, contraction 1e-4 leaves 3e-9 with a margin of thirty.
  CHECK(steps.make(1e-3, 1e-4, change) == 2);
  for (int k = 0; k < 6; ++k) CHECK(steps.make(1e-3, 1e-4, change) == 1);
  // Every eighth measures anew.
  CHECK(steps.make(1e-3, 1e-4, change) == 2);
  CHECK(steps.make(1e-3, 1e-4, change) == 1);
}

TEST_CASE("foresight: a contraction that the margin does not allow for is seen, not foretold") {
  ForetoldSteps steps;
  for (int k = 0; k < 20; ++k) CHECK(steps.make(1e-3, 0.02, [](int) { return 1e-6; }) == 2);
}

TEST_CASE(
    "foresight: the order that foretells best is taken, when so many accelerations are known") {
  // Smooth motion, each order a tenth of the one below; and what swings from step to step.
  for (const double by_order : {0.1, 2.0}) {
    CAPTURE(by_order);
    ForetoldSteps steps;
    const auto change = [by_order](int order) { return 1e-4 * std::pow(by_order, order); };
    std::vector<int> orders;
    for (int k = 0; k < 40; ++k) {
      steps.make(1e-3, 0.1, change);
      orders.push_back(steps.last_order);
    }
    CHECK(orders[0] == 1);  // a start knows one acceleration
    CHECK(orders[1] == 2);
    CHECK(orders[2] == 2);
    int best = 0;
    for (int k = 24; k < 40; ++k)
      best += orders[static_cast<std::size_t>(k)] == (by_order < 1.0 ? 3 : 2);
    CHECK(best == 15);  // of sixteen, with one trial
  }
}

TEST_CASE(
    "foresight: trials of the order that gain nothing become rare, and gain when they should") {
  ForetoldSteps steps;
  double by_order = 2.0;
  const auto change = [&by_order](int order) { return 1e-4 * std::pow(by_order, order); };
  std::vector<int> trials;
  for (int k = 1; k <= 256; ++k) {
    steps.make(1e-3, 0.1, change);
    if (steps.last_order == 3) trials.push_back(k);
  }
  CHECK(trials == std::vector<int>{8, 16, 32, 64, 128, 192, 256});
  by_order = 0.1;
  for (int k = 257; k <= 321; ++k) steps.make(1e-3, 0.1, change);
  CHECK(steps.last_order == 3);
}

TEST_CASE("foresight: steps that need no second look make no trials") {
  ForetoldSteps steps;
  for (int k = 0; k < 20; ++k) {
    CHECK(steps.make(1e-3, 0.5, [](int) { return 1e-9; }) == 1);
    CHECK(steps.last_order <= 2);
  }
}

TEST_CASE("foresight: a restart knows one acceleration, and keeps the contraction") {
  ForetoldSteps steps;
  const auto change = [](int) { return 1e-6; };
  for (int k = 0; k < 3; ++k) steps.make(1e-3, 1e-4, change);
  const double contraction = steps.progress.remembered.contraction;
  forget_accelerations(steps.progress);
  begin_step(steps.integrator, 4, steps.progress);
  CHECK(steps.progress.control.order == 1);
  CHECK(steps.progress.remembered.contraction == contraction);
}
