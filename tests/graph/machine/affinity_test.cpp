#include "graph/machine/affinity.h"

#include <doctest/doctest.h>
#include <sched.h>
#include <unistd.h>

#include <atomic>
#include <thread>
#include <vector>

#include "graph/execute/unbound_thread.h"
#include "graph/executor.h"

#ifdef SPOKE_HAS_OPENMP
#include "graph/execute/openmp_runtime.h"
#endif

// These run in processes, too, in which OpenMP binds its threads, and so the initial one.

using namespace spoke::graph;

namespace {

/// Returns the affinity of the process that started this one, and so of this one at its start.
std::vector<int> affinity_at_start() {
  cpu_set_t mask;
  REQUIRE(sched_getaffinity(getppid(), sizeof mask, &mask) == 0);
  std::vector<int> processors;
  for (int processor = 0; processor < CPU_SETSIZE; ++processor)
    if (CPU_ISSET(static_cast<std::size_t>(processor), &mask)) processors.push_back(processor);
  return processors;
}

}  // namespace

TEST_CASE("affinity: a thread's processors are set and read") {
  std::thread([] {
    const std::vector<int> first{affinity_at_start().front()};
    set_thread_affinity(first);
    CHECK(thread_affinity() == first);
    set_thread_affinity({});  // no processor at all: stays
    CHECK(thread_affinity() == first);
    set_widest_thread_affinity();
    CHECK(thread_affinity().size() >= affinity_at_start().size());
  }).join();
}

TEST_CASE("affinity: an unbound thread has the processors that the process was started with") {
  available_threads();  // a runtime that binds when first used has done so
  const std::vector<int> before = thread_affinity();
  {
    const UnboundThread unbound;
    CHECK(thread_affinity() == affinity_at_start());
    const UnboundThread within;
    CHECK(thread_affinity() == affinity_at_start());
  }
  CHECK(thread_affinity() == before);
}

TEST_CASE("affinity: a bound thread does not count as one processor") {
  const int available = available_threads();
  CHECK(available <= static_cast<int>(affinity_at_start().size()));
  const UnboundThread unbound;
  CHECK(available_threads() == available);
  int of_new_thread = 0;
  std::thread([&] { of_new_thread = available_threads(); }).join();
  CHECK(of_new_thread == available);
}

TEST_CASE("affinity: threads of a flow graph may run on all processors") {
  std::atomic<int> arrived{0};
  std::vector<std::vector<int>> processors(2);
  StepGraphBuilder builder;
  for (const int i : {0, 1})
    builder.add_node({"meet", i}, reads(), writes(), [&arrived, &mine = processors[i]]() noexcept {
      mine = thread_affinity();
      ++arrived;
      while (arrived < 2) std::this_thread::yield();  // so that each has a thread of its own
    });
  const StepGraph graph = builder.build();
  const std::vector<int> caller = thread_affinity();
  make_executor(graph, ExecutorKind::flow_graph, 2)->run();
  const bool first_is_caller = processors[0] == caller;
  CHECK((first_is_caller || processors[1] == caller));
  CHECK(processors[first_is_caller ? 1 : 0] == affinity_at_start());
}

#ifdef SPOKE_HAS_OPENMP

TEST_CASE("affinity: OpenMP has the processors of its places") {
  const auto binding = openmp_binding();
  if (!binding) {
    CHECK(processors_for_openmp() == available_threads());
    return;
  }
  CHECK(binding->processors == static_cast<int>(affinity_at_start().size()));
  CHECK_FALSE(binding->places.empty());
  CHECK(processors_for_openmp() <= static_cast<int>(binding->places.size()));
}

#endif
