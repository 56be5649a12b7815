// Finds the speed that each kind of drive ends with.

#include "engine/small_motions/steady/steady_speed.h"

#include <string>

#include "models/error.h"
#include "models/reader/scenario_fields.h"

namespace spoke::steady {
namespace {

struct FinalSpeed {
  std::optional<double> operator()(const SpinUp& drive) const { return drive.speed; }
  std::optional<double> operator()(const SpinUpHoldSpinDown& drive) const { return drive.speed; }
  std::optional<double> operator()(const SpeedTable& drive) const {
    return drive.speed.values().back();
  }
  std::optional<double> operator()(const FixedDrive&) const { return 0.0; }
  std::optional<double> operator()(const ConstantSpeed& drive) const { return drive.speed; }
  std::optional<double> operator()(const FreeDrive& drive) const { return drive.initial_speed; }
  std::optional<double> operator()(const TorqueDrive&) const { return std::nullopt; }
  std::optional<double> operator()(const TorqueBySpeed&) const { return std::nullopt; }
};

/// Returns the speed about the axis of a free hub in space, whose start is given as a vector.
std::optional<double> speed_of(const spatial::Hub& hub) {
  if (hub.support == HubSupport::free) return hub.angular_velocity.dot(hub.axis.normalized());
  return std::visit(FinalSpeed{}, hub.drive);
}

void require_speed(double speed) {
  if (const std::string expected = kSpeed.expectation_instead_of(speed); !expected.empty())
    throw InputError("the speed is " + spoke::describe(speed) + ", expected " + expected);
}

/// Returns the names of all rotors, each in quotes.
std::string list_rotors(const spatial::Model& model) {
  std::string list;
  for (int r = 0; r < count_rotors(model); ++r)
    list += (r == 0 ? "\"" : ", \"") + hub_of(model, r).name + '"';
  return list;
}

/// Throws unless each speed that is asked for by name is of a rotor that has none besides.
void require_rotors(const Scenario& scenario, const SteadyState& asked) {
  for (const auto& [name, speed] : asked.speeds) {
    require_speed(speed);
    if (!scenario.space || scenario.space->rotors.empty())
      throw InputError("a speed is for the rotor \"" + name +
                       "\", expected no name: the model has one rotor");
    const spatial::Model& model = *scenario.space;
    bool is_there = false;
    for (int r = 0; r < count_rotors(model); ++r) is_there |= hub_of(model, r).name == name;
    if (!is_there)
      throw InputError("a speed is for the rotor \"" + name + "\", expected one of " +
                       list_rotors(model));
    if (asked.speed && model.hub.name == name)
      throw InputError("a speed without a name and one for \"" + name +
                       "\" are given, expected only one of them: both are of the first rotor");
  }
}

}  // namespace

double find_steady_speed(const Scenario& scenario, int rotor, std::optional<double> asked) {
  if (asked) require_speed(*asked);
  if (asked) return *asked;
  const std::optional<double> speed = scenario.space
                                          ? speed_of(hub_of(*scenario.space, rotor))
                                          : std::visit(FinalSpeed{}, scenario.rotor.hub.drive);
  if (speed) return *speed;
  const std::string name = rotor > 0 ? hub_of(*scenario.space, rotor).name : "";
  throw InputError((rotor > 0 ? "the drive of the rotor \"" + name + '"' : "hub.drive") +
                   ": a torque has no steady speed by itself, expected a speed to be given "
                   "(--speed" +
                   (rotor > 0 ? ' ' + name + "=VALUE" : "") + ')');
}

std::vector<double> find_steady_speeds(const Scenario& scenario, const SteadyState& asked) {
  require_rotors(scenario, asked);
  const auto named = [&](const std::string& name) {
    const auto found = asked.speeds.find(name);
    return found == asked.speeds.end() ? std::nullopt : std::optional(found->second);
  };
  const bool has_name = scenario.space && !scenario.space->rotors.empty() && !asked.speed;
  std::vector<double> speeds{
      find_steady_speed(scenario, 0, has_name ? named(scenario.space->hub.name) : asked.speed)};
  for (int r = 1; scenario.space && r < count_rotors(*scenario.space); ++r)
    speeds.push_back(find_steady_speed(scenario, r, named(hub_of(*scenario.space, r).name)));
  return speeds;
}

std::vector<double> scale_steady_speeds(const Scenario& scenario, double first) {
  if (!scenario.space || scenario.space->rotors.empty()) return {first};
  std::vector<double> speeds = find_steady_speeds(scenario, {});
  const double own = speeds.front();
  if (own == 0.0)
    throw InputError("the drive of the rotor \"" + scenario.space->hub.name +
                     "\" lets it stand, expected one that turns: all rotors turn faster and slower "
                     "by the ratios of their drives' speeds");
  for (double& speed : speeds) speed = first * (speed / own);
  return speeds;
}

SteadyState scale_steady_state(const Scenario& scenario, double first) {
  const std::vector<double> speeds = scale_steady_speeds(scenario, first);
  SteadyState state{.speed = first};
  for (std::size_t r = 1; r < speeds.size(); ++r)
    state.speeds[scenario.space->rotors[r - 1].hub.name] = speeds[r];
  return state;
}

SteadyOptions at_speeds(const std::vector<double>& speeds, const SteadyOptions& others) {
  SteadyOptions options = others;
  options.speed = speeds.front();
  options.further_speeds.assign(speeds.begin() + 1, speeds.end());
  return options;
}

}  // namespace spoke::steady
