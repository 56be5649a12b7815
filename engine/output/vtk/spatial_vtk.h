#pragma once

// A model in space as a VTK file: its beams and the rods of its loops as lines, sections, rigid
// bodies and anchors as surfaces.

#include <string>
#include <vector>

#include "engine/output/scene/frame.h"

namespace spoke {

/// Makes the .vtp files of a simulation in space.
class SpatialVtk {
 public:
  explicit SpatialVtk(const Scenario& scenario);
  SpatialVtk(const SpatialVtk&) = delete;
  SpatialVtk& operator=(const SpatialVtk&) = delete;

  /// Returns the text of the file at simulation.time(); the simulation must be of this scenario.
  std::string make(const Simulation& simulation);

 private:
  scene::Scene scene_;
  scene::FrameReader reader_;
  scene::Frame frame_;
};

}  // namespace spoke
