// Binds the courses in force beside a state.

#include "engine/courses.h"

#include <pybind11/eigen.h>
#include <pybind11/stl.h>

#include <string>

#include "python/bindings/bindings.h"
#include "python/bindings/used_simulation.h"

namespace spoke::python {
namespace {

namespace py = pybind11;
using namespace py::literals;

py::dict rotors_of(const Courses& courses) {
  py::dict rotors;
  for (const RotorDrive& of : courses.rotors) rotors[py::str(of.rotor)] = of.drive;
  return rotors;
}

py::dict loads_of(const Courses& courses) {
  py::dict loads;
  for (const LoadFactor& load : courses.loads) loads[py::str(load.load)] = load.factor;
  return loads;
}

py::list joints_of(const Courses& courses) {
  py::list joints;
  for (const JointCourse& joint : courses.joints)
    joints.append(py::dict("tree"_a = joint.tree, "joint"_a = joint.joint,
                           "coordinate"_a = joint.coordinate, "begin"_a = joint.begin,
                           "motion"_a = joint.motion, "curve"_a = joint.curve));
  return joints;
}

py::list anchors_of(const Courses& courses) {
  py::list anchors;
  for (const AnchorCourse& anchor : courses.anchors)
    anchors.append(py::dict("anchor"_a = anchor.anchor, "begin"_a = anchor.begin,
                            "motion"_a = anchor.motion,
                            "follows_curves"_a = anchor.curves.has_value()));
  return anchors;
}

py::list torques_of(const Courses& courses) {
  py::list torques;
  for (const JointTorque& torque : courses.torques)
    torques.append(py::dict("tree"_a = torque.tree, "joint"_a = torque.joint,
                            "coordinate"_a = torque.coordinate, "torque"_a = torque.torque));
  return torques;
}

std::string describe_courses(const Courses& courses) {
  return "<spoke.Courses of the drive, " + std::to_string(courses.joints.size()) + " joints, " +
         std::to_string(courses.anchors.size()) + " anchors and " +
         std::to_string(courses.loads.size()) + " loads>";
}

}  // namespace

void bind_courses(py::module_& module) {
  py::class_<Courses>(module, "Courses",
                      "What is in force beside a state, and a program can set: see courses() and "
                      "Simulation.restore().")
      .def_property_readonly(
          "drive", [](const Courses& courses) { return courses.drive; }, "What moves the hub.")
      .def_property_readonly("rotors", &rotors_of,
                             "What moves the hubs of further rotors on a support, by their names.")
      .def_property_readonly("joints", &joints_of,
                             "Of coordinates that the scenario leaves to the program: dictionaries "
                             "with tree, joint and coordinate, motion, which holds from begin [s] "
                             "on, and curve, in place of these, or None.")
      .def_property_readonly(
          "anchors", &anchors_of,
          "Of anchors that the scenario leaves to the program: dictionaries with "
          "anchor, motion, which holds from begin [s] on, and follows_curves, "
          "whether curves take their place.")
      .def_property_readonly("torques", &torques_of,
                             "That the program adds to joints: dictionaries with tree, joint, "
                             "coordinate and torque [N m, N].")
      .def_property_readonly("loads", &loads_of, "Factors of the scenario's loads by their names.")
      .def("__repr__", &describe_courses);
  module.def(
      "courses",
      [](UsedSimulation& simulation) {
        const Use use(simulation);
        return courses(simulation);
      },
      "simulation"_a,
      "The courses in force: drives, joints and anchors that the scenario leaves to the "
      "program, "
      "factors of loads, the wind at the hub, torques on joints. Taken with Simulation.save(), "
      "they are what "
      "Simulation.restore() goes back with. Loads of the program's own are not among them.");
}

}  // namespace spoke::python
