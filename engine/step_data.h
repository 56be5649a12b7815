#pragma once

// Everything that changes during a step, as a table: one structure per producing node of the step
// graph. Structures hold doubles only, side by side, so that the graph can check declared accesses
// by memory. Vectors of deformation coordinates ("flex vectors") are stored padded, see FlexLayout.

#include <Eigen/Core>
#include <array>
#include <span>
#include <vector>

#include "engine/elastic_block.h"
#include "models/system.h"

namespace spoke {

/// Where the axial and bending parts of a body's flex vector stand in its storage. Four zeros stand
/// before and behind each part, so that banded products need no special rows at the ends.
struct FlexLayout {
  int axial = 0;
  int bending = 0;

  static constexpr int kPad = 4;
  int u() const { return kPad; }
  int v() const { return 2 * kPad + rounded(axial); }
  int size() const { return 3 * kPad + rounded(axial) + rounded(bending); }

 private:
  static int rounded(int n) { return (n + kPad - 1) / kPad * kPad; }
};

/// Coordinates that are integrated together: a body's deformation, or the hub's x, y and angle.
/// All arrays have `size` values (for a body: in its FlexLayout).
struct CoordinateBlock {
  int size = 0;
  double* q = nullptr;  ///< coordinates
  double* v = nullptr;  ///< velocities
  double* a = nullptr;  ///< accelerations
  std::array<double*, 4> history{};  ///< the integrator's own, see engine/integrator

  /// The block of coordinate `c` alone.
  CoordinateBlock component(int c) const {
    CoordinateBlock one{1, q + c, v + c, a + c, history};
    for (double*& h : one.history)
      if (h) h += c;
    return one;
  }
};

/// What one pass over the step graph evaluates; set by the integrator before the pass, constant
/// during it.
struct PassControl {
  static constexpr int kEvaluateOnly = -1;

  double time = 0.0;          ///< of the state to evaluate [s]
  int stage = kEvaluateOnly;  ///< of rk4, or iteration of generalized_alpha
  bool implicit = false;      ///< solve with the implicit elastic block
};

/// How a body stands to its chain, from the position analysis.
struct BodyPose {
  Pose X_HB;      ///< body frame in the hub frame
  Rotation R_PB;  ///< body frame to the parent's body frame (of the first body: to the hub frame)
};

/// Terms of a body's equations of motion that its state determines (docs/formulation.md, section
/// 2), all in the body frame. The flex vectors c_theta and Q_f belong to them.
struct BodyTerms {
  Position S;                    ///< first moment S0 + S qf [kg m]
  double rotary_inertia;         ///< M_ww [kg m^2]
  Twist Q;                       ///< right-hand side of translation and rotation [N, N m]
  double centrifugal_inertia;    ///< qf^T KG qf [kg m^2]
  double centrifugal_rate;       ///< qf^T KG qf' [kg m^2/s]
  double load_power;             ///< of applied loads [W]
  double dissipation;            ///< qf'^T D qf' [W]
};

/// What a body shows its neighbours: forces on the two handles to their accelerations,
/// a_i = P_ii F + P_io f + free_i, a_o = P_io^T F + P_oo f + free_o (all in the body frame).
struct TwoPort {
  TwistMatrix S_inverse;   ///< inverse of the condensed rigid-body mass M_RR - C Mhat^-1 C^T
  Twist p;                 ///< condensed rigid-body force [N, N m]
  TwistMatrix X_i, X_o;    ///< handle acceleration per frame acceleration, deformation following
  TwistMatrix P_ii, P_io, P_oo;
  Twist free_i, free_o;    ///< accelerations of the handles without joint forces
};

/// Elimination of the joint outboard of a body: its wrench on the body is
/// f = Pi (rhs - P_oi F), F the wrench on the body's inboard handle.
struct JointElimination {
  TwistMatrix Pi;
  Twist rhs;
};

/// A subsystem as the hub feels it, (P 10), in the hub frame, and how its root wrench follows.
struct EffectiveInertia {
  TwistMatrix mass;            ///< M^C
  Twist force;                 ///< Q^C
  double centrifugal_inertia;  ///< sum over the bodies
  double centrifugal_rate;
  TwistMatrix root_mass;       ///< Lambda^-1: wrench on the root handle per its acceleration
  Twist root_free;             ///< acceleration of the root handle without wrench, body frame
};

/// Wrenches on a body's two handles, in its frame: inboard, these are the multipliers of (P 8).
struct HandleWrenches {
  Twist inboard;
  Twist outboard;
};

/// Hub motion at the evaluated state.
struct HubState {
  Rotation R;   ///< hub frame to inertial frame
  Twist twist;  ///< velocity (resolved in the hub frame) and angular velocity
};

/// Result of (P 9).
struct HubSolution {
  Twist acceleration;    ///< hub frame, less gravity: a - g (see solve_hub)
  Twist reaction;        ///< wrench of the support and drive on the hub, hub frame [N, N m]
  double applied_torque; ///< of a torque drive [N m]
  double change;         ///< of a free coordinate in this iteration [m, rad]
};

/// What a body's recovery reports to the end of the pass.
struct BodyReport {
  double change;   ///< largest change of a coordinate in this iteration [m, rad]
  double failed;   ///< 1 if a coordinate is not finite or beyond its limit
};

/// The pass as a whole, summed in fixed order.
struct PassReport {
  double change;       ///< largest change of a coordinate in this iteration [m, rad]
  double power;        ///< of drive and loads [W]
  double dissipation;  ///< [W]
  double failed;       ///< 1 if any body or the hub failed
};

/// One body's share of the table.
struct BodyData {
  const ChainBody* model = nullptr;
  std::array<const ElasticBlock*, 2> blocks{};  ///< explicit, implicit
  FlexLayout layout;

  CoordinateBlock coordinates;
  const double* q_elastic = nullptr;  ///< coordinates in the elastic force (flex vector)
  const double* v_elastic = nullptr;  ///< velocities in the damping force (flex vector)

  BodyTerms terms;
  double* c_theta = nullptr;  ///< M_fw = c0 + G^T qf (flex vector)
  double* Q_f = nullptr;      ///< right-hand side of the deformation (flex vector)
  double* a_found = nullptr;  ///< accelerations that the pass finds (flex vector); rk4: `a` itself
  Twist X;                    ///< frame acceleration, body frame, less gravity
  BodyReport report;
};

/// One subsystem's share of the table; vectors by body, root to tip.
struct SubsystemData {
  std::vector<BodyData> bodies;
  std::vector<BodyPose> poses;
  std::vector<Twist> twists;  ///< of the body frames, in the body frames
  EffectiveInertia effective;
  std::vector<HandleWrenches> wrenches;
  Eigen::VectorXd storage;  ///< of all flex vectors
};

struct StepData {
  PassControl control;
  HubState hub;
  HubSolution hub_solution;
  CoordinateBlock hub_coordinates;
  std::array<Twist, 7> hub_storage;  ///< of hub_coordinates
  std::vector<SubsystemData> subsystems;
  PassReport report;
};

/// Allocates the table for a system, at rest and undeformed; `history` flex vectors per body. What
/// depends on the method is left to allocate(StepContext&). The system must outlive the data, which
/// must not move.
void allocate(const System& system, int history, StepData& data);

/// Memory of a structure of doubles, or of `count` of them in a row.
template <class T>
std::span<double> doubles(T& first, std::size_t count = 1) {
  static_assert(sizeof(T) % sizeof(double) == 0);
  return {reinterpret_cast<double*>(&first), count * sizeof(T) / sizeof(double)};
}

}  // namespace spoke
