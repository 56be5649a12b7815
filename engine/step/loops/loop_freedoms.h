#pragma once

// What the start of closed loops has found, for messages and checks: indices are from 0.

#include <vector>

namespace spoke {

/// A coordinate of a joint that was moved so that loops are closed.
struct LoopMove {
  int subsystem = 0;
  int body = 0;          ///< that the joint carries
  int coordinate = 0;    ///< of the joint; of an orientation the first one
  bool is_angle = true;  ///< else a displacement
  double by = 0.0;       ///< of an orientation the angle, positive [rad, m]
};

/// The speed of a coordinate of a joint that was changed so that loops stay closed.
struct LoopSpeed {
  int subsystem = 0;
  int body = 0;          ///< that the joint carries
  bool is_angle = true;  ///< else a displacement
  double from = 0.0;     ///< [rad/s, m/s]
  double to = 0.0;       ///< [rad/s, m/s]
};

/// A row of a loop.
struct LoopRowPlace {
  int subsystem = 0;
  int loop = 0;
  int row = 0;  ///< of the loop
};

/// Freedoms of a subsystem, the hub's not counted.
struct LoopFreedoms {
  int joints = 0;        ///< free coordinates of joints
  int deformations = 0;  ///< coordinates of deformations
  int rows = 0;          ///< rigid rows of its loops
  int independent = 0;   ///< those that are not redundant

  int mobility() const { return joints + deformations - independent; }
};

/// What counts at the start.
struct LoopLimits {
  /// Rows are redundant of which less than this share of the largest row is left across the others.
  double redundancy = 1e-9;
  double duration = 0.0;  ///< of the run, within which prescribed motions count [s]
  /// Whether loops have been started before, so that start_loops() leaves them as they are.
  bool has_started = false;
};

struct LoopStart {
  std::vector<LoopMove> moves;
  std::vector<LoopSpeed> speeds;
  std::vector<LoopRowPlace> dropped;   ///< redundant rows
  std::vector<LoopFreedoms> freedoms;  ///< by subsystem
};

}  // namespace spoke
