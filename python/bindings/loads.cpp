// Binds loads that are Python functions. They run in the threads of the executor, one at a time,
// since each holds the interpreter lock.

#include <pybind11/eigen.h>
#include <pybind11/numpy.h>
#include <pybind11/stl.h>

#include <memory>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "engine/load.h"
#include "models/scenario.h"
#include "python/bindings/bindings.h"
#include "python/bindings/run_in_python.h"

namespace spoke::python {
namespace {

namespace py = pybind11;
using namespace py::literals;
using Numbers = py::array_t<double>;

/// Wraps function(t, motions) -> [(force, moment), ...]
LoadFunction call_by_marker(py::function function) {
  return [held = share(std::move(function))](double t, std::span<const MarkerMotion> in,
                                             std::span<Wrench> out) {
    run_in_python([&] {
      const py::object returned = (*held)(t, std::vector<MarkerMotion>(in.begin(), in.end()));
      using Pairs = std::vector<std::pair<Eigen::Vector3d, Eigen::Vector3d>>;
      py::detail::make_caster<Pairs> pairs;
      const std::string expected =
          "expected a pair (force, moment) of three numbers each for "
          "each of " +
          std::to_string(out.size()) + " markers";
      if (!pairs.load(returned, true))
        throw py::type_error("it returned " + py::repr(returned).cast<std::string>() + ", " +
                             expected);
      const auto& wrenches = py::detail::cast_op<Pairs&>(pairs);
      if (wrenches.size() != out.size())
        throw py::value_error("it returned " + std::to_string(wrenches.size()) + ", " + expected);
      for (std::size_t k = 0; k < out.size(); ++k) out[k] = {wrenches[k].first, wrenches[k].second};
    });
  };
}

/// The motion of all markers, in one array of each kind.
struct MarkerMotions {
  Numbers position, rotation, velocity, angular_velocity;
};

Numbers make_vectors(std::size_t markers) {
  return Numbers({static_cast<py::ssize_t>(markers), py::ssize_t{3}});
}

MarkerMotions gather(std::span<const MarkerMotion> in) {
  const auto n = static_cast<py::ssize_t>(in.size());
  MarkerMotions motions{make_vectors(in.size()), Numbers({n, py::ssize_t{3}, py::ssize_t{3}}),
                        make_vectors(in.size()), make_vectors(in.size())};
  for (std::size_t k = 0; k < in.size(); ++k) {
    Eigen::Map<Eigen::Vector3d>(motions.position.mutable_data() + 3 * k) = in[k].position;
    Eigen::Map<Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>(motions.rotation.mutable_data() +
                                                             9 * k) = in[k].rotation;
    Eigen::Map<Eigen::Vector3d>(motions.velocity.mutable_data() + 3 * k) = in[k].velocity;
    Eigen::Map<Eigen::Vector3d>(motions.angular_velocity.mutable_data() + 3 * k) =
        in[k].angular_velocity;
  }
  return motions;
}

/// Wraps function(t, motions, force, moment), which fills the last two.
LoadFunction call_at_once(py::function function) {
  return [held = share(std::move(function))](double t, std::span<const MarkerMotion> in,
                                             std::span<Wrench> out) {
    run_in_python([&] {
      Numbers force = make_vectors(out.size()), moment = make_vectors(out.size());
      std::fill_n(force.mutable_data(), force.size(), 0.0);
      std::fill_n(moment.mutable_data(), moment.size(), 0.0);
      (*held)(t, gather(in), force, moment);
      for (std::size_t k = 0; k < out.size(); ++k)
        out[k] = {Eigen::Map<const Eigen::Vector3d>(force.data() + 3 * k),
                  Eigen::Map<const Eigen::Vector3d>(moment.data() + 3 * k)};
    });
  };
}

std::shared_ptr<Load> make_python_load(std::string name, std::vector<Marker> markers,
                                       py::function function, bool vectorized) {
  LoadFunction call =
      vectorized ? call_at_once(std::move(function)) : call_by_marker(std::move(function));
  return std::const_pointer_cast<Load>(
      make_load(std::move(name), std::move(markers), std::move(call)));
}

void bind_marker(py::module_& module) {
  py::class_<Marker>(
      module, "Marker",
      "A point on the axis of a flexible body; in space also one of a rigid body, or an "
      "interface of a solid.")
      .def(py::init([](int blade, int body, double station, const Eigen::Vector3d& point,
                       std::string interface) {
             return Marker{blade, body, station, point, std::move(interface)};
           }),
           "blade"_a, "body"_a, "station"_a = 0.0, "point"_a = Eigen::Vector3d::Zero().eval(),
           "interface"_a = "",
           "On body `body` of blade `blade`, both from 0 (in space the subsystems follow behind "
           "the blades), at `station`: 0 at the body's inboard end, 1 at its outboard end. On a "
           "rigid body at `point` in its frame, (3,) [m]. On a solid at `interface`, by its name; "
           "without one, the only one that does not carry its frame.")
      .def_readonly("blade", &Marker::blade, "From 0.")
      .def_readonly("body", &Marker::body, "From 0, at the root.")
      .def_readonly("station", &Marker::station, "0 to 1 along the body.")
      .def_readonly("point", &Marker::point, "On a rigid body, in its frame, (3,) [m].")
      .def_readonly("interface", &Marker::interface, "Of a solid, by name; else empty.")
      .def("__eq__", [](const Marker& a, const Marker& b) { return a == b; })
      .def("__hash__",
           [](const Marker& m) {
             return py::hash(py::make_tuple(m.blade, m.body, m.station, m.point.x(), m.point.y(),
                                            m.point.z(), m.interface));
           })
      .def("__repr__", [](const Marker& marker) {
        return py::str("Marker(blade={}, body={}, station={})")
            .format(marker.blade, marker.body, marker.station);
      });
  module.def(
      "markers_at",
      [](const Scenario& scenario, int blade, const std::vector<double>& positions) {
        return markers_at(scenario, blade, positions);
      },
      "scenario"_a, "blade"_a, "positions"_a,
      "The markers at distances from the root of a blade, counted from 0 [m]; in space at stations "
      "of its beam. Where two bodies meet, on the inner one. Raises InputError if there is no such "
      "blade, or a place is not on it.");
}

void bind_motions(py::module_& module) {
  py::class_<MarkerMotion>(module, "MarkerMotion",
                           "The motion of a marker's cross section, in the inertial frame.")
      .def_readonly("position", &MarkerMotion::position, "(3,) [m]")
      .def_readonly("rotation", &MarkerMotion::rotation,
                    "(3, 3), takes vectors from the section's frame to the inertial one.")
      .def_readonly("velocity", &MarkerMotion::velocity, "(3,) [m/s]")
      .def_readonly("angular_velocity", &MarkerMotion::angular_velocity, "(3,) [rad/s]");
  py::class_<MarkerMotions>(module, "MarkerMotions",
                            "The motion of all markers of a load, in the inertial frame.")
      .def_readonly("position", &MarkerMotions::position, "(markers, 3) [m]")
      .def_readonly("rotation", &MarkerMotions::rotation,
                    "(markers, 3, 3), take vectors from the sections' frames to the inertial one.")
      .def_readonly("velocity", &MarkerMotions::velocity, "(markers, 3) [m/s]")
      .def_readonly("angular_velocity", &MarkerMotions::angular_velocity, "(markers, 3) [rad/s]");
  py::class_<MarkerState, MarkerMotion>(module, "MarkerState", "What is known of a marker.")
      .def_readonly("acceleration", &MarkerState::acceleration, "(3,) [m/s^2]")
      .def_readonly("angular_acceleration", &MarkerState::angular_acceleration, "(3,) [rad/s^2]")
      .def_readonly("deflection", &MarkerState::deflection,
                    "(3,) from its place on the undeformed blade, in the hub frame [m]");
  py::class_<Wrench>(module, "Wrench", "A force and a moment.")
      .def_readonly("force", &Wrench::force, "(3,) [N]")
      .def_readonly("moment", &Wrench::moment, "(3,) [N m]")
      .def("__repr__", [](const Wrench& wrench) {
        return py::str("Wrench(force={}, moment={})").format(wrench.force, wrench.moment);
      });
}

}  // namespace

void bind_loads(py::module_& module) {
  bind_marker(module);
  bind_motions(module);
  py::class_<Load, std::shared_ptr<Load>>(
      module, "Load",
      "A force and a moment at markers, by a Python function of time and of the markers' motion, "
      "in "
      "the inertial frame. It must be a function of its arguments alone. Loads run in the threads "
      "of the executor, one at a time, and cost some microseconds in every evaluation of the "
      "accelerations: for long runs write the load in C++.")
      .def(py::init(&make_python_load), "name"_a, "markers"_a, "function"_a, "vectorized"_a = false,
           "`function(t, motions)` returns a pair (force [N], moment [N m]) for each marker, "
           "`motions` being a list of MarkerMotion, t the time [s]. With `vectorized`, "
           "`function(t, motions, force, moment)` fills the arrays `force` [N] and `moment` [N m] "
           "of shape (markers, 3), which are zero, and `motions` is a MarkerMotions. The moment is "
           "about the marker.")
      .def_property_readonly("name", &Load::name)
      .def_property_readonly("markers", &Load::markers);
}

}  // namespace spoke::python
