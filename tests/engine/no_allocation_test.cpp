// A program of its own: it counts every allocation of the process.

#include <doctest/doctest.h>

#include <atomic>
#include <cstdlib>
#include <new>

#include "engine/simulation.h"
#include "rotors.h"

using namespace spoke;
using namespace spoke::test;

namespace {
std::atomic<long> allocations{0};
std::atomic<std::size_t> allocated_bytes{0};
}  // namespace

// Eigen and oneTBB allocate by malloc, everything else by operator new, which calls it.
extern "C" void* __libc_malloc(std::size_t size);
extern "C" void* malloc(std::size_t size) {
  allocations.fetch_add(1, std::memory_order_relaxed);
  allocated_bytes.fetch_add(size, std::memory_order_relaxed);
  return __libc_malloc(size);
}

namespace {

long allocations_of_steps(const Scenario& scenario, const SimulationOptions& options, int steps) {
  Simulation simulation(scenario, options);
  for (int n = 0; n < 3; ++n) simulation.step();  // runtimes fill their pools
  const long before = allocations.load();
  for (int n = 0; n < steps; ++n) simulation.step();
  return allocations.load() - before;
}

}  // namespace

TEST_CASE("allocations are counted") {
  const long before = allocations.load();
  std::vector<double> some(100);
  CHECK(some.data() != nullptr);
  CHECK(allocations.load() == before + 1);
}

TEST_CASE("a step allocates nothing, at small and large numbers of elements") {
  for (const IntegrationMethod method :
       {IntegrationMethod::generalized_alpha, IntegrationMethod::rk4})
    for (const int elements : {1, 4, 64, 300}) {
      Scenario scenario = spin_up_scenario(wu_haug_blade(2, elements), 1e-3);
      scenario.integration.method = method;
      if (method == IntegrationMethod::rk4) scenario.integration.step = 1e-8;
      scenario.rotor.damping = {0.1, 1e-6};
      PointLoad load;
      load.force = Position{0.0, 1.0};
      load.factor = Curve({0.0, 1.0, 2.0}, {0.0, 1.0, 0.0});
      scenario.rotor.loads.push_back(load);
      CAPTURE(elements);
      CHECK(allocations_of_steps(scenario, {Formulation::structured, ExecutorKind::serial, 1},
                                 20) == 0);
    }
}

TEST_CASE("a step of the dense formulations allocates nothing at the paper's size") {
  for (const Formulation formulation : {Formulation::subsystem, Formulation::augmented})
    for (const IntegrationMethod method :
         {IntegrationMethod::generalized_alpha, IntegrationMethod::rk4}) {
      Scenario scenario = spin_up_scenario(wu_haug_blade(), 1e-3);
      scenario.integration.method = method;
      if (method == IntegrationMethod::rk4) scenario.integration.step = 8e-5;
      CAPTURE(name_of(formulation));
      CHECK(allocations_of_steps(scenario, {formulation, ExecutorKind::serial, 1}, 10) == 0);
    }
}

TEST_CASE("measuring the sensors allocates nothing") {
  Simulation simulation(spin_up_scenario(wu_haug_blade(), 1e-3),
                        {Formulation::structured, ExecutorKind::serial, 1});
  simulation.sensor_values();
  const long before = allocations.load();
  for (int n = 0; n < 5; ++n) {
    simulation.step();
    simulation.sensor_values();
  }
  CHECK(allocations.load() == before);
}

TEST_CASE("a load of the user's allocates nothing but what it allocates itself") {
  const auto drag = make_load("drag", {{0, 0, 0.5}, {0, 3, 1.0}},
                              [](double, std::span<const MarkerMotion> in, std::span<Wrench> out) {
                                for (std::size_t k = 0; k < in.size(); ++k)
                                  out[k].force = -0.1 * in[k].velocity;
                              });
  Simulation simulation(spin_up_scenario(wu_haug_blade(), 1e-3),
                        {Formulation::structured, ExecutorKind::serial, 1}, {drag});
  for (int n = 0; n < 3; ++n) simulation.step();
  const long before = allocations.load();
  for (int n = 0; n < 10; ++n) simulation.step();
  CHECK(allocations.load() == before);
}

TEST_CASE("recording a trace allocates nothing while steps are made") {
  for (const int window : {1, 10}) {
    const SimulationOptions options{Formulation::structured, ExecutorKind::serial, 1, window};
    Simulation simulation(spin_up_scenario(wu_haug_blade(), 1e-3), options);
    simulation.run_until(0.05);
    std::vector<long> counts;
    counts.reserve(100);
    const StepTrace trace = simulation.trace(
        100, [&](double, std::span<const double>) { counts.push_back(allocations.load()); });
    REQUIRE(counts.size() == 100);
    CHECK(trace.steps.size() == 100);
    CHECK(counts.back() == counts.front());
  }
}

TEST_CASE("a recording allocates no more than its buffer") {
  // Many blades with few nodes: places of passes take much beside the records.
  Scenario scenario = spin_up_scenario(wu_haug_blade(1, 1), 1e-3);
  scenario.rotor.blades.resize(24, scenario.rotor.blades[0]);
  scenario.integration.duration = 50.0;
  for (const int window : {1, 10}) {
    Simulation simulation(scenario, {Formulation::structured, ExecutorKind::serial, 1, window});
    simulation.run_until(0.05);
    TraceOptions options;
    options.buffer_bytes = 1000000;
    std::size_t used = 0;
    const std::size_t before = allocated_bytes.load();
    const StepObserver observe = [&](double, std::span<const double>) {
      if (used == 0) used = allocated_bytes.load() - before;
      simulation.stop();
    };
    simulation.trace(40000, observe, options);
    CHECK(used > options.buffer_bytes / 2);
    // Some more for a while, to find which node of a pass is which.
    CHECK(used <= options.buffer_bytes + options.buffer_bytes / 20);
  }
}

TEST_CASE("a step on the flow graph allocates nothing once its pools are filled") {
  const Scenario scenario = spin_up_scenario(wu_haug_blade(), 1e-3);
  Simulation simulation(scenario, {Formulation::structured, ExecutorKind::flow_graph, 2});
  for (int n = 0; n < 500; ++n) simulation.step();
  const long before = allocations.load();
  for (int n = 0; n < 500; ++n) simulation.step();
  // oneTBB grows a pool now and then, when a task ends on another thread; a step does not.
  CHECK(allocations.load() - before < 50);
}
