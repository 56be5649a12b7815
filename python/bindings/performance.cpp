// Binds the performance of rotors in wind.

#include "engine/performance.h"

#include <pybind11/numpy.h>
#include <pybind11/stl.h>

#include <algorithm>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "program/steady_report/performance_files.h"
#include "python/bindings/bindings.h"
#include "python/bindings/results.h"

namespace spoke::python {
namespace {

namespace py = pybind11;
using namespace py::literals;

/// Operating points, and further data of their page.
struct Performance {
  PerformanceResult result;
  std::size_t pitches = 1;  ///< of a map: points with the same tip-speed ratio
  std::string title;
};

/// Returns the shape of the arrays: of a map by tip-speed ratio and pitch.
std::vector<py::ssize_t> array_shape(const Performance& performance) {
  const auto points = static_cast<py::ssize_t>(performance.result.points.size());
  if (!performance.result.is_map) return {points};
  const auto pitches = static_cast<py::ssize_t>(performance.pitches);
  return {points / pitches, pitches};
}

/// Returns a property: the values of a member by point. What is found is not a number where there
/// is no steady state; what is asked for is always there.
auto values_of(double PerformancePoint::*member, bool is_found = true) {
  return [member, is_found](const Performance& performance) {
    py::array_t<double> numbers(array_shape(performance));
    double* to = numbers.mutable_data();
    for (const PerformancePoint& point : performance.result.points)
      *to++ =
          is_found && !point.gap.empty() ? std::numeric_limits<double>::quiet_NaN() : point.*member;
    return numbers;
  };
}

std::vector<std::string> gaps_of(const Performance& performance) {
  std::vector<std::string> gaps;
  for (const PerformancePoint& point : performance.result.points) gaps.push_back(point.gap);
  return gaps;
}

std::string describe(const Performance& performance) {
  const std::vector<PerformancePoint>& points = performance.result.points;
  const auto gaps = std::count_if(points.begin(), points.end(),
                                  [](const PerformancePoint& p) { return !p.gap.empty(); });
  std::string text = "<spoke.Performance " + counted_text(points.size(), "point");
  text += performance.result.is_map ? " by tip-speed ratio and pitch" : " by wind";
  if (gaps > 0) text += ", " + std::to_string(gaps) + " without a steady state";
  return text + ">";
}

Performance solve_points(const Scenario& scenario, std::vector<double> wind,
                         std::vector<double> tip_speed_ratio, std::vector<double> pitch,
                         std::string joint, bool is_rigid, std::string rotor) {
  const std::size_t pitches = std::max<std::size_t>(1, pitch.size());
  const PerformanceOptions options{.wind = std::move(wind),
                                   .tip_speed_ratio = std::move(tip_speed_ratio),
                                   .pitch = std::move(pitch),
                                   .joint = std::move(joint),
                                   .is_rigid = is_rigid,
                                   .rotor = std::move(rotor),
                                   .progress = [](std::size_t) {
                                     const py::gil_scoped_acquire lock;
                                     if (PyErr_CheckSignals() != 0) throw py::error_already_set();
                                   }};
  return {solve_performance(scenario, options), pitches, title_of(scenario)};
}

}  // namespace

void bind_performance(py::module_& module) {
  py::class_<Performance>(module, "Performance",
                          "Steady states of a rotor in wind. Arrays are (winds,), or of a map "
                          "(tip-speed ratios, pitches); what is found is not a number where there "
                          "is no steady state.")
      .def_property_readonly("wind", values_of(&PerformancePoint::wind, false),
                             "Speed of the wind at the hub [m/s].")
      .def_property_readonly("speed", values_of(&PerformancePoint::speed), "Of the hub [rad/s].")
      .def_property_readonly("tip_speed_ratio", values_of(&PerformancePoint::tip_speed_ratio),
                             "Undeformed radius times speed by wind.")
      .def_property_readonly("pitch", values_of(&PerformancePoint::pitch),
                             "Angle of the pitch joints [rad].")
      .def_property_readonly("thrust", values_of(&PerformancePoint::thrust),
                             "Of the air on the blades, along the axis [N].")
      .def_property_readonly("torque", values_of(&PerformancePoint::torque),
                             "Of the air on the blades, about the axis [N m].")
      .def_property_readonly("power", values_of(&PerformancePoint::power),
                             "Torque times speed [W].")
      .def_property_readonly("thrust_coefficient", values_of(&PerformancePoint::thrust_coefficient))
      .def_property_readonly("power_coefficient", values_of(&PerformancePoint::power_coefficient))
      .def_property_readonly("tip_displacement", values_of(&PerformancePoint::tip_displacement),
                             "Of the first blade's tip along the axis [m].")
      .def_property_readonly("gaps", &gaps_of,
                             "By point why there is no steady state, the pitch running fastest; "
                             "empty where there is one.")
      .def_property_readonly(
          "is_map", [](const Performance& p) { return p.result.is_map; },
          "Whether it is over tip-speed ratio and pitch.")
      .def_property_readonly(
          "radius", [](const Performance& p) { return p.result.radius; },
          "Of the undeformed tip [m].")
      .def_property_readonly(
          "density", [](const Performance& p) { return p.result.density; }, "Of the air [kg/m^3].")
      .def(
          "page", [](const Performance& p) { return steady_report::make_html(p.result, p.title); },
          "performance.html: one page without network.")
      .def("__repr__", [](const Performance& p) { return describe(p); });
  module.def("_solve_performance", &solve_points, py::call_guard<py::gil_scoped_release>());
}

}  // namespace spoke::python
