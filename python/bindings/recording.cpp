// Rows, extremes and pictures of a run, and Ctrl-C.

#include "python/bindings/recording.h"

#include <pybind11/numpy.h>
#include <pybind11/stl.h>

#include <chrono>
#include <cmath>
#include <utility>

#include "engine/run_report/html_file.h"
#include "engine/run_report/picture_steps.h"
#include "models/error.h"
#include "python/bindings/bindings.h"

namespace spoke::python {
namespace {

namespace py = pybind11;
using Clock = std::chrono::steady_clock;

/// Asks Python now and then, during steps without the interpreter lock, whether a signal has come.
class SignalWatch {
 public:
  /// True if Python raises what it has come to.
  bool has_come() {
    if (raised_ || ++calls_ % kCallsBetween != 0 || Clock::now() < next_) return raised_.has_value();
    next_ = Clock::now() + kPause;
    const py::gil_scoped_acquire lock;
    if (PyErr_CheckSignals() != 0) raised_.emplace();  // takes the exception from the interpreter
    return raised_.has_value();
  }
  /// Throws what was raised. The interpreter lock must be held.
  void rethrow() {
    if (raised_) throw std::move(*raised_);
  }

 private:
  static constexpr std::uint64_t kCallsBetween = 16;  // a look at the clock costs 25 ns
  static constexpr std::chrono::milliseconds kPause{50};
  std::uint64_t calls_ = 0;
  Clock::time_point next_ = Clock::now() + kPause;
  std::optional<py::error_already_set> raised_;
};

}  // namespace

Recording::Recording(std::shared_ptr<Simulation> simulation)
    : simulation_(std::move(simulation)),
      statistics_(simulation_->sensor_names().size()),
      recorder_(*simulation_) {}

std::unique_ptr<Recording> Recording::run(std::shared_ptr<Simulation> simulation, double until,
                                          double every) {
  OutputTimes due(every);
  std::unique_ptr<Recording> recording(new Recording(std::move(simulation)));
  recording->integrate(until, due);
  return recording;
}

void Recording::add_row(double t, std::span<const double> sensors) {
  numbers_.push_back(t);
  numbers_.insert(numbers_.end(), sensors.begin(), sensors.end());
  recorder_.add_row(t, sensors);
  last_row_ = t;
}

void Recording::add(double t, std::span<const double> sensors, OutputTimes& due) {
  statistics_.add(t, sensors);
  if (due.is_due(t)) add_row(t, sensors);
}

void Recording::integrate(double until, OutputTimes& due) {
  if (std::isnan(until)) throw InputError("until is not a number, expected a time [s]");
  Simulation& simulation = *simulation_;
  SignalWatch watch;
  add(simulation.time(), simulation.sensor_values(), due);
  recorder_.add_picture(simulation);
  const auto start = Clock::now();
  {
    const py::gil_scoped_release unlocked;
    const run_report::PictureSteps pictures(simulation, recorder_.animation().most_frames());
    const double end = until - 0.5 * simulation.step_size();
    bool is_stopped = false;
    const auto observe = [&](double t, std::span<const double> sensors) {
      add(t, sensors, due);
      if (!is_stopped && watch.has_come()) {
        is_stopped = true;
        simulation.stop();
      }
    };
    while (!is_stopped && !simulation.done() && simulation.time() < end) {
      const std::int64_t picture = pictures.next(simulation.steps());
      simulation.run_until(std::min(until, static_cast<double>(picture) * simulation.step_size()),
                           observe);
      if (simulation.steps() == picture) recorder_.add_picture(simulation);
    }
  }
  watch.rethrow();
  outcome_.wall_time = std::chrono::duration<double>(Clock::now() - start).count();
  if (last_row_ < simulation.time()) add_row(simulation.time(), simulation.sensor_values());
  last_step_ = simulation.steps();
}

void Recording::require_its_state() const {
  if (simulation_->steps() != last_step_)
    throw StateError("the simulation has gone on since the run ended: ask before it does");
}

std::string Recording::make_summary() const {
  require_its_state();
  return spoke::make_summary(*simulation_, statistics_, outcome_);
}

std::string Recording::make_page() const {
  require_its_state();
  return run_report::make_html(*simulation_, statistics_, outcome_, {}, recorder_);
}

void bind_recording(py::module_& module) {
  py::class_<Recording>(module, "Recording", "The sensors of a run at its output times.")
      .def_property_readonly(
          "numbers",
          [](const py::object& self) {
            const auto& recording = self.cast<const Recording&>();
            const auto rows = static_cast<py::ssize_t>(recording.rows());
            const auto width = static_cast<py::ssize_t>(recording.width());
            py::array_t<double> view({rows, width}, recording.numbers().data(), self);
            view.attr("setflags")(false);  // the recording's own numbers
            return view;
          },
          "(rows, 1 + sensors): time [s], then the sensors. A view: nothing is copied.")
      .def_property_readonly(
          "names", [](const Recording& r) { return r.simulation().sensor_names(); },
          "Of the sensors.")
      .def_property_readonly(
          "units", [](const Recording& r) { return r.simulation().sensor_units(); },
          "Of the sensors.")
      .def_property_readonly("wall_time", &Recording::wall_time, "Of the steps [s].")
      .def("make_summary", &Recording::make_summary, "The text of summary.json.")
      .def("make_page", &Recording::make_page, "The text of report.html.");
}

}  // namespace spoke::python
