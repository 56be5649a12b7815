// Vibrations of every model of the zoo: runs follow the modes of the linear model.

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "tests/engine/laws/vibrations.h"
#include "tests/engine/laws/zoo.h"

using namespace spoke;
using namespace spoke::test;
using Eigen::VectorXd;

namespace {

/// Models without modes to follow, and why.
const std::map<std::string_view, std::string_view> kWithoutModes{
    {"andrews_squeezer", "its motor leaves it no rest"},
    {"epicyclic_gear", "nothing in it is sprung: its root is zero"},
    {"fairground_ride", "a rotor on one that turns has matrices that change with its azimuth"},
    {"helicopter_on_gear, blades tied", "what ties a blade to the support turns against it"},
    {"heavy_top", "nothing holds it: all roots are zero"},
    {"quadcopter", "its rotors of two blades have no constant matrices"},
    {"quadcopter, a rotor on a rotor",
     "a rotor on one that turns has matrices that change with its azimuth"},
    {"solid_blade_rotor, nodal", "dense matrices of 9072 coordinates take 20 s; it holds"},
    {"tree_of_bodies, in the wind", "wind pushes a hub that is free"},
    {"tree_of_bodies, relaxing",
     "runs begin with its springs relaxed, not with the forces of a mode"},
    {"vehicle", "in a steady state a free hub has no weight to load its wheels"}};

/// Speeds at which models turn whose drives are torques from rest [rad/s].
const std::map<std::string_view, double> kSpeeds{{"articulated_rotor, hub by a torque", 36.0},
                                                 {"wu_haug_rotor, free hub", 4.0}};

/// Makes a torque nothing, so that the hub is free; one by the speed holds its speed.
void calm(std::optional<double> speed, Drive& drive) {
  if (const auto* torque = std::get_if<TorqueDrive>(&drive))
    drive = FreeDrive{speed.value_or(torque->initial_speed)};
  else if (const auto* by_speed = std::get_if<TorqueBySpeed>(&drive))
    drive = ConstantSpeed{by_speed->initial_speed};
}

void calm(spatial::JointCoordinate& coordinate) {
  coordinate.initial_speed = 0.0;
  coordinate.effort = Curve();
  if (!coordinate.motion) return;
  if (auto* azimuth = std::get_if<spatial::AzimuthMotion>(&*coordinate.motion))
    azimuth->cosine = azimuth->sine = 0.0;
  else if (std::holds_alternative<spatial::MotionTable>(*coordinate.motion))
    coordinate.motion = spatial::MotionTable{};
}

/// Leaves a rotor in wind along its axis, whose wake follows at once, without what carries it.
void calm_air(spatial::Model& model) {
  model.pitch_control.reset();
  if (model.support) {
    model.support.reset();
    model.subsystems.pop_back();
  }
  model.air->wind.turbulence.reset();
  model.air->wind.shear_exponent = 0.0;
  model.air->inflow = spatial::Inflow::quasi_steady;
  model.air->attached_flow = spatial::AttachedFlow::steady;
  model.air->stall = spatial::Stall::steady;
}

void calm(spatial::Model& model, std::optional<double> speed) {
  const spatial::Vector axis = model.hub.axis.normalized();
  if (!std::holds_alternative<FixedDrive>(model.hub.drive))
    model.gravity = axis * axis.dot(model.gravity);
  calm(speed, model.hub.drive);
  for (spatial::Rotor& rotor : model.rotors) calm(std::nullopt, rotor.hub.drive);
  model.hub.angular_velocity.setZero();
  model.hub_loads.clear();
  for (spatial::PointLoad& load : model.loads) load.factor = Curve(load.factor.values().back());
  for (spatial::DistributedLoad& load : model.distributed_loads)
    load.factor = Curve(load.factor.values().back());
  if (speed) model.distributed_loads.clear();  // they turn a hub that is free
  for (Anchor& anchor : model.anchors) anchor.motion = spatial::MountMotion{};
  for (spatial::Blade& blade : model.blades)
    for (spatial::BladeJoint& joint : blade.joints)
      for (spatial::JointCoordinate& coordinate : joint.joint.coordinates) calm(coordinate);
  for (spatial::Subsystem& subsystem : model.subsystems)
    for (spatial::SubsystemJoint& joint : subsystem.joints)
      for (spatial::JointCoordinate& coordinate : joint.joint.coordinates) calm(coordinate);
  if (model.air) calm_air(model);
}

/// Returns a model in steady motion: without what changes over time or turns against its rotor,
/// and without torques.
Scenario read_calm(const ZooModel& model) {
  Scenario scenario = model.read(1);
  scenario.initial = {InitialState::equilibrium, {}};
  scenario.sensors.clear();
  const auto known = kSpeeds.find(model.name);
  const auto speed = known == kSpeeds.end() ? std::nullopt : std::optional(known->second);
  if (scenario.space) {
    calm(*scenario.space, speed);
  } else {
    scenario.rotor.hub_loads.clear();
    calm(speed, scenario.rotor.hub.drive);
  }
  return scenario;
}

/// The least and the greatest of some magnitudes [rad/s].
std::pair<double, double> find_range(const std::vector<Vibration>& vibrations) {
  const auto [least, greatest] = std::minmax_element(
      vibrations.begin(), vibrations.end(),
      [](const Vibration& a, const Vibration& b) { return std::abs(a.rate) < std::abs(b.rate); });
  return {std::abs(least->rate), std::abs(greatest->rate)};
}

/// Returns the motion of a run that starts in a vibration, of a unit amplitude in the way of the
/// vibration. Half the difference of two opposite runs has no terms of second order.
std::vector<VectorXd> follow(const Vibration& vibration, int steps, Displaced& run) {
  constexpr double kAmplitude = 1e-4;  // m, rad
  const VectorXd x = vibration.motion(0.0).real(), v = vibration.start_velocities();
  const double scale = kAmplitude / vibration.motion(0.0).cwiseAbs().maxCoeff();
  std::vector<VectorXd> motion = run.run(scale * x, scale * v, steps);
  const std::vector<VectorXd> opposite = run.run(-scale * x, -scale * v, steps);
  for (std::size_t k = 0; k < motion.size(); ++k)
    motion[k] = (motion[k] - opposite[k]) / (2.0 * scale);
  return motion;
}

/// Largest distances of runs from a vibration, by its largest amplitude: with a step, with half of
/// it, and extrapolated to none.
struct Distances {
  double whole = 0.0, half = 0.0, extrapolated = 0.0;
};

Distances compare(const Vibration& vibration, double step, const std::vector<VectorXd>& whole,
                  const std::vector<VectorXd>& half) {
  Distances most;
  double size = 0.0;
  const auto keep = [](const VectorXd& distance, double& greatest) {
    greatest = std::max(greatest, distance.cwiseAbs().maxCoeff());
  };
  for (std::size_t k = 0; k < whole.size(); ++k) {
    const VectorXd known = vibration.motion(static_cast<double>(k) * step).real();
    const VectorXd &coarse = whole[k], &fine = half[2 * k];
    keep(known, size);
    keep(coarse - known, most.whole);
    keep(fine - known, most.half);
    keep((4.0 * fine - coarse) / 3.0 - known, most.extrapolated);
  }
  return {most.whole / size, most.half / size, most.extrapolated / size};
}

}  // namespace

TEST_CASE("runs from the modes of every model follow them, the better the shorter the step") {
  constexpr double kTurn = 2.0 * std::numbers::pi / 40.0;  // in a step, of what is fastest [rad]
  for (const ZooModel& model : list_zoo()) {
    if (kWithoutModes.contains(model.name)) continue;
    CAPTURE(model.name);
    Scenario scenario = read_calm(model);
    const std::vector<Vibration> vibrations = list_vibrations(scenario, 3);
    REQUIRE(!vibrations.empty());
    const auto [slowest, fastest] = find_range(vibrations);
    const double step = kTurn / (fastest + std::abs(steady_speed(scenario)));
    // Half a period, if that does not take long.
    const int steps = static_cast<int>(std::clamp(std::numbers::pi / slowest / step, 40.0, 120.0));
    scenario.integration = {.step = step, .duration = 2.0 * steps * step, .tolerance = 1e-11};
    Displaced whole(scenario);
    scenario.integration.step = 0.5 * step;
    Displaced half(scenario);
    for (const Vibration& vibration : vibrations) {
      CAPTURE(vibration.name);
      const Distances distances = compare(vibration, step, follow(vibration, steps, whole),
                                          follow(vibration, 2 * steps, half));
      // Without the terms of the square of the step the next ones are left.
      CHECK(distances.extrapolated < std::pow(kTurn, 4));
      if (distances.whole > 1e-4) CHECK(distances.whole > 3.5 * distances.half);
    }
  }
}
