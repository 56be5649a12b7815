// Calls the controller with the interpreter lock, and binds what it is given.

#include "python/bindings/controllers.h"

#include <pybind11/numpy.h>
#include <pybind11/stl.h>

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "python/bindings/bindings.h"
#include "python/bindings/run_in_python.h"

namespace spoke::python {
namespace {

namespace py = pybind11;

class PythonController final : public Controller {
 public:
  /// Precondition: the interpreter lock is held.
  explicit PythonController(py::object object) : object_(share(std::move(object))) {}

  void begin(const std::vector<std::string>& sensors) override {
    run_in_python([&] {
      if (py::hasattr(*object_, "begin")) object_->attr("begin")(sensors);
    });
  }
  void control(const ControlRecord& record, ControlCommands& commands) override {
    run_in_python([&] {
      const py::object call =
          py::hasattr(*object_, "control") ? py::object(object_->attr("control")) : *object_;
      call(record, py::cast(&commands, py::return_value_policy::reference));
    });
  }
  std::optional<std::string> save() const override {
    std::optional<std::string> saved;
    run_in_python([&] {
      if (is_saved()) saved = object_->attr("save")().cast<py::bytes>();
    });
    return saved;
  }
  void restore(const std::string& saved) override {
    run_in_python([&] { object_->attr("restore")(py::bytes(saved)); });
  }
  std::shared_ptr<Controller> clone() const override {
    std::shared_ptr<Controller> copy;
    run_in_python([&] {
      if (is_saved())
        copy = std::make_shared<PythonController>(
            py::module_::import("copy").attr("deepcopy")(*object_));
    });
    return copy;
  }

 private:
  bool is_saved() const {
    return py::hasattr(*object_, "save") && py::hasattr(*object_, "restore");
  }

  std::shared_ptr<const py::object> object_;
};

void bind_record(py::module_& module) {
  py::class_<ControlledBlade>(module, "ControlledBlade",
                              "What a controller is told of a blade or a subsystem on the hub.")
      .def_readonly("pitch", &ControlledBlade::pitch, "Angle of its pitch joints [rad].")
      .def_readonly("pitch_rate", &ControlledBlade::pitch_rate, "[rad/s]")
      .def_readonly("out_of_plane_moment", &ControlledBlade::out_of_plane_moment,
                    "At its root, that of forces along the axis [N m].")
      .def_readonly("in_plane_moment", &ControlledBlade::in_plane_moment,
                    "That of forces in the sense of rotation [N m].");
  py::class_<ControlRecord>(
      module, "ControlRecord",
      "What a controller is told at a sample. Speeds, angles and torques count in the sense in "
      "which the rotor turns, `direction` of the scenario.")
      .def_readonly("time", &ControlRecord::time, "[s]")
      .def_readonly("period", &ControlRecord::period, "To the next sample [s].")
      .def_readonly("is_first", &ControlRecord::is_first, "Whether it is the first sample.")
      .def_readonly("speed", &ControlRecord::speed, "Of the hub about its axle [rad/s].")
      .def_readonly("azimuth", &ControlRecord::azimuth, "Of the hub, from 0 to 2 pi [rad].")
      .def_readonly("drive_speed", &ControlRecord::drive_speed,
                    "Of what the drive turns, on the hub's side of a gearbox [rad/s].")
      .def_readonly("torque", &ControlRecord::torque,
                    "Of the drive, likewise; a generator's is negative [N m].")
      .def_readonly("shaft_torque", &ControlRecord::shaft_torque, "The sensor hub.torque [N m].")
      .def_readonly("wind_speed", &ControlRecord::wind_speed,
                    "Horizontal, where the hub was at the start [m/s].")
      .def_readonly("yaw", &ControlRecord::yaw, "Of the joint that yaws the support [rad].")
      .def_readonly("yaw_error", &ControlRecord::yaw_error,
                    "Angle of the wind from the rotor's axis, about the vertical [rad].")
      .def_readonly("fore_aft", &ControlRecord::fore_aft,
                    "Acceleration of the hub's origin along the axis, horizontal [m/s^2].")
      .def_readonly("side_side", &ControlRecord::side_side, "Across it, horizontal [m/s^2].")
      .def_readonly("blades", &ControlRecord::blades, "A ControlledBlade for each.")
      .def_property_readonly(
          "sensors",
          [](const ControlRecord& record) {
            return py::array_t<double>(static_cast<py::ssize_t>(record.sensors.size()),
                                       record.sensors.data());
          },
          "(sensors,) in the order of Simulation.sensor_names, a copy.");
}

}  // namespace

std::shared_ptr<Controller> make_python_controller(py::object object) {
  return std::make_shared<PythonController>(std::move(object));
}

void bind_controllers(py::module_& module) {
  bind_record(module);
  py::class_<ControlCommands>(module, "ControlCommands",
                              "What a controller demands: it holds until the next sample.")
      .def_readwrite("torque", &ControlCommands::torque,
                     "Of the drive, in place of the scenario's, on the hub's side of a gearbox; a "
                     "generator's is negative [N m].")
      .def_readwrite("pitch", &ControlCommands::pitch,
                     "Of each blade, a list that is set as a whole [rad].")
      .def_readwrite("yaw_rate", &ControlCommands::yaw_rate, "[rad/s]")
      .def_readwrite("brake", &ControlCommands::brake, "Share of the brake's torque, from 0 to 1.");
}

}  // namespace spoke::python
