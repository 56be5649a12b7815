// The executor serial: a loop on the calling thread.

#include <memory>
#include <string_view>

#include "graph/execute/executor_kinds.h"
#include "graph/execute/node_recorder.h"

namespace spoke::graph {
namespace {

class SerialExecutor final : public Executor {
 public:
  explicit SerialExecutor(const StepGraph& graph) : graph_(graph) {}

  void run() override {
    run_nodes(recorder(), 0, -1, graph_.serial_order(),
              [this](NodeId node) { graph_.run_node(node); });
  }
  std::string_view name() const override { return name_of(ExecutorKind::serial); }
  Threads threads() const override { return 1; }

 private:
  const StepGraph& graph_;
};

}  // namespace

std::unique_ptr<Executor> make_serial_executor(const StepGraph& graph) {
  return std::make_unique<SerialExecutor>(graph);
}

}  // namespace spoke::graph
