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

}  // namespace

double find_steady_speed(const Scenario& scenario, std::optional<double> asked) {
  if (asked)
    if (const std::string expected = kSpeed.expectation_instead_of(*asked); !expected.empty())
      throw InputError("the speed is " + spoke::describe(*asked) + ", expected " + expected);
  if (asked) return *asked;
  const std::optional<double> speed = scenario.space
                                          ? speed_of(scenario.space->hub)
                                          : std::visit(FinalSpeed{}, scenario.rotor.hub.drive);
  if (!speed)
    throw InputError(
        "hub.drive: a torque has no steady speed by itself, expected a speed to be given "
        "(--speed)");
  return *speed;
}

}  // namespace spoke::steady
