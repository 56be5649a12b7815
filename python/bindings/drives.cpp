// Binds the drives of the hub.

#include <pybind11/stl.h>

#include "models/drive.h"
#include "python/bindings/bindings.h"

namespace spoke::python {
namespace py = pybind11;
using namespace py::literals;

void bind_drives(py::module_& module) {
  py::class_<Curve>(module, "Curve",
                    "A smooth function of time through given points: monotone cubic interpolation, "
                    "constant before and after.")
      .def(py::init<double>(), "value"_a, "A constant.")
      .def(py::init<std::vector<double>, std::vector<double>>(), "times"_a, "values"_a,
           "Through `values` at `times` [s], which increase.")
      .def_property_readonly("times", &Curve::times, "Of its points [s].")
      .def_property_readonly("values", &Curve::values, "At its points.")
      .def("__call__", &Curve::value, "t"_a, "At time t [s].");
  py::implicitly_convertible<py::float_, Curve>();
  py::implicitly_convertible<py::int_, Curve>();

  py::class_<SpinUp>(module, "SpinUp", "A smooth start to a constant speed.")
      .def(py::init([](double speed, double ramp) {
             return SpinUp{speed, ramp};
           }),
           "speed"_a, "ramp"_a, "To `speed` [rad/s] within `ramp` [s].")
      .def_readonly("speed", &SpinUp::speed, "[rad/s]")
      .def_readonly("ramp", &SpinUp::ramp, "[s]");
  py::class_<SpinUpHoldSpinDown>(module, "SpinUpHoldSpinDown",
                                 "A smooth start, constant speed, and down to rest.")
      .def(py::init([](double speed, double ramp, double hold, double ramp_down) {
             return SpinUpHoldSpinDown{speed, ramp, hold, ramp_down};
           }),
           "speed"_a, "ramp"_a, "hold"_a, "ramp_down"_a,
           "To `speed` [rad/s] within `ramp`, held for `hold`, to rest within `ramp_down` [s].")
      .def_readonly("speed", &SpinUpHoldSpinDown::speed, "[rad/s]")
      .def_readonly("ramp", &SpinUpHoldSpinDown::ramp, "[s]")
      .def_readonly("hold", &SpinUpHoldSpinDown::hold, "[s]")
      .def_readonly("ramp_down", &SpinUpHoldSpinDown::ramp_down, "[s]");
  py::class_<SpeedTable>(module, "SpeedTable", "The hub's speed is a curve over time.")
      .def(py::init([](const Curve& speed) { return SpeedTable{speed}; }), "speed"_a, "[rad/s]")
      .def_readonly("speed", &SpeedTable::speed, "[rad/s]");
  py::class_<FixedDrive>(module, "FixedDrive", "The hub stands still.").def(py::init<>());
  py::class_<ConstantSpeed>(module, "ConstantSpeed", "The hub turns at one speed from t = 0 on.")
      .def(py::init([](double speed) { return ConstantSpeed{speed}; }), "speed"_a, "[rad/s]")
      .def_readonly("speed", &ConstantSpeed::speed, "[rad/s]");
  py::class_<TorqueDrive>(module, "TorqueDrive", "A torque acts on the hub.")
      .def(py::init([](const Curve& torque, double initial_speed) {
             return TorqueDrive{torque, initial_speed};
           }),
           "torque"_a, "initial_speed"_a = 0.0, "`torque` over time [N m]; [rad/s] at t = 0.")
      .def_readonly("torque", &TorqueDrive::torque, "[N m]")
      .def_readonly("initial_speed", &TorqueDrive::initial_speed, "[rad/s]");
  py::class_<TorqueBySpeed>(module, "TorqueBySpeed", "A motor or generator.")
      .def(py::init([](const Curve& torque, double initial_speed, double ramp) {
             return TorqueBySpeed{torque, initial_speed, ramp};
           }),
           "torque"_a, "initial_speed"_a = 0.0, "ramp"_a = 0.0,
           "`torque` [N m] over the hub's speed [rad/s], which takes the place of time; it rises "
           "within `ramp` [s].")
      .def_readonly("torque", &TorqueBySpeed::torque, "[N m] over [rad/s]")
      .def_readonly("initial_speed", &TorqueBySpeed::initial_speed, "[rad/s]")
      .def_readonly("ramp", &TorqueBySpeed::ramp, "[s]");
  py::class_<FreeDrive>(module, "FreeDrive", "Nothing acts on the hub's rotation.")
      .def(py::init([](double initial_speed) { return FreeDrive{initial_speed}; }),
           "initial_speed"_a = 0.0, "[rad/s] at t = 0.")
      .def_readonly("initial_speed", &FreeDrive::initial_speed, "[rad/s]");
}

}  // namespace spoke::python
