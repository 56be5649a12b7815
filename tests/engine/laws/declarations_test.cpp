// Nodes of every model read and write what they declare.

#include <doctest/doctest.h>

#include "engine/step/step_graph_builder.h"
#include "graph/declaration_check.h"
#include "tests/engine/laws/zoo.h"
#include "tests/engine/step/damaged_graph.h"

using namespace spoke;
using namespace spoke::test;

namespace {

template <class World>
void check_declared(const System<World>& system, Formulation formulation, const Method& method) {
  CAPTURE(name_of(formulation));
  CAPTURE(method.index());
  SystemContext<World> context;
  context.system = system;
  context.formulation = formulation;
  context.integrator = {method, {1e-10, 0, 50}};
  allocate(context);
  const graph::StepGraph graph = build_step_graph(context);
  CHECK(graph::conflicts_are_ordered(graph));
  const bool is_implicit = std::holds_alternative<GeneralizedAlpha>(method);
  for (const int stage : {0, 1, PassControl::kEvaluateOnly}) {
    set_progress({0.1, stage, is_implicit && stage >= 0}, context);
    for (const graph::DeclarationFault& fault : graph::check_declarations(graph))
      FAIL_CHECK(fault.message);
  }
}

}  // namespace

TEST_CASE("nodes of every model read and write what they declare, and conflicts are ordered") {
  for (const ZooModel& model : list_zoo()) {
    CAPTURE(model.name);
    on_system(model.read(1), [](const auto& system, double step) {
      for (const Formulation formulation : quick_formulations(system.deformation_count()))
        check_declared(system, formulation, make_generalized_alpha(0.8, step));
    });
  }
}
