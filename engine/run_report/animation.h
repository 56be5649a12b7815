#pragma once

// The moving pictures of report.html.

#include <cstddef>
#include <vector>

#include "engine/simulation.h"

namespace spoke::run_report {

/// Pictures of a rotor over time: where its nodes are in the hub frame, and the hub's motion.
class Animation {
 public:
  static constexpr std::size_t kMostFrames = 400;
  static constexpr std::size_t kFewestFrames = 40;
  static constexpr std::size_t kMostNumbers = 400000;  ///< of all frames together
  static constexpr std::size_t kMostNodes = 2000;      ///< in a picture

  /// Large models get fewer frames, or a part of their nodes.
  explicit Animation(const Simulation& simulation);

  /// How many frames there should be.
  std::size_t most_frames() const { return most_frames_; }
  /// Adds a picture of simulation.time(), unless the last one is of that time or a number in it is
  /// not finite.
  void add(const Simulation& simulation);

  struct Blade {
    std::vector<Position> undeformed;  ///< of the nodes that are shown, hub frame [m]
    int nodes_per_body = 0;            ///< that are shown; 0: they do not end where bodies do
  };
  const std::vector<Blade>& blades() const { return blades_; }
  const std::vector<double>& times() const { return times_; }  ///< [s]
  const std::vector<float>& hub() const { return hub_; }       ///< by frame: x, y [m], angle
  /// x and y by frame and node, resolved in the hub frame [m]
  const std::vector<float>& displacements() const { return displacements_; }
  float largest_displacement() const;  ///< largest of these numbers [m]

 private:
  /// Calls visit(node) for the nodes of shape_ that are shown.
  template <class Visit>
  void each_shown(Visit visit) const;

  std::size_t stride_ = 1;  ///< one node in so many is shown, and the tip
  std::size_t most_frames_ = 0;
  std::vector<Blade> blades_;
  std::vector<double> times_;
  std::vector<float> hub_;
  std::vector<float> displacements_;
  BladeShape shape_;
};

}  // namespace spoke::run_report
