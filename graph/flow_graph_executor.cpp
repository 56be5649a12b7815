#include <oneapi/tbb/flow_graph.h>
#include <oneapi/tbb/global_control.h>
#include <oneapi/tbb/info.h>
#include <oneapi/tbb/task_arena.h>

#include <algorithm>
#include <deque>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string_view>
#include <utility>

#include "graph/executor_kinds.h"
#include "graph/node_recorder.h"
#include "graph/thread_sanitizer.h"
#include "graph/thread_trial.h"

namespace spoke::graph {
namespace {

namespace flow = oneapi::tbb::flow;
using oneapi::tbb::global_control;

// How many threads oneTBB lets work at once: as many as there are processors, or what the program
// allows by a global_control of its own. It counts the processors once. If OpenMP had bound the
// thread that asked first, it has counted too few; then a control tells it (of several the smallest
// counts, and this one is the same for all executors).
int allowed_threads(std::optional<global_control>& control) {
  constexpr auto limit = global_control::max_allowed_parallelism;
  const auto processors = static_cast<std::size_t>(available_threads());
  if (global_control::active_value(limit) < processors) control.emplace(limit, processors);
  return static_cast<int>(global_control::active_value(limit));
}

/// An arena of oneTBB, which goes to the next executor when this one ends. oneTBB (2021.8) frees an
/// arena only when a worker has come by and found it empty, so that executors made one right after
/// the other would leave ever more behind.
class Arena {
 public:
  Arena() = default;
  Arena(const Arena&) = delete;
  Arena& operator=(const Arena&) = delete;
  ~Arena() {
    if (!arena_) return;
    const std::lock_guard lock(idle_arenas().mutex);
    idle_arenas().by_threads.emplace(threads_, std::move(arena_));
  }

  void initialize(int threads) {
    threads_ = threads;
    const std::lock_guard lock(idle_arenas().mutex);
    if (auto idle = idle_arenas().by_threads.extract(threads)) {
      arena_ = std::move(idle.mapped());
      return;
    }
    arena_ = std::make_unique<oneapi::tbb::task_arena>(threads);
    arena_->initialize();
  }
  template <class Function>
  void execute(const Function& function) {
    arena_->execute(function);
  }

 private:
  struct IdleArenas {
    std::mutex mutex;
    std::multimap<int, std::unique_ptr<oneapi::tbb::task_arena>> by_threads;
  };
  /// Never destroyed: oneTBB may be gone before static objects are.
  static IdleArenas& idle_arenas() {
    static IdleArenas& arenas = *new IdleArenas;
    return arenas;
  }

  int threads_ = 0;
  std::unique_ptr<oneapi::tbb::task_arena> arena_;
};

class FlowGraphExecutor final : public Executor {
 public:
  FlowGraphExecutor(const StepGraph& graph, Plan plan, int threads)
      : graph_(graph), plan_(std::move(plan)), threads_(threads) {
    const int width = level_width(plan_);
    if (width <= 1) return;  // no threads for what one thread does
    // Threads beyond those that find work would only wake and search for it.
    working_ = std::min({threads, width, allowed_threads(thread_limit_)});
    // oneTBB ends the program if the system refuses it a thread: that shows here.
    if (working_ > available_threads()) try_threads(working_);
    arena_.initialize(working_);
    // A flow graph belongs to the arena it is made in.
    arena_.execute([this] { make_flow(); });
  }
  ~FlowGraphExecutor() override {
    if (!flow_) return;
    arena_.execute([this] {
      nodes_.clear();
      flow_.reset();
    });
  }

  void run() override {
    if (!flow_) {
      for (int c = 0; c < plan_.cluster_count(); ++c) run_cluster(c, 0);
      return;
    }
    tell_start(graph_);
    arena_.execute([this] {
      for (FlowNode* root : roots_) root->try_put(flow::continue_msg());
      flow_->wait_for_all();
    });
    tell_end(graph_);
  }
  std::string_view name() const override { return name_of(ExecutorKind::flow_graph); }
  Threads threads() const override { return threads_; }
  Threads recorded_threads() const override { return working_; }

 private:
  using FlowNode = flow::continue_node<flow::continue_msg>;

  void run_cluster(int cluster, int thread) const noexcept {
    run_nodes(recorder(), thread, cluster, plan_.nodes(cluster),
              [this](NodeId node) { run_told(graph_, node); });
  }

  // The calling thread is the only one that enters the arena, and gets its reserved place, 0.
  int this_thread() const {
    return recorder() == nullptr ? 0 : oneapi::tbb::this_task_arena::current_thread_index();
  }

  void make_flow() {
    flow_.emplace(context_);
    for (int c = 0; c < plan_.cluster_count(); ++c) {
      const auto body = [this, c](flow::continue_msg) noexcept { run_cluster(c, this_thread()); };
      nodes_.emplace_back(*flow_, body);
      if (plan_.predecessors(c).empty()) roots_.push_back(&nodes_.back());
    }
    for (int c = 0; c < plan_.cluster_count(); ++c) {
      for (const int next : plan_.successors(c)) {
        flow::make_edge(nodes_[static_cast<std::size_t>(c)],
                        nodes_[static_cast<std::size_t>(next)]);
      }
    }
  }

  const StepGraph& graph_;
  const Plan plan_;
  int threads_;
  int working_ = 1;  // of them
  std::optional<global_control> thread_limit_;
  Arena arena_;
  // With the floating-point environment of the thread that makes the executor: that of the arena is
  // an earlier one's.
  oneapi::tbb::task_group_context context_{oneapi::tbb::task_group_context::isolated,
                                           oneapi::tbb::task_group_context::default_traits |
                                               oneapi::tbb::task_group_context::fp_settings};
  std::optional<flow::graph> flow_;
  std::deque<FlowNode> nodes_;  // nodes neither move nor copy with their edges
  std::vector<FlowNode*> roots_;
};

}  // namespace

std::unique_ptr<Executor> make_flow_graph_executor(const StepGraph& graph, Plan plan, int threads) {
  return std::make_unique<FlowGraphExecutor>(graph, std::move(plan), threads);
}

}  // namespace spoke::graph
