// Calls Python functions for the velocity of the wind.

#include "python/bindings/wind.h"

#include <pybind11/eigen.h>

#include <limits>
#include <string>
#include <utility>

namespace spoke::python {
namespace {

namespace py = pybind11;

class PythonWind : public WindField {
 public:
  explicit PythonWind(py::function function) : function_(std::move(function)) {}
  ~PythonWind() override {
    const py::gil_scoped_acquire lock;
    function_.release().dec_ref();
  }

  Eigen::Vector3d velocity(const Eigen::Vector3d& place, double t) const override {
    const py::gil_scoped_acquire lock;
    try {
      const py::object returned = function_(place, t);
      py::detail::make_caster<Eigen::Vector3d> numbers;
      if (numbers.load(returned, true)) return py::detail::cast_op<Eigen::Vector3d&>(numbers);
      throw py::type_error("the wind returned " + py::repr(returned).cast<std::string>() +
                           ", expected three numbers [m/s]");
    } catch (py::error_already_set& error) {
      if (error.matches(PyExc_KeyboardInterrupt)) PyErr_SetInterrupt();
      error.discard_as_unraisable("the wind");
    } catch (const py::builtin_exception& error) {
      error.set_error();
      PyErr_WriteUnraisable(function_.ptr());
    }
    return Eigen::Vector3d::Constant(std::numeric_limits<double>::quiet_NaN());
  }

 private:
  py::function function_;
};

}  // namespace

std::shared_ptr<const WindField> make_python_wind(py::function function) {
  return std::make_shared<PythonWind>(std::move(function));
}

}  // namespace spoke::python
