#include <doctest/doctest.h>

#include <cfenv>
#include <cstdlib>
#include <memory>
#include <random>
#include <stdexcept>
#include <string>
#include <thread>

#include "graph/execute/executor_kinds.h"
#include "spoke/error.h"
#include "tests/graph/arithmetic_graph.h"
#include "tests/graph/recorded_graph.h"

using namespace spoke::graph;
using spoke::graph::testing::build_graph;
using spoke::graph::testing::GraphPlan;
using spoke::graph::testing::make_random_plan;
using spoke::graph::testing::make_step_plan;
using spoke::graph::testing::RecordedGraph;

namespace {

constexpr int kPasses = 4;

struct Configuration {
  ExecutorKind kind;
  Threads threads;
};

std::vector<Configuration> configurations() {
  std::vector<Configuration> list;
  for (const ExecutorKind kind : {ExecutorKind::openmp_scheme1, ExecutorKind::openmp_scheme2,
                                  ExecutorKind::openmp_levels, ExecutorKind::openmp_tasks}) {
    for (const int threads : {1, 2, 3, 6, 12}) list.push_back({kind, threads});
    if (!has_nested_teams(kind)) continue;
    for (const int outer : {1, 2, 3})
      for (const int inner : {2, 4}) list.push_back({kind, {outer, inner}});
  }
  return list;
}

// Makes labels that have nothing to do with the edges.
GraphPlan make_random_labels(std::uint32_t seed) {
  GraphPlan plan = make_random_plan(seed, 60, 25, 4);
  std::mt19937 random(seed);
  std::uniform_int_distribution<int> any_subsystem(-1, 3);
  std::uniform_int_distribution<int> any_body(-1, 2);
  for (auto& node : plan.nodes) {
    node.label.subsystem = any_subsystem(random);
    node.label.body = any_body(random);
  }
  return plan;
}

// Returns plans without labels, with random ones, and steps with and without a hub.
std::vector<GraphPlan> plans() {
  return {make_random_plan(3, 60, 25, 4), make_random_labels(1), make_random_labels(2),
          make_step_plan({3, 4, 2, true}), make_step_plan({5, 3, 2, false})};
}

// Makes an executor with as many working threads as are asked for, however few processors there
// are.
std::unique_ptr<Executor> make(const StepGraph& graph, const Configuration& configuration) {
  const auto& [kind, threads] = configuration;
  return kind == ExecutorKind::openmp_scheme1
             ? make_openmp_scheme1_executor(graph, threads, kMostThreads)
             : make_executor(graph, kind, threads);
}

void run_passes(Executor& executor, int passes) {
  executor.run_while([left = passes]() mutable { return --left > 0; });
}

std::vector<std::vector<double>> results(GraphPlan plan, const Configuration& configuration) {
  const StepGraph graph = build_graph(plan);
  const auto executor = make(graph, configuration);
  executor->run();
  run_passes(*executor, kPasses);
  return plan.memory;
}

void capture_and(const Configuration& configuration, const auto& check) {
  CAPTURE(name_of(configuration.kind));
  CAPTURE(name_of(configuration.threads));
  check();
}

}  // namespace

TEST_CASE("openmp: every node runs once per pass, after its predecessors") {
  for (const GraphPlan& plan : plans()) {
    for (const Configuration& configuration : configurations()) {
      capture_and(configuration, [&] {
        RecordedGraph recorded(plan);
        const auto executor = make(recorded.graph(), configuration);
        executor->run();
        int faults = recorded.count_nodes_not_run(1) + recorded.count_edges_out_of_order();
        int passes = 0;
        executor->run_while([&] {
          ++passes;
          faults += recorded.count_nodes_not_run(1 + passes) + recorded.count_edges_out_of_order();
          return passes < kPasses;
        });
        CHECK(faults == 0);
        CHECK(recorded.count_nodes_not_run(1 + kPasses) == 0);
      });
    }
  }
}

// The values are finite, so that equal vectors are equal bits but for the sign of zero.
TEST_CASE("openmp: results equal the serial ones, whatever the number of threads") {
  for (const GraphPlan& plan : plans()) {
    const auto serial = results(plan, {ExecutorKind::serial, 1});
    for (const Configuration& configuration : configurations())
      capture_and(configuration, [&] { CHECK(results(plan, configuration) == serial); });
  }
}

TEST_CASE("openmp: whether to go on is asked on the calling thread, whose exception arrives") {
  GraphPlan plan = make_step_plan({3, 4, 1, true});
  const StepGraph graph = build_graph(plan);
  for (const Configuration& configuration : configurations()) {
    capture_and(configuration, [&] {
      const auto executor = make(graph, configuration);
      bool elsewhere = false;
      int asked = 0;
      const auto more = [&, caller = std::this_thread::get_id()] {
        elsewhere |= std::this_thread::get_id() != caller;
        if (++asked == 3) throw std::runtime_error("enough");
        return true;
      };
      CHECK_THROWS_WITH_AS(executor->run_while(more), "enough", std::runtime_error);
      CHECK(asked == 3);
      CHECK_FALSE(elsewhere);
      run_passes(*executor, 2);  // and the executor still runs
    });
  }
}

TEST_CASE("openmp: all threads round as the calling one does") {
  for (const Configuration& configuration : configurations()) {
    capture_and(configuration, [&] {
      StepGraphBuilder builder;
      std::vector<int> modes(12, -1);
      for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 4; ++j)
          builder.add_node({"round", i, j}, reads(), writes(),
                           [&mode = modes[static_cast<std::size_t>(4 * i + j)]]() noexcept {
                             mode = std::fegetround();
                           });
      const StepGraph graph = builder.build();
      const auto executor = make(graph, configuration);
      for (const int mode : {FE_TONEAREST, FE_UPWARD, FE_TONEAREST}) {
        std::fesetround(mode);
        executor->run();
        CHECK(modes == std::vector<int>(12, mode));
        run_passes(*executor, 1);
        CHECK(modes == std::vector<int>(12, mode));
      }
    });
  }
}

TEST_CASE("openmp: executors run at once in two threads of the program") {
  const GraphPlan plan = make_step_plan({3, 4, 3, true});
  const auto serial = results(plan, {ExecutorKind::serial, 1});
  for (const Configuration& configuration : configurations()) {
    if (configuration.threads.total() > 4) continue;
    capture_and(configuration, [&] {
      std::vector<std::vector<double>> first;
      std::vector<std::vector<double>> second;
      std::thread one([&] { first = results(plan, configuration); });
      std::thread two([&] { second = results(plan, configuration); });
      one.join();
      two.join();
      CHECK(first == serial);
      CHECK(second == serial);
    });
  }
}

// The runtime's own threads go on, with memory of its tasks; LLVM's has its difficulties there.
TEST_CASE("openmp: threads of the program that ran an executor may end") {
  const GraphPlan plan = make_step_plan({3, 4, 3, true});
  const auto serial = results(plan, {ExecutorKind::serial, 1});
  for (const Configuration& configuration : configurations()) {
    if (configuration.threads != Threads(3)) continue;
    capture_and(configuration, [&] {
      int faults = 0;
      for (int repetition = 0; repetition < 100; ++repetition)
        std::thread([&] { faults += results(plan, configuration) != serial ? 1 : 0; }).join();
      CHECK(faults == 0);
    });
  }
}

TEST_CASE("openmp: an empty graph runs") {
  const StepGraph graph = StepGraphBuilder().build();
  for (const Configuration& configuration : configurations()) {
    capture_and(configuration, [&] {
      const auto executor = make(graph, configuration);
      executor->run();
      run_passes(*executor, 2);
      CHECK(executor->threads() == configuration.threads);
      CHECK(executor->name() == name_of(configuration.kind));
    });
  }
}

TEST_CASE("openmp: of scheme 1 as many threads work as there are processors, first one a team") {
  GraphPlan plan = make_step_plan({3, 4, 1, true});
  const StepGraph graph = build_graph(plan);
  const auto working = [&](const Threads& asked, int processors) {
    const auto executor = make_openmp_scheme1_executor(graph, asked, processors);
    CHECK(executor->threads() == asked);
    return executor->recorded_threads();
  };
  CHECK(working({3, 4}, 12) == Threads{3, 4});
  CHECK(working({3, 4}, 11) == Threads{3, 3});
  CHECK(working({3, 4}, 5) == Threads{3, 1});
  CHECK(working({3, 4}, 2) == Threads{2, 1});
  CHECK(working({1, 4}, 2) == Threads{1, 2});
  CHECK(working({12, 1}, 1) == Threads{1, 1});
  CHECK(make_openmp_scheme1_executor(graph, {3, 4}, 2)->describe() ==
        "openmp_scheme1 on 3x4 threads, 2 at work");
}

namespace {

/// Makes `chains` chains of nodes that count their runs, and a last node that waits for all of
/// them.
StepGraph make_chains(int chains, int length, std::vector<int>& counts) {
  StepGraphBuilder builder;
  std::vector<PartId> parts;
  for (int c = 0; c < chains; ++c)
    parts.push_back(builder.add_part("chain " + std::to_string(c),
                                     {bytes_of(counts[static_cast<std::size_t>(c)])}));
  for (int i = 0; i < length; ++i)
    for (int c = 0; c < chains; ++c)
      builder.add_node({"count", c, i}, reads(), writes(parts[static_cast<std::size_t>(c)]),
                       [&count = counts[static_cast<std::size_t>(c)]]() noexcept { ++count; });
  const PartId sum = builder.add_part("sum", {bytes_of(counts.back())});
  builder.add_node({"sum"}, reads(parts), writes(sum), [&counts, chains]() noexcept {
    for (int c = 0; c < chains; ++c) counts.back() += counts[static_cast<std::size_t>(c)];
  });
  return builder.build();
}

}  // namespace

// Lists of predecessors lie on the stack of the thread that makes the tasks, one after the other:
// if they stayed there, these would be 300 MB. Runtimes throttle makers of too many tasks.
TEST_CASE("openmp: as many nodes as there are, and as many predecessors, are tasks") {
  constexpr int chains = 1000, length = 20;
  std::vector<int> counts(chains + 1);
  const StepGraph graph = make_chains(chains, length, counts);
  for (const int threads : {1, 2, 3}) {
    CAPTURE(threads);
    std::fill(counts.begin(), counts.end(), 0);
    const auto executor = make_executor(graph, ExecutorKind::openmp_tasks, threads);
    run_passes(*executor, 2);
    CHECK(counts.front() == 2 * length);
    CHECK(counts.back() == chains * length + 2 * chains * length);
  }
}

TEST_CASE("openmp: threads are those available unless given, and levels and tasks have one layer") {
  const StepGraph graph = StepGraphBuilder().build();
  CHECK(make_executor(graph, ExecutorKind::openmp_scheme1, {0, 3})->threads() ==
        Threads(available_threads(), 3));
  CHECK(make_executor(graph, ExecutorKind::openmp_levels)->threads() ==
        Threads(available_threads()));
  CHECK_THROWS_AS(make_executor(graph, ExecutorKind::openmp_levels, {3, 2}), spoke::InputError);
  CHECK(make_executor(graph, ExecutorKind::openmp_tasks, 3)->describe() ==
        "openmp_tasks on 3 threads");
  CHECK_THROWS_AS(make_executor(graph, ExecutorKind::openmp_tasks, {3, 2}), spoke::InputError);
  CHECK_THROWS_AS(make_executor(graph, ExecutorKind::openmp_scheme2, {3, 0}), spoke::InputError);
}

namespace {

/// Sets a value of OMP_NUM_THREADS while it lives. The runtime has read its own long before, or
/// will.
class NumThreads {
 public:
  explicit NumThreads(const std::string& value) : before_(std::getenv("OMP_NUM_THREADS")) {
    if (before_) saved_ = before_;
    setenv("OMP_NUM_THREADS", value.c_str(), 1);
  }
  ~NumThreads() {
    if (before_)
      setenv("OMP_NUM_THREADS", saved_.c_str(), 1);
    else
      unsetenv("OMP_NUM_THREADS");
  }
  NumThreads(const NumThreads&) = delete;
  NumThreads& operator=(const NumThreads&) = delete;

 private:
  const char* before_;
  std::string saved_;
};

}  // namespace

TEST_CASE("openmp executors are refused where the runtime would not survive OMP_NUM_THREADS") {
  GraphPlan plan = make_random_plan(3, 10, 25, 4);
  const StepGraph step = build_graph(plan);
  const auto make = [&] { make_executor(step, ExecutorKind::openmp_levels, {1, 1}); };
  for (const char* value : {"junk", "", "0", "-1", "2,junk", "2,", "4x", "99999999"}) {
    const NumThreads set(value);
    CAPTURE(value);
    CHECK_THROWS_AS(make(), spoke::InputError);
    CHECK_THROWS_AS(check_thread_limit(ExecutorKind::openmp_levels, {1, 1}), spoke::InputError);
    CHECK_NOTHROW(check_thread_limit(ExecutorKind::flow_graph, {1, 1}));
  }
  for (const char* value : {"1", "4,2", " 4 , 2 ", "1024"}) {
    const NumThreads set(value);
    CAPTURE(value);
    CHECK_NOTHROW(make());
  }
}
