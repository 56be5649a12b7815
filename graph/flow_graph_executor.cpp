#include <oneapi/tbb/flow_graph.h>
#include <oneapi/tbb/global_control.h>
#include <oneapi/tbb/info.h>
#include <oneapi/tbb/task_arena.h>

#include <algorithm>
#include <deque>
#include <memory>
#include <optional>
#include <string_view>

#include "graph/executor_kinds.h"
#include "graph/thread_sanitizer.h"

namespace spoke::graph {
namespace {

namespace flow = oneapi::tbb::flow;
using oneapi::tbb::global_control;

// oneTBB makes no more threads than there are processors unless a global_control asks for them,
// and of several controls the smallest counts. So all executors that need one ask for the same
// generous limit: how many threads there are is decided by the arenas, which ask for what they use.
void raise_thread_limit(int threads, std::optional<global_control>& control) {
  constexpr std::size_t limit = 256;
  const auto wanted = static_cast<std::size_t>(threads);
  if (threads <= oneapi::tbb::info::default_concurrency()) return;
  control.emplace(global_control::max_allowed_parallelism, std::max(limit, wanted));
}

class FlowGraphExecutor final : public Executor {
 public:
  FlowGraphExecutor(const StepGraph& graph, int threads) : graph_(graph), threads_(threads) {
    raise_thread_limit(threads, thread_limit_);
    arena_.initialize(threads);
    // A flow graph belongs to the arena it is made in.
    arena_.execute([&] { make_flow(graph); });
  }
  ~FlowGraphExecutor() override {
    arena_.execute([this] {
      nodes_.clear();
      flow_.reset();
    });
  }

  void run() override {
    tell_start(graph_);
    arena_.execute([this] {
      for (FlowNode* root : roots_) root->try_put(flow::continue_msg());
      flow_->wait_for_all();
    });
    tell_end(graph_);
  }
  std::string_view name() const override { return name_of(ExecutorKind::flow_graph); }
  Threads threads() const override { return threads_; }

 private:
  using FlowNode = flow::continue_node<flow::continue_msg>;

  void make_flow(const StepGraph& graph) {
    flow_.emplace();
    for (int i = 0; i < graph.node_count(); ++i) {
      const auto body = [&graph, i](flow::continue_msg) noexcept { run_told(graph, {i}); };
      nodes_.emplace_back(*flow_, body);
      if (graph.predecessors({i}).empty()) roots_.push_back(&nodes_.back());
    }
    for (int i = 0; i < graph.node_count(); ++i) {
      for (const NodeId successor : graph.successors({i})) {
        flow::make_edge(nodes_[static_cast<std::size_t>(i)],
                        nodes_[static_cast<std::size_t>(successor.index)]);
      }
    }
  }

  const StepGraph& graph_;
  int threads_;
  std::optional<global_control> thread_limit_;
  oneapi::tbb::task_arena arena_;
  std::optional<flow::graph> flow_;
  std::deque<FlowNode> nodes_;  // nodes neither move nor copy with their edges
  std::vector<FlowNode*> roots_;
};

}  // namespace

std::unique_ptr<Executor> make_flow_graph_executor(const StepGraph& graph, int threads) {
  return std::make_unique<FlowGraphExecutor>(graph, threads);
}

}  // namespace spoke::graph
