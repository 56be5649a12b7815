#pragma once

// Where sensors are on the trees of a model in space.

#include <string>
#include <vector>

#include "models/sensor.h"
#include "models/tree/tree.h"

namespace spoke::spatial {

/// Bodies of one tree that a sensor is on, inboard ones first: all of a blade, or the parts of a
/// body of a subsystem; those of a subsystem where it names no body.
struct SensorPlace {
  std::size_t tree = 0;
  std::vector<int> bodies{};

  /// The body that holds a station, at a boundary the inner one. Precondition: they are of a beam.
  int body_at(const Tree& of, double station) const;
};

/// Of a sensor that is_of_blade(): one for each tree that it is on. `blades`: how many of the trees
/// are blades. Nothing if there is no such place.
std::vector<SensorPlace> find_places(const Sensor& sensor, std::size_t blades,
                                     const std::vector<Tree>& trees);

/// What names of sensors begin with: "blade1" of "blade 1".
std::string sensor_name_of(const Tree& tree);

/// Names of the columns of a tree's joints, in their order: a joint of one value by its name, of
/// more by number.
std::vector<std::string> joint_columns_of(const Tree& tree);

}  // namespace spoke::spatial
