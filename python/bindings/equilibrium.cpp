// Binds equilibria: values, with arrays made when asked for.

#include "engine/equilibrium.h"

#include <pybind11/eigen.h>
#include <pybind11/numpy.h>
#include <pybind11/stl.h>

#include <algorithm>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "program/steady_report/static_files.h"
#include "python/bindings/bindings.h"
#include "python/bindings/results.h"

namespace spoke::python {
namespace {

namespace py = pybind11;
using namespace py::literals;

/// An equilibrium, and further data of its page.
struct Equilibrium {
  EquilibriumResult result;
  Scenario scenario;
};

std::string vector_text(const Eigen::Vector3d& v) {
  return py::str("[{:.6g}, {:.6g}, {:.6g}]").format(v.x(), v.y(), v.z());
}

/// Returns what air does to the sections of a blade, by station; None: no air acts.
py::object air_of(const BladeEquilibrium& blade) {
  if (blade.air.empty()) return py::none();
  const auto by_station = [&](double SectionAir::*member) {
    return array_of<double>(blade.air, [member](const SectionAir& s) { return s.*member; });
  };
  return py::dict(
      "station"_a = by_station(&SectionAir::station), "attack"_a = by_station(&SectionAir::attack),
      "relative_speed"_a = by_station(&SectionAir::relative_speed),
      "axial_induction"_a = by_station(&SectionAir::axial_induction),
      "tangential_induction"_a = by_station(&SectionAir::tangential_induction),
      "lift"_a = by_station(&SectionAir::lift), "drag"_a = by_station(&SectionAir::drag),
      "moment"_a = by_station(&SectionAir::moment),
      "axial_force"_a = by_station(&SectionAir::axial_force),
      "tangential_force"_a = by_station(&SectionAir::tangential_force),
      "pitching_moment"_a = by_station(&SectionAir::pitching_moment));
}

/// Returns whether small motions decay; None: not known.
py::object stability_of(const Equilibrium& equilibrium) {
  if (!equilibrium.result.stability) return py::none();
  const Stability& stability = *equilibrium.result.stability;
  return py::dict("small_motions"_a = steady_report::word_of(stability.motions),
                  "rate"_a = stability.rate, "frequency"_a = stability.frequency,
                  "mode"_a = stability.mode, "of"_a = stability.of);
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

}  // namespace

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
  py::class_<RotorAir>(module, "RotorAir", "What air does to a rotor in equilibrium; hub frame.")
      .def_readonly("wind", &RotorAir::wind, "Speed along the axis, against the hub [m/s].")
      .def_readonly("thrust", &RotorAir::thrust, "Along the axis [N].")
      .def_readonly("torque", &RotorAir::torque, "About the axis [N m].")
      .def("__repr__", [](const RotorAir& air) {
        return "<spoke.RotorAir wind " + six_digits(air.wind) + " m/s, thrust " +
               six_digits(air.thrust) + " N, torque " + six_digits(air.torque) + " N m>";
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
      .def_property_readonly(
          "air", &air_of,
          "By station what air does to the sections, arrays (stations,): station [m], attack "
          "[rad], relative_speed [m/s], axial_induction, tangential_induction, the coefficients "
          "lift, drag and moment, axial_force and tangential_force [N/m], pitching_moment [N m/m]; "
          "None where no air acts.")
      .def("__repr__", [](const BladeEquilibrium& blade) {
        return "<spoke.BladeEquilibrium " + blade.name + ", tip displacement " +
               vector_text(blade.tip_displacement) + " m>";
      });
  py::class_<RotorEquilibrium>(module, "RotorEquilibrium",
                               "One of several rotors on a support in equilibrium.")
      .def_readonly("name", &RotorEquilibrium::name)
      .def_readonly("speed", &RotorEquilibrium::speed, "Of its hub [rad/s].")
      .def_property_readonly(
          "position", [](const RotorEquilibrium& rotor) { return rotor.hub.position; },
          "(3,) of its hub, from the support's base [m]")
      .def_property_readonly(
          "axes", [](const RotorEquilibrium& rotor) { return rotor.hub.axes; },
          "(3, 3) of its hub at the angle 0, columns; the last is the axis of rotation")
      .def_readonly("force", &RotorEquilibrium::force,
                    "(3,) of support and drive on its hub, in its frame [N]")
      .def_readonly("moment", &RotorEquilibrium::moment,
                    "(3,) likewise, about the hub's origin [N m]")
      .def_readonly("air", &RotorEquilibrium::air, "As of an equilibrium.")
      .def("__repr__", [](const RotorEquilibrium& rotor) {
        return "<spoke.RotorEquilibrium " + rotor.name + " at " + six_digits(rotor.speed) +
               " rad/s>";
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
      .def_property_readonly("air", get(&EquilibriumResult::air),
                             "What air does to the rotor: wind [m/s], thrust [N] and torque [N m]; "
                             "None where no air acts.")
      .def_property_readonly("rotors", get(&EquilibriumResult::rotors),
                             "Of several on a support all, in their order; else empty.")
      .def_property_readonly(
          "stability", &stability_of,
          "Whether small motions about it decay: a dictionary with small_motions (\"decay\", "
          "\"persist\" without damping, or \"grow\"), rate [1/s] and frequency [rad/s] of the "
          "motion "
          "that decays least, its mode and of; None where it is not known.")
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
      [](const Scenario& scenario, std::optional<double> speed,
         std::map<std::string, double> speeds) {
        return Equilibrium{solve_equilibrium(scenario, {speed, std::move(speeds)}), scenario};
      },
      py::call_guard<py::gil_scoped_release>());
}

}  // namespace spoke::python
