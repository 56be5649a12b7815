// Binds equilibria, modes, Campbell diagrams and critical values: values, with arrays made when
// asked for.

#include <pybind11/complex.h>
#include <pybind11/eigen.h>
#include <pybind11/numpy.h>
#include <pybind11/stl.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <limits>
#include <memory>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "engine/campbell.h"
#include "engine/critical.h"
#include "engine/equilibrium.h"
#include "engine/modes.h"
#include "models/count_text.h"
#include "models/error.h"
#include "program/steady_report/critical_files.h"
#include "program/steady_report/mode_files.h"
#include "program/steady_report/modes_page.h"
#include "program/steady_report/static_files.h"
#include "python/bindings/bindings.h"

namespace spoke::python {
namespace {

namespace py = pybind11;
using namespace py::literals;
using Complex = std::complex<double>;

/// Modes, and further data of their page.
struct Modes {
  Modes(ModesResult found, const Scenario& of) : result(std::move(found)), scenario(of) {}

  ModesResult result;
  Scenario scenario;
};

/// One of the modes; the common equilibrium is part of its picture.
struct OneMode {
  std::shared_ptr<const Modes> modes;
  std::size_t index = 0;

  const Mode& mode() const { return modes->result.modes[index]; }
};

/// A diagram, and further data of its page.
struct Campbell {
  Campbell(CampbellResult found, int lines, const Scenario& of)
      : result(std::move(found)), harmonics(lines), scenario(of) {}

  CampbellResult result;
  int harmonics = 0;
  Scenario scenario;
};

/// A search for a critical value, and further data of its page.
struct Critical {
  CriticalResult result;
  CriticalOptions options;
  Scenario scenario;
};

std::string title_of(const Scenario& scenario) {
  return scenario.title.empty() ? scenario.name : scenario.title;
}

/// An equilibrium, and further data of its page.
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

/// Returns the values of a function for each item as an array.
template <class Number, class Item, class Function>
py::array_t<Number> array_of(const std::vector<Item>& items, Function&& function) {
  py::array_t<Number> numbers(static_cast<py::ssize_t>(items.size()));
  Number* to = numbers.mutable_data();
  for (const Item& item : items) *to++ = function(item);
  return numbers;
}

/// Returns "3 blades", "1 mode".
std::string counted_text(std::size_t count, const char* what) {
  return counted(static_cast<std::int64_t>(count), what);
}

std::string six_digits(double value) { return py::str("{:.6g}").format(value); }

std::string vector_text(const Eigen::Vector3d& v) {
  return py::str("[{:.6g}, {:.6g}, {:.6g}]").format(v.x(), v.y(), v.z());
}

std::string describe(const EquilibriumResult& result) {
  std::string text = "<spoke.Equilibrium at " + six_digits(result.speed) + " rad/s, " +
                     counted_text(result.blades.size(), "subsystem");
  const auto largest =
      std::max_element(result.blades.begin(), result.blades.end(),
                       [](const BladeEquilibrium& a, const BladeEquilibrium& b) {
                         return a.tip_displacement.norm() < b.tip_displacement.norm();
                       });
  if (largest != result.blades.end())
    text += ", largest tip displacement " + six_digits(largest->tip_displacement.norm()) + " m (" +
            largest->name + ")";
  return text + ">";
}

std::string describe(const Mode& mode) {
  std::string text = mode.name + " of " + mode.of + ", " + six_digits(mode.frequency) + " rad/s";
  if (const double damping = steady_report::damping_of(mode); damping != 0.0)
    text += ", damping ratio " + six_digits(damping);
  return mode.grows() ? text + ", grows" : text;
}

std::string describe(const ModesResult& result) {
  constexpr std::size_t most = 4;
  std::string text = "<spoke.Modes " + counted_text(result.modes.size(), "mode") + " at " +
                     six_digits(result.equilibrium.speed) + " rad/s";
  for (std::size_t k = 0; k < std::min(most, result.modes.size()); ++k)
    text += (k == 0 ? ": " : "; ") + describe(result.modes[k]);
  return text + (result.modes.size() > most ? "; ...>" : ">");
}

std::string describe(const CampbellResult& result) {
  return "<spoke.Campbell " + counted_text(result.states.size(), "speed") + " from " +
         six_digits(result.states.front().equilibrium.speed) + " to " +
         six_digits(result.states.back().equilibrium.speed) + " rad/s, " +
         counted_text(result.branches.size(), "mode") + " followed, " +
         counted_text(result.crossings.size(), "crossing") + ">";
}

/// Returns the page of all modes or of some.
std::string make_modes_page(const ModesResult& result, const Scenario& scenario) {
  if (result.equilibrium.blades.empty())
    throw StateError("no page: there are no blades, or no equilibrium was found at this speed");
  return steady_report::make_html(result, scenario, title_of(scenario));
}

std::string make_modes_page(const OneMode& one) {
  const ModesResult& all = one.modes->result;
  return make_modes_page(
      {all.equilibrium, all.frame, all.bodies, all.are_blades_coupled, {one.mode()}},
      one.modes->scenario);
}

std::vector<OneMode> list_modes(const std::shared_ptr<const Modes>& modes) {
  std::vector<OneMode> list;
  for (std::size_t k = 0; k < modes->result.modes.size(); ++k) list.push_back({modes, k});
  return list;
}

void bind_equilibrium(py::module_& module) {
  py::class_<JointPosition>(module, "JointPosition", "A coordinate of a joint in equilibrium.")
      .def_readonly("name", &JointPosition::name)
      .def_readonly("value", &JointPosition::value, "[rad], or [m] if it slides")
      .def_readonly("turns", &JointPosition::turns, "Whether it is an angle.")
      .def("__repr__", [](const JointPosition& joint) {
        return "<spoke.JointPosition " + joint.name + ", " + six_digits(joint.value) +
               (joint.turns ? " rad>" : " m>");
      });
  py::class_<SectionLoad>(module, "SectionLoad",
                          "What the outer part of a blade exerts on the inner one where a body "
                          "begins, in axes of the section there: as the sensor section_force.")
      .def_readonly("body", &SectionLoad::body, "That begins there.")
      .def_readonly("station", &SectionLoad::station, "Undeformed distance from the root [m].")
      .def_readonly("force", &SectionLoad::force, "(3,) [N]")
      .def_readonly("moment", &SectionLoad::moment, "(3,) [N m]")
      .def("__repr__", [](const SectionLoad& load) {
        return "<spoke.SectionLoad at " + six_digits(load.station) + " m, force " +
               vector_text(load.force) + " N, moment " + vector_text(load.moment) + " N m>";
      });
  py::class_<LoopLoad>(
      module, "LoopLoad",
      "What the closure of a loop exerts on its place `from`, about it; hub frame.")
      .def_readonly("name", &LoopLoad::name)
      .def_readonly("force", &LoopLoad::force, "(3,) [N]")
      .def_readonly("moment", &LoopLoad::moment, "(3,) [N m]")
      .def_readonly("tension", &LoopLoad::tension, "Of a loop of kind distance [N]; else None.")
      .def("__repr__", [](const LoopLoad& load) {
        return "<spoke.LoopLoad " + load.name + ", force " + vector_text(load.force) +
               " N, moment " + vector_text(load.moment) + " N m>";
      });
  py::class_<BladeEquilibrium>(module, "BladeEquilibrium",
                               "A blade, or another subsystem, in equilibrium; hub frame.")
      .def_readonly("name", &BladeEquilibrium::name)
      .def_readonly("tip_displacement", &BladeEquilibrium::tip_displacement, "(3,) [m]")
      .def_readonly("tip_rotation", &BladeEquilibrium::tip_rotation, "(3,) rotation vector [rad]")
      .def_readonly("joints", &BladeEquilibrium::joints, "That are free.")
      .def_readonly("loads", &BladeEquilibrium::loads, "From the root on.")
      .def_readonly("loops", &BladeEquilibrium::loops, "That are closed.")
      .def_readonly("bending", &BladeEquilibrium::bending,
                    "By body: its largest deflection across its axis by its length.")
      .def_property_readonly(
          "nodes", [](const BladeEquilibrium& blade) { return rows_of(blade.nodes); },
          "(nodes, 3): places from root to tip, body after body: the last node of a body is "
          "the first of the next [m]")
      .def_property_readonly(
          "undeformed", [](const BladeEquilibrium& blade) { return rows_of(blade.undeformed); },
          "(nodes, 3): of the same nodes [m]")
      .def("__repr__", [](const BladeEquilibrium& blade) {
        return "<spoke.BladeEquilibrium " + blade.name + ", tip displacement " +
               vector_text(blade.tip_displacement) + " m>";
      });
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
          "static.html: one page without network.")
      .def("__repr__", [](const Equilibrium& e) { return describe(e.result); });
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

/// Returns a property of one of the modes.
template <class Value>
auto of_mode(Value Mode::*member) {
  return [member](const OneMode& one) { return one.mode().*member; };
}

void bind_mode(py::module_& module) {
  py::class_<OneMode>(module, "Mode",
                      "A vibration: motion Re(shape exp(eigenvalue t)) about the equilibrium, in "
                      "the frame that turns with the hub.")
      .def_property_readonly("name", of_mode(&Mode::name), "By what moves most: \"flap 1\".")
      .def_property_readonly("kind", of_mode(&Mode::kind),
                             "\"flap\", \"lag\", \"axial\", \"torsion\", ...")
      .def_property_readonly("of", of_mode(&Mode::of),
                             "Whose: \"blade 1\", \"blades 1 to 3\", \"all\".")
      .def_property_readonly("eigenvalue", of_mode(&Mode::eigenvalue), "Complex [rad/s].")
      .def_property_readonly("frequency", of_mode(&Mode::frequency), "Of the motion [rad/s].")
      .def_property_readonly("damping_ratio", of_mode(&Mode::damping_ratio), "Negative: it grows.")
      .def_property_readonly(
          "grows", [](const OneMode& one) { return one.mode().grows(); },
          "Whether the equilibrium is unstable in it.")
      .def_property_readonly(
          "shape", [](const OneMode& one) { return shape_of(one.mode()); },
          "By blade, then other subsystems: (nodes, 3) complex displacements in "
          "the hub's frame, the largest of all being 1; (0, 3) of a blade that "
          "is not in it.")
      .def(
          "page", [](const OneMode& one) { return make_modes_page(one); },
          "modes.html of this mode alone: one page without network.")
      .def("__repr__",
           [](const OneMode& one) { return "<spoke.Mode " + describe(one.mode()) + ">"; });
}

void bind_modes(py::module_& module) {
  using Self = std::shared_ptr<Modes>;
  const auto numbers = [](auto Mode::*member) {
    return [member](const Modes& modes) {
      using Number = std::decay_t<decltype(std::declval<Mode>().*member)>;
      return array_of<Number>(modes.result.modes,
                              [member](const Mode& mode) { return mode.*member; });
    };
  };
  bind_mode(module);
  py::class_<Modes, Self>(module, "Modes", "Vibration modes of a model about its steady motion.")
      .def_property_readonly(
          "modes", [](const Self& modes) { return list_modes(modes); },
          "By ascending magnitude of the eigenvalue; where blades do not couple, blade by blade.")
      .def_property_readonly("frequencies", numbers(&Mode::frequency), "(modes,) [rad/s]")
      .def_property_readonly("damping_ratios", numbers(&Mode::damping_ratio), "(modes,)")
      .def_property_readonly("eigenvalues", numbers(&Mode::eigenvalue), "(modes,) complex [rad/s]")
      .def_property_readonly(
          "are_blades_coupled", [](const Modes& modes) { return modes.result.are_blades_coupled; },
          "Whether blades move each other through the hub.")
      .def_property_readonly(
          "speed", [](const Modes& modes) { return modes.result.equilibrium.speed; },
          "Of the hub [rad/s].")
      .def(
          "page", [](const Modes& modes) { return make_modes_page(modes.result, modes.scenario); },
          "modes.html: one page without network.")
      .def("__repr__", [](const Modes& modes) { return describe(modes.result); })
      .def("__len__", [](const Modes& modes) { return modes.result.modes.size(); })
      .def("__getitem__", [](const Self& modes, std::ptrdiff_t k) {
        const auto n = static_cast<std::ptrdiff_t>(modes->result.modes.size());
        if (k < -n || k >= n) throw py::index_error();
        return OneMode{modes, static_cast<std::size_t>(k < 0 ? k + n : k)};
      });
  module.def(
      "_solve_modes",
      [](const Scenario& scenario, std::optional<double> speed, std::optional<int> count) {
        return std::make_shared<Modes>(solve_modes(scenario, {{speed}, count}), scenario);
      },
      py::call_guard<py::gil_scoped_release>());
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
                         std::optional<double> speed, int points, std::optional<int> count) {
  CriticalOptions options{.of = std::move(of),
                          .from = from,
                          .to = to,
                          .state = {speed},
                          .points = points,
                          .count = count,
                          .progress = [](std::size_t) {
                            const py::gil_scoped_acquire lock;
                            if (PyErr_CheckSignals() != 0) throw py::error_already_set();
                          }};
  CriticalResult result = solve_critical(scenario, options);
  options.progress = {};
  return {std::move(result), std::move(options), scenario};
}

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
          "\"no equilibrium\"; or None.")
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

}  // namespace

void bind_steady(py::module_& module) {
  bind_equilibrium(module);
  bind_modes(module);
  bind_campbell(module);
  bind_critical(module);
}

}  // namespace spoke::python
