#pragma once

// What the engine asks a body in space by its kind, each in a folder of its own: engine/bodies. A
// kind has no state: its functions work on the data of the body. In the plane all bodies are beams
// of one kind, whose functions are called by name.
//
// A virtual call is opaque to the instructions of a kernel (models/support/wide_kernels.h): the
// functions of a pass open kernels within, and are called outside of them.

#include <Eigen/Core>
#include <cstddef>
#include <span>

#include "engine/bodies/table/body_view.h"
#include "engine/bodies/table/step_data.h"

namespace spoke {

struct ElasticShares;
template <class World>
struct BodyMemory;
namespace structured {
template <class World>
struct BodyWork;
}

/// What a body that has several slices does by them, each in nodes of its own; p counts them.
class BodySlices {
 public:
  /// Calculates the terms of slice p of body j at time t [s].
  virtual void calc_terms(const System<Space>& system, double t, int j, int p,
                          SubsystemData<Space>& data) const noexcept = 0;
  /// Calculates the half solutions of slice p, before the body is condensed.
  virtual void condense(int p, bool implicit, BodyData<Space>& body) const noexcept = 0;
  /// Calculates the accelerations of slice p, behind the recovery of the body.
  virtual void recover(int p, bool implicit, BodyData<Space>& body) const noexcept = 0;
  /// Copies the accelerations of all into the flex vector `a`.
  virtual void take(const BodyData<Space>& body, double* a) const noexcept = 0;

 protected:
  ~BodySlices() = default;
};

/// A kind of bodies: what is made once, and what a pass calls; besides what others see of it.
template <>
class BodyKind<Space> : public BodyView<Space> {
 public:
  // Made once, of the constants of a body.

  /// Count the doubles of its work, and place the work in so much memory, aligned to 16 bytes.
  virtual std::size_t count_work(const space::Body& body) const = 0;
  virtual space::BodyWork place_work(const space::Body& body, double* memory) const = 0;
  /// Returns the sum of the squares of all coordinates up to which no deflection is above `range`
  /// [m].
  virtual double calc_surely_linear(const space::Body& body, double range) const = 0;
  /// Whether its strains are of second order.
  virtual bool has_nonlinear_strain(const space::Body&) const { return false; }
  /// Whether condensing it clears rows of its terms: those of coordinates that its frame fixes.
  virtual bool clears_rows(const space::Body&) const { return false; }
  /// Whether it may be eliminated by its mass in place of compliances
  /// (engine/bodies/tree/mass_elimination.h).
  virtual bool has_mass_alone() const { return false; }
  /// Makes its constant block; factors: of Mff, K and the damping of sections or of modes.
  virtual space::Block make_block(const space::Body& body,
                                  const space::BlockFactors& factors) const = 0;
  /// Makes what stiffens a body whose blocks are made, and memory that depends on it.
  virtual void make_tension(const ElasticShares& implicit, BodyMemory<Space>& memory,
                            Data& body) const = 0;
  /// Declares the parts of these of body j.
  virtual void declare_tension(std::size_t j, SubsystemData<Space>& data) const = 0;
  /// Return the rows of its terms, and the workspace of its kernels, but for those of slices.
  virtual std::span<double> rows_of(const Data&) const noexcept { return {}; }
  virtual std::span<double> scratch_of(const Data&) const noexcept { return {}; }
  /// Adds the memory of condensing it to its inverse, and declares what else has parts of its own.
  virtual void declare_inverse(const PartMaker& maker, Data& body, BodyParts& parts) const = 0;
  /// Places a load of the scenario.
  virtual PlacedLoad<Space, BodyLoad<Space>> place_load(const BodyLoad<Space>& load,
                                                        const space::Body& body) const = 0;
  /// Estimate the memory of its constants, which bodies of one type share, and of what it has in a
  /// tree besides its fields [bytes].
  virtual double estimate_constants(const space::Body& body) const = 0;
  virtual double estimate_own(const TreeBody<Space>& member) const = 0;
  /// Counts the nodes of a step graph that it has besides those of all bodies.
  virtual double count_own_nodes(const space::Body&) const { return 0.0; }

  // In a pass.

  /// Sets the motions of its handles against its frame.
  virtual void place_handles(Data& body) const noexcept = 0;
  /// Takes the twist of its inboard section to that of its frame, and the joint's motion, where
  /// this section moves against the frame.
  virtual void leave_inboard(const Data&, space::JointMotion&, space::Twist&) const noexcept {}
  /// Makes, at the first pass of a step, what the left-hand side has of the predicted state.
  virtual void follow_state(const HubState<Space>&, Data&) const noexcept {}
  /// Keeps what a step needs of the state at which it begins.
  virtual void keep_state(Data&) const noexcept {}
  /// Sets the terms of body j at the state in the table, (P 3) in space, without loads. `shares`:
  /// those of stiffness and damping that an implicit pass leaves to the unknown accelerations.
  virtual void calc_terms(const System<Space>& system, double t,
                          const space::ImplicitShares& shares, std::size_t j,
                          SubsystemData<Space>& data) const noexcept = 0;
  /// Adds all that is applied to body j at time t [s]: loads of the user's, then those of the
  /// scenario; and the tension of these and of the forces beyond the body. R_HB: only if a load is
  /// resolved in other frames.
  virtual void add_applied(double t, const space::Rotation& R_HB, std::size_t j,
                           SubsystemData<Space>& data) const noexcept = 0;
  /// Adds factor times forces on the deformation coordinates (flex vector).
  virtual void add_forces(double factor, const double* forces, Data& body) const noexcept = 0;
  /// Returns the sum of the scenario's loads on it, in B [N]; R_0: from the hub's frame to the
  /// inertial one.
  virtual space::Position sum_loads(double t, const space::Rotation& R_HB,
                                    const space::Rotation& R_0,
                                    const Data& body) const noexcept = 0;
  /// Returns its linear momentum by its terms, in B.
  virtual space::Position calc_linear_momentum(const Data& body,
                                               const space::Twist& twist) const noexcept = 0;
  /// Condenses the body to its multi-port; `twist`: of its frame.
  virtual void condense(const space::Twist& twist, bool implicit,
                        const structured::BodyWork<Space>& work, Data& body) const noexcept = 0;
  /// Sets X, and the accelerations of the deformation in the flex vector `a`, from the wrenches on
  /// the handles.
  virtual void recover(const structured::BodyWork<Space>& work, bool implicit, Data& body,
                       double* a) const noexcept = 0;
  /// Returns what it does by slices, if it has several, all else being done between these; else
  /// null.
  virtual const BodySlices* slices(const Data&) const noexcept { return nullptr; }

  // As full matrices, in the coordinates [X; q], for the dense formulations.

  /// Returns Mhat of the deformation; empty for a rigid body. factors: see make_block().
  virtual Eigen::MatrixXd make_dense_block(const space::Body& body,
                                           const space::BlockFactors& factors) const = 0;
  /// Fills the mass matrix of (P 3), `elastic` being its deformation block.
  virtual void calc_dense_mass(const Data& body, const Eigen::MatrixXd& elastic, bool implicit,
                               Eigen::Ref<Eigen::MatrixXd> mass) const = 0;
  /// Fills the right-hand side [Q; Q_f].
  virtual void calc_dense_force(const Data& body, Eigen::Ref<Eigen::VectorXd> force) const = 0;
  /// Fills the Jacobian J of a handle's twist with respect to the body's.
  virtual void calc_handle_jacobian(const Data& body, int handle,
                                    Eigen::Ref<Eigen::MatrixXd> J) const = 0;
  /// Returns its mass matrix, without what it carries.
  virtual Eigen::MatrixXd calc_own_mass(const Data& body) const;
  /// Returns K, or D, of its deformation.
  virtual Eigen::MatrixXd calc_stiffness(const Data& body) const;
  virtual Eigen::MatrixXd calc_damping(const Damping& damping, const Data& body) const;
  /// Adds the trace of K of its own coordinates, as far as it is cheap.
  virtual void add_stiffness_trace(const space::Body&, double&) const {}
  /// Returns the force on it at zero accelerations of its deformation: [Q; Q_f] - [M_RR; C^T] X.
  virtual Eigen::VectorXd calc_frame_force(const Data& body) const = 0;

 protected:
  ~BodyKind() = default;
};

/// Returns the kind of a body: the one place where it is chosen.
const BodyKind<Space>& kind_of(const space::Body& body) noexcept;

}  // namespace spoke
