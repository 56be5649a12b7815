// Binds scenarios as the reader makes them.

#include "models/scenario.h"

#include <pybind11/stl.h>

#include "program/run_report/model_page.h"
#include "python/bindings/bindings.h"

namespace spoke::python {
namespace py = pybind11;
using namespace py::literals;

namespace {

std::string draw_model(const Scenario& scenario) {
  return run_report::make_model_page(
      Simulation(scenario, {Formulation::structured, ExecutorKind::serial, 1}));
}

}  // namespace

void bind_scenario(py::module_& module) {
  py::class_<Scenario>(module, "Scenario",
                       "Everything about a simulation that a file says. See read_scenario().")
      .def_static("_read", &read_scenario, "file"_a, "overrides"_a)
      .def_static("_parse", &parse_scenario, "text"_a, "name"_a, "overrides"_a)
      .def_readonly("title", &Scenario::title, "For people.")
      .def_readonly("name", &Scenario::name, "Of the file, without its ending.")
      .def_property_readonly(
          "duration", [](const Scenario& s) { return s.integration.duration; }, "[s]")
      .def_property_readonly(
          "output_interval", [](const Scenario& s) { return s.output.interval; },
          "Between rows of a result [s]; 0: every step.")
      .def_property_readonly(
          "is_spatial", [](const Scenario& s) { return s.space.has_value(); },
          "Whether the model lies in space, not in the plane.")
      .def("to_json", &Scenario::to_json,
           "Every key with the value in force, as JSON of the shape of the file.")
      .def("page", &draw_model,
           "The model as it stands at t = 0, its loops closed, drawn: one HTML page without "
           "network. "
           "Raises InputError if the model cannot be simulated.");
}

}  // namespace spoke::python
