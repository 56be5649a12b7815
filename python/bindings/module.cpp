// Makes the module spoke._spoke, on which the package spoke is built.

#include "python/bindings/bindings.h"

PYBIND11_MODULE(_spoke, module) {
  module.doc() = "The compiled part of the package spoke.";
  module.attr("__version__") = SPOKE_VERSION;
  spoke::python::bind_errors(module);
  spoke::python::bind_drives(module);
  spoke::python::bind_loads(module);
  spoke::python::bind_controllers(module);
  spoke::python::bind_scenario(module);
  spoke::python::bind_simulation(module);
  spoke::python::bind_courses(module);
  spoke::python::bind_recording(module);
  spoke::python::bind_trace(module);
  spoke::python::bind_reduce(module);
  spoke::python::bind_equilibrium(module);
  spoke::python::bind_modes(module);
  spoke::python::bind_campbell(module);
  spoke::python::bind_critical(module);
  spoke::python::bind_performance(module);
}
