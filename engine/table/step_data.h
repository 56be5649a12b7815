#pragma once

// Everything that changes during a step, as a table: one structure per producing node of the step
// graph. Any bits are a value of each member (see Flag), so that the graph can check declared
// accesses by memory. Vectors of deformation coordinates ("flex vectors") are stored padded, see
// FlexLayout.

#include <Eigen/Core>
#include <array>
#include <limits>
#include <memory>
#include <span>
#include <vector>

#include "engine/body/elastic_block.h"
#include "engine/table/load_data.h"
#include "engine/table/reading.h"
#include "engine/table/step_progress.h"
#include "models/system/system.h"

namespace spoke {

/// Coordinates that are integrated together: a body's deformation, or the hub's x, y and angle.
/// All arrays have `size` values (for a body: in its FlexLayout). Coordinates stand in the places
/// from `margin` to `gap_begin`, and from `gap_end` to size - margin; what stands elsewhere is
/// padding, and zero.
struct CoordinateBlock {
  int size = 0;
  int margin = 0;
  int gap_begin = 0;
  int gap_end = 0;
  double* q = nullptr;               ///< coordinates
  double* v = nullptr;               ///< velocities
  double* a = nullptr;               ///< accelerations
  std::array<double*, 4> history{};  ///< the integrator's own, see engine/integrator

  /// The block of coordinate `c` alone.
  CoordinateBlock component(int c) const {
    CoordinateBlock one{1, 0, 0, 0, q + c, v + c, a + c, history};
    for (double*& h : one.history)
      if (h) h += c;
    return one;
  }
  /// Calls `apply(first, n)` with the place of the first of n neighbouring coordinates, for all.
  template <class Apply>
  void for_parts(Apply&& apply) const {
    if (gap_begin > margin) apply(margin, gap_begin - margin);
    apply(gap_end, size - margin - gap_end);
  }
};

/// Terms of a body's equations of motion that its state determines (docs/formulation.md, section
/// 2), all in the body frame. The flex vectors c_theta and Q_f belong to them.
struct BodyTerms {
  Position S;                  ///< first moment S0 + S qf [kg m]
  double rotary_inertia;       ///< M_ww [kg m^2]
  Twist Q;                     ///< right-hand side of translation and rotation [N, N m]
  double centrifugal_inertia;  ///< qf^T KG qf [kg m^2]
  double centrifugal_rate;     ///< qf^T KG qf' [kg m^2/s]
  double load_power;           ///< of applied loads [W]
  double dissipation;          ///< qf'^T D qf' [W]
};

/// X_o of a straight beam, [xx 0 xr; 0 yy yr; 0 ry rr]: axial and bending response decouple.
struct HandleMap {
  double xx = 1.0, xr = 0.0;
  double yy = 1.0, yr = 0.0;
  double ry = 0.0, rr = 1.0;
};

/// What a body shows its neighbours: forces on the two handles to their accelerations,
/// a_i = P_ii F + P_io f + free_i, a_o = P_io^T F + P_oo f + free_o (all in the body frame).
struct TwoPort {
  SymmetricTwistMatrix
      S_inverse;  ///< inverse of the condensed rigid-body mass M_RR - C Mhat^-1 C^T
  Twist p;        ///< condensed rigid-body force [N, N m]
  // Handle accelerations per frame acceleration, deformation following: X_e = J_e - E_e W.
  HandleMap X_o;
  Twist x_i;  ///< last row of X_i; the others are the identity's, for the frame stands there
  SymmetricTwistMatrix P_ii, P_oo;
  TwistMatrix P_io;
  Twist free_i, free_o;  ///< accelerations of the handles without joint forces
};

/// Elimination of the joint outboard of a body: its wrench on the body is
/// f = Pi (rhs - P_oi F), F the wrench on the body's inboard handle.
struct JointElimination {
  SymmetricTwistMatrix Pi;
  Twist rhs;
};

/// A subsystem as the hub feels it, (P 10), in the hub frame.
struct EffectiveInertia {
  TwistMatrix mass;            ///< M^C
  Twist force;                 ///< Q^C
  double centrifugal_inertia;  ///< sum over the bodies
  double centrifugal_rate;
};

/// Wrenches on a body's two handles, in its frame: inboard, these are the multipliers of (P 8).
struct HandleWrenches {
  Twist inboard;
  Twist outboard;
};

/// Hub motion at the evaluated state.
struct HubState {
  Position p;   ///< in the inertial frame [m]
  Rotation R;   ///< hub frame to inertial frame
  Twist twist;  ///< velocity (resolved in the hub frame) and angular velocity
};

/// Hub motion that support and drive prescribe.
struct PrescribedHub {
  HubState state;
  Twist acceleration;  ///< hub frame, less gravity: a - g (see solve_hub)
};

/// Result of (P 9).
struct HubSolution {
  Twist acceleration;     ///< hub frame, less gravity: a - g (see solve_hub)
  Twist reaction;         ///< wrench of the support and drive on the hub, hub frame [N, N m]
  double applied_torque;  ///< of a torque drive [N m]
  Twist load;             ///< of the loads on the hub, about its axis, hub frame [N, N m]
  double change;          ///< of a free coordinate in this iteration [m, rad]
};

/// What a body's recovery reports to the end of the pass.
struct BodyReport {
  double change;      ///< largest change of a coordinate in this iteration [m, rad]
  double deflection;  ///< by the body's length, if beyond the linear range; else 0
  Flag failed;        ///< a coordinate is not finite or beyond its limit
};

/// One body's share of the table.
struct BodyData {
  const ChainBody* model = nullptr;
  // Offsets of the handles' coordinates (u, v, psi) in flex vectors; of those that the reference
  // frame fixes, one into the padding, which is zero.
  std::array<int, kTwist> inboard_at{};
  std::array<int, kTwist> outboard_at{};
  std::array<const ElasticBlock*, 2> blocks{};  ///< explicit, implicit
  FlexLayout layout;
  double linear_range = std::numeric_limits<double>::infinity();  ///< of deflections [m]
  /// No deflection is beyond the linear range if the sum of the squares of all coordinates is not
  /// greater than this.
  double surely_linear = std::numeric_limits<double>::infinity();

  CoordinateBlock coordinates;
  const double* q_elastic = nullptr;  ///< coordinates in the elastic force (flex vector)
  const double* v_elastic = nullptr;  ///< velocities in the damping force (flex vector)

  BodyTerms terms;
  double* c_theta = nullptr;  ///< M_fw = c0 + G^T qf (flex vector)
  double* Q_f = nullptr;      ///< right-hand side of the deformation (flex vector)
  double* a_found = nullptr;  ///< accelerations that the pass finds (flex vector); rk4: `a` itself
  Twist X;                    ///< frame acceleration, body frame, less gravity
  BodyReport report;
  std::vector<AppliedWrench> applied;  ///< by loads of the user's
  std::vector<PlacedLoad<BodyLoad>> loads;
  std::vector<PlacedLoad<BodyDrag>> drags;
};

/// One subsystem's share of the table; vectors by body, root to tip.
struct alignas(kInterferenceSize) SubsystemData {
  Arena* arena = nullptr;  ///< of its arrays
  ArenaVector<BodyData> bodies;
  /// R_PB: from the body frame to the parent's body frame (of the first body: to the hub frame).
  ArenaVector<Rotation> rotations;
  ArenaVector<Twist> twists;  ///< of the body frames, in the body frames
  EffectiveInertia effective;
  ArenaVector<HandleWrenches> wrenches;
  ArenaVector<Pose> poses;       ///< in the hub frame; for sensors, no part of a step
  ArenaVector<Pose> drag_poses;  ///< the same during a step; none unless drag depends on them
  ArenaVector<double> storage;   ///< of all flex vectors
  std::vector<LoadData> loads;   ///< of the user's, whose first blade this is

  // What the subsystem's nodes follow: the system's if it is coupled, else its own.
  StepProgress* progress = nullptr;
  const HubState* hub = nullptr;
  const Twist* hub_acceleration = nullptr;  ///< hub frame, less gravity

  PrescribedHub prescribed;              ///< if not coupled
  ArenaVector<StepRecord> records;       ///< ring by step, if not coupled
  ArenaVector<SubsystemSample> samples;  ///< ring by step

  // At the end of the last step, by its last evaluation.
  Twist root_load =
      Twist::Zero();               ///< what the blade does to the hub, in the blade's axes [N, N m]
  ArenaVector<Twist> joint_loads;  ///< on the inboard handle of each body, body frames [N, N m]

  // Sensors of the scenario's.
  std::vector<Reading> readings;
  std::size_t reading_count = 0;     ///< values that they take
  ArenaVector<double> reading_ring;  ///< by step, reading_count each
};

/// Values of the readings of a step in the ring.
inline double* readings_of(SubsystemData& data, std::int64_t step) {
  return data.reading_ring.data() +
         data.reading_count * (static_cast<std::size_t>(step) % data.samples.size());
}
inline const double* readings_of(const SubsystemData& data, std::int64_t step) {
  return readings_of(const_cast<SubsystemData&>(data), step);
}

struct StepData {
  Window window;
  /// One progress and one hub motion for all subsystems, because the hub has a free coordinate, the
  /// formulation solves for all at once, or a load of the user's acts between subsystems. Else each
  /// has its own.
  bool is_coupled = false;
  std::vector<StepProgress> progress;  ///< one, or one for each subsystem
  HubState hub;
  HubSolution hub_solution;
  CoordinateBlock hub_coordinates;
  std::array<Twist, 7> hub_storage;            ///< of hub_coordinates
  std::vector<std::unique_ptr<Arena>> arenas;  ///< by subsystem; they outlive what lies in them
  std::vector<SubsystemData> subsystems;
  std::vector<SystemRecord> records;  ///< ring by step
};

/// What the table's size depends on besides the system.
struct TableOptions {
  int history = 0;          ///< flex vectors per body that the integrator keeps
  bool is_coupled = false;  ///< see StepData
  int window_steps = 1;     ///< steps between the first without a record and the last begun
  /// Deflections by the length of their body up to which linear elasticity holds.
  double linear_range = std::numeric_limits<double>::infinity();
};

/// Allocates the table for a system, at rest and undeformed. What depends on the method is left to
/// allocate(StepContext&). The system must outlive the data, which must not move.
void allocate(const System& system, const TableOptions& options, StepData& data);

/// The record of a step in a ring.
template <class Ring>
auto& of_step(Ring& ring, std::int64_t step) {
  return ring[static_cast<std::size_t>(step) % ring.size()];
}

/// Memory of a structure of doubles, or of `count` of them in a row.
template <class T>
std::span<double> doubles(T& first, std::size_t count = 1) {
  static_assert(sizeof(T) % sizeof(double) == 0);
  return {reinterpret_cast<double*>(&first), count * sizeof(T) / sizeof(double)};
}

}  // namespace spoke
