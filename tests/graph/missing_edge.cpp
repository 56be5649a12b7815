// Two nodes write one number, and the second does not say so: there is no edge between them. A
// build with the thread sanitizer has to report that, otherwise its silence about other graphs
// means nothing. The argument names an executor that the sanitizer does not see into.

#include <atomic>
#include <thread>

#include "graph/executor.h"

using namespace spoke::graph;

int main(int, char** arguments) {
  double shared = 0.0;
  std::atomic<int> arrived{0};
  // Both have begun, each on its own thread, before one goes on; this orders nothing.
  const auto meet = [&arrived]() noexcept {
    arrived.fetch_add(1, std::memory_order_relaxed);
    while (arrived.load(std::memory_order_relaxed) < 2) std::this_thread::yield();
  };
  StepGraphBuilder builder;
  const PartId part = builder.add_part("shared", {bytes_of(shared)});
  builder.add_node({"first"}, reads(), writes(part), [&]() noexcept {
    meet();
    shared = 1.0;
  });
  builder.add_node({"second"}, reads(), writes(), [&]() noexcept {
    meet();
    shared = 2.0;
  });
  const StepGraph graph = builder.build();
  make_executor(graph, executor_kind(arguments[1]), 2)->run();
}
