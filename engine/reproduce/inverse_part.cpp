#include "engine/reproduce/inverse_part.h"

#include "engine/integrator/time_stepper.h"
#include "engine/step_graph_builder.h"

namespace spoke::reproduce {
namespace {

/// The nodes of one stage, with the parts they declare.
graph::StepGraph extract(const graph::StepGraph& whole, std::string_view stage) {
  graph::StepGraphBuilder builder(whole.subsystem_word());
  for (const graph::Part& part : whole.parts()) builder.add_part(part.name, part.memory);
  for (int k = 0; k < whole.node_count(); ++k) {
    const graph::NodeId id{k};
    const graph::Node& node = whole.node(id);
    if (node.label.stage == stage)
      builder.add_node(node.label, graph::reads(node.reads), graph::writes(node.writes),
                       [&whole, id]() noexcept { whole.run_node(id); });
  }
  return builder.build();
}

std::unique_ptr<StepContext> make_context(const Scenario& scenario, Formulation formulation) {
  auto context = std::make_unique<StepContext>();
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
        part(extract(whole, "inverse")),
        executor(graph::make_executor(part, options.executor, options.threads)) {
    TimeStepper(*context, whole).start();
    // After the evaluation at t = 0 the clocks wait for a window, and the nodes with them.
    for (Clock& clock : context->data.clocks) clock.halted = 0.0;
  }

  std::unique_ptr<StepContext> context;
  graph::StepGraph whole;
  graph::StepGraph part;
  std::unique_ptr<graph::Executor> executor;
};

InversePart::InversePart(const Scenario& scenario, const SimulationOptions& options)
    : impl_(std::make_unique<Impl>(scenario, options)) {}
InversePart::~InversePart() = default;

void InversePart::run(std::int64_t steps) {
  std::int64_t left = steps * Rk4::kStages;
  impl_->executor->run_while([&left] { return --left > 0; });
}

int InversePart::nodes() const { return impl_->part.node_count(); }

}  // namespace spoke::reproduce
