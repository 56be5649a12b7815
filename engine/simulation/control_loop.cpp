// Takes samples, and puts what is demanded into the table and the drive.

#include "engine/simulation/control_loop.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <sstream>
#include <string>
#include <utility>

#include "engine/bodies/kernels/pitch_control.h"
#include "engine/simulation/bladed_library.h"
#include "engine/simulation/turbine_controller.h"
#include "models/error.h"
#include "models/tree/tree.h"

namespace spoke {
namespace {

constexpr std::size_t kNumbers = 5;  // of a saved loop, before the angles

/// Returns how errors name a controller: control.library "file", or control.program.
std::string name_of(const OuterControl& place) {
  std::string name(place.table());
  if (place.is_library()) name += " \"" + place.file + '"';
  return name;
}

/// Returns the azimuths of the trees on the hub of the first rotor, blades before subsystems, in
/// the sense of rotation [rad].
std::vector<double> find_azimuths(const spatial::Model& model, double direction) {
  std::vector<double> azimuths;
  const std::vector<spatial::Tree> trees = spatial::build_trees(model);
  for (std::size_t i = 0; i < trees.size(); ++i)
    if (trees[i].rotor == 0 && !(model.support && i + 1 == trees.size()))
      azimuths.push_back(direction * trees[i].azimuth);
  return azimuths;
}

}  // namespace

ControlLoop::ControlLoop(const Scenario& scenario, double step_size,
                         std::shared_ptr<Controller> controller, SimulatedModel& model)
    : place_(&*scenario.space->outer_control),
      step_size_(step_size),
      every_(count_sample_steps(place_->period, step_size)),
      period_(static_cast<double>(every_) * step_size),
      controller_(std::move(controller)),
      measurement_(scenario, model),
      own_drive_(model.drive(0)) {
  commands_.pitch.assign(measurement_.blades().size(), place_->initial);
  commands_.torque =
      place_->direction * calc_torque(own_drive_, 0.0, calc_initial_speed(own_drive_));
  controller_->begin(model.sensor_names());
}

void ControlLoop::require_possible(const ControlCommands& commands, double t,
                                   std::int64_t step) const {
  const auto fail = [&](const std::string& what, const std::string& expected) {
    std::ostringstream text;
    text << "diverged at t = " << t << " s, step " << step << ": " << name_of(*place_) << ' '
         << what << ", expected " << expected;
    throw DivergenceError(text.str(), {.time = t, .step = step, .quantity = "control"});
  };
  const auto require_finite = [&](double value, const char* what) {
    if (!std::isfinite(value))
      fail(std::string("demands a ") + what + " that is not finite", "a number");
  };
  require_finite(commands.torque, "torque");
  require_finite(commands.yaw_rate, "rate of yaw");
  for (const double pitch : commands.pitch) require_finite(pitch, "pitch angle");
  if (!(commands.brake >= 0.0 && commands.brake <= 1.0))
    fail("demands " + std::to_string(commands.brake) + " of the brake", "0 to 1");
  if (commands.pitch.size() != measurement_.blades().size())
    fail("demands " + std::to_string(commands.pitch.size()) + " pitch angles",
         "one of each of " + std::to_string(measurement_.blades().size()) + " blades");
}

DemandedDrive ControlLoop::sample(std::int64_t step, const Scenario& scenario,
                                  std::span<const double> sensors, SimulatedModel& model) {
  assert(is_due(step));
  const double t = static_cast<double>(step) * step_size_;
  ControlRecord record = measurement_.measure(scenario, model, t, sensors);
  record.period = period_;
  record.is_first = sampled_ < 0;
  ControlCommands next = commands_;
  controller_->control(record, next);
  require_possible(next, t, step + 1);
  // A brake that is on is a torque by the speed, and jumps.
  const bool jumps = next.brake > 0.0 || commands_.brake > 0.0;
  torque_before_ = commands_.torque;
  commands_ = std::move(next);
  sampled_ = step;
  put_angles(t, model);
  return {make_drive(), jumps};
}

void ControlLoop::put_angles(double t, SimulatedModel& model) {
  std::vector<SubsystemData<Space>>& subsystems = model.space()->data.subsystems;
  const auto demand = [&](double demanded, SubsystemData<Space>& subsystem) {
    for (ControlState& angle : subsystem.controls)
      if (angle.held == 0.0) demand_angle(demanded, t, period_, angle);
  };
  for (std::size_t k = 0; k < commands_.pitch.size(); ++k)
    demand(commands_.pitch[k], subsystems[measurement_.blades()[k]]);
  if (place_->yaw_joint.empty()) return;
  yaw_ += commands_.yaw_rate * period_;
  demand(yaw_, subsystems.back());
}

Drive ControlLoop::make_drive() const {
  if (sampled_ < 0 || (!place_->sets_torque() && commands_.brake == 0.0)) return own_drive_;
  const double sense = place_->direction, torque = sense * commands_.torque;
  const double initial_speed = calc_initial_speed(own_drive_);
  if (const double brake = commands_.brake * place_->brake_torque; brake > 0.0) {
    const double full = place_->brake_speed;
    return TorqueBySpeed{Curve({-full, 0.0, full}, {torque + brake, torque, torque - brake}),
                         initial_speed};
  }
  if (torque_before_ == commands_.torque) return TorqueDrive{Curve(torque), initial_speed};
  const double since = static_cast<double>(sampled_) * step_size_;
  return TorqueDrive{Curve({since, since + period_}, {sense * torque_before_, torque}),
                     initial_speed};
}

SavedControl ControlLoop::save() const {
  std::optional<std::string> memory = controller_->save();
  if (!memory)
    throw InputError("the simulation cannot be saved: " + name_of(*place_) +
                     " keeps data of its own that it does not give, expected no checkpoints");
  SavedControl saved{sampled_, {}, std::move(*memory)};
  saved.commands = {commands_.torque, torque_before_, commands_.yaw_rate, yaw_, commands_.brake};
  saved.commands.insert(saved.commands.end(), commands_.pitch.begin(), commands_.pitch.end());
  return saved;
}

void ControlLoop::restore(const std::optional<SavedControl>& saved, std::int64_t steps) {
  if (!saved || saved->sampled < -1 || saved->sampled > steps ||
      saved->commands.size() != kNumbers + commands_.pitch.size() ||
      !std::all_of(saved->commands.begin(), saved->commands.end(),
                   [](double value) { return std::isfinite(value); }))
    throw InputError("the saved state has nothing of " + name_of(*place_));
  if (!controller_->save())
    throw InputError("the simulation cannot go to a saved state: " + name_of(*place_) +
                     " keeps data of its own that it does not give");
  controller_->restore(saved->memory);
  sampled_ = saved->sampled;
  const std::vector<double>& numbers = saved->commands;
  commands_.torque = numbers[0];
  torque_before_ = numbers[1];
  commands_.yaw_rate = numbers[2];
  yaw_ = numbers[3];
  commands_.brake = numbers[4];
  std::copy(numbers.begin() + kNumbers, numbers.end(), commands_.pitch.begin());
}

std::unique_ptr<ControlLoop> ControlLoop::clone(const Scenario& scenario) const {
  std::shared_ptr<Controller> copy = controller_->clone();
  if (!copy)
    throw InputError("the simulation cannot be cloned: " + name_of(*place_) +
                     " gives no copy of itself");
  auto made = std::make_unique<ControlLoop>(*this);
  made->place_ = &*scenario.space->outer_control;
  made->controller_ = std::move(copy);
  return made;
}

std::unique_ptr<ControlLoop> make_control_loop(const Scenario& scenario, double step_size,
                                               std::shared_ptr<Controller> given,
                                               SimulatedModel& model) {
  const OuterControl* const place =
      scenario.space && scenario.space->outer_control ? &*scenario.space->outer_control : nullptr;
  if (given && (!place || place->table() != "control.program"))
    throw InputError("a controller is given, but the scenario has no [control.program]");
  if (!place || !place->has_controller) return nullptr;
  if (place->is_library())
    given = make_bladed_library(scenario, model);
  else if (place->laws)
    given = make_turbine_controller(*place->laws, place->initial,
                                    find_azimuths(*scenario.space, place->direction));
  else if (!given)
    throw InputError(
        "control.program: the program gives no controller, expected one "
        "(SimulationOptions::controller, in Python controller=)",
        {.key = "control.program"});
  return std::make_unique<ControlLoop>(scenario, step_size, std::move(given), model);
}

}  // namespace spoke
