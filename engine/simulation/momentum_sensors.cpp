// Reads the momentum of hub and subsystems, and compares it with the start and with its possible
// size.

#include "engine/simulation/momentum_sensors.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numeric>

#include "engine/bodies/columns/spatial_columns.h"

namespace spoke {
namespace {

double mass_of_body(const TreeBody<Plane>& body) { return body.body->mass; }
double mass_of_body(const TreeBody<Space>& body) { return body.body->mass(); }

template <class World>
double linear_size(const std::array<double, World::kTwist>& P) {
  return std::sqrt(std::inner_product(P.begin(), P.begin() + World::kPosition, P.begin(), 0.0));
}

/// Returns the magnitude of the angular momentum about `place`, |L - p x P|, from that about the
/// origin.
template <class World>
double angular_size(const TwistOf<World>& p, const std::array<double, World::kTwist>& P) {
  if constexpr (World::kTwist == kTwist) {
    return std::abs(P[2] - (p[0] * P[1] - p[1] * P[0]));
  } else {
    const space::Position place(p[0], p[1], p[2]), linear(P[0], P[1], P[2]);
    return (space::Angular(P[3], P[4], P[5]) - cross(place, linear)).norm();
  }
}

}  // namespace

bool keeps_momentum(const Scenario& scenario) {
  if (!scenario.space) {
    const Rotor& rotor = scenario.rotor;
    return rotor.hub.support == HubSupport::free &&
           std::holds_alternative<FreeDrive>(rotor.hub.drive) &&
           rotor.gravity == Position(0.0, 0.0) && rotor.loads.empty() &&
           rotor.distributed_loads.empty() && rotor.drags.empty() && rotor.hub_loads.empty();
  }
  const spatial::Model& model = *scenario.space;
  // A drive acts between the hub and its support.
  const bool is_free = model.support ? model.support->from == spatial::SupportBase::free
                                     : model.hub.support == HubSupport::free &&
                                           std::holds_alternative<FreeDrive>(model.hub.drive);
  return is_free && model.gravity.isZero(0.0) && model.loads.empty() &&
         model.distributed_loads.empty() && model.hub_loads.empty();
}

std::vector<Sensor> with_momentum(const Scenario& scenario, bool keeps) {
  std::vector<Sensor> sensors = scenario.sensors;
  if (keeps) sensors.emplace_back().quantity = SensorQuantity::momentum;
  return sensors;
}

std::vector<SensorColumn> take_momentum(const Scenario& scenario, bool keeps,
                                        std::vector<SensorColumn>& columns) {
  if (!keeps) return {};
  const auto count = static_cast<std::ptrdiff_t>(scenario.space ? Space::kTwist : Plane::kTwist);
  const auto first = columns.end() - count;
  std::vector<SensorColumn> taken(std::make_move_iterator(first),
                                  std::make_move_iterator(columns.end()));
  columns.erase(first, columns.end());
  return taken;
}

template <class World>
MomentumSensors<World>::MomentumSensors(const System<World>& system,
                                        std::vector<SensorColumn> columns)
    : columns_(std::move(columns)), mass_(system.hub.mass) {
  for (const Subsystem<World>& subsystem : system.subsystems)
    for (const TreeBody<World>& body : subsystem.bodies) mass_ += mass_of_body(body);
}

template <class World>
typename MomentumSensors<World>::Momentum MomentumSensors<World>::read(
    const System<World>& system, std::int64_t step, const StepData<World>& data) const {
  Momentum momentum;
  std::transform(
      columns_.begin(), columns_.end(), momentum.begin(),
      [&](const SensorColumn& column) { return value_of(column, system.hub, step, data); });
  return momentum;
}

template <class World>
void MomentumSensors<World>::start(const System<World>& system, const StepData<World>& data) {
  if (are_there()) start_ = read(system, 0, data);
}

template <class World>
void MomentumSensors<World>::measure(const System<World>& system, double kinetic, std::int64_t step,
                                     const StepData<World>& data) {
  // If all parts of the motion pass through the hub, there is no angular momentum to compare with.
  constexpr double kLeast = 1e-3;
  const TwistOf<World>& hub = of_step(data.records, step).position;
  const Momentum momentum = read(system, step, data);
  Momentum change = momentum;
  for (std::size_t c = 0; c < change.size(); ++c) change[c] -= start_[c];
  balance_.residual = linear_size<World>(change);
  balance_.angular_residual = angular_size<World>(hub, change);
  balance_.size = std::sqrt(2.0 * mass_ * std::max(kinetic, 0.0));  // |P|^2 <= 2 M T
  balance_.angular_size = angular_size<World>(hub, momentum);
  for (std::size_t i = 0; i < data.subsystems.size(); ++i) {
    Momentum part;
    std::copy_n(readings_of(data.subsystems[i], step) + columns_.front().places[i], part.size(),
                part.begin());
    balance_.angular_size += angular_size<World>(hub, part);
  }
  balance_.angular_size = std::max(balance_.angular_size, kLeast * balance_.size * data.length);
}

template class MomentumSensors<Plane>;
template class MomentumSensors<Space>;

}  // namespace spoke
