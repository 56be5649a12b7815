#pragma once

// What the module spoke._spoke is made of: a function for each file of bindings.

#include <pybind11/pybind11.h>

namespace spoke::python {

/// Error, InputError, DivergenceError, LoadError, StateError.
void bind_errors(pybind11::module_& module);
/// Curve and the kinds of drives.
void bind_drives(pybind11::module_& module);
/// Marker, Wrench, and loads that are Python functions.
void bind_loads(pybind11::module_& module);
/// Scenario.
void bind_scenario(pybind11::module_& module);
/// Simulation, SavedState, and what a simulation is asked for.
void bind_simulation(pybind11::module_& module);
/// Recording: what a run leaves behind.
void bind_recording(pybind11::module_& module);
/// Trace: which thread ran which node when.
void bind_trace(pybind11::module_& module);
/// Equilibria, modes and Campbell diagrams.
void bind_steady(pybind11::module_& module);

}  // namespace spoke::python
