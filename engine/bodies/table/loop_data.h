#pragma once

// A subsystem's closed loops in the table (docs/formulation.md, section 12). Rows of all its loops
// are numbered through, loop after loop.

#include <algorithm>
#include <cassert>
#include <cstddef>
#include <functional>
#include <utility>
#include <vector>

#include "engine/bodies/table/step_progress.h"
#include "engine/support/page_arena.h"
#include "engine/support/skyline.h"
#include "models/plane/plane.h"
#include "models/space/space.h"
#include "models/system/system.h"

namespace spoke {

/// A row at the state of a pass. Its unit force acts on the handle of `from` and against that of
/// `to`; the relative acceleration that belongs to it is
///   from . (acceleration of from's handle) + to . (of to's) + hub . Y''
/// with accelerations less gravity.
template <class World>
struct LoopRowState {
  TwistOf<World> from;  ///< wrench of the unit force on the handle, in the frame of its body
  TwistOf<World> to;    ///< likewise; zero unless a body carries `to`
  TwistOf<World> hub;   ///< on the hub, about its origin, in H; zero unless `to` is on the hub
  double opening;       ///< [m, rad]
  double rate;          ///< [m/s, rad/s]
  double given_rate;    ///< what prescribed motion of `to` makes of the rate [m/s, rad/s]
  /// The relative acceleration to be found; of a share of another subsystem's loop that comes
  /// through a hub, what happens without the forces of loops between that hub and it, with the
  /// other sign [m/s^2, rad/s^2].
  double target;
  double compliance;  ///< of a spring in an implicit pass; 0: rigid [m/(N s^2), rad/(N m s^2)]
  double force;       ///< of a spring in an explicit pass, which is given; else 0 [N, N m]
  /// Of the first row of a bearing with matrices in an implicit pass: the compliance that it shares
  /// with the next row; else 0.
  double shared_compliance;
  double loss;  ///< power of a bearing's matrices that no spring stores; else 0 [W]
};

/// How a row takes part in a pass.
enum class LoopRowUse : char {
  solved,   ///< its force is an unknown
  sprung,   ///< likewise in implicit passes; in explicit ones its force is given
  dropped,  ///< redundant: no force
};

/// Where the force of a row is found.
enum class LoopRowLevel : char {
  here,   ///< by the subsystem alone
  base,   ///< where all subsystems meet: the loop ends on another one
  share,  ///< likewise, for the share of a loop that is another subsystem's
};

/// A joint of the tree that the forces of a loop load: that of body `child`, at a handle of its
/// parent.
struct LoadedJoint {
  int parent = 0;
  int child = 0;
  int handle = 0;
  int child_at = -1;  ///< place of the child among the path's bodies; -1: it carries no loop

  bool carries() const { return child_at >= 0; }
};

/// The bodies and joints of a tree that the forces of one loop load.
struct LoopPath {
  int first_row = 0;
  int rows = 0;
  std::vector<int> bodies;          ///< that carry it, directly or not, from the tips to the hub
  std::vector<LoadedJoint> joints;  ///< of these bodies' children, in the order of elimination
  std::vector<int> roots;           ///< those of the bodies that the hub carries
  int handles = 0;                  ///< most of one of its bodies: the inboard one, and children's
  std::size_t first_joint = 0;      ///< place of the first joint's columns in LoopData::joints
  std::size_t first_branch = 0;     ///< place of its rows' bodies in LoopData::branches
  std::size_t first_handle = 0;     ///< place in LoopData::scratch

  /// Returns the place of a body in `bodies`; -1: it is none of them.
  int place_of(int body) const {
    const auto at = std::lower_bound(bodies.begin(), bodies.end(), body, std::greater<>());
    return at != bodies.end() && *at == body ? static_cast<int>(at - bodies.begin()) : -1;
  }
  /// Returns the place of the columns of a joint, or behind these of a root.
  std::size_t column(std::size_t joint, int row) const {
    return first_joint + joint * static_cast<std::size_t>(rows) + static_cast<std::size_t>(row);
  }
  std::size_t columns() const {
    return (joints.size() + roots.size()) * static_cast<std::size_t>(rows);
  }
  std::size_t branches() const { return bodies.size() * static_cast<std::size_t>(rows); }
};

/// What the loops of a subsystem did in a pass.
struct LoopReport {
  double opening;      ///< largest opening of a solved rigid row, of lengths by the model's [rad]
  double dropped;      ///< likewise of a redundant row
  double least_pivot;  ///< least pivot of D by what it was at the start
  std::int64_t row;    ///< row of that pivot
  double power;        ///< of anchors and mount [W]
  double dissipation;  ///< of dampers in closures [W]
  std::int64_t is_finite;  ///< 1: multipliers and pivots are
};

/// Whether a loop cannot be closed any more, or a redundant row has ceased to be one.
inline bool has_lost_loop(const LoopReport& report) {
  constexpr double kMost = 1e-4;
  return report.is_finite != 1 || report.dropped > kMost + 10.0 * report.opening;
}

/// The loops of a subsystem. Columns are by row.
template <class World>
struct LoopData {
  // Constants.
  int rows = 0;
  std::vector<LoopPath> paths;          ///< by loop
  std::vector<LoopRowUse> use;          ///< by row
  std::vector<LoopRowLevel> level;      ///< by row
  int closed = 0;                       ///< number of rows that are solved here
  int last_body = -1;                   ///< the last body that carries a loop
  std::vector<int> coupled;             ///< bodies whose joints are in couplings
  std::vector<int> bearings;            ///< first rows of bearings with matrices
  std::vector<std::vector<int>> meets;  ///< by loop: itself and those before that share a body
  /// The order in which rows are eliminated: by place in it the row, and by row the place. Rows of
  /// one loop follow one another; those come last that are not solved here, and stay.
  std::vector<int> row_at, place_of;

  // "loop motion"
  ArenaVector<PoseOf<World>> poses;           ///< of bodies, in H
  ArenaVector<TwistOf<World>> accelerations;  ///< of frames, by those of the last iterate
  ArenaVector<LoopRowState<World>> states;    ///< by row
  // "loop columns": what unit forces of rows that take part do, and what bodies do without them.
  /// By loaded joint, then by root, and row: relative acceleration at joints, acceleration of
  /// roots; and the wrenches that joints and roots transmit for it.
  ArenaVector<TwistOf<World>> joints, joint_forces;
  ArenaVector<TwistOf<World>> hub;  ///< N, by row: of the row per Y''
  ArenaVector<double> free;         ///< relative acceleration by row without unit forces
  /// By loop, row and body of its path: acceleration of the body's inboard handle.
  ArenaVector<TwistOf<World>> branches;
  ArenaVector<TwistOf<World>> scratch;  ///< by loop and handle of a body: its acceleration
  // "loop factor"; here rows are in the order of elimination.
  Skyline matrix;                        ///< D; then its Cholesky factor
  ArenaVector<TwistOf<World>> half_hub;  ///< L^-1 N
  ArenaVector<double> half;              ///< L^-1 (target - free); by "loop forces" the forces
  /// On D's diagonal; and those at the start, of explicit and of implicit passes.
  ArenaVector<double> pivots, first_explicit, first_implicit;
  // "loop forces"
  ArenaVector<double> multipliers;  ///< by row [N, N m]
  LoopReport report{};

  // Values at the end of the last step, by its last evaluation.
  ArenaVector<double> kept_multipliers;  ///< by row

  bool is_empty() const { return rows == 0; }
  bool is_closed(std::size_t row) const { return level[row] == LoopRowLevel::here; }
  /// Acceleration of the inboard handle of a body of a path, for a row of its loop.
  TwistOf<World>& branch(const LoopPath& path, int at, int of_loop) {
    assert(at >= 0 && std::cmp_less(at, path.bodies.size()) && of_loop >= 0);
    return branches[path.first_branch + path.bodies.size() * static_cast<std::size_t>(of_loop) +
                    static_cast<std::size_t>(at)];
  }
  const TwistOf<World>& branch(const LoopPath& path, int at, int of_loop) const {
    return const_cast<LoopData&>(*this).branch(path, at, of_loop);
  }
  /// Acceleration of a handle of the body at hand.
  TwistOf<World>& handle(const LoopPath& path, int h) {
    assert(h >= 0 && h < path.handles);
    return scratch[path.first_handle + static_cast<std::size_t>(h)];
  }
  /// Element of D, by rows.
  double& entry(int r, int c) {
    const int p = place_of[static_cast<std::size_t>(r)], q = place_of[static_cast<std::size_t>(c)];
    return matrix.entry(std::max(p, q), std::min(p, q));
  }

  /// Element of D, or of what the elimination of the rows before has left of it, by rows.
  double value(int r, int c) const {
    const int p = place_of[static_cast<std::size_t>(r)], q = place_of[static_cast<std::size_t>(c)];
    return matrix.value(std::max(p, q), std::min(p, q));
  }
};

/// The rows of the loops between subsystems, where these meet at the hub of the system: with D, N
/// and free of what subsystems have handed up. Of LoopData there are no paths, but the rows of each
/// loop, in the order of System::shared_loops.
template <class World>
struct SharedLoopData {
  LoopData<World> rows;
  /// What they add to effective mass and force of all subsystems.
  TwistMatrixOf<World> mass = TwistMatrixOf<World>::Zero();
  TwistOf<World> force = TwistOf<World>::Zero();
  std::vector<int> subsystems;  ///< on that hub, with rows that are handed up
  std::vector<int> visited;     ///< all that have places of these loops, or of hubs on the way
};

}  // namespace spoke
