#pragma once

// The moving pictures of report.html.

#include <cstddef>
#include <vector>

#include "engine/output/scene/frame.h"

namespace spoke::run_report {

/// Pictures of a model over time: frames of its scene, as single numbers.
class Animation {
 public:
  static constexpr std::size_t kMostFrames = 400;
  static constexpr std::size_t kFewestFrames = 40;
  static constexpr std::size_t kMostNumbers = 400000;  ///< numbers of all frames together
  static constexpr std::size_t kMostNodes = 2000;      ///< nodes in a picture, see make_scene()

  /// Makes an empty animation. Large models get fewer frames, or a part of their nodes.
  explicit Animation(const Simulation& simulation);
  Animation(const Animation&) = delete;
  Animation& operator=(const Animation&) = delete;

  /// Returns the largest number of frames.
  std::size_t most_frames() const { return most_frames_; }
  /// Adds a picture of simulation.time(), unless the last one shows that time or a number in it is
  /// not finite.
  void add(const Simulation& simulation);

  const scene::Scene& scene() const { return scene_; }
  const std::vector<double>& times() const { return times_; }  ///< [s]
  /// Returns by frame the hub's pose if it is free in space, otherwise x, y, z [m] and the angle
  /// about the axis [rad]; on a support the pose at an angle of 0, and the angle. A pose is x, y, z
  /// [m] and a quaternion (w, x, y, z).
  const std::vector<float>& hub() const { return hub_; }
  /// Returns poses by frame and group, without the first group; in the hub's frame. The base of a
  /// support has its pose in the inertial frame, and what stands on it is in the base's frame, as
  /// displacements and rotations of its nodes are.
  const std::vector<float>& groups() const { return groups_; }
  /// Returns displacements by frame and node in the hub's frame; only x and y for a planar model
  /// [m].
  const std::vector<float>& displacements() const { return displacements_; }
  /// Returns rotation vectors by frame and node; angles for a planar model [rad].
  const std::vector<float>& rotations() const { return rotations_; }
  /// Returns by solid of the scene and by frame its numbers: modal coordinates; of a nodal one the
  /// displacements of its drawn nodes in its frame [m] and their von Mises stresses [Pa].
  const std::vector<std::vector<float>>& solids() const { return solids_; }
  /// The largest values of the drawn nodes of solids.
  struct SolidExtremes {
    double displacement = 0.0;  ///< from the undeformed place [m]
    double time = 0.0;          ///< of it [s]
    double von_mises = 0.0;     ///< [Pa]
  };
  const SolidExtremes& solid_extremes() const { return extremes_; }
  const std::vector<float>& axial_forces() const { return axial_forces_; }  ///< by element [N]
  const std::vector<float>& bending_moments() const { return bending_moments_; }  ///< [N m]

 private:
  void append();
  void append_solids();
  void turn_to_base();
  spatial::Tensor calc_standing_hub() const;
  void observe_solids();

  scene::Scene scene_;
  scene::FrameReader reader_;
  scene::Frame frame_;
  bool is_free_in_space_;
  std::size_t most_frames_ = 0;
  std::vector<double> times_;
  std::vector<std::vector<float>> solids_;
  SolidExtremes extremes_;
  std::vector<float> hub_, groups_, displacements_, rotations_, axial_forces_, bending_moments_;
};

}  // namespace spoke::run_report
