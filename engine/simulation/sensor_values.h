#pragma once

// Common part of the sensors of every world: columns, and the balance of energy.

#include <string>
#include <vector>

#include "engine/bodies/table/step_data.h"
#include "engine/simulation/observations.h"

namespace spoke {

/// Energies of a system [J].
struct Energies {
  double kinetic = 0.0;  ///< centrifugal stiffening term included
  double strain = 0.0;
  double gravity = 0.0;  ///< work of gravity since the undeformed start, -(change of potential)
};

/// Work done on the system since t = 0, by the quadrature that belongs to the method.
struct WorkDone {
  double by_drive_and_loads = 0.0;  ///< without gravity, see Energies [J]
  double dissipated = 0.0;          ///< by damping [J]

  void add(const StepRecord& step);
};

template <class World>
Energies operator+(Energies energies, const SubsystemSample<World>& sample) {
  energies.kinetic += sample.kinetic;
  energies.strain += sample.strain;
  energies.gravity += sample.gravity;
  return energies;
}

/// Adds the energies in the samples of a step to those of the hub, in the order of the subsystems.
template <class World>
Energies sum_energies(const Energies& hub, std::int64_t step, const StepData<World>& data) {
  Energies energies = hub;
  for (const SubsystemData<World>& subsystem : data.subsystems)
    energies = energies + of_step(subsystem.samples, step);
  return energies;
}

/// Names and units of columns, and the values of one step.
class SensorValues {
 public:
  const std::vector<std::string>& names() const { return names_; }
  const std::vector<std::string>& units() const { return units_; }
  double initial_energy() const { return initial_energy_; }  ///< kinetic and strain energy [J]
  /// Returns the balance at the step measured last.
  const EnergyBalance& balance() const { return balance_; }

 protected:
  void add(std::string name, std::string unit);
  /// Adds columns for angle, speed and torque of the hub, then for the energies, whose values
  /// append_energies() yields.
  void add_hub_columns();
  /// Takes the energies at the start as reference.
  void start_balance(const Energies& energies);
  void append_energies(const Energies& energies, const WorkDone& work);
  /// Adds columns for the residuals of the momentum of a free model, whose values append_momentum()
  /// yields.
  void add_momentum_columns();
  void append_momentum(const MomentumBalance& balance);

  std::vector<double> values_;

 private:
  std::vector<std::string> names_;
  std::vector<std::string> units_;
  EnergyBalance balance_;
  double initial_energy_ = 0.0;
  double initial_gravity_ = 0.0;
};

}  // namespace spoke
