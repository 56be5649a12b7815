#pragma once

#include <string>
#include <vector>

#include "engine/integrator/time_stepper.h"
#include "engine/step_context.h"

namespace spoke {

/// Energies of a system [J].
struct Energies {
  double kinetic = 0.0;  ///< centrifugal stiffening term included
  double strain = 0.0;
  double gravity = 0.0;  ///< work of gravity since the undeformed start, -(change of potential)
};

/// Energies at the state in the table. Recalculates what depends on the state: the last pass of an
/// implicit step stands one correction behind it.
Energies calc_energies(const System& system, StepData& data);

/// Displacement of a subsystem's tip node from its undeformed place, and its rotation, hub frame
/// [m, m, rad]; poses must be those of the state. Bodies with geometric stiffening are
/// foreshortened.
Twist calc_tip_displacement(const Subsystem& subsystem, const SubsystemData& data);

/// Names, units and values of the sensors of a system.
class Sensors {
 public:
  explicit Sensors(const System& system);

  const std::vector<std::string>& names() const { return names_; }
  const std::vector<std::string>& units() const { return units_; }

  /// Takes the state at the start as reference of energy.
  void start(const System& system, StepData& data);
  /// Values at the state in the table, in the order of names().
  const std::vector<double>& measure(const System& system, const WorkDone& work, StepData& data);

 private:
  void add(std::string name, std::string unit);

  std::vector<std::string> names_;
  std::vector<std::string> units_;
  std::vector<double> values_;
  double initial_energy_ = 0.0;
  double initial_gravity_ = 0.0;
};

}  // namespace spoke
