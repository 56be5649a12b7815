// The executor openmp_tasks: every node is an OpenMP task, ordered by depend clauses on the edges.

#include <omp.h>
#include <unistd.h>

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

// A programmer who has the graph and OpenMP 5 would write this today. One region lasts for all
// passes of run_while(): one thread makes the tasks of a pass, and waits until all are done,
// running tasks itself; the others run tasks at the barrier that ends the region. A region for each
// pass would begin and end a team each time, and several threads cannot make the tasks: OpenMP
// orders those of one parent only. The runtime allocates its tasks and finds their predecessors
// anew in every pass.
//
// The maker is the calling thread, if that lasts as long as the process. In LLVM's runtime a thread
// gives the memory of tasks that it has run back to their maker, some at a time, and some of it in
// later regions. By then another calling thread may have ended, and LLVM's (14) ends the program,
// whatever the tasks; threads of the runtime's own last. So for these the second thread of the team
// makes the tasks, and all meet at barriers, which takes longer where threads share processors.

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
    const bool caller_lasts = getpid() == gettid();  // the main thread
#pragma omp parallel num_threads(threads_)
    {
      environment.apply();
      if (caller_lasts || omp_get_num_threads() == 1)
        run_as_maker(question);
      else
        run_between_barriers(question, again);
    }
    question.rethrow();
  }

  std::string_view name() const override { return name_of(ExecutorKind::openmp_tasks); }
  Threads threads() const override { return threads_; }

 private:
  // Makes and awaits all passes on the calling thread; the others return to run tasks.
  void run_as_maker(PassQuestion& question) {
    if (omp_get_thread_num() != 0) return;
    do {
      make_tasks();
#pragma omp taskwait
    } while (ask(question));
  }

  // Makes the tasks on the second thread. The team shares `again`.
  void run_between_barriers(PassQuestion& question, bool& again) {
    do {
      if (omp_get_thread_num() == 1) make_tasks();
#pragma omp barrier
#pragma omp master
      again = ask(question);
#pragma omp barrier
    } while (again);
  }

  // Makes the tasks in the order of insertion: a task waits for those made before it, and runtimes
  // that hold few tasks at a time then hold some of all subsystems.
  void make_tasks() {
    for (int i = 0; i < graph_.node_count(); ++i) make_task({i});
  }

  // Makes one task. A function of its own frees, when it returns, the stack that the clauses take
  // for their list.
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
  std::vector<std::byte> tokens_;  // one per node, for depend clauses: only addresses count
};

}  // namespace

std::unique_ptr<Executor> make_openmp_tasks_executor(const StepGraph& graph, int threads) {
  return std::make_unique<OpenMpTasksExecutor>(graph, threads);
}

}  // namespace spoke::graph
