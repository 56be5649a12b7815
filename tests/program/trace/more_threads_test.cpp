#include "program/trace/more_threads.h"

#include <doctest/doctest.h>

#include <algorithm>

#include "tests/program/trace/samples.h"

using namespace spoke;
using namespace spoke::trace;
using namespace spoke::trace::testing;
using doctest::Approx;

namespace {

/// The graph of small_trace(), `passes` passes long: 0 -> 1, 0 -> 2, and both before the next pass.
graph::StepGraph small_graph(int passes) {
  graph::StepGraphBuilder builder;
  const auto root = builder.add_part("root", {}), one = builder.add_part("one", {}),
             two = builder.add_part("two", {});
  const auto nothing = []() noexcept {};
  for (int pass = 0; pass < passes; ++pass) {
    builder.add_node({.stage = "root", .pass = pass}, {{one, two}}, {{root}}, nothing);
    builder.add_node({.stage = "mass", .subsystem = 0, .body = 0, .pass = pass}, {{root}}, {{one}},
                     nothing);
    builder.add_node({.stage = "mass", .subsystem = 0, .body = 1, .pass = pass}, {{root}}, {{two}},
                     nothing);
  }
  return builder.build();
}

}  // namespace

TEST_CASE("steps made by hand on more threads, in runs of one pass and of a window") {
  const StepTrace trace = small_trace().steps;
  // A pass is a root of 1 us before masses of 3 and 2 us; a step takes two.
  for (const int passes : {1, 2, 6}) {
    CAPTURE(passes);
    const graph::StepGraph run = small_graph(passes);
    const MoreThreads more = find_more_threads(trace, run, passes / 2, {1, 2, 5});
    CHECK(more.passes == passes);
    CHECK(more.window_steps == passes / 2);
    CHECK(more.work == Approx(12e-6));
    CHECK(more.span == Approx(8e-6));
    CHECK(more.bound() == Approx(1.5));
    REQUIRE(more.rows.size() == 3);
    CHECK(more.rows[0].scheduled == Approx(12e-6));
    CHECK(more.rows[0].by_auto == Approx(12e-6));
    CHECK(more.rows[0].clusters == 1);
    CHECK(more.rows[1].threads == 2);
    CHECK(more.rows[1].scheduled == Approx(8e-6));
    CHECK(more.rows[2].scheduled == Approx(8e-6));
  }
}

TEST_CASE("what interrupts a node once is not its cost") {
  StepTrace trace = small_trace().steps;
  trace.slices[1].end += 1000000;
  const std::vector<double> costs = costs_of_run(trace, small_graph(2));
  REQUIRE(costs.size() == 6);
  for (const std::size_t pass : {0, 1}) {
    CHECK(costs[3 * pass] == Approx(1e-6));
    CHECK(costs[3 * pass + 1] == Approx(3e-6));
    CHECK(costs[3 * pass + 2] == Approx(2e-6));
  }
}

TEST_CASE("no number of threads is faster than the bounds") {
  for (const int window : {1, 5}) {
    Simulation simulation = make_simulation({.window = window});
    const StepTrace trace = simulation.trace(10);
    const std::vector<int> threads{1, 2, 3, 8, 64};
    const MoreThreads more = find_more_threads(trace, simulation.run_graph(), window, threads);
    CHECK(more.passes >= window);
    CHECK(more.bound() >= 1.0);
    REQUIRE(more.rows.size() == threads.size());
    for (const StepOnThreads& row : more.rows) {
      CAPTURE(row.threads);
      const double least = (1.0 - 1e-12) * std::max(more.work / row.threads, more.span);
      CHECK(row.scheduled >= least);
      CHECK(row.by_auto >= least);
      CHECK(row.by_auto <= (1.0 + 1e-12) * more.work);
    }
    CHECK(more.rows[0].scheduled == Approx(more.work));
    CHECK(more.rows[0].by_auto == Approx(more.work));
  }
}
