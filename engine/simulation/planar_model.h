#pragma once

// The part of a model on the table that is of the plane, see ModelOn.

#include <vector>

#include "engine/bodies/columns/sensor_columns.h"
#include "engine/load.h"
#include "engine/simulation/sensors.h"
#include "engine/simulation/spatial_joints.h"
#include "engine/small_motions/steady/subsystem_names.h"
#include "engine/step/step_context.h"
#include "engine/tree_shape.h"
#include "models/scenario.h"

namespace spoke {

/// The model of `scenario.rotor`.
class PlanarModel {
 public:
  /// Makes the system in the context. Both must outlive it.
  PlanarModel(const Scenario& scenario, SystemContext<Plane>& context);
  /// Makes the part of a copy of a model, whose system is not made here.
  PlanarModel(const Scenario& scenario, SystemContext<Plane>& context, const PlanarModel&)
      : scenario_(scenario), context_(context) {}

  std::vector<SubsystemNames> names() const { return name_subsystems(scenario_.rotor); }
  /// Returns null, since joints of the plane do not move.
  SpatialJoints* joints() { return nullptr; }

  /// Returns the number of values that the subsystems keep of a step for these sensors.
  std::size_t count_readings(const std::vector<Sensor>& asked) const;
  /// Returns the memory that readings in the table take besides their rings [bytes].
  double reading_bytes() const;
  /// Places sensors in the table, see spoke::place_sensors().
  std::vector<SensorColumn> place_sensors(const std::vector<Sensor>& asked);
  Sensors make_sensors(std::vector<SensorColumn> asked, std::vector<SensorColumn> momentum) const;
  /// Takes the state at the start as reference of energy.
  void start(Sensors& sensors);
  void sample(std::int64_t step, double t);
  double energy_resolution() const;

  Wrench section_force(const Marker& marker) const;
  void calc_shape(int subsystem, double t, TreeShape& shape);
  HubPose hub_pose() const;
  MarkerMotion base_frame(double t) const;
  /// Returns the motion of an anchor's frame, or of the mount's (-1).
  MarkerMotion carrier_frame(int anchor, double t) const;

 private:
  const Scenario& scenario_;
  SystemContext<Plane>& context_;
};

}  // namespace spoke
