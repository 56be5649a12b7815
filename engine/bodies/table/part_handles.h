#pragma once

// Handles of the table's parts, by which nodes declare what they read and write. One that a model
// has no part for is invalid, and names none (graph::maybe).

#include <vector>

#include "graph/access.h"

namespace spoke {

/// Parts of a body.
struct BodyParts {
  bool is_root = false;         ///< whether the hub carries it
  graph::PartId coordinates;    ///< q, v
  graph::PartId history;        ///< the integrator's vectors
  graph::PartId accelerations;  ///< a, X
  graph::PartId found;          ///< accelerations that a recovery finds, if apart from a
  graph::PartId terms;          ///< with c_theta and Q_f
  graph::PartId power;          ///< power of loads and damping
  graph::PartId inverse;        ///< two-port, or dense inverse columns
  graph::PartId workspace;      ///< workspace of the inverse
  graph::PartId scratch;  ///< workspace of the kernels of its terms and of its recovery (space)
  graph::PartId joint;    ///< elimination of the inboard joint (structured, not at the hub)
  graph::PartId port;     ///< multi-port, which the effective inertia changes (structured, space)
  graph::PartId carried;  ///< what a rotor's subsystems add to its hub, if the body is that (space)
  graph::PartId report;
  graph::PartId tension;  ///< tension in implicit steps, if the body has any
  // Of a solid in nodal coordinates, by slice: rows and sums of its terms; half solutions and
  // accelerations (structured). Of these the last part is what is between slices.
  std::vector<graph::PartId> tiles, halves, solution;
};

/// Parts of a subsystem's closed loops.
struct LoopParts {
  graph::PartId motion;                ///< states of rows
  std::vector<graph::PartId> columns;  ///< by loop: what its unit forces do
  std::vector<graph::PartId> scratch;  ///< by loop: workspace
  graph::PartId factor;                ///< D, and the multipliers
  graph::PartId first_pivots;          ///< pivots of D at the start; not if augmented
  graph::PartId report;

  bool is_empty() const { return motion.index < 0; }
};

/// Parts of a subsystem.
struct SubsystemParts {
  std::vector<BodyParts> bodies;
  graph::PartId rotations, twists, poses, effective, wrenches, samples;
  graph::PartId drag_poses;             ///< if there are any
  graph::PartId applied_forces;         ///< if a tension depends on them
  graph::PartId modal_forces;           ///< if modes damp beams
  graph::PartId joint_loads, readings;  ///< with the load of the root; if there are sensors
  graph::PartId progress, hub_state, hub_acceleration;  ///< own ones, or the system's if coupled
  graph::PartId records;                                ///< if not coupled
  graph::PartId workspace;                              ///< workspace of the effective inertia
  LoopParts loops;                                      ///< if there are loops

  /// Returns one member of all bodies, parents before children.
  std::vector<graph::PartId> all(graph::PartId BodyParts::*member) const;
  /// Returns the tiles of all bodies.
  std::vector<graph::PartId> tiles() const;
  /// Returns the parts of the joints between the bodies.
  std::vector<graph::PartId> joints() const;
  /// Returns the multi-ports of the bodies, if they have any.
  std::vector<graph::PartId> ports() const;
};

/// Parts of a rotor on a support.
struct RotorParts {
  graph::PartId hub;      ///< motion of its hub
  graph::PartId carried;  ///< what its subsystems add to the hub
  graph::PartId records;
};

/// Parts of the system.
struct SystemParts {
  std::vector<RotorParts> rotors;
  graph::PartId hub_coordinates, hub_history, records;
  graph::PartId progress, hub_state, hub_solution;  ///< if coupled
  graph::PartId flight_acceleration;                ///< if coupled
  graph::PartId augmented_solution;
  graph::PartId shared_loops, first_pivots;  ///< of loops between subsystems, if there are some
};

}  // namespace spoke
