#pragma once

// A model in space as a VTK file: its beams as lines, and sections and rigid bodies as surfaces.

#include <string>
#include <vector>

#include "engine/scene/frame.h"

namespace spoke {

/// Makes the .vtp files of a simulation in space.
class VtkTrees {
 public:
  explicit VtkTrees(const Scenario& scenario);
  VtkTrees(const VtkTrees&) = delete;
  VtkTrees& operator=(const VtkTrees&) = delete;

  /// The text of the file at simulation.time(), of a simulation of this scenario.
  std::string make(const Simulation& simulation);

 private:
  scene::Scene scene_;
  scene::FrameReader reader_;
  scene::Frame frame_;
};

}  // namespace spoke
