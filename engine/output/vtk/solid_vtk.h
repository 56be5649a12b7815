#pragma once

// The solids of a model as a VTK file: their meshes as they are, deformed.

#include <memory>
#include <string>
#include <vector>

#include "engine/bodies/space/solid_output.h"
#include "engine/simulation.h"

namespace spoke {

/// Makes the .vtu files of the solids of a simulation in space.
class SolidVtk {
 public:
  explicit SolidVtk(const Simulation& simulation);
  SolidVtk(const SolidVtk&) = delete;
  SolidVtk& operator=(const SolidVtk&) = delete;

  /// Whether the model has solids.
  bool are_there() const { return !solids_.empty(); }
  /// Returns the text of the file at simulation.time(); the simulation must be of the same model.
  std::string make(const Simulation& simulation);

 private:
  struct Solid {
    int subsystem = 0, body = 0;
    std::shared_ptr<const space::SolidConstants> constants;
    std::shared_ptr<const space::NodeRecovery> recovery;  ///< equal solids share it
    int first = 0;                                        ///< its first point
  };

  void read_shapes(const Simulation& simulation);
  int count_points() const;
  const TreeBodyShape& shape_of(const Solid& solid) const {
    return shapes_[static_cast<std::size_t>(solid.subsystem)]
        .bodies[static_cast<std::size_t>(solid.body)];
  }

  std::vector<TreeShape> shapes_;  ///< by subsystem
  std::vector<Solid> solids_;
};

}  // namespace spoke
