#pragma once

// The places of sensors on the trees of a model in space.

#include <string>
#include <vector>

#include "models/sensor.h"
#include "models/tree/tree.h"

namespace spoke::spatial {

/// Bodies of one tree that a sensor is on, inboard ones first: all bodies of a blade, the parts of
/// one body of a subsystem, or all bodies of a subsystem if the sensor names none.
struct SensorPlace {
  std::size_t tree = 0;
  std::vector<int> bodies{};

  /// Returns the body that holds a station, at a boundary the inner one. Precondition: the bodies
  /// are parts of a beam.
  int body_at(const Tree& of, double station) const;
};

/// Finds the places of a sensor that is_of_blade(): one for each tree that it is on. `blades`: how
/// many of the trees are blades. Empty if there is no such place.
std::vector<SensorPlace> find_places(const Sensor& sensor, std::size_t blades,
                                     const std::vector<Tree>& trees);

/// Returns the first word in the names of a tree's sensors: "blade1" for "blade 1".
std::string sensor_name_of(const Tree& tree);

/// Names of the columns of a tree's joints, in their order: a joint of one value by its name, of
/// more by number.
std::vector<std::string> joint_columns_of(const Tree& tree);

}  // namespace spoke::spatial
