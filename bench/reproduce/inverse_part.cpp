// Takes the nodes "inverse" out of a step's graph, and runs and times them.

#include "bench/reproduce/inverse_part.h"

#include <cassert>
#include <cstdint>
#include <limits>
#include <string_view>
#include <vector>

#include "engine/step/run/time_stepper.h"
#include "engine/step/stages.h"
#include "engine/step/step_graph_builder.h"
#include "graph/calibrate/node_costs.h"

namespace spoke::reproduce {
namespace {

/// Returns a graph of the nodes of one stage, with the parts that they declare.
graph::StepGraph extract(const graph::StepGraph& whole, std::string_view stage) {
  graph::StepGraphBuilder builder(whole.names());
  for (const graph::Part& part : whole.parts())
    builder.add_part(part.name, part.memory, part.record_size);
  for (int k = 0; k < whole.node_count(); ++k) {
    const graph::NodeId id{k};
    const graph::Node& node = whole.node(id);
    if (node.label.stage == stage)
      builder.add_node(node.label, graph::reads(node.reads), graph::writes(node.writes),
                       [&whole, id]() noexcept { whole.run_node(id); });
  }
  assert(builder.node_count() > 0);
  return builder.build();
}

/// Lets all nodes run without end; after the evaluation at t = 0 they wait for a window.
void resume_all(SystemContext<Plane>& context) {
  context.data.window.last = std::numeric_limits<std::int32_t>::max();
  for (StepProgress& progress : context.data.progress) progress.is_halted = false;
}

std::unique_ptr<SystemContext<Plane>> make_context(const Scenario& scenario,
                                                   Formulation formulation) {
  auto context = std::make_unique<SystemContext<Plane>>();
  context->system = make_system(scenario.rotor);
  context->formulation = formulation;
  context->integrator = {Rk4{scenario.integration.step}, {}};
  allocate(*context);
  return context;
}

}  // namespace

struct InversePart::Impl {
  Impl(const Scenario& scenario, const SimulationOptions& options)
      : context(make_context(scenario, options.formulation)),
        whole(build_step_graph(*context)),
        part(extract(whole, stages::kInverse.name)),
        executor(graph::make_executor(part, options.executor, options.threads)) {
    TimeStepper(*context, whole).start();
    resume_all(*context);
  }

  std::unique_ptr<SystemContext<Plane>> context;
  graph::StepGraph whole;
  graph::StepGraph part;
  std::unique_ptr<graph::Executor> executor;
};

InversePart::InversePart(const Scenario& scenario, const SimulationOptions& options)
    : impl_(std::make_unique<Impl>(scenario, options)) {
  assert(options.formulation != Formulation::augmented);
}
InversePart::~InversePart() = default;

void InversePart::run(std::int64_t steps) {
  std::int64_t left = steps * Rk4::kStages;
  impl_->executor->run_while([&left] { return --left > 0; });
}

int InversePart::nodes() const { return impl_->part.node_count(); }

double measure_inverse_share(const Scenario& scenario, Formulation formulation) {
  constexpr int kWarmUpPasses = 40, kPasses = 800;
  const auto context = make_context(scenario, formulation);
  const graph::StepGraph whole = build_step_graph(*context);
  TimeStepper(*context, whole).start();
  resume_all(*context);
  for (int pass = 0; pass < kWarmUpPasses; ++pass)
    for (const graph::NodeId node : whole.serial_order()) whole.run_node(node);
  graph::NodeCosts costs(whole);
  while (costs.runs() < kPasses) costs.run();
  const std::vector<double> seconds = costs.costs();
  double inverse = 0.0, all = 0.0;
  for (int k = 0; k < whole.node_count(); ++k) {
    const double cost = seconds[static_cast<std::size_t>(k)];
    all += cost;
    if (whole.node({k}).label.stage == stages::kInverse.name) inverse += cost;
  }
  return inverse / all;
}

}  // namespace spoke::reproduce
