#pragma once

// Binds queries of a simulation between steps.

#include <pybind11/pybind11.h>

#include <memory>

#include "python/bindings/used_simulation.h"

namespace spoke::python {

/// Binds HubMotion, BodyState, BladeShape.
void bind_query_results(pybind11::module_& module);
/// Binds sensors, hub, bodies, shapes, markers, reactions and section forces.
void bind_queries(pybind11::class_<UsedSimulation, std::shared_ptr<UsedSimulation>>& simulation);

}  // namespace spoke::python
