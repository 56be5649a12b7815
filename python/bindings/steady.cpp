// Equilibria, modes and Campbell diagrams: values, with arrays made when asked for.

#include <pybind11/complex.h>
#include <pybind11/eigen.h>
#include <pybind11/numpy.h>
#include <pybind11/stl.h>

#include <cmath>
#include <complex>
#include <limits>
#include <string>
#include <vector>

#include "engine/campbell.h"
#include "engine/equilibrium.h"
#include "engine/modes.h"
#include "engine/steady_report/modes_page.h"
#include "engine/steady_report/static_files.h"
#include "python/bindings/bindings.h"

namespace spoke::python {
namespace {

namespace py = pybind11;
using namespace py::literals;
using Complex = std::complex<double>;

/// A diagram, and what its page needs besides.
struct Campbell {
  CampbellResult result;
  int harmonics = 0;
  Scenario scenario;
};

std::string title_of(const Scenario& scenario) {
  return scenario.title.empty() ? scenario.name : scenario.title;
}

/// An equilibrium, and what its page needs besides.
struct Equilibrium {
  EquilibriumResult result;
  Scenario scenario;
};

template <class Number>
py::array_t<Number> rows_of(const std::vector<Eigen::Matrix<Number, 3, 1>>& vectors) {
  py::array_t<Number> rows({static_cast<py::ssize_t>(vectors.size()), py::ssize_t{3}});
  Number* to = rows.mutable_data();
  for (const auto& vector : vectors)
    for (int c = 0; c < 3; ++c) *to++ = vector[c];
  return rows;
}

/// What a function says of each item, as an array.
template <class Number, class Item, class Function>
py::array_t<Number> array_of(const std::vector<Item>& items, Function&& function) {
  py::array_t<Number> numbers(static_cast<py::ssize_t>(items.size()));
  Number* to = numbers.mutable_data();
  for (const Item& item : items) *to++ = function(item);
  return numbers;
}

py::array_t<double> frequencies_of(const ModesResult& result) {
  return array_of<double>(result.modes, [](const Mode& mode) { return mode.frequency; });
}

void bind_equilibrium(py::module_& module) {
  py::class_<JointPosition>(module, "JointPosition", "A coordinate of a joint in equilibrium.")
      .def_readonly("name", &JointPosition::name)
      .def_readonly("value", &JointPosition::value, "[rad], or [m] if it slides")
      .def_readonly("turns", &JointPosition::turns, "Whether it is an angle.");
  py::class_<SectionLoad>(module, "SectionLoad",
                          "What the outer part of a blade exerts on the inner one where a body "
                          "begins, in axes of the section there: as the sensor section_force.")
      .def_readonly("body", &SectionLoad::body, "That begins there.")
      .def_readonly("station", &SectionLoad::station, "Undeformed distance from the root [m].")
      .def_readonly("force", &SectionLoad::force, "(3,) [N]")
      .def_readonly("moment", &SectionLoad::moment, "(3,) [N m]");
  py::class_<BladeEquilibrium>(module, "BladeEquilibrium",
                               "A blade, or another subsystem, in equilibrium; hub frame.")
      .def_readonly("name", &BladeEquilibrium::name)
      .def_readonly("tip_displacement", &BladeEquilibrium::tip_displacement, "(3,) [m]")
      .def_readonly("tip_rotation", &BladeEquilibrium::tip_rotation, "(3,) rotation vector [rad]")
      .def_readonly("joints", &BladeEquilibrium::joints, "That are free.")
      .def_readonly("loads", &BladeEquilibrium::loads, "From the root on.")
      .def_readonly("bending", &BladeEquilibrium::bending,
                    "By body: its largest deflection across its axis by its length.")
      .def_property_readonly(
          "nodes", [](const BladeEquilibrium& blade) { return rows_of(blade.nodes); },
          "(nodes, 3): places from root to tip, body after body: the last node of a body is "
          "the first of the next [m]")
      .def_property_readonly(
          "undeformed", [](const BladeEquilibrium& blade) { return rows_of(blade.undeformed); },
          "(nodes, 3): of the same nodes [m]");
  const auto get = [](auto EquilibriumResult::*member) {
    return [member](const Equilibrium& equilibrium) { return equilibrium.result.*member; };
  };
  py::class_<Equilibrium>(module, "Equilibrium", "A model in steady rotation, or at rest.")
      .def_property_readonly("speed", get(&EquilibriumResult::speed), "Of the hub [rad/s].")
      .def_property_readonly("blades", get(&EquilibriumResult::blades), "Then other subsystems.")
      .def_property_readonly("hub_force", get(&EquilibriumResult::hub_force),
                             "(3,) of support and drive on the hub, hub frame [N]")
      .def_property_readonly("hub_moment", get(&EquilibriumResult::hub_moment),
                             "(3,) likewise, about the hub's origin [N m]")
      .def_property_readonly("iterations", get(&EquilibriumResult::iterations),
                             "Of Newton's method, over all blades.")
      .def_property_readonly("load_steps", get(&EquilibriumResult::load_steps),
                             "In which loads were applied.")
      .def_property_readonly(
          "warnings",
          [](const Equilibrium& e) {
            std::vector<std::string> texts;
            for (const Warning& warning : e.result.warnings) texts.push_back(warning.text);
            return texts;
          },
          "What makes it doubtful, as of a run.")
      .def(
          "page",
          [](const Equilibrium& e) {
            return steady_report::make_html(e.result, e.scenario, title_of(e.scenario));
          },
          "static.html: one page without network.");
  module.def(
      "_solve_equilibrium",
      [](const Scenario& scenario, std::optional<double> speed) {
        return Equilibrium{solve_equilibrium(scenario, {speed}), scenario};
      },
      py::call_guard<py::gil_scoped_release>());
}

py::list shape_of(const Mode& mode) {
  py::list shape;
  for (const auto& blade : mode.shape) shape.append(rows_of(blade));
  return shape;
}

void bind_modes(py::module_& module) {
  py::class_<Mode>(module, "Mode",
                   "A vibration: motion Re(shape exp(eigenvalue t)) about the equilibrium, in the "
                   "frame that turns with the hub.")
      .def_readonly("name", &Mode::name, "By what moves most: \"flap 1\".")
      .def_readonly("kind", &Mode::kind, "\"flap\", \"lag\", \"axial\", \"torsion\", ...")
      .def_readonly("of", &Mode::of, "Whose: \"blade 1\", \"blades 1 to 3\", \"all\".")
      .def_readonly("eigenvalue", &Mode::eigenvalue, "Complex [rad/s].")
      .def_readonly("frequency", &Mode::frequency, "Of the motion [rad/s].")
      .def_readonly("damping_ratio", &Mode::damping_ratio, "Negative: it grows.")
      .def_property_readonly("grows", &Mode::grows)
      .def_property_readonly("shape", &shape_of,
                             "By blade, then other subsystems: (nodes, 3) complex displacements in "
                             "the hub's frame, the largest of all being 1; (0, 3) of a blade that "
                             "is not in it.")
      .def("__repr__", [](const Mode& mode) {
        return py::str("<spoke.Mode {!r} of {}, {:.6g} rad/s>")
            .format(mode.name, mode.of, mode.frequency);
      });
  py::class_<ModesResult>(module, "Modes", "Vibration modes of a model about its steady motion.")
      .def_property_readonly(
          "modes", [](const ModesResult& result) { return result.modes; },
          "By ascending magnitude of the eigenvalue; where blades do not couple, blade by blade.")
      .def_property_readonly("frequencies", &frequencies_of, "(modes,) [rad/s]")
      .def_property_readonly(
          "damping_ratios",
          [](const ModesResult& result) {
            return array_of<double>(result.modes, [](const Mode& m) { return m.damping_ratio; });
          },
          "(modes,)")
      .def_property_readonly(
          "eigenvalues",
          [](const ModesResult& result) {
            return array_of<Complex>(result.modes, [](const Mode& m) { return m.eigenvalue; });
          },
          "(modes,) complex [rad/s]")
      .def_readonly("are_blades_coupled", &ModesResult::are_blades_coupled)
      .def_property_readonly(
          "speed", [](const ModesResult& result) { return result.equilibrium.speed; },
          "Of the hub [rad/s].")
      .def("__len__", [](const ModesResult& result) { return result.modes.size(); })
      .def("__getitem__", [](const ModesResult& result, std::ptrdiff_t k) {
        const auto n = static_cast<std::ptrdiff_t>(result.modes.size());
        if (k < -n || k >= n) throw py::index_error();
        return result.modes[static_cast<std::size_t>(k < 0 ? k + n : k)];
      });
  module.def(
      "_solve_modes",
      [](const Scenario& scenario, std::optional<double> speed, std::optional<int> count) {
        return solve_modes(scenario, {{speed}, count});
      },
      py::call_guard<py::gil_scoped_release>());
}

/// By speed the frequency of a branch; not a number where it was not found.
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

Campbell solve_diagram(const Scenario& scenario, std::vector<double> speeds,
                       std::optional<int> count, int harmonics, int threads) {
  CampbellOptions options{.speeds = std::move(speeds),
                          .count = count,
                          .harmonics = harmonics,
                          .threads = threads,
                          .progress = [](std::size_t) {
                            const py::gil_scoped_acquire lock;
                            if (PyErr_CheckSignals() != 0) throw py::error_already_set();
                          }};
  return {solve_campbell(scenario, options), harmonics, scenario};
}

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
      .def_property_readonly(
          "states", [](const Campbell& campbell) { return campbell.result.states; },
          "By speed its Modes.")
      .def(
          "page",
          [](const Campbell& c) {
            return steady_report::make_html(c.result, c.harmonics, c.scenario,
                                            title_of(c.scenario));
          },
          "campbell.html: one page without network.");
  module.def("_solve_campbell", &solve_diagram, py::call_guard<py::gil_scoped_release>());
}

}  // namespace

void bind_steady(py::module_& module) {
  bind_equilibrium(module);
  bind_modes(module);
  bind_campbell(module);
}

}  // namespace spoke::python
