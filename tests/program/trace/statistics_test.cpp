#include "program/trace/statistics.h"

#include <doctest/doctest.h>

#include <cmath>
#include <numeric>

#include "tests/program/trace/samples.h"

using namespace spoke;
using namespace spoke::trace;
using namespace spoke::trace::testing;
using doctest::Approx;

TEST_CASE("work, span and makespan of steps made by hand") {
  const StepTrace trace = small_trace().steps;
  const auto times = time_steps(trace);
  REQUIRE(times.size() == 2);
  for (const StepTimes& step : times) {
    CHECK(step.work == Approx(12e-6));     // two passes of 1 + 3 + 2 us
    CHECK(step.span == Approx(8e-6));      // 1 + 3 us in each
    CHECK(step.makespan == Approx(9e-6));  // and the pause between them
  }
  CHECK(times[0].step == 7);
  CHECK_FALSE(overlap(trace));
  const Summary summary = summarise(trace);
  CHECK(summary.bound == Approx(8e-6));
  CHECK(summary.speedup == Approx(12.0 / 9.0));
  CHECK(summary.idle == Approx(1.0 - 12.0 / 18.0));
  CHECK(bound_at_capacity(trace, summary, {2, 1.25, 1.2}) == Approx(12e-6 / 1.25));
  CHECK(bound_at_capacity(trace, summary, {2, 1.9, 2.0}) == Approx(8e-6));
}

TEST_CASE("steps that overlap are timed together") {
  StepTrace trace = small_trace().steps;
  // The second pass of step 7 and the first of step 8 change places.
  for (NodeSlice& slice : trace.slices) {
    if (slice.step == 7 && slice.pass == 1)
      slice.step = 8, slice.pass = 0;
    else if (slice.step == 8 && slice.pass == 0)
      slice.step = 7, slice.pass = 1;
  }
  CHECK(overlap(trace));
  const Summary summary = summarise(trace);
  CHECK(summary.elapsed == Approx(9.5e-6));  // 19 us for two
  CHECK(summary.bound == Approx(6e-6));
  CHECK(summary.speedup == Approx(24.0 / 19.0));
}

TEST_CASE("costs and shares by node leave surplus passes out") {
  StepTrace trace = small_trace().steps;
  trace.slices.push_back({0, -1, -1, 4, 0, 30000, 90000});
  CHECK(mean_costs(trace)[0] == Approx(1e-6));
  const auto shares = time_shares(trace);
  CHECK(shares[0] == Approx(1.0 / 6.0));
  CHECK(shares[1] == Approx(3.0 / 6.0));
  CHECK(std::accumulate(shares.begin(), shares.end(), 0.0) == Approx(1.0));
}

TEST_CASE("the longest path goes by costs, in any numbering") {
  CHECK(longest_path({{0, 1}, {0, 2}, {1, 3}, {2, 3}}, {1, 2, 3, 1}) == std::vector<int>{0, 2, 3});
  CHECK(longest_path({{3, 1}, {3, 2}, {1, 0}, {2, 0}}, {1, 4, 3, 1}) == std::vector<int>{3, 1, 0});
  CHECK(longest_path({}, {1, 5, 2}) == std::vector<int>{1});
  CHECK(longest_path({}, {}).empty());
}

TEST_CASE("no step beats work and span") {
  for (const bool is_coupled : {false, true}) {
    const StepTrace trace =
        make_trace({ExecutorKind::flow_graph, 2, 1, is_coupled, Formulation::subsystem}).steps;
    for (const StepTimes& step : time_steps(trace)) {
      CHECK(step.span <= step.work);
      CHECK(step.makespan >= step.span);
      CHECK(step.makespan * 2 >= step.work);
    }
    const Summary summary = summarise(trace);
    CHECK(summary.idle >= 0.0);
    CHECK(summary.idle < 1.0);
    CHECK(summary.elapsed >= summary.bound);
  }
}
