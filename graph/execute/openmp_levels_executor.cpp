// The executor openmp_levels: rounds of nodes with barriers between them.

#include <omp.h>

#include <memory>
#include <string_view>

#include "graph/execute/executor_kinds.h"
#include "graph/execute/guarded_predicate.h"
#include "graph/execute/node_recorder.h"
#include "graph/machine/floating_point_environment.h"
#include "graph/plan/level_rounds.h"

namespace spoke::graph {
namespace {

class OpenMpLevelsExecutor final : public Executor {
 public:
  OpenMpLevelsExecutor(const StepGraph& graph, int threads)
      : graph_(graph),
        threads_(threads),
        rounds_(derive_level_rounds(graph, threads)),
        ends_alone_(ends_alone(rounds_)) {}

  void run() override {
    omp_set_dynamic(0);  // the number of threads was asked for
    const FloatingPointEnvironment environment;
#pragma omp parallel num_threads(threads_)
    {
      environment.apply();
      run_rounds();
    }
  }

  // Runs all passes in one region.
  void run_while(const std::function<bool()>& more) override {
    omp_set_dynamic(0);
    const FloatingPointEnvironment environment;
    PassQuestion question(more);
    bool again = true;
#pragma omp parallel num_threads(threads_)
    {
      environment.apply();
      do {
        run_rounds();
        if (!ends_alone_) {
#pragma omp barrier
        }
#pragma omp master
        again = question.ask();
#pragma omp barrier
      } while (again);
    }
    question.rethrow();
  }

  std::string_view name() const override { return name_of(ExecutorKind::openmp_levels); }
  Threads threads() const override { return threads_; }

 private:
  // Runs the rounds on each thread of the team. If it has fewer threads than were asked for, each
  // takes the nodes of several.
  void run_rounds() const {
    const auto first = static_cast<std::size_t>(omp_get_thread_num());
    const auto team = static_cast<std::size_t>(omp_get_num_threads());
    bool begins = true;
    for (const Round& round : rounds_) {
      if (!begins) {
#pragma omp barrier
      }
      begins = false;
      for (std::size_t thread = first; thread < round.size(); thread += team)
        run_nodes(recorder(), static_cast<int>(first), -1, round[thread],
                  [this](NodeId node) { graph_.run_node(node); });
    }
  }

  const StepGraph& graph_;
  int threads_;
  std::vector<Round> rounds_;
  bool ends_alone_;  // if so, the question whether to go on needs no barrier before it
};

}  // namespace

std::unique_ptr<Executor> make_openmp_levels_executor(const StepGraph& graph, int threads) {
  return std::make_unique<OpenMpLevelsExecutor>(graph, threads);
}

}  // namespace spoke::graph
