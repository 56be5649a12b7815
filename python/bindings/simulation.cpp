// Scenario and Simulation.

#include "engine/simulation.h"

#include <pybind11/eigen.h>
#include <pybind11/numpy.h>
#include <pybind11/stl.h>

#include <limits>
#include <optional>
#include <string>

#include "engine/checkpoint.h"
#include "models/error.h"
#include "python/bindings/bindings.h"
#include "python/bindings/recording.h"

namespace spoke::python {
namespace {

namespace py = pybind11;
using namespace py::literals;
using Unlocked = py::call_guard<py::gil_scoped_release>;

Formulation formulation_of(const std::string& name) {
  std::string names;
  for (const Formulation formulation :
       {Formulation::structured, Formulation::subsystem, Formulation::augmented}) {
    if (name == name_of(formulation)) return formulation;
    names += (names.empty() ? "\"" : ", \"") + std::string(name_of(formulation)) + '"';
  }
  throw InputError("formulation: \"" + name + "\", expected one of " + names);
}

std::shared_ptr<Simulation> make_simulation(const Scenario& scenario,
                                            const std::string& formulation,
                                            const std::string& executor,
                                            std::pair<int, int> threads, int window,
                                            const std::vector<std::shared_ptr<Load>>& loads) {
  SimulationOptions options;
  options.formulation = formulation_of(formulation);
  options.executor = graph::executor_kind(executor);
  options.threads = {threads.first, threads.second};
  options.window = window;
  const Loads all(loads.begin(), loads.end());
  const py::gil_scoped_release unlocked;  // loads of Python's are evaluated
  return std::make_shared<Simulation>(scenario, options, all);
}

py::array_t<double> copy_of(std::span<const double> numbers) {
  return py::array_t<double>(static_cast<py::ssize_t>(numbers.size()), numbers.data());
}

void bind_scenario(py::module_& module) {
  py::class_<Scenario>(module, "Scenario", "Everything about a simulation that a file says.")
      .def_static("_read", &read_scenario, "file"_a, "overrides"_a)
      .def_static("_parse", &parse_scenario, "text"_a, "name"_a, "overrides"_a)
      .def_readonly("title", &Scenario::title)
      .def_readonly("name", &Scenario::name, "Of the file, without its ending.")
      .def_property_readonly(
          "duration", [](const Scenario& s) { return s.integration.duration; }, "[s]")
      .def_property_readonly(
          "output_interval", [](const Scenario& s) { return s.output.interval; }, "[s]");
}

void bind_queries(py::class_<Simulation, std::shared_ptr<Simulation>>& simulation) {
  simulation
      .def_property_readonly("sensor_names", &Simulation::sensor_names)
      .def_property_readonly("sensor_units", &Simulation::sensor_units, "In the same order.")
      .def_property_readonly(
          "sensors", [](const Simulation& s) { return copy_of(s.sensor_values()); },
          "(sensors,): all sensors at `time`, a copy.")
      .def("sensor", &Simulation::sensor, "name"_a, "One sensor at `time`.")
      .def("marker", &Simulation::marker, "marker"_a, Unlocked(),
           "Motion and deflection of a point anywhere on a body.")
      .def("joint_reaction", &Simulation::joint_reaction, "blade"_a, "joint"_a, Unlocked(),
           "What the joint inboard of a body (0: at the hub) does to the body, about the joint, in "
           "the inertial frame. Both count from 0.")
      .def("hub_reaction", &Simulation::hub_reaction, Unlocked(),
           "What support and drive do to the hub, about its axis, in the inertial frame.")
      .def("section_force", &Simulation::section_force, "marker"_a, Unlocked(),
           "What the part of a blade outboard of a section does to the part inboard, in the frame "
           "of the section.")
      .def_property_readonly(
          "warnings",
          [](const Simulation& s) {
            std::vector<std::string> texts;
            for (const Warning& warning : s.warnings()) texts.push_back(warning.text);
            return texts;
          },
          "What makes the results doubtful so far: sentences.");
}

void bind_steps(py::class_<Simulation, std::shared_ptr<Simulation>>& simulation) {
  simulation.def("step", &Simulation::step, Unlocked(), "Makes one time step.")
      .def(
          "_run",
          [](const std::shared_ptr<Simulation>& s, double until, double every) {
            return Recording::run(s, until, every);
          },
          "until"_a, "every"_a)
      .def("save", &Simulation::save, "The state, a value: see restore().")
      .def("restore", &Simulation::restore, "state"_a,
           "Goes back, or on, to a state of any simulation of the same model, formulation and step "
           "size: what follows has the bits of the run that was saved.")
      .def_property("drive", &Simulation::drive, &Simulation::set_drive,
                    "What moves the hub. A new drive must go on from the hub's angle and speed, "
                    "and prescribe the rotation if and only if the present one does.")
      .def(
          "set_load",
          [](Simulation& s, int index, const std::shared_ptr<Load>& load) {
            s.set_load(index, load);
          },
          "index"_a, "load"_a, Unlocked(),
          "Replaces a load of those given at the start by one with the same markers.");
}

}  // namespace

void bind_simulation(py::module_& module) {
  bind_scenario(module);
  py::class_<MarkerState, MarkerMotion>(module, "MarkerState", "What is known of a marker.")
      .def_readonly("acceleration", &MarkerState::acceleration, "(3,) [m/s^2]")
      .def_readonly("angular_acceleration", &MarkerState::angular_acceleration, "(3,) [rad/s^2]")
      .def_readonly("deflection", &MarkerState::deflection,
                    "(3,) from its place on the undeformed blade, in the hub frame [m]");
  py::class_<SavedState>(module, "SavedState", "The state of a simulation between two steps.")
      .def_readonly("time", &SavedState::time, "[s]")
      .def_readonly("steps", &SavedState::steps, "Made since t = 0.")
      .def("to_file", [](const SavedState& state, const std::string& file) {
        save_checkpoint(file, state);
      }, "file"_a, "Writes a checkpoint: the old file or the new one as a whole.")
      .def_static("from_file", [](const std::string& file) { return load_checkpoint(file).state; },
                  "file"_a, "Reads a checkpoint, also one of `spoke run`.")
      .def(py::pickle(
          [](const SavedState& state) { return py::bytes(make_checkpoint(state)); },
          [](const py::bytes& bytes) {
            return parse_checkpoint(std::string(bytes), "pickled state").state;
          }));
  py::class_<Simulation, std::shared_ptr<Simulation>> simulation(module, "Simulation");
  simulation.def(py::init(&make_simulation), "scenario"_a, "formulation"_a, "executor"_a,
                 "threads"_a, "window"_a, "loads"_a)
      .def_property_readonly("scenario", &Simulation::scenario)
      .def_property_readonly("time", &Simulation::time, "[s]")
      .def_property_readonly("step_size", &Simulation::step_size, "[s]")
      .def_property_readonly("steps", &Simulation::steps, "Done so far.")
      .def_property_readonly("planned_steps", &Simulation::planned_steps, "In all.")
      .def_property_readonly("evaluations", &Simulation::evaluations,
                             "Of the accelerations, so far.")
      .def_property_readonly("done", &Simulation::done, "Whether the duration is over.")
      .def_property_readonly("executor", &Simulation::executor_description,
                             "What runs the steps, in one line.")
      .def_property_readonly("state_hash", &Simulation::state_hash,
                             "64-bit hash of the state, as in summary.json.")
      .def_property_readonly(
          "coordinates", [](const Simulation& s) { return s.size().coordinates; },
          "Independent coordinates: free ones of the hub, and all deformations.");
  bind_steps(simulation);
  bind_queries(simulation);
}

}  // namespace spoke::python
