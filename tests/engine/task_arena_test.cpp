// Makes steps within the caller's own oneTBB arena.

#include <doctest/doctest.h>
#include <oneapi/tbb/task_arena.h>

#include "tests/engine/load_rotors.h"

using namespace spoke;
using namespace spoke::test;

TEST_CASE("a simulation runs within an arena of the caller's, to the same bits") {
  const Scenario scenario = soft_scenario(IntegrationMethod::generalized_alpha, 0.04);
  const auto run = [&](ExecutorKind kind, int window) {
    Simulation simulation(scenario, {Formulation::structured, kind, 2, window},
                          {demanding_load(0), demanding_load(1)});
    simulation.run_until(0.04);
    return simulation.state_hash();
  };
  const std::uint64_t hash = run(ExecutorKind::serial, 1);
  for (const int threads : {1, 2})
    for (const int window : {1, 10}) {
      oneapi::tbb::task_arena arena(threads);
      arena.execute([&] { CHECK(run(ExecutorKind::flow_graph, window) == hash); });
    }
}
