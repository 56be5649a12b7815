// The executors openmp_scheme1 and openmp_scheme2: the paper's two schemes of nested teams.

#include <omp.h>

#include <algorithm>
#include <deque>
#include <memory>
#include <string_view>
#include <vector>

#include "graph/execute/executor_kinds.h"
#include "graph/execute/fork_join.h"
#include "graph/execute/guarded_predicate.h"
#include "graph/execute/node_recorder.h"
#include "graph/machine/floating_point_environment.h"
#include "graph/plan/nested_loops.h"
#include "graph/plan/static_share.h"

// The two schemes of parallel threads in two layers, subsystems and the bodies within them, of Han,
// Song and Kim (2017), section 4: teams that last as long as the integration, and teams that begin
// and end with every loop. The runtime may give fewer threads than are asked for; the work is
// shared out among those.

namespace spoke::graph {
namespace {

void ask_for_nested_teams() {
  constexpr int layers = 2;
  omp_set_dynamic(0);  // the numbers of threads were asked for
  const int levels = omp_get_active_level() + layers;
  if (omp_get_max_active_levels() < levels) omp_set_max_active_levels(levels);
}

/// Returns as many threads as there are processors for, first of all one for each team.
Threads threads_with_processors(const Threads& asked, int processors) {
  if (asked.total() <= processors) return asked;
  const int teams = std::min(asked.outer, processors);
  return {teams, std::min(asked.inner, processors / teams)};
}

/// The work common to both schemes; each shares out its loops in its own way.
class NestedExecutor : public Executor {
 public:
  /// `working`: those of `threads` that get work.
  NestedExecutor(const StepGraph& graph, Threads threads, Threads working)
      : graph_(graph), threads_(threads), working_(working), loops_(derive_nested_loops(graph)) {}

  Threads threads() const final { return threads_; }
  Threads recorded_threads() const final { return working_; }

 protected:
  /// One of the threads that share a loop.
  struct Member {
    int index;
    int count;
  };

  /// Runs a chain on thread `thread` of team `team`.
  void run_chain(const NodeChain& chain, int team, int thread) const {
    run_nodes(recorder(), team * working_.inner + thread, -1, chain,
              [this](NodeId node) { graph_.run_node(node); });
  }

  /// Runs one thread's share of a loop over bodies, in team `team`.
  void run_share(const BodyLoop& loop, int team, Member thread) const {
    const StaticShare share = static_share(loop.bodies.size(), thread.index, thread.count);
    for (std::size_t k = share.begin; k < share.end; ++k)
      run_chain(loop.bodies[k], team, thread.index);
  }

  /// Runs one team's share of a loop over subsystems; `run_bodies` shares out a loop over bodies.
  template <class RunBodies>
  void run_share(const SubsystemLoop& loop, Member team, RunBodies run_bodies) const {
    const StaticShare share = static_share(loop.subsystems.size(), team.index, team.count);
    for (std::size_t k = share.begin; k < share.end; ++k) {
      for (const BodyLoop& body_loop : loop.subsystems[k]) {
        run_chain(body_loop.alone, team.index, 0);
        run_bodies(body_loop);
      }
    }
  }

  const StepGraph& graph_;
  const Threads threads_;
  const Threads working_;
  const std::vector<SubsystemLoop> loops_;
};

/// Both layers of threads are there from the first pass to the last. The first thread of each team
/// hands work to the others through a ForkJoin: OpenMP's own barriers bind to the innermost team.
/// There are no threads without a processor, since they would delay those that wait for them.
class OpenMpScheme1Executor final : public NestedExecutor {
 public:
  OpenMpScheme1Executor(const StepGraph& graph, Threads threads, int processors)
      : NestedExecutor(graph, threads, threads_with_processors(threads, processors)) {}

  void run() override {
    run_while([] { return false; });
  }

  void run_while(const std::function<bool()>& more) override {
    ask_for_nested_teams();
    const FloatingPointEnvironment environment;
    PassQuestion question(more);
    Subsystems subsystems;
    std::deque<Bodies> teams(static_cast<std::size_t>(working_.outer));
#pragma omp parallel num_threads(working_.outer)
    {
      const Member team{omp_get_thread_num(), omp_get_num_threads()};
      Bodies& bodies = teams[static_cast<std::size_t>(team.index)];
#pragma omp parallel num_threads(working_.inner)
      {
        environment.apply();
        const Member thread{omp_get_thread_num(), omp_get_num_threads()};
        if (thread.index == 0)
          lead(team, thread.count, subsystems, bodies, question);
        else
          bodies.serve([&](const BodyLoop& loop) { run_share(loop, team.index, thread); });
      }
    }
    question.rethrow();
  }

  std::string_view name() const override { return name_of(ExecutorKind::openmp_scheme1); }

 private:
  using Subsystems = ForkJoin<SubsystemLoop>;
  using Bodies = ForkJoin<BodyLoop>;

  // Runs the work of the first thread of each team, from the first pass to the last.
  void lead(Member team, int threads, Subsystems& subsystems, Bodies& bodies,
            PassQuestion& question) const {
    bodies.set_workers(threads - 1);
    if (team.index == 0) {
      subsystems.set_workers(team.count - 1);
      do run_pass(team, threads, subsystems, bodies);
      while (question.ask());
      subsystems.fork(nullptr);
    } else {
      subsystems.serve(
          [&](const SubsystemLoop& loop) { run_subsystems(loop, team, threads, bodies); });
    }
    bodies.fork(nullptr);
  }

  void run_pass(Member team, int threads, Subsystems& subsystems, Bodies& bodies) const {
    for (const SubsystemLoop& loop : loops_) {
      run_chain(loop.alone, 0, 0);
      if (loop.subsystems.empty()) continue;
      subsystems.fork(&loop);
      run_subsystems(loop, team, threads, bodies);
      subsystems.join();
    }
  }

  void run_subsystems(const SubsystemLoop& loop, Member team, int threads, Bodies& bodies) const {
    run_share(loop, team, [&](const BodyLoop& body_loop) {
      if (body_loop.bodies.size() < 2) return run_share(body_loop, team.index, {0, 1});
      bodies.fork(&body_loop);
      run_share(body_loop, team.index, {0, threads});
      bodies.join();
    });
  }
};

/// A loop over subsystems is a parallel region, and each loop over bodies one within it.
class OpenMpScheme2Executor final : public NestedExecutor {
 public:
  OpenMpScheme2Executor(const StepGraph& graph, Threads threads)
      : NestedExecutor(graph, threads, threads) {}

  void run() override {
    ask_for_nested_teams();
    const FloatingPointEnvironment environment;
    for (const SubsystemLoop& loop : loops_) {
      run_chain(loop.alone, 0, 0);
      if (!loop.subsystems.empty()) run_subsystems(loop, environment);
    }
  }
  std::string_view name() const override { return name_of(ExecutorKind::openmp_scheme2); }

 private:
  void run_subsystems(const SubsystemLoop& loop,
                      const FloatingPointEnvironment& environment) const {
#pragma omp parallel num_threads(threads_.outer)
    {
      environment.apply();
      const Member team{omp_get_thread_num(), omp_get_num_threads()};
      run_share(loop, team,
                [&](const BodyLoop& body_loop) { run_bodies(body_loop, team.index, environment); });
    }
  }

  void run_bodies(const BodyLoop& loop, int team,
                  const FloatingPointEnvironment& environment) const {
    if (threads_.inner == 1 || loop.bodies.size() < 2) return run_share(loop, team, {0, 1});
#pragma omp parallel num_threads(threads_.inner)
    {
      environment.apply();
      run_share(loop, team, {omp_get_thread_num(), omp_get_num_threads()});
    }
  }
};

}  // namespace

std::unique_ptr<Executor> make_openmp_scheme1_executor(const StepGraph& graph, Threads threads,
                                                       int processors) {
  return std::make_unique<OpenMpScheme1Executor>(graph, threads, processors);
}

std::unique_ptr<Executor> make_openmp_scheme2_executor(const StepGraph& graph, Threads threads) {
  return std::make_unique<OpenMpScheme2Executor>(graph, threads);
}

}  // namespace spoke::graph
