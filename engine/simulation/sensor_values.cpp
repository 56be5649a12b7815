// Columns that every world has, and the balance of energy.

#include "engine/simulation/sensor_values.h"

#include <utility>

namespace spoke {

void WorkDone::add(const StepRecord& step) {
  by_drive_and_loads += step.work;
  dissipated += step.dissipated;
}

void SensorValues::add(std::string name, std::string unit) {
  names_.push_back(std::move(name));
  units_.push_back(std::move(unit));
}

void SensorValues::add_hub_columns() {
  add("hub.angle", "rad");
  add("hub.speed", "rad/s");
  add("hub.torque", "N m");
  add("energy.kinetic", "J");
  add("energy.strain", "J");
  add("energy.work", "J");
  add("energy.dissipated", "J");
  add("energy.residual", "J");
}

void SensorValues::add_momentum_columns() {
  add("momentum.residual.linear", "kg m/s");
  add("momentum.residual.angular", "kg m^2/s");
}

void SensorValues::append_momentum(const MomentumBalance& balance) {
  values_.insert(values_.end(), {balance.residual, balance.angular_residual});
}

void SensorValues::start_balance(const Energies& energies) {
  initial_energy_ = energies.kinetic + energies.strain;
  initial_gravity_ = energies.gravity;
}

void SensorValues::append_energies(const Energies& energies, const WorkDone& work) {
  const double done = work.by_drive_and_loads + (energies.gravity - initial_gravity_);
  const double residual =
      energies.kinetic + energies.strain - initial_energy_ + work.dissipated - done;
  values_.insert(values_.end(),
                 {energies.kinetic, energies.strain, done, work.dissipated, residual});
  balance_ = {energies.kinetic + energies.strain, residual};
}

}  // namespace spoke
