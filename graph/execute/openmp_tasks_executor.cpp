// The executor openmp_tasks: every node is an OpenMP task, ordered by depend clauses on the edges.

#include <omp.h>

#include <algorithm>
#include <cstddef>
#include <memory>
#include <span>
#include <string_view>
#include <vector>

#include "graph/execute/executor_kinds.h"
#include "graph/execute/guarded_predicate.h"
#include "graph/execute/node_recorder.h"
#include "graph/execute/thread_sanitizer.h"
#include "graph/machine/floating_point_environment.h"

// What a programmer would write today who has the graph and OpenMP 5. One region lasts for all
// passes of run_while(): one thread makes the tasks of a pass, and all meet at a barrier, where
// OpenMP has them run tasks until all are done. A region for each pass would begin and end a team
// each time, and several threads cannot make the tasks: OpenMP orders those of one parent only.
// The runtime allocates its tasks and finds their predecessors anew in every pass.
//
// The maker is not the calling thread but the second one, if there is one. In LLVM's runtime a
// thread gives the memory of tasks that it has run back to their maker, some at a time, and some of
// it in later regions. By then a calling thread may have ended, and LLVM's (14) ends the program,
// whatever the tasks; threads of the runtime's own last as long as it does.

namespace spoke::graph {
namespace {

class OpenMpTasksExecutor final : public Executor {
 public:
  OpenMpTasksExecutor(const StepGraph& graph, int threads)
      : graph_(graph), threads_(threads), tokens_(static_cast<std::size_t>(graph.node_count())) {}

  void run() override {
    run_while([] { return false; });
  }

  void run_while(const std::function<bool()>& more) override {
    omp_set_dynamic(0);  // the number of threads was asked for
    const FloatingPointEnvironment environment;
    PassQuestion question(more);
    bool again = true;
    tell_start(graph_);
#pragma omp parallel num_threads(threads_)
    {
      environment.apply();
      const int maker = std::min(1, omp_get_num_threads() - 1);
      do {
        if (omp_get_thread_num() == maker) make_tasks();
#pragma omp barrier
#pragma omp master
        again = ask(question);
#pragma omp barrier
      } while (again);
    }
    question.rethrow();
  }

  std::string_view name() const override { return name_of(ExecutorKind::openmp_tasks); }
  Threads threads() const override { return threads_; }

 private:
  // In the order in which the step was written down: a task waits for those made before it, and
  // runtimes that hold few tasks at a time then hold some of all subsystems.
  void make_tasks() {
    for (int i = 0; i < graph_.node_count(); ++i) make_task({i});
  }

  // A function of its own gives back at its end what the clauses take of the stack for their list.
  void make_task(NodeId node) {
    const std::span<const NodeId> before = graph_.predecessors(node);
    const int count = static_cast<int>(before.size());
    std::byte* const tokens = tokens_.data();
    [[maybe_unused]] std::byte& own = tokens[node.index];
#pragma omp task depend(out : own) depend(iterator(k = 0 : count), in : tokens[before[k].index])
    run_nodes(recorder(), omp_get_thread_num(), -1, {&node, 1},
              [this](NodeId id) { run_told(graph_, id); });
  }

  bool ask(PassQuestion& question) const {
    tell_end(graph_);
    const bool again = question.ask();
    tell_start(graph_);
    return again;
  }

  const StepGraph& graph_;
  int threads_;
  std::vector<std::byte> tokens_;  // name the nodes in depend clauses: only addresses count
};

}  // namespace

std::unique_ptr<Executor> make_openmp_tasks_executor(const StepGraph& graph, int threads) {
  return std::make_unique<OpenMpTasksExecutor>(graph, threads);
}

}  // namespace spoke::graph
