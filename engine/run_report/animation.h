#pragma once

// The moving pictures of report.html.

#include <cstddef>
#include <vector>

#include "engine/scene/frame.h"

namespace spoke::run_report {

/// Pictures of a model over time: frames of its scene, as single numbers.
class Animation {
 public:
  static constexpr std::size_t kMostFrames = 400;
  static constexpr std::size_t kFewestFrames = 40;
  static constexpr std::size_t kMostNumbers = 400000;  ///< of all frames together
  static constexpr std::size_t kMostNodes = 2000;      ///< in a picture, see make_scene()

  /// Large models get fewer frames, or a part of their nodes.
  explicit Animation(const Simulation& simulation);
  Animation(const Animation&) = delete;
  Animation& operator=(const Animation&) = delete;

  /// How many frames there should be.
  std::size_t most_frames() const { return most_frames_; }
  /// Adds a picture of simulation.time(), unless the last one is of that time or a number in it is
  /// not finite.
  void add(const Simulation& simulation);

  const scene::Scene& scene() const { return scene_; }
  const std::vector<double>& times() const { return times_; }  ///< [s]
  /// By frame: of a hub that is free in space a pose, of others x, y, z [m] and the angle about the
  /// axis. A pose is x, y, z [m] and a quaternion (w, x, y, z).
  const std::vector<float>& hub() const { return hub_; }
  /// Poses by frame and group, without the first.
  const std::vector<float>& groups() const { return groups_; }
  /// By frame and node, in the hub's frame; of a planar model x and y alone [m].
  const std::vector<float>& displacements() const { return displacements_; }
  /// By frame and node: rotation vectors; of a planar model angles.
  const std::vector<float>& rotations() const { return rotations_; }
  const std::vector<float>& axial_forces() const { return axial_forces_; }  ///< by element [N]
  const std::vector<float>& bending_moments() const { return bending_moments_; }  ///< [N m]

 private:
  void append();

  scene::Scene scene_;
  scene::FrameReader reader_;
  scene::Frame frame_;
  bool is_free_in_space_;
  std::size_t most_frames_ = 0;
  std::vector<double> times_;
  std::vector<float> hub_, groups_, displacements_, rotations_, axial_forces_, bending_moments_;
};

}  // namespace spoke::run_report
