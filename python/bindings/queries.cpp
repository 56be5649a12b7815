// Returns answers as arrays of their own, which do not change while the simulation goes on.

#include "python/bindings/queries.h"

#include <pybind11/eigen.h>
#include <pybind11/numpy.h>
#include <pybind11/stl.h>

#include <span>
#include <string>
#include <vector>

namespace spoke::python {
namespace {

namespace py = pybind11;
using namespace py::literals;

py::array_t<double> copy_of(std::span<const double> numbers) {
  return py::array_t<double>(static_cast<py::ssize_t>(numbers.size()), numbers.data());
}

/// Returns vectors of the nodes of a blade as the rows of an array.
template <class Node, class Vector>
py::array_t<double> rows_of(const std::vector<Node>& nodes, Vector Node::*vector) {
  const auto width = static_cast<py::ssize_t>(Vector::RowsAtCompileTime);
  py::array_t<double> rows({static_cast<py::ssize_t>(nodes.size()), width});
  double* to = rows.mutable_data();
  for (const Node& node : nodes)
    for (py::ssize_t c = 0; c < width; ++c) *to++ = (node.*vector)[c];
  return rows;
}

py::array_t<double> angles_of(const std::vector<ShapeNode>& nodes) {
  py::array_t<double> angles(static_cast<py::ssize_t>(nodes.size()));
  for (std::size_t k = 0; k < nodes.size(); ++k) angles.mutable_data()[k] = nodes[k].angle;
  return angles;
}

BladeShape shape_of(UsedSimulation& simulation, int blade) {
  const Use use(simulation);
  BladeShape shape;
  simulation.calc_shape(blade, shape);
  return shape;
}

/// Returns the places of the nodes of a tree in space, body after body.
py::array_t<double> places_of(UsedSimulation& simulation, int tree) {
  const Use use(simulation);
  TreeShape shape;
  simulation.calc_shape(tree, shape);
  std::vector<TreeNode> nodes;
  for (const TreeBodyShape& body : shape.bodies)
    nodes.insert(nodes.end(), body.nodes.begin(), body.nodes.end());
  return rows_of(nodes, &TreeNode::p);
}

std::vector<std::string> warnings_of(UsedSimulation& simulation) {
  const Use use(simulation);
  std::vector<std::string> texts;
  for (const Warning& warning : simulation.warnings()) texts.push_back(warning.text);
  return texts;
}

}  // namespace

void bind_query_results(py::module_& module) {
  py::class_<HubMotion>(module, "HubMotion", "A hub's motion in the inertial frame.")
      .def_readonly("position", &HubMotion::position, "(3,) x [m], y [m], angle [rad]")
      .def_readonly("velocity", &HubMotion::velocity, "(3,) [m/s, m/s, rad/s]")
      .def_readonly("acceleration", &HubMotion::acceleration, "(3,) [m/s^2, m/s^2, rad/s^2]");
  const auto array = [](std::vector<double> BodyState::*numbers) {
    return [numbers](const BodyState& body) { return copy_of(body.*numbers); };
  };
  py::class_<BodyState>(module, "BodyState", "The deformation of a body of a rotor in the plane.")
      .def_property_readonly("coordinates", array(&BodyState::coordinates),
                             "(3 elements,): axial ones by node, then v and psi by node [m, rad]")
      .def_property_readonly("velocities", array(&BodyState::velocities), "likewise [m/s, rad/s]")
      .def_property_readonly("accelerations", array(&BodyState::accelerations),
                             "likewise [m/s^2, rad/s^2]");
  const auto by_element = [](std::vector<double> BladeShape::*numbers) {
    return [numbers](const BladeShape& shape) { return copy_of(shape.*numbers); };
  };
  py::class_<BladeShape>(module, "BladeShape",
                         "Where the nodes of a blade in the plane stand, in the hub's frame.")
      .def_property_readonly(
          "places", [](const BladeShape& s) { return rows_of(s.nodes, &ShapeNode::p); },
          "(nodes, 2) [m]")
      .def_property_readonly(
          "displacements",
          [](const BladeShape& s) { return rows_of(s.nodes, &ShapeNode::displacement); },
          "(nodes, 2) from the undeformed place [m]")
      .def_property_readonly(
          "velocities", [](const BladeShape& s) { return rows_of(s.nodes, &ShapeNode::velocity); },
          "(nodes, 2) relative to the inertial frame [m/s]")
      .def_property_readonly(
          "angles", [](const BladeShape& s) { return angles_of(s.nodes); },
          "(nodes,) of the section from its undeformed direction [rad]")
      .def_property_readonly("axial_forces", by_element(&BladeShape::axial_forces),
                             "(elements,) mean of each, positive in tension [N]")
      .def_property_readonly("bending_moments", by_element(&BladeShape::bending_moments),
                             "(elements,) in the middle of each [N m]");
}

void bind_queries(py::class_<UsedSimulation, std::shared_ptr<UsedSimulation>>& simulation) {
  simulation.def_property_readonly("sensor_names", &Simulation::sensor_names, "In their order.")
      .def_property_readonly("sensor_units", &Simulation::sensor_units, "In the same order.")
      .def_property_readonly(
          "sensors",
          [](UsedSimulation& s) { return copy_of(alone(&Simulation::sensor_values)(s)); },
          "(sensors,): all sensors at `time`, a copy.")
      .def("sensor", alone(&Simulation::sensor), "name"_a,
           "One sensor at `time`. Raises InputError, with the nearest name, if there is none.")
      .def_property_readonly("hub", alone(&Simulation::hub),
                             "The hub's motion. Of a rotor in the plane.")
      .def("body", alone(&Simulation::body), "blade"_a, "body"_a,
           "The deformation of a body, both counted from 0. Of a rotor in the plane.")
      .def("shape", &shape_of, "blade"_a,
           "Where the nodes of a blade stand, counted from 0. Of a rotor in the plane.")
      .def("places", &places_of, "tree"_a,
           "(nodes, 3): where the nodes of a blade or subsystem in space stand, counted from 0, in "
           "the hub's frame [m].")
      .def("marker", alone(&Simulation::marker), "marker"_a,
           "Motion and deflection of a point anywhere on a body.")
      .def("joint_reaction", alone(&Simulation::joint_reaction), "blade"_a, "joint"_a,
           "What the joint inboard of a body (0: at the hub) does to the body, about the joint, in "
           "the inertial frame. Both count from 0.")
      .def("loop_reaction", alone(&Simulation::loop_reaction), "tree"_a, "loop"_a,
           "What the loop of that name on a blade or subsystem, counted from 0, does to its place "
           "`from`, about it, in the inertial frame.")
      .def("hub_reaction", alone(&Simulation::hub_reaction),
           "What support and drive do to the hub, about its axis, in space about its origin, in "
           "the inertial frame.")
      .def("section_force", alone(&Simulation::section_force), "marker"_a,
           "What the part of a blade outboard of a section does to the part inboard, in the frame "
           "of the section: in the plane force x is axial, positive in tension, y shear, moment z "
           "bending; in space all six.")
      .def_property_readonly("warnings", &warnings_of,
                             "What makes the results doubtful so far: sentences.");
}

}  // namespace spoke::python
