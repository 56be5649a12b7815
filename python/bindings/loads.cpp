// Loads that are Python functions. They run in the threads of the executor, one at a time: whoever
// runs Python holds its interpreter lock.

#include "engine/load.h"

#include <pybind11/eigen.h>
#include <pybind11/numpy.h>
#include <pybind11/stl.h>

#include <memory>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "python/bindings/bindings.h"

namespace spoke::python {
namespace {

namespace py = pybind11;
using namespace py::literals;
using Rows = Eigen::Matrix<double, Eigen::Dynamic, 3, Eigen::RowMajor>;

/// A Python object that threads without the interpreter lock may drop.
std::shared_ptr<const py::object> share(py::object object) {
  return {new py::object(std::move(object)), [](const py::object* held) {
            const py::gil_scoped_acquire lock;
            delete held;
          }};
}

/// Calls `evaluate` with the interpreter lock; what Python raises leaves as its sentence, since
/// nobody may touch a Python exception without the lock.
template <class Evaluate>
void run_in_python(Evaluate&& evaluate) {
  std::string raised;
  {
    const py::gil_scoped_acquire lock;
    try {
      evaluate();
      return;
    } catch (py::error_already_set& error) {
      raised = error.what();
    } catch (const py::cast_error& error) {
      raised = std::string("what it returned is no sequence of (force, moment): ") + error.what();
    }
  }
  throw std::runtime_error(raised);
}

/// function(t, motions) -> [(force, moment), ...]
LoadFunction call_by_marker(py::function function) {
  return [held = share(std::move(function))](double t, std::span<const MarkerMotion> in,
                                             std::span<Wrench> out) {
    run_in_python([&] {
      const std::vector<MarkerMotion> motions(in.begin(), in.end());
      const py::object returned = (*held)(t, motions);
      const auto wrenches =
          returned.cast<std::vector<std::pair<Eigen::Vector3d, Eigen::Vector3d>>>();
      if (wrenches.size() != out.size())
        throw py::value_error("it returned " + std::to_string(wrenches.size()) +
                              " wrenches, expected one for each of " + std::to_string(out.size()) +
                              " markers");
      for (std::size_t k = 0; k < out.size(); ++k)
        out[k] = {wrenches[k].first, wrenches[k].second};
    });
  };
}

/// The motion of all markers in one array of each kind, and what acts on them.
struct MarkerArrays {
  explicit MarkerArrays(std::size_t n)
      : position(n, 3),
        velocity(n, 3),
        angular_velocity(n, 3),
        rotation(9 * n),
        force(Rows::Zero(static_cast<Eigen::Index>(n), 3)),
        moment(Rows::Zero(static_cast<Eigen::Index>(n), 3)) {}

  Rows position, velocity, angular_velocity;
  std::vector<double> rotation;  ///< by marker a matrix, row by row
  Rows force, moment;
};

MarkerArrays gather(std::span<const MarkerMotion> in) {
  MarkerArrays arrays(in.size());
  for (std::size_t k = 0; k < in.size(); ++k) {
    const auto row = static_cast<Eigen::Index>(k);
    arrays.position.row(row) = in[k].position.transpose();
    arrays.velocity.row(row) = in[k].velocity.transpose();
    arrays.angular_velocity.row(row) = in[k].angular_velocity.transpose();
    Eigen::Map<Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>(&arrays.rotation[9 * k]) =
        in[k].rotation;
  }
  return arrays;
}

/// function(t, motion, force, moment), which fills the last two.
LoadFunction call_at_once(py::function function) {
  return [held = share(std::move(function))](double t, std::span<const MarkerMotion> in,
                                             std::span<Wrench> out) {
    MarkerArrays arrays = gather(in);
    run_in_python([&] {
      const auto n = static_cast<py::ssize_t>(in.size());
      const auto rows = [n](Rows& numbers) { return py::array_t<double>({n, py::ssize_t{3}}, numbers.data()); };
      const py::object motion = py::module_::import("types").attr("SimpleNamespace")(
          "position"_a = rows(arrays.position), "velocity"_a = rows(arrays.velocity),
          "angular_velocity"_a = rows(arrays.angular_velocity),
          "rotation"_a = py::array_t<double>({n, py::ssize_t{3}, py::ssize_t{3}},
                                             arrays.rotation.data()));
      py::array_t<double> force = rows(arrays.force), moment = rows(arrays.moment);
      (*held)(t, motion, force, moment);
      for (std::size_t k = 0; k < out.size(); ++k)
        for (int i = 0; i < 3; ++i) {
          const auto row = static_cast<py::ssize_t>(k);
          out[k].force[i] = force.at(row, i);
          out[k].moment[i] = moment.at(row, i);
        }
    });
  };
}

void bind_motions(py::module_& module) {
  py::class_<Marker>(module, "Marker", "A point on the axis of a flexible body.")
      .def(py::init([](int blade, int body, double station) { return Marker{blade, body, station}; }),
           "blade"_a, "body"_a, "station"_a,
           "On body `body` of blade `blade`, both from 0, at `station`: 0 at the body's inboard "
           "end, 1 at its outboard end.")
      .def_readwrite("blade", &Marker::blade, "From 0.")
      .def_readwrite("body", &Marker::body, "From 0, at the root.")
      .def_readwrite("station", &Marker::station, "0 to 1 along the body.")
      .def("__eq__", [](const Marker& a, const Marker& b) { return a == b; })
      .def("__repr__", [](const Marker& marker) {
        return py::str("Marker(blade={}, body={}, station={})")
            .format(marker.blade, marker.body, marker.station);
      });
  py::class_<MarkerMotion>(module, "MarkerMotion",
                           "The motion of a marker's cross section, in the inertial frame.")
      .def_readonly("position", &MarkerMotion::position, "(3,) [m]")
      .def_readonly("rotation", &MarkerMotion::rotation,
                    "(3, 3), takes vectors from the section's frame to the inertial one.")
      .def_readonly("velocity", &MarkerMotion::velocity, "(3,) [m/s]")
      .def_readonly("angular_velocity", &MarkerMotion::angular_velocity, "(3,) [rad/s]");
  py::class_<Wrench>(module, "Wrench", "A force and a moment.")
      .def_readonly("force", &Wrench::force, "(3,) [N]")
      .def_readonly("moment", &Wrench::moment, "(3,) [N m]")
      .def("__repr__", [](const Wrench& wrench) {
        return py::str("Wrench(force={}, moment={})").format(wrench.force, wrench.moment);
      });
}

}  // namespace

void bind_loads(py::module_& module) {
  bind_motions(module);
  py::class_<Load, std::shared_ptr<Load>>(
      module, "Load",
      "A force and a moment at markers, by a Python function of time and of the markers' motion, in "
      "the inertial frame. It must be a function of its arguments alone. Loads run in the threads "
      "of the executor, one at a time, and cost some microseconds in every evaluation of the "
      "accelerations: for long runs write the load in C++.")
      .def(py::init([](std::string name, std::vector<Marker> markers, py::function function,
                       bool vectorized) {
             LoadFunction call = vectorized ? call_at_once(std::move(function))
                                            : call_by_marker(std::move(function));
             return std::const_pointer_cast<Load>(
                 make_load(std::move(name), std::move(markers), std::move(call)));
           }),
           "name"_a, "markers"_a, "function"_a, "vectorized"_a = false,
           "`function(t, motions)` returns a pair (force [N], moment [N m]) for each marker, "
           "`motions` being a list of MarkerMotion. With `vectorized`: `function(t, motion, force, "
           "moment)` fills the arrays `force` and `moment` of shape (markers, 3); `motion.position`, "
           "`velocity` and `angular_velocity` have that shape, `motion.rotation` (markers, 3, 3).")
      .def_property_readonly("name", &Load::name)
      .def_property_readonly("markers", &Load::markers);
}

}  // namespace spoke::python
