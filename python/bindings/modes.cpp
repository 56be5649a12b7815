// Binds modes: values, with arrays made when asked for.

#include "python/bindings/modes.h"

#include <pybind11/complex.h>
#include <pybind11/eigen.h>
#include <pybind11/numpy.h>
#include <pybind11/stl.h>

#include <algorithm>
#include <complex>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "models/error.h"
#include "program/steady_report/mode_files.h"
#include "program/steady_report/modes_page.h"
#include "python/bindings/bindings.h"
#include "python/bindings/results.h"

namespace spoke::python {
namespace {

namespace py = pybind11;
using namespace py::literals;

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

/// Returns the page of all modes or of some.
std::string make_modes_page(const ModesResult& result, const Scenario& scenario) {
  if (result.equilibrium.blades.empty())
    throw StateError("no page: there are no blades, or no equilibrium was found at this speed");
  return steady_report::make_html(result, scenario, title_of(scenario));
}

std::string make_modes_page(const OneMode& one) {
  const ModesResult& all = one.modes->result;
  return make_modes_page(
      {all.equilibrium, all.frame, all.bodies, all.are_blades_coupled, all.notes, {one.mode()}},
      one.modes->scenario);
}

std::vector<OneMode> list_modes(const std::shared_ptr<const Modes>& modes) {
  std::vector<OneMode> list;
  for (std::size_t k = 0; k < modes->result.modes.size(); ++k) list.push_back({modes, k});
  return list;
}

py::list shape_of(const Mode& mode) {
  py::list shape;
  for (const auto& blade : mode.shape) shape.append(rows_of(blade));
  return shape;
}

py::list harmonics_of(const Mode& mode) {
  py::list harmonics;
  for (const ModeHarmonic& harmonic : mode.harmonics)
    harmonics.append(py::dict("multiple"_a = harmonic.multiple, "frequency"_a = harmonic.frequency,
                              "share"_a = harmonic.share, "of_hub"_a = harmonic.of_hub));
  return harmonics;
}

/// Returns a property of one of the modes.
template <class Value>
auto of_mode(Value Mode::*member) {
  return [member](const OneMode& one) { return one.mode().*member; };
}

void bind_mode(py::module_& module) {
  py::class_<OneMode>(module, "Mode",
                      "A vibration: motion Re(shape exp(eigenvalue t)) about the equilibrium, in "
                      "the frame of its Modes.")
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
      .def_property_readonly(
          "harmonics", [](const OneMode& one) { return harmonics_of(one.mode()); },
          "In the frame \"floquet\": dictionaries with multiple, frequency [rad/s], share and "
          "of_hub, that part of the share which the hub has; else empty.")
      .def(
          "page", [](const OneMode& one) { return make_modes_page(one); },
          "modes.html of this mode alone: one page without network.")
      .def("__repr__",
           [](const OneMode& one) { return "<spoke.Mode " + describe(one.mode()) + ">"; });
}

}  // namespace

std::optional<ModeFrame> frame_of(const std::optional<std::string>& name) {
  if (!name) return std::nullopt;
  static const std::map<std::string, ModeFrame> frames = {{"turning", ModeFrame::turning},
                                                          {"fixed", ModeFrame::fixed},
                                                          {"floquet", ModeFrame::floquet}};
  const auto found = frames.find(*name);
  if (found == frames.end())
    throw InputError("frame \"" + *name + "\", expected \"turning\", \"fixed\" or \"floquet\"");
  return found->second;
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
      .def_property_readonly(
          "notes", [](const Modes& modes) { return modes.result.notes; },
          "What a reader of the modes should know: a frame that was chosen, air at rest.")
      .def_property_readonly("frequencies", numbers(&Mode::frequency), "(modes,) [rad/s]")
      .def_property_readonly("damping_ratios", numbers(&Mode::damping_ratio), "(modes,)")
      .def_property_readonly("eigenvalues", numbers(&Mode::eigenvalue), "(modes,) complex [rad/s]")
      .def_property_readonly(
          "are_blades_coupled", [](const Modes& modes) { return modes.result.are_blades_coupled; },
          "Whether blades move each other through the hub.")
      .def_property_readonly(
          "speed", [](const Modes& modes) { return modes.result.equilibrium.speed; },
          "Of the hub, of several rotors of the first [rad/s].")
      .def_property_readonly(
          "rotors", [](const Modes& modes) { return modes.result.equilibrium.rotors; },
          "Of several rotors on a support all, as of an equilibrium; else empty.")
      .def_property_readonly(
          "frame", [](const Modes& modes) { return steady_report::name_of(modes.result.frame); },
          "From where they are seen: \"turning\", \"fixed\" or \"floquet\".")
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
      [](const Scenario& scenario, std::optional<double> speed,
         std::map<std::string, double> speeds, std::optional<int> count,
         const std::optional<std::string>& frame) {
        return std::make_shared<Modes>(
            solve_modes(scenario, {{speed, std::move(speeds)}, count, frame_of(frame)}), scenario);
      },
      py::call_guard<py::gil_scoped_release>());
}

}  // namespace spoke::python
