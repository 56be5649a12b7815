// Binds solids reduced to modes.

#include "engine/reduce.h"

#include <pybind11/eigen.h>
#include <pybind11/numpy.h>
#include <pybind11/stl.h>

#include <string>
#include <vector>

#include "models/count_text.h"
#include "python/bindings/bindings.h"

namespace spoke::python {
namespace {

namespace py = pybind11;
using namespace py::literals;

/// Raises KeyboardInterrupt, if Ctrl-C was pressed, between steps of the reduction.
void check_interruption(const std::string&, double) {
  const py::gil_scoped_acquire lock;
  if (PyErr_CheckSignals() != 0) throw py::error_already_set();
}

template <class Number>
py::array_t<Number> array_of_numbers(const std::vector<Number>& numbers) {
  return py::array_t<Number>(static_cast<py::ssize_t>(numbers.size()), numbers.data());
}

py::array_t<double> nodes_of(const SolidReduction& solid) {
  py::array_t<double> array({static_cast<py::ssize_t>(solid.nodes.size()), py::ssize_t{3}});
  double* to = array.mutable_data();
  for (const Eigen::Vector3d& node : solid.nodes)
    for (const double value : node) *to++ = value;
  return array;
}

py::array_t<double> shapes_of(const SolidReduction& solid) {
  py::array_t<double> array({static_cast<py::ssize_t>(solid.shapes.size()),
                             static_cast<py::ssize_t>(solid.nodes.size()), py::ssize_t{3}});
  double* to = array.mutable_data();
  for (const std::vector<Eigen::Vector3d>& shape : solid.shapes)
    for (const Eigen::Vector3d& node : shape)
      for (const double value : node) *to++ = value;
  return array;
}

py::list interfaces_of(const SolidReduction& solid) {
  py::list list;
  for (const SolidReductionInterface& interface : solid.interfaces)
    list.append(py::dict("name"_a = interface.name, "kind"_a = std::string(name_of(interface.kind)),
                         "nodes"_a = interface.nodes, "point"_a = interface.point,
                         "area"_a = interface.area));
  return list;
}

std::string describe_reduction(const SolidReduction& solid) {
  std::string text = "<spoke.SolidReduction " + solid.subsystem + " / " + solid.body + ", " +
                     counted(std::ssize(solid.nodes), "node");
  if (solid.kind == spatial::SolidCoordinates::nodal) return text + ", not reduced>";
  text += ", " + counted(solid.coordinates, "mode");
  if (solid.frequencies.empty()) return text + ">";
  const py::str range("{:.6g} to {:.6g} Hz");
  return text + ", " +
         std::string(range.format(solid.frequencies.front(), solid.frequencies.back())) + ">";
}

}  // namespace

void bind_reduce(py::module_& module) {
  py::class_<SolidReduction>(
      module, "SolidReduction",
      "A body from a finite-element mesh, and the modes that its deformation "
      "is made of.")
      .def_readonly("subsystem", &SolidReduction::subsystem, "Its name.")
      .def_readonly("body", &SolidReduction::body, "Its name.")
      .def_property_readonly(
          "kind", [](const SolidReduction& solid) { return std::string(name_of(solid.kind)); },
          "\"reduced\" or \"nodal\".")
      .def_readonly("file", &SolidReduction::file,
                    "Of the mesh, or of the stiffness matrix; may be empty.")
      .def_readonly("mass", &SolidReduction::mass, "[kg]")
      .def_readonly("elements", &SolidReduction::elements, "Their number; 0 of matrices.")
      .def_readonly("has_locking_elements", &SolidReduction::has_locking_elements,
                    "Whether linear elements, tet4 or hex8, make it too stiff.")
      .def_readonly("coordinates", &SolidReduction::coordinates,
                    "Number of its deformation coordinates.")
      .def_property_readonly(
          "interfaces", &interfaces_of,
          "Dictionaries with name, kind, nodes (their number), point (3,) in the "
          "frame of the body [m] and area [m^2], 0 without faces.")
      .def_property_readonly(
          "frequencies",
          [](const SolidReduction& solid) { return array_of_numbers(solid.frequencies); },
          "(modes,) ascending [Hz]; of kind nodal (0,).")
      .def_property_readonly(
          "damping_ratios",
          [](const SolidReduction& solid) { return array_of_numbers(solid.damping_ratios); },
          "(modes,)")
      .def_property_readonly(
          "vibration_frequencies",
          [](const SolidReduction& solid) { return array_of_numbers(solid.vibration_frequencies); },
          "Of the vibration modes with all interfaces held, from which the modes were made, with "
          "static shapes [Hz].")
      .def_property_readonly("nodes", &nodes_of, "(nodes, 3) in the frame of the body [m]")
      .def_property_readonly(
          "labels", [](const SolidReduction& solid) { return array_of_numbers(solid.labels); },
          "(nodes,) numbers of the nodes in their file.")
      .def_property_readonly("shapes", &shapes_of,
                             "(modes, nodes, 3): displacements, orthonormal with the mass "
                             "[1/sqrt(kg)]; of kind nodal (0, nodes, 3).")
      .def_readonly("seconds", &SolidReduction::seconds, "That it took to make or to read [s].")
      .def_readonly("memory_bytes", &SolidReduction::memory_bytes, "Kept for simulations, about.")
      .def_readonly("was_cached", &SolidReduction::was_cached, "Whether the cache had it.")
      .def_readonly("cache_file", &SolidReduction::cache_file,
                    "File of the cache; empty: there is none.")
      .def("__repr__", &describe_reduction);
  module.def(
      "_reduce",
      [](const Scenario& scenario, bool force) {
        return reduce(scenario, {.progress = check_interruption, .anew = force});
      },
      py::call_guard<py::gil_scoped_release>());
}

}  // namespace spoke::python
