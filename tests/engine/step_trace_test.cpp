#include "engine/step_trace.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <map>
#include <set>
#include <string>
#include <tuple>

#include "engine/simulation.h"
#include "models/error.h"
#include "tests/engine/rotors.h"

using namespace spoke;
using namespace spoke::test;

namespace {

bool is_coupled(const Scenario& scenario, const SimulationOptions& options) {
  return scenario.rotor.hub.support == HubSupport::free ||
         options.formulation == Formulation::augmented;
}

using Times = std::map<std::tuple<std::int64_t, int, int>, NodeSlice>;  // step, pass, node

/// Returns the slices of complete steps; fails if a node is there twice.
Times times_of(const StepTrace& trace, bool is_windowed) {
  Times times;
  for (const NodeSlice& slice : trace.slices) {
    if (slice.step < 0) continue;
    const bool is_new = times.emplace(std::tuple(slice.step, slice.pass, slice.node), slice).second;
    const bool is_hub = trace.graph.names[static_cast<std::size_t>(slice.node)] == "hub solve";
    if (!(is_windowed && is_hub)) CHECK(is_new);
  }
  return times;
}

void check_threads(const StepTrace& trace) {
  std::vector<std::int64_t> ends(static_cast<std::size_t>(trace.threads), 0);
  std::int64_t before = 0;
  int faults = 0;
  for (const NodeSlice& slice : trace.slices) {
    REQUIRE(slice.thread >= 0);
    REQUIRE(slice.thread < trace.threads);
    std::int64_t& end = ends[static_cast<std::size_t>(slice.thread)];
    faults += slice.begin < end || slice.end < slice.begin || slice.begin < before;
    end = slice.end;
    before = slice.begin;
    faults += std::none_of(trace.runs.begin(), trace.runs.end(), [&](const TracedRun& run) {
      return run.begin <= slice.begin && slice.end <= run.end;
    });
  }
  CHECK(faults == 0);
}

/// Checks that every node follows its predecessors, also those of the pass before.
void check_order(const StepTrace& trace, const Times& times) {
  int faults = 0;
  const auto end_of = [&](std::int64_t step, int pass, int node) {
    const auto found = times.find({step, pass, node});
    return found == times.end() ? std::int64_t{-1} : found->second.end;
  };
  for (const auto& [key, slice] : times) {
    const auto [step, pass, node] = key;
    for (const NodeEdge& edge : trace.graph.edges)
      faults += edge.to == node && end_of(step, pass, edge.from) > slice.begin;
    for (const NodeEdge& edge : trace.graph.next_pass_edges)
      faults += edge.to == node && pass > 0 && end_of(step, pass - 1, edge.from) > slice.begin;
  }
  CHECK(faults == 0);
}

/// Checks that the nodes of each subsystem are all there in as many passes as it needs, those of at
/// least one subsystem in all passes of the step.
void check_complete(const StepTrace& trace, const Times& times, bool is_windowed) {
  std::map<std::int64_t, std::map<int, std::map<int, int>>> counts;  // step, subsystem, pass
  std::map<int, int> nodes;                                          // by subsystem
  for (const graph::NodeLabel& label : trace.graph.labels) ++nodes[label.subsystem];
  for (const auto& [key, slice] : times)
    ++counts[slice.step][trace.graph.labels[static_cast<std::size_t>(slice.node)].subsystem]
            [slice.pass];
  for (const TracedStep& step : trace.steps) {
    int most = 0;
    for (const auto& [subsystem, count] : nodes) {
      if (subsystem < 0 && is_windowed) continue;
      const auto& by_pass = counts[step.step][subsystem];
      REQUIRE(!by_pass.empty());
      CHECK(by_pass.begin()->first == 0);
      CHECK(by_pass.rbegin()->first == static_cast<int>(by_pass.size()) - 1);
      for (const auto& [pass, found] : by_pass) CHECK(found == count);
      most = std::max(most, static_cast<int>(by_pass.size()));
    }
    CHECK(most == step.passes);
  }
}

void check_trace(const Scenario& scenario, const SimulationOptions& options) {
  constexpr std::int64_t first = 31, count = 12;
  Simulation simulation(scenario, options), untraced(scenario, options);
  simulation.run_until((first - 1) * simulation.step_size());
  const std::int64_t evaluations = simulation.evaluations();
  const StepTrace trace = simulation.trace(count);
  CHECK(simulation.steps() == first - 1 + count);
  CHECK(trace.dropped_steps == 0);
  REQUIRE(trace.steps.size() == count);
  std::int64_t passes = 0;
  for (std::size_t k = 0; k < trace.steps.size(); ++k) {
    CHECK(trace.steps[k].step == first + static_cast<std::int64_t>(k));
    CHECK(trace.steps[k].time == static_cast<double>(trace.steps[k].step) * simulation.step_size());
    passes += trace.steps[k].passes;
  }
  CHECK(passes == simulation.evaluations() - evaluations);
  const bool is_auto_alone =  // it makes no windows for one thread
      options.executor == ExecutorKind::automatic && options.threads.total() == 1;
  CHECK(trace.window_steps == (is_auto_alone ? 1 : std::max(options.window, 1)));
  const bool is_windowed = trace.window_steps > 1 && !is_coupled(scenario, options);
  const Times times = times_of(trace, is_windowed);
  check_threads(trace);
  check_order(trace, times);
  check_complete(trace, times, is_windowed);
  simulation.run_until(1e9);
  untraced.run_until(1e9);
  CHECK(simulation.state_hash() == untraced.state_hash());
  CHECK(simulation.evaluations() == untraced.evaluations());
}

}  // namespace

TEST_CASE("a trace has each node once per pass, in the order of the edges, on every executor") {
  for (const ExecutorKind kind : graph::executor_kinds())
    for (const HubSupport support : {HubSupport::axle, HubSupport::free})
      for (const int window : {1, 4})
        for (const int threads : {1, 3}) {
          CAPTURE(name_of(kind));
          CAPTURE(static_cast<int>(support));
          CAPTURE(window);
          CAPTURE(threads);
          const Scenario scenario = unequal_scenario(support, IntegrationMethod::generalized_alpha);
          check_trace(scenario, {Formulation::structured, kind, threads, window});
        }
}

TEST_CASE("traces of nested teams") {
  const Scenario scenario =
      unequal_scenario(HubSupport::axle, IntegrationMethod::generalized_alpha);
  for (const ExecutorKind kind : graph::executor_kinds()) {
    if (kind != ExecutorKind::openmp_scheme1 && kind != ExecutorKind::openmp_scheme2) continue;
    check_trace(scenario, {Formulation::subsystem, kind, {3, 2}, 1});
  }
}

TEST_CASE("traces of all formulations and of rk4, and of a single blade") {
  for (const int window : {1, 3}) {
    for (const Formulation formulation : {Formulation::subsystem, Formulation::augmented})
      check_trace(unequal_scenario(HubSupport::axle, IntegrationMethod::generalized_alpha),
                  {formulation, ExecutorKind::flow_graph, 2, window});
    for (const HubSupport support : {HubSupport::axle, HubSupport::free})
      check_trace(unequal_scenario(support, IntegrationMethod::rk4),
                  {Formulation::structured, ExecutorKind::flow_graph, 2, window});
    Scenario single = unequal_scenario(HubSupport::axle, IntegrationMethod::generalized_alpha);
    single.rotor.blades.resize(1);
    check_trace(single, {Formulation::structured, ExecutorKind::flow_graph, 2, window});
  }
}

TEST_CASE("traces of steps that follow one another become one") {
  const Scenario scenario =
      unequal_scenario(HubSupport::axle, IntegrationMethod::generalized_alpha);
  for (const int window : {1, 4}) {
    Simulation simulation(scenario, {Formulation::structured, ExecutorKind::flow_graph, 2, window});
    StepTrace all = simulation.trace(8);
    const std::size_t slices = all.slices.size(), runs = all.runs.size();
    const std::int64_t end = all.runs.back().end;
    const StepTrace one = simulation.trace(1), last = simulation.trace(7);
    all.append(one);
    CHECK(all.window_steps == window);  // of the first; a single step is made without a window
    all.append(last);
    CHECK(all.slices.size() == slices + one.slices.size() + last.slices.size());
    CHECK(all.runs.size() == runs + one.runs.size() + last.runs.size());
    CHECK(all.runs[runs].begin >= end);
    CHECK(all.runs[runs].end - all.runs[runs].begin == one.runs[0].end - one.runs[0].begin);
    REQUIRE(all.steps.size() == 16);
    for (std::size_t k = 0; k < all.steps.size(); ++k)
      CHECK(all.steps[k].step == static_cast<std::int64_t>(k) + 1);
    const Times times = times_of(all, window > 1);
    check_threads(all);
    check_order(all, times);
    check_complete(all, times, window > 1);
  }
}

TEST_CASE("parts of a trace that had no room count as dropped in the whole") {
  Simulation simulation(unequal_scenario(HubSupport::axle, IntegrationMethod::generalized_alpha),
                        {Formulation::structured, ExecutorKind::serial, 1, 1});
  TraceOptions no_room;
  no_room.buffer_bytes = 0;
  StepTrace all = simulation.trace(3, {}, no_room);
  all.append(simulation.trace(2));
  all.append(simulation.trace(4, {}, no_room));
  CHECK(all.dropped_steps == 7);
  REQUIRE(all.steps.size() == 2);
  CHECK(all.steps[0].step == 4);
  CHECK_FALSE(all.slices_of(4).empty());
  CHECK_FALSE(all.slices_of(5).empty());
}

TEST_CASE("a trace tells the observer what run_until() tells") {
  const Scenario scenario =
      unequal_scenario(HubSupport::axle, IntegrationMethod::generalized_alpha);
  const SimulationOptions options{Formulation::structured, ExecutorKind::flow_graph, 2, 4};
  std::vector<double> rows, expected;
  const auto into = [](std::vector<double>& values) {
    return [&values](double t, std::span<const double> sensors) {
      values.push_back(t);
      values.insert(values.end(), sensors.begin(), sensors.end());
    };
  };
  Simulation traced(scenario, options), plain(scenario, options);
  traced.trace(20, into(rows));
  plain.run_until(20 * plain.step_size(), into(expected));
  CHECK(rows == expected);
  CHECK_FALSE(rows.empty());
}

TEST_CASE("every finished step is told with its slices, in order") {
  for (const int window : {1, 4}) {
    Simulation simulation(unequal_scenario(HubSupport::axle, IntegrationMethod::generalized_alpha),
                          {Formulation::structured, ExecutorKind::flow_graph, 2, window});
    std::vector<TracedStep> steps;
    std::vector<std::vector<NodeSlice>> slices;
    TraceOptions options;
    options.finished = [&](const TracedStep& step, std::span<const NodeSlice> own) {
      steps.push_back(step);
      slices.emplace_back(own.begin(), own.end());
    };
    const StepTrace trace = simulation.trace(13, {}, options);
    REQUIRE(steps.size() == 13);
    for (std::size_t k = 0; k < steps.size(); ++k) {
      CHECK(steps[k].step == trace.steps[k].step);
      CHECK(steps[k].time == trace.steps[k].time);
      CHECK(steps[k].passes == trace.steps[k].passes);
      const auto expected = trace.slices_of(steps[k].step);
      REQUIRE(slices[k].size() == expected.size());
      CHECK(std::equal(expected.begin(), expected.end(), slices[k].begin(),
                       [](const NodeSlice& one, const NodeSlice& other) {
                         return one.node == other.node && one.pass == other.pass &&
                                one.thread == other.thread && one.begin == other.begin &&
                                one.end == other.end;
                       }));
    }
    options.buffer_bytes = 0;
    simulation.trace(3, {}, options);
    CHECK(steps.size() == 13);
  }
}

TEST_CASE("a full buffer drops whole steps and says how many") {
  for (const int window : {1, 5}) {
    const Scenario scenario =
        unequal_scenario(HubSupport::axle, IntegrationMethod::generalized_alpha);
    const SimulationOptions options{Formulation::structured, ExecutorKind::serial, 1, window};
    const auto run = [&](std::size_t bytes) {
      Simulation simulation(scenario, options);
      TraceOptions trace_options;
      trace_options.buffer_bytes = bytes;
      return simulation.trace(40, {}, trace_options);
    };
    const StepTrace all = run(std::size_t{1} << 24);
    CHECK(all.dropped_steps == 0);
    const StepTrace some = run(std::size_t{64} << 10);
    CHECK(some.dropped_steps > 0);
    CHECK(static_cast<std::int64_t>(some.steps.size()) == 40 - some.dropped_steps);
    REQUIRE(!some.steps.empty());
    check_complete(some, times_of(some, window > 1), window > 1);
    const std::int64_t last = some.steps.back().step;
    CHECK(some.slices_of(last).size() == all.slices_of(last).size());
    CHECK(some.slices_of(last + 1).empty());
    const StepTrace none = run(0);
    CHECK(none.steps.empty());
    CHECK(none.slices.empty());
    CHECK(none.dropped_steps == 40);
  }
}

TEST_CASE("the buffer that is said to suffice holds the first step, or all of them") {
  for (const ExecutorKind kind : {ExecutorKind::serial, ExecutorKind::flow_graph})
    for (const int window : {1, 5}) {
      const Scenario scenario =
          unequal_scenario(HubSupport::axle, IntegrationMethod::generalized_alpha);
      const auto run = [&](std::size_t bytes) {
        Simulation simulation(scenario, {Formulation::structured, kind, 4, window});
        TraceOptions options;
        options.buffer_bytes = bytes;
        return simulation.trace(40, {}, options);
      };
      const StepTrace none = run(1000);
      CHECK(none.dropped_steps == 40);
      REQUIRE(none.bytes_of_first > 1000);
      CHECK(none.bytes_of_first < none.bytes_of_all);
      const StepTrace first = run(none.bytes_of_first);
      REQUIRE(!first.steps.empty());
      CHECK(first.steps.front().step == 1);
      const StepTrace all = run(none.bytes_of_all);
      CHECK(all.dropped_steps == 0);
      CHECK(all.bytes_of_all == none.bytes_of_all);
    }
}

TEST_CASE("steps of many iterations are recorded as long as the buffer has room") {
  Scenario scenario = spin_up_scenario(wu_haug_blade(), 0.02);
  scenario.rotor.hub.drive = SpinUp{4.0, 0.5};
  scenario.integration.duration = 2.0;
  for (const int window : {1, 10}) {
    Simulation simulation(scenario, {Formulation::structured, ExecutorKind::flow_graph, 2, window});
    const StepTrace trace = simulation.trace(50);
    int most = 0;
    for (const TracedStep& step : trace.steps) most = std::max(most, step.passes);
    CHECK(most >= 6);
    CHECK(trace.dropped_steps == 0);
    CHECK(trace.steps.size() == 50);
  }
}

TEST_CASE("less than half a window runs without windows, and the trace names what ran it") {
  const Scenario scenario =
      unequal_scenario(HubSupport::axle, IntegrationMethod::generalized_alpha);
  const auto run = [&](ExecutorKind kind, std::int64_t steps) {
    Simulation simulation(scenario, {Formulation::structured, kind, 2, 100});
    return simulation.trace(steps);
  };
  const StepTrace few = run(ExecutorKind::flow_graph, 49);
  CHECK(few.executor == "flow_graph on 2 threads");
  CHECK(few.threads == 2);
  CHECK(few.window_steps == 1);
  CHECK(few.unused_window == 100);
  const StepTrace half = run(ExecutorKind::flow_graph, 50);
  CHECK(half.executor == "windows of 100 steps, flow_graph on 2 threads");
  CHECK(half.window_steps == 100);
  CHECK(half.unused_window == 0);
  const StepTrace serial = run(ExecutorKind::automatic, 49);
  CHECK(serial.executor == "serial on 1 thread");
  CHECK(serial.threads == 1);
  CHECK(serial.window_steps == 1);
  CHECK(serial.unused_window == 100);
}

TEST_CASE("a trace says whether auto had chosen, and names the serial steps before") {
  Scenario scenario = unequal_scenario(HubSupport::axle, IntegrationMethod::generalized_alpha);
  const auto begin = [&](int window) {
    return Simulation(scenario, {Formulation::structured, ExecutorKind::automatic, 2, window});
  };
  const StepTrace first = begin(0).trace(3);
  CHECK(first.choice == ChoiceState::none);
  CHECK(first.executor == "serial: not timed yet");
  CHECK(first.threads == 1);
  if (graph::available_threads() > 1) {
    const StepTrace tuning = begin(4).trace(20);
    CHECK(tuning.choice == ChoiceState::tuning);
    CHECK(tuning.executor == "windows of 4 steps, serial: still tuning on 2 threads");
    CHECK(tuning.threads == 1);
    CHECK(std::all_of(tuning.slices.begin(), tuning.slices.end(),
                      [](const NodeSlice& slice) { return slice.thread == 0; }));
  }
  // As soon as a simulation is long enough to be timed, hardly anything is left of it.
  StepTrace last;
  last.choice = ChoiceState::none;
  for (int steps = 20; last.choice != ChoiceState::made; steps += 8) {
    REQUIRE(steps < 4000);
    scenario.integration.duration = steps * scenario.integration.step;
    Simulation brief = begin(0);
    brief.run_until((steps - 2) * brief.step_size());
    last = brief.trace(2);
  }
  CHECK(last.executor.find("too short to plan for") != std::string::npos);
}

TEST_CASE("slices_of gives a step's slices by begin") {
  Simulation simulation(unequal_scenario(HubSupport::axle, IntegrationMethod::generalized_alpha),
                        {Formulation::structured, ExecutorKind::flow_graph, 2, 4});
  const StepTrace trace = simulation.trace(8);
  std::size_t count = 0, surplus = 0;
  for (const TracedStep& step : trace.steps) {
    const auto slices = trace.slices_of(step.step);
    CHECK(std::is_sorted(slices.begin(), slices.end(), [](const auto& one, const auto& other) {
      return one.begin < other.begin;
    }));
    count += slices.size();
  }
  for (const NodeSlice& slice : trace.slices) surplus += slice.step < 0;
  CHECK(count + surplus == trace.slices.size());
  CHECK(trace.slices_of(-1).empty());
  CHECK(trace.slices_of(9).empty());
}

TEST_CASE("a trace of steps that diverge throws, and the simulation is left as without") {
  Scenario scenario = spin_up_scenario(wu_haug_blade(1, 4), 0.005);
  scenario.rotor.blades[1].geometric_stiffening = false;  // fails beyond 3 rad/s
  scenario.integration.duration = 12.0;
  for (const int window : {1, 20}) {
    const SimulationOptions options{Formulation::structured, ExecutorKind::flow_graph, 2, window};
    Simulation traced(scenario, options), plain(scenario, options);
    CHECK_THROWS_AS(traced.trace(2400), DivergenceError);
    CHECK_THROWS_AS(plain.run_until(12.0), DivergenceError);
    CHECK(traced.state_hash() == plain.state_hash());
    CHECK(traced.steps() == plain.steps());
  }
}

TEST_CASE("what was recorded before a step fails is told, complete steps alone") {
  Scenario scenario = spin_up_scenario(wu_haug_blade(1, 4), 0.005);
  scenario.rotor.blades[1].geometric_stiffening = false;  // fails beyond 3 rad/s
  scenario.integration.duration = 12.0;
  for (const int window : {1, 20}) {
    Simulation simulation(scenario, {Formulation::structured, ExecutorKind::flow_graph, 2, window});
    std::int64_t finished = 0;
    std::vector<StepTrace> told;
    TraceOptions options;
    options.finished = [&](const TracedStep& step, std::span<const NodeSlice>) {
      finished = step.step;
    };
    options.unfinished = [&](StepTrace trace) { told.push_back(std::move(trace)); };
    CHECK_THROWS_AS(simulation.trace(2400, {}, options), DivergenceError);
    REQUIRE(told.size() == 1);
    const StepTrace& trace = told[0];
    CHECK(trace.asked_steps == 2400);
    CHECK(trace.dropped_steps == 0);
    const auto count = static_cast<std::int64_t>(trace.steps.size());
    CHECK(count > 100);
    CHECK(count <= simulation.steps());
    if (window == 1) CHECK(count == simulation.steps());
    CHECK(trace.steps.back().step == count);
    CHECK(finished == count);
    CHECK(trace.window_steps == window);
    const Times times = times_of(trace, window > 1);
    check_complete(trace, times, window > 1);
    for (const NodeSlice& slice : trace.slices) REQUIRE(slice.step <= count);
  }
}

TEST_CASE("steps that are undone, as an observer threw, are not in what is told") {
  Simulation simulation(unequal_scenario(HubSupport::axle, IntegrationMethod::generalized_alpha),
                        {Formulation::structured, ExecutorKind::flow_graph, 2, 4});
  int calls = 0;
  std::size_t steps = 0;
  TraceOptions options;
  options.unfinished = [&](const StepTrace& trace) { steps = trace.steps.size(); };
  const StepObserver observe = [&](double, std::span<const double>) {
    if (++calls == 13) throw std::runtime_error("enough");
  };
  CHECK_THROWS_WITH(simulation.trace(40, observe, options), "enough");
  CHECK(simulation.steps() == 13);
  CHECK(steps == 13);
}

TEST_CASE("what an observer throws ends a trace, and nothing goes on recording") {
  Simulation simulation(unequal_scenario(HubSupport::axle, IntegrationMethod::generalized_alpha),
                        {Formulation::structured, ExecutorKind::flow_graph, 2, 1});
  int calls = 0;
  CHECK_THROWS_WITH(simulation.trace(10,
                                     [&](double, std::span<const double>) {
                                       if (++calls == 3) throw std::runtime_error("enough");
                                     }),
                    "enough");
  CHECK(calls == 3);
  CHECK(simulation.steps() == 3);
  simulation.step();  // between two steps of all blades here, so it may go on
  CHECK(simulation.steps() == 4);
}

TEST_CASE("the graph of a trace is that of a step, with edges to the next pass") {
  for (const HubSupport support : {HubSupport::axle, HubSupport::free}) {
    Simulation simulation(unequal_scenario(support, IntegrationMethod::generalized_alpha),
                          {Formulation::structured, ExecutorKind::serial, 1, 4});
    const TracedGraph graph = simulation.trace(1).graph;
    const graph::StepGraph& expected = simulation.step_graph();
    REQUIRE(graph.node_count() == expected.node_count());
    CHECK(static_cast<int>(graph.edges.size()) == expected.edge_count());
    for (int i = 0; i < graph.node_count(); ++i)
      CHECK(graph.names[static_cast<std::size_t>(i)] == expected.name_of({i}));
    // Every node that waits for nothing in its pass waits for the pass before.
    std::set<int> waiting;
    for (const NodeEdge& edge : graph.next_pass_edges) waiting.insert(edge.to);
    for (int i = 0; i < expected.node_count(); ++i)
      if (expected.predecessors({i}).empty()) CHECK(waiting.count(i) == 1);
  }
}

TEST_CASE("of several loads on one blade each has a node of its own in a trace") {
  const Scenario scenario = spin_up_scenario(wu_haug_blade(1, 1), 1e-3);
  const auto load = [] { return make_load("none", {{0, 0, 1.0}}, [](auto...) {}); };
  Simulation simulation(scenario, {Formulation::structured, ExecutorKind::serial, 1, 1},
                        {load(), load()});
  const StepTrace trace = simulation.trace(2);
  CHECK(trace.graph.node_count() == simulation.step_graph().node_count());
  const std::set<std::string> names(trace.graph.names.begin(), trace.graph.names.end());
  CHECK(std::ssize(names) == trace.graph.node_count());
  CHECK(names.contains("blade 1 / load 2 / load"));
}
