#include "program/run_report/picture_steps.h"

#include <doctest/doctest.h>

#include <vector>

#include "engine/results.h"
#include "tests/program/run_report/scenarios.h"

using namespace spoke;
using spoke::run_report::PictureSteps;

namespace {

std::vector<std::int64_t> steps_of(const Simulation& simulation, std::size_t most) {
  const PictureSteps pictures(simulation, most);
  std::vector<std::int64_t> steps;
  for (std::int64_t step = 0; step < simulation.planned_steps();)
    steps.push_back(step = pictures.next(step));
  return steps;
}

}  // namespace

TEST_CASE("without a limit there is a picture at every output time and at the end") {
  for (const double interval : {0.0, 0.003, 0.01, 0.05, 0.07, 0.1, 0.3333, 5.0}) {
    CAPTURE(interval);
    Scenario scenario = test_scenario();
    scenario.output.interval = interval;
    const Simulation simulation(scenario, test_options());
    std::vector<std::int64_t> expected;
    OutputTimes due(interval);
    for (std::int64_t step = 0; step <= simulation.planned_steps(); ++step) {
      const bool is_due = due.is_due(static_cast<double>(step) * simulation.step_size());
      if (step > 0 && (is_due || step == simulation.planned_steps())) expected.push_back(step);
    }
    CHECK(steps_of(simulation, 0) == expected);
  }
}

TEST_CASE("pictures keep to a number, and to the window of steps") {
  Scenario scenario = test_scenario();
  scenario.output.interval = 0.0;
  const Simulation simulation(scenario, test_options());
  CHECK(steps_of(simulation, 10) ==
        std::vector<std::int64_t>{20, 40, 60, 80, 100, 120, 140, 160, 180, 200});
  SimulationOptions options = test_options();
  options.window = 90;
  CHECK(steps_of(Simulation(scenario, options), 10) == std::vector<std::int64_t>{90, 180, 200});
}
