#pragma once

// The sensors of a simulation: names, units and values.

#include <string>
#include <vector>

#include "engine/simulation/observations.h"
#include "engine/simulation/sensor_columns.h"
#include "engine/table/step_data.h"

namespace spoke {

/// Energies of a system [J].
struct Energies {
  double kinetic = 0.0;  ///< centrifugal stiffening term included
  double strain = 0.0;
  double gravity = 0.0;  ///< work of gravity since the undeformed start, -(change of potential)
};

/// Energies at the state in the table, whose kinematics it recalculates. Where subsystems follow a
/// prescribed hub, its motion must be that of the state.
Energies calc_energies(const System<Plane>& system, StepData<Plane>& data);

/// Work done on the system since t = 0, by the quadrature that belongs to the method.
struct WorkDone {
  double by_drive_and_loads = 0.0;  ///< [J]; gravity's is a function of the state, see Energies
  double dissipated = 0.0;          ///< by damping [J]

  void add(const StepRecord& step);
};

/// Names, units and values of the sensors of a system.
class Sensors {
 public:
  /// `asked`: of the scenario, behind those that every simulation has.
  Sensors(const System<Plane>& system, std::vector<SensorColumn> asked);

  const std::vector<std::string>& names() const { return names_; }
  const std::vector<std::string>& units() const { return units_; }

  /// Takes the state at the start as reference of energy.
  void start(const System<Plane>& system, StepData<Plane>& data);
  double initial_energy() const { return initial_energy_; }  ///< kinetic and strain energy [J]
  /// Fills the samples and readings of step `step`, time t [s], from the state in the table, which
  /// must be the step's.
  static void sample(const System<Plane>& system, std::int64_t step, double t,
                     StepData<Plane>& data);
  /// Values at the end of step `step`, of which records and samples must be in the table, in the
  /// order of names(). `work`: up to then.
  const std::vector<double>& measure(const System<Plane>& system, const WorkDone& work,
                                     std::int64_t step, const StepData<Plane>& data);
  /// Of the step measured last.
  const EnergyBalance& balance() const { return balance_; }

 private:
  void add(std::string name, std::string unit);
  void add_blade_values(const System<Plane>& system, std::int64_t step,
                        const StepData<Plane>& data);

  std::vector<SensorColumn> asked_;
  std::vector<std::string> names_;
  std::vector<std::string> units_;
  std::vector<double> values_;
  EnergyBalance balance_;
  double initial_energy_ = 0.0;
  double initial_gravity_ = 0.0;
};

}  // namespace spoke
