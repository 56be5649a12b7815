#pragma once

// Whether the step graph of a system declares what its nodes read and write.

#include <doctest/doctest.h>

#include "engine/bodies/act/user_load/user_loads.h"
#include "engine/step/step_graph_builder.h"
#include "graph/declaration_check.h"
#include "tests/engine/step/damaged_graph.h"

namespace spoke::test {

/// Checks the declarations in two iterations or stages and in an evaluation, and the order of nodes
/// that conflict.
inline void check_step_declarations(const System<Space>& system, Formulation formulation,
                                    const Method& method, const Loads& loads = {}) {
  SystemContext<Space> context;
  context.system = system;
  context.formulation = formulation;
  context.integrator = {method, {1e-10, 0, 50}};
  allocate(context);
  place_loads(ask_loads(loads), context.system, context.data);
  const graph::StepGraph graph = build_step_graph(context, 1);
  CHECK(graph::conflicts_are_ordered(graph));
  const bool is_implicit = method.index() == 0;
  for (const int stage : {0, 1, PassControl::kEvaluateOnly}) {
    set_progress({0.1, stage, is_implicit && stage >= 0}, context);
    for (const graph::DeclarationFault& fault : graph::check_declarations(graph))
      FAIL_CHECK(fault.message);
  }
}

}  // namespace spoke::test
