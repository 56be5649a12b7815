// Binds Simulation: how it is made, its steps and states.

#include "engine/simulation.h"

#include <pybind11/eigen.h>
#include <pybind11/numpy.h>
#include <pybind11/stl.h>

#include <array>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "engine/checkpoint.h"
#include "engine/courses.h"
#include "models/error.h"
#include "python/bindings/bindings.h"
#include "python/bindings/controllers.h"
#include "python/bindings/queries.h"
#include "python/bindings/used_simulation.h"
#include "python/bindings/wind.h"

namespace spoke::python {
namespace {

namespace py = pybind11;
using namespace py::literals;
using Class = py::class_<UsedSimulation, std::shared_ptr<UsedSimulation>>;

/// Returns the scenario, with a wind of the program's own in place of its own if one is given.
Scenario in_wind(Scenario scenario, std::optional<py::function> wind) {
  if (!wind) return scenario;
  if (!scenario.space || !scenario.space->air)
    throw InputError("wind: the model is in no air, expected one with [air]", {.key = "wind"});
  scenario.space->air->wind = Wind{.by_program = true, .field = make_python_wind(std::move(*wind))};
  return scenario;
}

std::shared_ptr<UsedSimulation> make_simulation(
    const Scenario& scenario, const std::string& formulation, const std::string& executor,
    std::pair<int, int> threads, int window, const std::vector<std::shared_ptr<Load>>& loads,
    std::optional<py::function> wind, std::optional<py::object> controller) {
  SimulationOptions options;
  if (controller) options.controller = make_python_controller(std::move(*controller));
  options.formulation = formulation_of(formulation);
  options.executor = graph::executor_kind(executor);
  options.threads = {threads.first, threads.second};
  options.window = window;
  const Loads all(loads.begin(), loads.end());
  const Scenario blown = in_wind(scenario, std::move(wind));
  const py::gil_scoped_release unlocked;  // since loads and winds in Python are evaluated
  return std::make_shared<UsedSimulation>(blown, options, all);
}

std::shared_ptr<UsedSimulation> clone(UsedSimulation& original) {
  const Use use(original);
  const py::gil_scoped_release unlocked;
  return std::make_shared<UsedSimulation>(original.clone());
}

void go_back(UsedSimulation& simulation, const SavedState& state, const Courses* courses) {
  const Use use(simulation);
  const py::gil_scoped_release unlocked;
  if (courses)
    restore(simulation, state, *courses);
  else
    simulation.restore(state);
}

void bind_saved_state(py::module_& module) {
  py::class_<SavedState>(module, "SavedState",
                         "The state of a simulation between two steps. It can be pickled.")
      .def_readonly("time", &SavedState::time, "[s]")
      .def_readonly("steps", &SavedState::steps, "Made since t = 0.")
      .def("_to_file",
           [](const SavedState& state, const std::string& file) { save_checkpoint(file, state); })
      .def_static("_from_file", [](const std::string& file) { return load_checkpoint(file).state; })
      .def(py::pickle([](const SavedState& state) { return py::bytes(make_checkpoint(state)); },
                      [](const py::bytes& bytes) {
                        return parse_checkpoint(std::string(bytes), "pickled state").state;
                      }));
}

void bind_progress(Class& simulation) {
  simulation.def_property_readonly("scenario", &Simulation::scenario, "As given.")
      .def_property_readonly("time", alone(&Simulation::time), "[s]")
      .def_property_readonly("step_size", &Simulation::step_size, "[s]")
      .def_property_readonly("steps", alone(&Simulation::steps), "Done so far.")
      .def_property_readonly("planned_steps", &Simulation::planned_steps, "In all.")
      .def_property_readonly("evaluations", alone(&Simulation::evaluations),
                             "Of the accelerations, so far.")
      .def_property_readonly("done", alone(&Simulation::done), "Whether the duration is over.")
      .def_property_readonly("executor", alone(&Simulation::executor_description),
                             "What runs the steps, in one line.")
      .def_property_readonly("state_hash", alone(&Simulation::state_hash),
                             "64-bit hash of the state, as in summary.json.")
      .def_property_readonly(
          "coordinates", [](const UsedSimulation& s) { return s.size().coordinates; },
          "Independent coordinates: free ones of the hub, and all deformations.");
}

void bind_anchor_motion(py::module_& module) {
  py::class_<AnchorMotion>(module, "AnchorMotion",
                           "The motion of an anchor at one time, in the frame in which it moves.")
      .def(py::init<>())
      .def_readwrite("translation", &AnchorMotion::translation, "(3,) [m]")
      .def_readwrite("velocity", &AnchorMotion::velocity, "(3,) [m/s]")
      .def_readwrite("acceleration", &AnchorMotion::acceleration, "(3,) [m/s^2]")
      .def_readwrite("rotation", &AnchorMotion::rotation, "(3,) rotation vector [rad]")
      .def_readwrite("rotation_rate", &AnchorMotion::rotation_rate,
                     "(3,) derivative of the rotation vector [rad/s]")
      .def_readwrite("rotation_acceleration", &AnchorMotion::rotation_acceleration,
                     "(3,) its second derivative [rad/s^2]");
}

void bind_anchors(Class& simulation) {
  simulation
      .def("anchor_motion", alone(&Simulation::anchor_motion), "name"_a,
           "The motion at `time` of an anchor of closed loops. Raises InputError, with the nearest "
           "name, if there is none.")
      .def("set_anchor_motion",
           alone(static_cast<void (Simulation::*)(std::string_view, const AnchorMotion&)>(
               &Simulation::set_anchor_motion)),
           "name"_a, "motion"_a,
           "Moves an anchor that the scenario leaves to the program from the next step on: "
           "accelerations stay as they are given. It must go on from where it is, with its rates.")
      .def(
          "set_anchor_course",
          [](UsedSimulation& s, const std::string& name, const std::array<Curve, 3>& translation,
             const std::array<Curve, 3>& rotation) {
            const Use use(s);
            const py::gil_scoped_release unlocked;
            s.set_anchor_course(
                name, {spatial::VectorTable{translation}, spatial::VectorTable{rotation}});
          },
          "name"_a, "translation"_a, "rotation"_a,
          "Moves it by functions of time: three curves or numbers each, of the translation [m] and "
          "the rotation vector [rad].");
}

void bind_joint_motion(py::module_& module) {
  py::class_<CoordinateMotion>(module, "CoordinateMotion",
                               "The motion of a coordinate of a joint at one time.")
      .def(py::init([](double value, double velocity, double acceleration) {
             return CoordinateMotion{value, velocity, acceleration};
           }),
           "value"_a = 0.0, "velocity"_a = 0.0, "acceleration"_a = 0.0)
      .def_readwrite("value", &CoordinateMotion::value, "[rad, m]")
      .def_readwrite("velocity", &CoordinateMotion::velocity, "[rad/s, m/s]")
      .def_readwrite("acceleration", &CoordinateMotion::acceleration, "[rad/s^2, m/s^2]");
}

void bind_joints(Class& simulation) {
  simulation
      .def("joint_index", alone(&Simulation::joint_index), "tree"_a, "name"_a,
           "The number of the joint of that name on a blade or subsystem, from 0. Raises "
           "InputError, with the nearest name, if there is none.")
      .def("joint_motion", alone(&Simulation::joint_motion), "tree"_a, "joint"_a,
           "coordinate"_a = 0,
           "The motion at `time` of a coordinate of a joint that is prescribed.")
      .def("set_joint_motion",
           alone(static_cast<void (Simulation::*)(int, int, int, const CoordinateMotion&)>(
               &Simulation::set_joint_motion)),
           "tree"_a, "joint"_a, "coordinate"_a, "motion"_a,
           "Moves a coordinate that the scenario leaves to the program from the next step on: the "
           "acceleration stays as it is given. It must go on from where it is, with its rate.")
      .def("set_joint_course", alone(&Simulation::set_joint_course), "tree"_a, "joint"_a,
           "coordinate"_a, "course"_a, "Moves it by a curve over time [s].")
      .def(
          "set_joint_torque",
          [](UsedSimulation& s, int tree, int joint, double torque, int coordinate) {
            const Use use(s);
            const py::gil_scoped_release unlocked;
            set_joint_torque(s, tree, joint, coordinate, torque);
          },
          "tree"_a, "joint"_a, "torque"_a, "coordinate"_a = 0,
          "Adds a torque [N m], or the force of a joint that slides [N], to what acts on a free "
          "coordinate of a joint, from the next step on and until it is set again.");
}

void bind_steps(Class& simulation) {
  simulation
      .def("step", alone(&Simulation::step),
           "Makes one time step. Raises DivergenceError, after which a saved state has to be "
           "restored, and LoadError.")
      .def("save", alone(&Simulation::save), "The state, a value: see restore().")
      .def("restore", &go_back, "state"_a, "courses"_a = py::none(),
           "Goes back, or on, to a state of any simulation of the same model, formulation and step "
           "size. With the courses() that were in force when it was saved, what follows has the "
           "bits of the run that was saved; without, it goes on with those in force now. Raises "
           "InputError if the state is of another model.")
      .def_property_readonly(
          "drive", [](const UsedSimulation& s) { return Drive(s.drive()); },
          "What moves the hub, of several rotors that of the first.")
      .def(
          "drive_of",
          [](const UsedSimulation& s, const std::string& rotor) { return Drive(s.drive(rotor)); },
          "rotor"_a, "What moves the hub of a rotor on a support, by its name.")
      .def("set_drive", alone(&Simulation::set_drive), "drive"_a, "rotor"_a = "",
           "Replaces what moves the hub, of several rotors that of the one by this name or the "
           "first, from the next step on. A new drive must go on from the hub's angle and speed, "
           "and prescribe the rotation if and only if the present one does.")
      .def(
          "set_load_factor",
          [](UsedSimulation& s, const std::string& load, double factor) {
            const Use use(s);
            const py::gil_scoped_release unlocked;
            set_load_factor(s, load, factor);
          },
          "load"_a, "factor"_a,
          "Multiplies the scenario's loads of a name by a factor from the next step on; 1 is what "
          "the scenario says.")
      .def(
          "set_load",
          [](UsedSimulation& s, int index, std::shared_ptr<Load> load) {
            const Use use(s);
            const py::gil_scoped_release unlocked;
            s.set_load(index, std::move(load));
          },
          "index"_a, "load"_a,
          "Replaces a load of those given at the start, counted from 0, by one with the same "
          "markers.");
}

}  // namespace

void bind_simulation(py::module_& module) {
  bind_saved_state(module);
  bind_query_results(module);
  bind_anchor_motion(module);
  bind_joint_motion(module);
  Class simulation(module, "Simulation");
  simulation.def(py::init(&make_simulation), "scenario"_a, "formulation"_a, "executor"_a,
                 "threads"_a, "window"_a, "loads"_a, "wind"_a, "controller"_a = py::none());
  simulation.def(py::init(&clone), "original"_a);
  bind_progress(simulation);
  bind_steps(simulation);
  bind_anchors(simulation);
  bind_joints(simulation);
  bind_queries(simulation);
}

}  // namespace spoke::python
