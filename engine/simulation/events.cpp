// Looks at conditions, and moves joints at the rates of events.

#include "engine/simulation/events.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <numeric>
#include <string>
#include <string_view>

#include "engine/bodies/kernels/pitch_control.h"
#include "models/error.h"
#include "models/support/nearest_name.h"
#include "models/system/spatial_system.h"

namespace spoke {
namespace {

/// Time between the demands of events on joints: within it their course turns smoothly to another
/// rate, over steps enough that these see it [s].
constexpr double kDemandPeriod = 0.1;

/// Returns the steps that last a time [s] or longer; a relative slack of 1e-9 keeps round values
/// from gaining one.
std::int64_t count_steps_of(double time, double step_size) {
  return static_cast<std::int64_t>(std::ceil(time / step_size * (1.0 - 1e-9)));
}

std::size_t find_column(const std::string& key, const std::string& name,
                        const std::vector<std::string>& names) {
  const auto found = std::find(names.begin(), names.end(), name);
  if (found != names.end()) return static_cast<std::size_t>(found - names.begin());
  const std::vector<std::string_view> views(names.begin(), names.end());
  throw InputError(key + ": the sensor " + describe_unknown(name, views), {.key = key});
}

/// Whether a joint that an event holds has come to rest where it is to be.
bool is_at_rest(const ControlState& state, const std::optional<double>& to) {
  const double last = state.demands.back();
  return (!to || *to == last) && std::all_of(state.demands.begin(), state.demands.end(),
                                             [last](double demand) { return demand == last; });
}

}  // namespace

Events::Events(const Scenario& scenario, double step_size, SimulatedModel& model)
    : step_size_(step_size),
      period_(static_cast<double>(count_sample_steps(kDemandPeriod, step_size)) * step_size),
      own_drive_(model.drive(0)) {
  const std::vector<Subsystem<Space>>& subsystems = model.space()->system.subsystems;
  for (std::size_t i = 0; i < subsystems.size(); ++i)
    if (!subsystems[i].controls.empty())
      (subsystems[i].controls.front().is_pitch ? pitched_ : yawed_).push_back(i);
  holds_.resize(subsystems.size());
  for (const Event& event : scenario.space->events) {
    Course course{event, parse_condition(event.when)};
    const std::string key = "event." + std::to_string(events_.size() + 1) + ".when";
    if (course.condition)
      course.sensor = find_column(key, course.condition->sensor, model.sensor_names());
    else
      course.at = count_steps_of(*event.at, step_size);
    course.delay = count_steps_of(event.delay, step_size);
    if (event.pitch)
      for (const int blade : event.pitch->blades)
        course.pitched.push_back(static_cast<std::size_t>(blade - 1));
    if (course.pitched.empty()) course.pitched = pitched_;
    events_.push_back(std::move(course));
  }
}

bool Events::reads_sensors() const {
  return std::any_of(events_.begin(), events_.end(),
                     [](const Course& course) { return course.condition && course.noticed < 0; });
}

bool Events::take(std::int64_t step, std::span<const double> sensors, SimulatedModel& model) {
  assert(is_due(step));
  const double t = static_cast<double>(step) * step_size_;
  bool changes_drive = false;
  for (Course& course : events_) {
    if (course.acted >= 0) continue;
    if (course.noticed < 0 &&
        (course.condition ? course.condition->holds(sensors[course.sensor]) : step >= course.at))
      course.noticed = step;
    if (course.noticed < 0 || step < course.noticed + course.delay) continue;
    course.acted = step;
    act(course);
    changes_drive = changes_drive || course.event.generator_off || course.event.brake > 0.0;
  }
  for (std::size_t i = 0; i < holds_.size(); ++i) {
    if (!holds_[i].is_held) continue;
    for (ControlState& state : model.space()->data.subsystems[i].controls) {
      if (holds_[i].is_new) hold_angle(t, period_, state);
      if (holds_[i].is_new || step >= next_demand(state)) move(holds_[i], t, state);
    }
    holds_[i].is_new = false;
  }
  taken_ = step;
  return changes_drive;
}

/// Puts in force what an event does; of the joints, what it demands of them.
void Events::act(const Course& course) {
  const Event& event = course.event;
  if (event.generator_off) generator_is_off_ = true;
  if (event.brake > 0.0) brake_ = {event.brake, event.brake_speed};
  if (event.pitch) hold(*event.pitch, course.pitched);
  if (event.yaw) hold(*event.yaw, yawed_);
  if (!event.controller_off) return;
  stops_controller_ = true;  // what no event moves stops where it is
  for (const std::vector<std::size_t>& subsystems : {pitched_, yawed_})
    for (const std::size_t i : subsystems)
      if (!holds_[i].is_held) holds_[i] = {true, true};
}

void Events::hold(const EventTurn& turn, const std::vector<std::size_t>& subsystems) {
  for (const std::size_t i : subsystems) holds_[i] = {true, true, turn.to, turn.rate.value_or(0.0)};
}

/// Demands the next angle of a joint, unless it has come to rest.
void Events::move(const Hold& hold, double t, ControlState& state) const {
  if (is_at_rest(state, hold.to)) return;
  const double last = state.demands.back(), most = hold.rate * period_;
  const double way = hold.to.value_or(last) - last;
  const bool arrives = std::abs(way) <= most;
  const double next = arrives ? hold.to.value_or(last) : last + std::copysign(most, way);
  demand_angle(next, t, period_, state);
}

/// Returns the step at whose end the course of a joint that is held needs a demand.
std::int64_t Events::next_demand(const ControlState& state) const {
  return std::llround((state.since + state.period) / step_size_);
}

std::int64_t Events::next(std::int64_t step, SimulatedModel& model) const {
  std::int64_t next = std::numeric_limits<std::int64_t>::max();
  for (const Course& course : events_) {
    if (course.acted >= 0) continue;
    if (course.noticed < 0 && course.condition) return step + 1;
    const std::int64_t begin = course.noticed < 0 ? course.at : course.noticed + course.delay;
    next = std::min(next, std::max(step + 1, begin));
  }
  for (std::size_t i = 0; i < holds_.size(); ++i)
    if (holds_[i].is_held)
      for (const ControlState& state : model.space()->data.subsystems[i].controls)
        if (!is_at_rest(state, holds_[i].to))
          next = std::min(next, std::max(step + 1, next_demand(state)));
  return next;
}

Drive Events::act_on(const Drive& drive) const {
  Drive left = drive;
  if (generator_is_off_) left = TorqueDrive{Curve(0.0), calc_initial_speed(drive)};
  if (brake_.torque == 0.0) return left;
  if (std::holds_alternative<FreeDrive>(left))
    left = TorqueDrive{Curve(0.0), calc_initial_speed(drive)};
  if (auto* torque = std::get_if<TorqueDrive>(&left)) torque->brake = brake_;
  if (auto* by_speed = std::get_if<TorqueBySpeed>(&left)) by_speed->brake = brake_;
  return left;
}

std::vector<EventInRun> Events::in_run() const {
  std::vector<EventInRun> all;
  for (std::size_t k = 0; k < events_.size(); ++k) {
    EventInRun& made = all.emplace_back();
    made.name = name_of_event(events_[k].event, k);
    if (events_[k].acted >= 0) made.time = static_cast<double>(events_[k].acted) * step_size_;
  }
  return all;
}

void Events::save(std::vector<double>& values) const {
  values.push_back(static_cast<double>(taken_));
  for (const Course& course : events_) {
    values.push_back(static_cast<double>(course.noticed));
    values.push_back(static_cast<double>(course.acted));
  }
}

bool Events::is_possible(std::span<const double> saved, std::int64_t steps) const {
  if (saved.size() != count_saved()) return false;
  const auto is_step = [steps](double value) {
    return value >= -1.0 && value <= static_cast<double>(steps) && value == std::floor(value);
  };
  if (!std::all_of(saved.begin(), saved.end(), is_step)) return false;
  for (std::size_t k = 1; k < saved.size(); k += 2)  // none acts before it is noticed
    if (saved[k + 1] >= 0.0 && (saved[k] < 0.0 || saved[k + 1] < saved[k])) return false;
  return true;
}

void Events::restore(std::span<const double> saved) {
  taken_ = static_cast<std::int64_t>(saved[0]);
  for (std::size_t k = 0; k < events_.size(); ++k) {
    events_[k].noticed = static_cast<std::int64_t>(saved[2 * k + 1]);
    events_[k].acted = static_cast<std::int64_t>(saved[2 * k + 2]);
  }
  std::fill(holds_.begin(), holds_.end(), Hold{});
  stops_controller_ = generator_is_off_ = false;
  brake_ = {};
  std::vector<std::size_t> order(events_.size());  // of acting; at one step that of the list
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [this](std::size_t a, std::size_t b) {
    return events_[a].acted < events_[b].acted;
  });
  for (const std::size_t k : order)
    if (events_[k].acted >= 0) act(events_[k]);
  for (Hold& hold : holds_) hold.is_new = false;
}

std::unique_ptr<Events> make_events(const Scenario& scenario, double step_size,
                                    SimulatedModel& model) {
  if (!scenario.space || scenario.space->events.empty()) return nullptr;
  return std::make_unique<Events>(scenario, step_size, model);
}

}  // namespace spoke
