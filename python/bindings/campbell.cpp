// Binds Campbell diagrams.

#include "engine/campbell.h"

#include <pybind11/numpy.h>
#include <pybind11/stl.h>

#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "program/steady_report/modes_page.h"
#include "python/bindings/bindings.h"
#include "python/bindings/modes.h"
#include "python/bindings/results.h"

namespace spoke::python {
namespace {

namespace py = pybind11;
using namespace py::literals;

/// A diagram, and further data of its page.
struct Campbell {
  Campbell(CampbellResult found, int lines, const Scenario& of)
      : result(std::move(found)), harmonics(lines), scenario(of) {}

  CampbellResult result;
  int harmonics = 0;
  Scenario scenario;
};

std::string describe(const CampbellResult& result) {
  return "<spoke.Campbell " + counted_text(result.states.size(), "speed") + " from " +
         six_digits(result.states.front().equilibrium.speed) + " to " +
         six_digits(result.states.back().equilibrium.speed) + " rad/s, " +
         counted_text(result.branches.size(), "mode") + " followed, " +
         counted_text(result.crossings.size(), "crossing") + ">";
}

std::vector<std::shared_ptr<Modes>> states_of(const Campbell& campbell) {
  std::vector<std::shared_ptr<Modes>> states;
  for (const ModesResult& state : campbell.result.states)
    states.push_back(std::make_shared<Modes>(state, campbell.scenario));
  return states;
}

/// Returns by speed the frequency of a branch; not a number where it was not found.
py::array_t<double> follow(const Campbell& campbell, const CampbellBranch& branch,
                           double Mode::*value) {
  py::array_t<double> numbers(static_cast<py::ssize_t>(branch.modes.size()));
  for (std::size_t k = 0; k < branch.modes.size(); ++k)
    numbers.mutable_data()[k] = branch.modes[k]
                                    ? campbell.result.states[k].modes[*branch.modes[k]].*value
                                    : std::numeric_limits<double>::quiet_NaN();
  return numbers;
}

py::list branches_of(const Campbell& campbell) {
  py::list branches;
  for (const CampbellBranch& branch : campbell.result.branches)
    branches.append(py::dict("name"_a = branch.name, "of"_a = branch.of,
                             "frequencies"_a = follow(campbell, branch, &Mode::frequency),
                             "damping_ratios"_a = follow(campbell, branch, &Mode::damping_ratio)));
  return branches;
}

py::list crossings_of(const Campbell& campbell) {
  py::list crossings;
  for (const CampbellCrossing& crossing : campbell.result.crossings)
    crossings.append(py::dict("branch"_a = crossing.branch, "harmonic"_a = crossing.harmonic,
                              "speed"_a = crossing.speed, "frequency"_a = crossing.frequency,
                              "margin"_a = crossing.margin));
  return crossings;
}

py::list losses_of(const Campbell& campbell) {
  py::list losses;
  for (const CampbellLoss& loss : campbell.result.losses)
    losses.append(py::dict("branch"_a = loss.branch, "last"_a = loss.last, "lost"_a = loss.lost));
  return losses;
}

Campbell solve_diagram(const Scenario& scenario, std::vector<double> speeds,
                       std::optional<int> count, int harmonics, int threads,
                       const std::optional<std::string>& frame) {
  CampbellOptions options{.speeds = std::move(speeds),
                          .count = count,
                          .frame = frame_of(frame),
                          .harmonics = harmonics,
                          .threads = threads,
                          .progress = [](std::size_t) {
                            const py::gil_scoped_acquire lock;
                            if (PyErr_CheckSignals() != 0) throw py::error_already_set();
                          }};
  return {solve_campbell(scenario, options), harmonics, scenario};
}

}  // namespace

void bind_campbell(py::module_& module) {
  py::class_<Campbell>(module, "Campbell", "Frequencies over the speed of rotation.")
      .def_property_readonly(
          "speeds",
          [](const Campbell& campbell) {
            return array_of<double>(campbell.result.states,
                                    [](const ModesResult& r) { return r.equilibrium.speed; });
          },
          "(speeds,) [rad/s]")
      .def_property_readonly("branches", &branches_of,
                             "Modes that were followed: dictionaries with name, of, frequencies "
                             "(speeds,) [rad/s] and damping_ratios (speeds,), not a number where "
                             "the mode was not found.")
      .def_property_readonly("crossings", &crossings_of,
                             "Where a mode has a multiple of the speed as frequency: dictionaries "
                             "with branch, harmonic, speed and frequency [rad/s], and margin, the "
                             "distance from the scenario's speed by the latter, or None.")
      .def_property_readonly("losses", &losses_of,
                             "Branches that end: dictionaries with branch, and the indices of the "
                             "speeds where it was last, and where it was lost.")
      .def_property_readonly("states", &states_of, "By speed its Modes.")
      .def(
          "page",
          [](const Campbell& c) {
            return steady_report::make_html(c.result, c.harmonics, c.scenario,
                                            title_of(c.scenario));
          },
          "campbell.html: one page without network.")
      .def("__repr__", [](const Campbell& campbell) { return describe(campbell.result); });
  module.def("_solve_campbell", &solve_diagram, py::call_guard<py::gil_scoped_release>());
}

}  // namespace spoke::python
