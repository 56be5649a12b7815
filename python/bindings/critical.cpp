// Binds searches for critical speeds and loads.

#include "engine/critical.h"

#include <pybind11/numpy.h>
#include <pybind11/stl.h>

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "program/steady_report/critical_files.h"
#include "program/steady_report/modes_page.h"
#include "python/bindings/bindings.h"
#include "python/bindings/modes.h"
#include "python/bindings/results.h"

namespace spoke::python {
namespace {

namespace py = pybind11;
using namespace py::literals;

/// A search for a critical value, and further data of its page.
struct Critical {
  CriticalResult result;
  CriticalOptions options;
  Scenario scenario;
};

std::vector<std::shared_ptr<Modes>> critical_states(const Critical& critical) {
  std::vector<std::shared_ptr<Modes>> states;
  for (const ModesResult& state : critical.result.states)
    states.push_back(std::make_shared<Modes>(state, critical.scenario));
  return states;
}

/// Returns the critical mode, if there is one.
std::optional<OneMode> critical_mode(const Critical& critical) {
  const std::optional<CriticalPoint>& point = critical.result.critical;
  if (!point || !point->mode) return std::nullopt;
  return OneMode{std::make_shared<Modes>(critical.result.states[point->state], critical.scenario),
                 *point->mode};
}

/// Returns a property of the critical point; None where there is none.
template <class Get>
auto of_point(Get get) {
  return [get](const Critical& critical) -> py::object {
    if (!critical.result.critical) return py::none();
    return py::cast(get(critical, *critical.result.critical));
  };
}

Critical search_critical(const Scenario& scenario, std::string of, double from, double to,
                         std::optional<double> speed, std::map<std::string, double> speeds,
                         int points, std::optional<int> count,
                         const std::optional<std::string>& frame) {
  CriticalOptions options{.of = std::move(of),
                          .from = from,
                          .to = to,
                          .state = {speed, std::move(speeds)},
                          .points = points,
                          .count = count,
                          .frame = frame_of(frame),
                          .progress = [](std::size_t) {
                            const py::gil_scoped_acquire lock;
                            if (PyErr_CheckSignals() != 0) throw py::error_already_set();
                          }};
  CriticalResult result = solve_critical(scenario, options);
  options.progress = {};
  return {std::move(result), std::move(options), scenario};
}

}  // namespace

void bind_critical(py::module_& module) {
  py::class_<Critical>(module, "Critical",
                       "A search for the least speed or load at which an equilibrium is lost or a "
                       "mode stops decaying.")
      .def_property_readonly(
          "value", of_point([](const Critical&, const CriticalPoint& p) { return p.value; }),
          "The critical speed [rad/s] or factor; None if the whole range is stable.")
      .def_property_readonly(
          "kind", of_point([](const Critical&, const CriticalPoint& p) { return name_of(p.kind); }),
          "\"buckling\", \"divergence\", \"flutter\", \"critical speed\", \"limit point\", "
          "\"no equilibrium\", \"jump\"; or None.")
      .def_property_readonly("frequency", of_point([](const Critical&, const CriticalPoint& p) {
                               return p.frequency;
                             }),
                             "Of the critical mode [rad/s]; or None.")
      .def_property_readonly(
          "name", of_point([](const Critical&, const CriticalPoint& p) { return p.name; }),
          "Of the critical mode: \"lag 1\"; or None.")
      .def_property_readonly("of",
                             of_point([](const Critical&, const CriticalPoint& p) { return p.of; }),
                             "Whose the critical mode is: \"blade 1\"; or None.")
      .def_property_readonly("mode", &critical_mode,
                             "The critical Mode a millionth beyond; or None.")
      .def_property_readonly(
          "values",
          [](const Critical& critical) {
            return array_of<double>(critical.result.values, [](double value) { return value; });
          },
          "(values,): those of the search, and the critical one.")
      .def_property_readonly("states", &critical_states, "By value its Modes.")
      .def(
          "page",
          [](const Critical& c) {
            return steady_report::make_html(c.result, c.options, c.scenario, title_of(c.scenario));
          },
          "critical.html: one page without network.")
      .def("__repr__", [](const Critical& c) {
        return "<spoke.Critical " + steady_report::describe_critical(c.result, c.options) + '>';
      });
  module.def("_solve_critical", &search_critical, py::call_guard<py::gil_scoped_release>());
}

}  // namespace spoke::python
