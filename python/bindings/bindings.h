#pragma once

// The parts of the module spoke._spoke: a function for each file of bindings.

#include <pybind11/pybind11.h>

namespace spoke::python {

/// Binds Error, InputError, DivergenceError, LoadError, StateError.
void bind_errors(pybind11::module_& module);
/// Binds Curve and the kinds of drives.
void bind_drives(pybind11::module_& module);
/// Binds Marker, Wrench, and loads that are Python functions.
void bind_loads(pybind11::module_& module);
/// Binds what controllers that are Python objects are given.
void bind_controllers(pybind11::module_& module);
/// Binds Scenario.
void bind_scenario(pybind11::module_& module);
/// Binds Courses.
void bind_courses(pybind11::module_& module);
/// Binds Simulation, SavedState, and queries of a simulation.
void bind_simulation(pybind11::module_& module);
/// Binds Recording, the results of a run.
void bind_recording(pybind11::module_& module);
/// Binds Trace: which thread ran which node when.
void bind_trace(pybind11::module_& module);
/// Binds solids reduced to modes.
void bind_reduce(pybind11::module_& module);
/// Binds equilibria.
void bind_equilibrium(pybind11::module_& module);
/// Binds modes.
void bind_modes(pybind11::module_& module);
/// Binds Campbell diagrams.
void bind_campbell(pybind11::module_& module);
/// Binds searches for critical values.
void bind_critical(pybind11::module_& module);
/// Binds the performance of rotors in wind.
void bind_performance(pybind11::module_& module);

}  // namespace spoke::python
