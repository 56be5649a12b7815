#pragma once

// The part of a model on the table that is of space, see ModelOn.

#include <memory>
#include <vector>

#include "engine/bodies/columns/spatial_columns.h"
#include "engine/load.h"
#include "engine/simulation/spatial_joints.h"
#include "engine/simulation/spatial_sensors.h"
#include "engine/small_motions/steady/subsystem_names.h"
#include "engine/step/step_context.h"
#include "engine/tree_shape.h"
#include "models/scenario.h"
#include "models/tree/tree.h"

namespace spoke {

/// The model of `*scenario.space`.
class SpatialModel {
 public:
  /// Makes the system in the context. Both must outlive it. Throws InputError if the method of
  /// integration cannot follow the motions of its joints.
  SpatialModel(const Scenario& scenario, SystemContext<Space>& context);
  /// Makes the part of a copy of `original`, whose system is not made here.
  SpatialModel(const Scenario& scenario, SystemContext<Space>& context,
               const SpatialModel& original)
      : scenario_(scenario),
        context_(context),
        trees_(original.trees_),
        joints_(*trees_, context) {}

  std::vector<SubsystemNames> names() const { return name_subsystems(*trees_); }
  SpatialJoints* joints() { return &joints_; }

  /// Returns the number of values that the subsystems keep of a step for these sensors and for
  /// joints.
  std::size_t count_readings(const std::vector<Sensor>& asked) const;
  /// Returns the memory that readings in the table take besides their rings [bytes].
  double reading_bytes() const;
  /// Places sensors in the table, see spoke::place_sensors(), and makes the rings of readings.
  std::vector<SensorColumn> place_sensors(const std::vector<Sensor>& asked);
  SpatialSensors make_sensors(std::vector<SensorColumn> asked,
                              std::vector<SensorColumn> momentum) const;
  /// Takes the state at the start as reference of energy.
  void start(SpatialSensors& sensors);
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
  SystemContext<Space>& context_;
  std::shared_ptr<const std::vector<spatial::Tree>> trees_;  ///< copies have the same
  SpatialJoints joints_;
};

}  // namespace spoke
