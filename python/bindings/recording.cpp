// Records rows, extremes and pictures of a run, and handles Ctrl-C.

#include "python/bindings/recording.h"

#include <pybind11/numpy.h>
#include <pybind11/stl.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <utility>

#include "models/error.h"
#include "program/run_report/html_file.h"
#include "python/bindings/bindings.h"
#include "python/bindings/load_exception.h"

namespace spoke::python {

namespace py = pybind11;
using Clock = std::chrono::steady_clock;

/// Asks Python now and then, during steps without the interpreter lock, whether a signal has come.
class SignalWatch {
 public:
  /// Python handles signals in its main thread alone: others need not ask.
  SignalWatch() {
    const py::module_ threading = py::module_::import("threading");
    is_main_ = threading.attr("current_thread")().is(threading.attr("main_thread")());
  }
  /// Returns true if a signal makes Python raise an exception.
  bool has_come() {
    if (!is_main_ || raised_ || ++calls_ < calls_between_) return raised_.has_value();
    calls_ = 0;
    const auto now = Clock::now();
    // A look at the clock costs 25 ns: for short steps, every 16th is enough.
    calls_between_ = now - looked_ < kShort ? std::min(2 * calls_between_, 16) : 1;
    looked_ = now;
    if (now < next_) return false;
    next_ = now + kPause;
    const py::gil_scoped_acquire lock;
    // The exception is taken from the interpreter.
    if (PyErr_CheckSignals() != 0) raised_.emplace();
    return raised_.has_value();
  }
  /// Throws the exception that was raised. The interpreter lock must be held.
  void rethrow() {
    if (raised_) throw std::move(*raised_);
  }

 private:
  static constexpr std::chrono::milliseconds kShort{1};
  static constexpr std::chrono::milliseconds kPause{50};
  bool is_main_ = false;
  int calls_ = 0;
  int calls_between_ = 1;
  Clock::time_point looked_ = Clock::now();
  Clock::time_point next_ = looked_ + kPause;
  std::optional<py::error_already_set> raised_;
};

Recording::Recording(std::shared_ptr<UsedSimulation> simulation, double every, bool has_page,
                     std::optional<double> statistics_from)
    : simulation_(std::move(simulation)),
      due_(every),
      statistics_(simulation_->sensor_names().size()),
      row_statistics_(*simulation_, statistics_from),
      tips_(*simulation_) {
  if (has_page) recorder_.emplace(*simulation_);
}

void Recording::add_row(double t, std::span<const double> sensors) {
  numbers_.push_back(t);
  numbers_.insert(numbers_.end(), sensors.begin(), sensors.end());
  row_statistics_.add_row(t, sensors);
  if (recorder_) recorder_->add_row(t, sensors);
}

void Recording::add(double t, std::span<const double> sensors) {
  statistics_.add(t, sensors);
  tips_.add(t, sensors);
  if (due_.is_due(t)) add_row(t, sensors);
}

/// Steps on, with stops to take pictures for the page.
template <class Observe>
void Recording::step_to(double until, const bool& is_stopped, const Observe& observe) {
  UsedSimulation& simulation = *simulation_;
  const run_report::PictureSteps pictures(simulation, recorder_->animation().most_frames());
  const double end = until - 0.5 * simulation.step_size();
  while (!is_stopped && !simulation.done() && simulation.time() < end) {
    const std::int64_t picture = pictures.next(simulation.steps());
    simulation.run_until(std::min(until, static_cast<double>(picture) * simulation.step_size()),
                         observe);
    if (simulation.steps() == picture) recorder_->add_picture(simulation);
  }
}

void Recording::step_to(double until, SignalWatch& watch) {
  bool is_stopped = false;
  const auto observe = [&](double t, std::span<const double> sensors) {
    add(t, sensors);
    if (is_stopped || !watch.has_come()) return;
    is_stopped = true;
    simulation_->stop();
  };
  if (recorder_)
    step_to(until, is_stopped, observe);
  else
    simulation_->run_until(until, observe);
}

/// Ends the recording. The last step is a row, also of a run that ended early.
void Recording::finish() {
  last_step_ = simulation_->steps();
  const double t = statistics_.last_time();
  if (numbers_[numbers_.size() - width()] < t) add_row(t, statistics_.final_values());
  numbers_.shrink_to_fit();
}

void Recording::keep_end() {
  try {
    last_ = simulation_->save();
  } catch (const InputError&) {  // of a controller that keeps data of its own
    last_.reset();
  }
  last_courses_ = courses(*simulation_);
}

void Recording::run(double until) {
  if (std::isnan(until)) throw InputError("until is not a number, expected a time [s]");
  const Use use(*simulation_);
  SignalWatch watch;
  const auto start = Clock::now();
  const auto took = [&] { return std::chrono::duration<double>(Clock::now() - start).count(); };
  {
    const py::gil_scoped_release unlocked;
    add(simulation_->time(), simulation_->sensor_values());
    if (recorder_) recorder_->add_picture(*simulation_);
    try {
      step_to(until, watch);
    } catch (const DivergenceError& error) {
      outcome_ = {took(), error.what()};
      finish();
      throw;
    } catch (const LoadException&) {  // of a controller
      outcome_.wall_time = took();
      finish();
      keep_end();
      const py::gil_scoped_acquire lock;
      if (PyErr_CheckSignals() != 0) throw py::error_already_set();  // for Ctrl-C within it
      throw;
    } catch (const LoadError&) {
      outcome_.wall_time = took();
      finish();
      keep_end();
      const py::gil_scoped_acquire lock;
      if (PyErr_CheckSignals() != 0) throw py::error_already_set();  // for Ctrl-C within the load
      throw;
    }
    outcome_.wall_time = took();
    finish();
    keep_end();
  }
  watch.rethrow();
}

/// Calls `make` with the simulation as it was when the run ended.
template <class Make>
std::string Recording::at_last_step(Make&& make) {
  const Use use(*simulation_);
  const py::gil_scoped_release unlocked;
  if (!last_) {
    if (!is_at_hand())
      throw StateError(
          "the simulation has left the end of the run, whose state was not kept: ask before it "
          "does, as after a divergence, or of a controller that does not save what it keeps");
    return make();
  }
  const SavedState present = simulation_->save();
  const Courses present_courses = courses(*simulation_);
  restore(*simulation_, *last_, last_courses_);
  const std::string text = make();
  restore(*simulation_, present, present_courses);
  return text;
}

std::string Recording::make_summary() {
  return at_last_step(
      [&] { return spoke::make_summary(*simulation_, statistics_, outcome_, row_statistics_); });
}

std::string Recording::make_page() {
  if (!recorder_) throw StateError("no page: the run was made with report=False");
  return at_last_step([&] {
    return run_report::make_html(*simulation_, statistics_, outcome_, tips_.summarise(), *recorder_,
                                 row_statistics_);
  });
}

void bind_recording(py::module_& module) {
  py::class_<Recording>(module, "Recording", "The sensors of a run at its output times.")
      .def(py::init<std::shared_ptr<UsedSimulation>, double, bool, std::optional<double>>())
      .def("run", &Recording::run)
      .def_property_readonly(
          "numbers",
          [](const py::object& self) {
            const auto& recording = self.cast<const Recording&>();
            const auto rows = static_cast<py::ssize_t>(recording.rows());
            const auto width = static_cast<py::ssize_t>(recording.width());
            py::array_t<double> view({rows, width}, recording.numbers().data(), self);
            view.attr("setflags")(false);  // since they are the recording's own numbers
            return view;
          },
          "(rows, 1 + sensors): time [s], then the sensors. A view: nothing is copied.")
      .def_property_readonly("names",
                             [](const Recording& r) { return r.simulation().sensor_names(); })
      .def_property_readonly("units",
                             [](const Recording& r) { return r.simulation().sensor_units(); })
      .def_property_readonly("wall_time", &Recording::wall_time)
      .def_property_readonly("has_page", &Recording::has_page)
      .def_property_readonly("is_at_hand", &Recording::is_at_hand)
      .def("make_summary", &Recording::make_summary)
      .def("make_page", &Recording::make_page);
}

}  // namespace spoke::python
