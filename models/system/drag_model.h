#pragma once

// What the wind does to the bodies of a subsystem, as constants at places on them.

#include <vector>

#include "models/air.h"
#include "models/space/space.h"

namespace spoke {

/// The drag of a subsystem's bodies.
struct DragModel {
  /// A place on a beam, for the stretch around it: force 1/2 rho `across` |v| v of the wind's
  /// velocity v against it, without its part along the beam.
  struct Stretch {
    int body = 0;
    double station = 0.0;  ///< on the body [m]
    double across = 0.0;   ///< coefficient by width by length [m^2]
  };
  /// A rigid body: force 1/2 rho |v| A v, by the axes of its frame.
  struct Block {
    int body = 0;
    space::Position point;  ///< [m]
    space::Position area;   ///< A [m^2]
  };

  /// A beam that disturbs the wind of blades.
  struct Tower {
    /// A point of its axis, which is straight between two of them.
    struct Point {
      int body = 0;
      double station = 0.0;      ///< on the body [m]
      double diameter = 0.0;     ///< [m]
      double coefficient = 0.0;  ///< of drag
    };
    spatial::TowerPotential potential = spatial::TowerPotential::none;
    spatial::TowerShadow shadow = spatial::TowerShadow::none;
    std::vector<Point> points;  ///< from root to tip, two or more
  };

  double density = 0.0;  ///< rho [kg/m^3]
  std::vector<Stretch> stretches;
  std::vector<Block> blocks;
  std::vector<Tower> towers;
};

}  // namespace spoke
