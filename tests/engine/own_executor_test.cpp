// Tests executors that a program brings along: whatever order they choose, they give the bits of
// "serial".

#include <doctest/doctest.h>

#include <map>
#include <memory>
#include <nlohmann/json.hpp>
#include <random>
#include <set>
#include <thread>
#include <vector>

#include "engine/results.h"
#include "engine/simulation.h"
#include "models/error.h"
#include "tests/engine/rotors.h"

using namespace spoke;
using namespace spoke::test;

namespace {

/// Runs a random one of the nodes that may run, on the calling thread or one that it starts and
/// waits for.
class RandomOrder final : public graph::Executor {
 public:
  explicit RandomOrder(const graph::StepGraph& graph) : graph_(graph) {}

  void run() override {
    std::vector<graph::NodeId> ready;
    std::vector<std::size_t> waits_for;
    for (int i = 0; i < graph_.node_count(); ++i) {
      waits_for.push_back(graph_.predecessors({i}).size());
      if (waits_for.back() == 0) ready.push_back({i});
    }
    while (!ready.empty()) {
      std::swap(ready[random_() % ready.size()], ready.back());
      const graph::NodeId node = ready.back();
      ready.pop_back();
      if (random_() % 100 == 0)
        std::thread([&] { run_on_thread(1, graph_, {&node, 1}); }).join();
      else
        run_on_thread(0, graph_, {&node, 1});
      for (const graph::NodeId next : graph_.successors(node))
        if (--waits_for[static_cast<std::size_t>(next.index)] == 0) ready.push_back(next);
    }
  }
  std::string_view name() const override { return "random_order"; }
  graph::Threads threads() const override { return 2; }

 private:
  const graph::StepGraph& graph_;
  std::mt19937 random_{11};
};

SimulationOptions own_options(Formulation formulation, int window) {
  SimulationOptions options{.formulation = formulation, .window = window};
  options.make_executor = [](const graph::StepGraph& graph) {
    return std::make_unique<RandomOrder>(graph);
  };
  return options;
}

/// Claims a number of threads.
class Threaded final : public graph::Executor {
 public:
  explicit Threaded(int threads) : threads_(threads) {}
  void run() override {}
  std::string_view name() const override { return "threaded"; }
  graph::Threads threads() const override { return threads_; }

 private:
  int threads_;
};

}  // namespace

TEST_CASE("an executor of one's own gives the bits of serial: all formulations, in windows too") {
  for (const IntegrationMethod method :
       {IntegrationMethod::generalized_alpha, IntegrationMethod::rk4})
    for (const Formulation formulation : formulations()) {
      Scenario scenario = unequal_scenario(HubSupport::axle, method);
      scenario.integration.duration = 20 * scenario.integration.step;
      Simulation serial(scenario, {formulation, ExecutorKind::serial, 1});
      serial.run_until(scenario.integration.duration);
      for (const int window : {0, 1, 4}) {
        CAPTURE(name_of(formulation));
        CAPTURE(window);
        Simulation own(scenario, own_options(formulation, window));
        own.step();
        own.run_until(scenario.integration.duration, [](double, std::span<const double>) {});
        CHECK(own.steps() == serial.steps());
        CHECK(own.evaluations() == serial.evaluations());
        CHECK(own.state_hash() == serial.state_hash());
      }
    }
}

TEST_CASE("a free hub, on an executor of one's own") {
  Scenario scenario = unequal_scenario(HubSupport::free, IntegrationMethod::generalized_alpha);
  scenario.rotor.hub.mass = 10.0;
  scenario.rotor.hub.drive = FreeDrive{1.0};
  scenario.integration.duration = 20 * scenario.integration.step;
  Simulation serial(scenario, {Formulation::structured, ExecutorKind::serial, 1});
  Simulation own(scenario, own_options(Formulation::structured, 3));
  serial.run_until(scenario.integration.duration);
  own.run_until(scenario.integration.duration);
  CHECK(own.state_hash() == serial.state_hash());
}

TEST_CASE("an executor of one's own is called by its name and traced") {
  Scenario scenario = unequal_scenario(HubSupport::axle, IntegrationMethod::generalized_alpha);
  for (const int window : {1, 4}) {
    Simulation own(scenario, own_options(Formulation::structured, window));
    CHECK(own.executor_name() == "random_order");
    CHECK(own.threads() == graph::Threads(2));
    const StepTrace trace = own.trace(8);
    CHECK(trace.executor.find("random_order on 2 threads") != std::string::npos);
    CHECK(trace.steps.size() == 8);
    std::map<std::int64_t, std::set<int>> nodes;
    std::set<int> threads;
    for (const NodeSlice& slice : trace.slices) {
      if (slice.step >= 0 && slice.pass == 0) nodes[slice.step].insert(slice.node);
      threads.insert(slice.thread);
    }
    CHECK(nodes.size() == 8);
    CHECK(nodes.begin()->second.size() > 10);
    CHECK(threads == std::set<int>{0, 1});
    const std::string summary = make_summary(own, SensorStatistics(own.sensor_names().size()), {});
    CHECK(nlohmann::json::parse(summary)["executor"] == "random_order");
  }
}

TEST_CASE("a function that makes no executor, or an impossible one, is refused") {
  const Scenario scenario =
      unequal_scenario(HubSupport::axle, IntegrationMethod::generalized_alpha);
  SimulationOptions options;
  options.make_executor = [](const graph::StepGraph&) { return nullptr; };
  CHECK_THROWS_WITH_AS(Simulation(scenario, options),
                       "SimulationOptions::make_executor made none, expected an executor",
                       InputError);
  options.make_executor = [](const graph::StepGraph&) { return std::make_unique<Threaded>(0); };
  CHECK_THROWS_WITH_AS(Simulation(scenario, options),
                       "the executor threaded has 0 threads, expected 1 to 1024", InputError);
}
