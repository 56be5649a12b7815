// The executor on oneTBB, in the only file that includes it: flow graphs in an arena of their own.

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
#include <vector>

#include "graph/compressed_rows.h"
#include "graph/execute/executor_kinds.h"
#include "graph/execute/node_recorder.h"
#include "graph/execute/thread_sanitizer.h"
#include "graph/machine/thread_trial.h"
#include "graph/plan/flow_graph_partition.h"

namespace spoke::graph {
namespace {

namespace flow = oneapi::tbb::flow;
using oneapi::tbb::global_control;

// Returns how many threads oneTBB lets work at once: as many as there are processors, or as the
// program allows by a global_control of its own. It counts the processors once. If OpenMP had bound
// the thread that asked first, it has counted too few; then a control tells it (the smallest of
// several counts, and this one is the same for all executors).
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

/// A flow graph. Every thread that starts or ends one of its tasks writes its count of them, which
/// therefore has cache lines of its own.
struct alignas(128) CountedFlow {  // 128: processors fetch cache lines in pairs
  explicit CountedFlow(oneapi::tbb::task_group_context& context) : graph(context) {}
  flow::graph graph;
};

class FlowGraphExecutor final : public Executor {
 public:
  FlowGraphExecutor(const StepGraph& graph, Plan plan, int threads, std::vector<int> partition)
      : graph_(graph), plan_(std::move(plan)), threads_(threads) {
    const int width = level_width(plan_);
    if (width <= 1) return;  // no threads where one thread does all
    // Threads beyond those that find work would only wake and search for it.
    working_ = std::min({threads, width, allowed_threads(thread_limit_)});
    // oneTBB ends the program if the system refuses it a thread: so that is tried before.
    if (working_ > available_threads()) try_threads(working_);
    arena_.initialize(working_);
    if (partition.empty()) partition = partition_clusters(plan_, working_);
    // A flow graph belongs to the arena it is made in.
    arena_.execute([&] { make_flow(partition); });
  }
  ~FlowGraphExecutor() override {
    if (flows_.empty()) return;
    arena_.execute([this] {
      // The task of the last cluster may have a few instructions to go after the end of a run.
      for (CountedFlow& flow : flows_) {
        flow.graph.release_wait();
        flow.graph.wait_for_all();
      }
      nodes_.clear();
      flows_.clear();
      unfinished_.reset();
    });
  }

  void run() override {
    if (flows_.empty()) {
      for (int c = 0; c < plan_.cluster_count(); ++c) run_cluster(c, 0);
      return;
    }
    tell_start(graph_);
    arena_.execute([this] {
      for (int k = 0; k < final_clusters_; ++k) unfinished_->graph.reserve_wait();
      for (auto root = roots_.rbegin(); root != roots_.rend(); ++root)
        (*root)->try_put(flow::continue_msg());
      unfinished_->graph.wait_for_all();
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

  // Returns the thread's number. The calling thread is the only one that enters the arena, and gets
  // its reserved place, 0.
  int this_thread() const {
    return recorder() == nullptr ? 0 : oneapi::tbb::this_task_arena::current_thread_index();
  }

  // Makes the flow nodes and their edges. oneTBB's edges stay within a flow graph: predecessors
  // themselves notify a cluster of another one. Threads of oneTBB go on with the cluster that
  // became ready last, so successors are notified from the last to the first, so that a thread
  // comes through the clusters, and through the memory of their flow nodes, in depth-first order.
  void make_flow(const std::vector<int>& partition) {
    const auto are_apart = [&](int a, int b) {
      return partition[static_cast<std::size_t>(a)] != partition[static_cast<std::size_t>(b)];
    };
    make_flows(1 + *std::max_element(partition.begin(), partition.end()));
    for (int c = 0; c < plan_.cluster_count(); ++c) {
      const auto is_apart = [&](int other) { return are_apart(c, other); };
      const auto before = plan_.predecessors(c);
      const auto flow = static_cast<std::size_t>(partition[static_cast<std::size_t>(c)]);
      const auto notifiers = std::count_if(before.begin(), before.end(), is_apart);
      nodes_.emplace_back(flows_[flow].graph, static_cast<int>(notifiers),
                          [this, c](flow::continue_msg) noexcept { run_and_notify(c); });
      if (before.empty()) roots_.push_back(&nodes_.back());
    }
    for (int c = 0; c < plan_.cluster_count(); ++c) {
      const auto after = plan_.successors(c);
      for (auto next = after.rbegin(); next != after.rend(); ++next) {
        if (are_apart(c, *next)) {
          notified_.push_back(&node_of(*next));
        } else {
          flow::make_edge(node_of(c), node_of(*next));
        }
      }
      notified_.end_row();
      if (plan_.successors(c).empty()) ++final_clusters_;
    }
  }

  // Makes flow graphs that always have something to wait for: otherwise a graph looks for threads
  // to wake whenever none of its tasks is under way.
  void make_flows(int count) {
    for (int k = 0; k < count; ++k) flows_.emplace_back(context_).graph.reserve_wait();
    unfinished_.emplace(run_context_);
  }

  FlowNode& node_of(int cluster) { return nodes_[static_cast<std::size_t>(cluster)]; }

  void run_and_notify(int cluster) noexcept {
    run_cluster(cluster, this_thread());
    for (FlowNode* next : notified_.row(static_cast<std::size_t>(cluster)))
      next->try_put(flow::continue_msg());
    if (plan_.successors(cluster).empty()) unfinished_->graph.release_wait();
  }

  const StepGraph& graph_;
  const Plan plan_;
  int threads_;
  int working_ = 1;  // of them
  std::optional<global_control> thread_limit_;
  Arena arena_;
  // A context with the floating-point environment of the thread that makes the executor: that of
  // the arena is an earlier one's.
  oneapi::tbb::task_group_context context_{oneapi::tbb::task_group_context::isolated,
                                           oneapi::tbb::task_group_context::default_traits |
                                               oneapi::tbb::task_group_context::fp_settings};
  oneapi::tbb::task_group_context run_context_{oneapi::tbb::task_group_context::isolated};
  std::deque<CountedFlow> flows_;  // one flow per part of the partition; none: no threads
  // a flow without nodes that counts final clusters yet to end.
  std::optional<CountedFlow> unfinished_;
  int final_clusters_ = 0;  // number of clusters without successors
  // In a deque, since they neither move nor copy with their edges.
  std::deque<FlowNode> nodes_;
  CompressedRows<FlowNode*> notified_;  // successors of each cluster in other flow graphs
  std::vector<FlowNode*> roots_;
};

}  // namespace

std::unique_ptr<Executor> make_flow_graph_executor(const StepGraph& graph, Plan plan, int threads,
                                                   std::vector<int> partition) {
  return std::make_unique<FlowGraphExecutor>(graph, std::move(plan), threads, std::move(partition));
}

}  // namespace spoke::graph
