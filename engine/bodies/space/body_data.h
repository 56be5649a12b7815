#pragma once

// Inputs and outputs of the kernels of a spatial body: the contract between a flexible body and the
// rest of the engine. Everything is resolved in the body frame B unless said otherwise.

#include <array>
#include <vector>

#include "engine/bodies/space/elastic_block.h"
#include "engine/bodies/space/handle_motion.h"
#include "engine/bodies/space/nodal_tiles.h"
#include "models/space/rigid_body.h"
#include "models/space/solid.h"
#include "models/space/space.h"
#include "models/space/tension_place.h"

namespace spoke::space {

/// Constants of a body in its tree.
struct BodyModel {
  const FlexibleBody* body = nullptr;
  std::array<const ElasticBlock*, 2> blocks{};  ///< explicit, implicit
  const TensionPlace* tension = nullptr;        ///< null: without geometric stiffening
  const ImplicitShift* shift = nullptr;         ///< of the implicit block; null: none
};

/// Flex vectors of a body.
struct BodyState {
  const double* q = nullptr;
  const double* v = nullptr;
  const double* q_elastic = nullptr;  ///< coordinates in the elastic force
  const double* v_elastic = nullptr;  ///< velocities in the damping force
};

/// Motion on which a body's terms depend besides its deformation.
struct BodyMotion {
  Angular w = Angular::Zero();          ///< angular velocity of B [rad/s]
  Angular hub_w = Angular::Zero();      ///< angular velocity of the hub, in H [rad/s]
  Position gravity = Position::Zero();  ///< in H [m/s^2]; only for the tension, see TensionPlace
};

/// Terms of a body's stiffening in the hub's equation, in H.
struct HubStiffening {
  Matrix3 inertia = Matrix3::Zero();   ///< Lambda, taken off the hub's inertia, symmetric [kg m^2]
  Matrix3 rate = Matrix3::Zero();      ///< Lambda' [kg m^2/s]
  Position moment = Position::Zero();  ///< g x gamma, by gravity's tension [N m]

  HubStiffening& operator+=(const HubStiffening& other) {
    inertia += other.inertia;
    rate += other.rate;
    moment += other.moment;
    return *this;
  }
};
/// Returns the moment on the hub by the stiffening, on the right-hand side: Lambda' w0 + w0 x
/// (Lambda w0) + g x gamma.
inline Angular calc_stiffening_moment(const HubStiffening& s, const Angular& w0) {
  return s.rate * w0 + cross(w0, Position(s.inertia.lazyProduct(w0))) + s.moment;
}

/// gamma of calc_tension_moment() and its rate, in H.
struct TensionMoment {
  Position value = Position::Zero();  ///< [kg m]
  Position rate = Position::Zero();   ///< [kg m/s]
};
/// Returns the power of a field in H [m/s^2] on the tension of a body [W]: on its deformation, and
/// on the hub, which turns the field.
inline double calc_tension_power(const TensionMoment& gamma, const Angular& hub_w,
                                 const Position& field) {
  return hub_w.dot(cross(field, gamma.value)) - field.dot(gamma.rate);
}

/// Mass terms and right-hand side of a body's frame.
struct BodyTerms {
  Position S = Position::Zero();       ///< first moment [kg m]
  Position S_rate = Position::Zero();  ///< rate of S by the deformation [kg m/s]
  Matrix3 Theta = Matrix3::Zero();     ///< inertia about the origin [kg m^2]
  Twist Q = Twist::Zero();             ///< right-hand side of translation and rotation [N, N m]
  HubStiffening stiffening;
  TensionMoment tension;
  double load_power = 0.0;   ///< power of applied loads [W]
  double dissipation = 0.0;  ///< q'^T D q' [W]
};

/// Returns Q of a frame at its angular velocity w, from first moment, Theta w, the rate of the
/// first moment and G = sum rho mu'^T over the slots:
///   Q_t = -w x (w x S) - 2 w x S',  Q_w = -w x Theta w - 2 (tr(G) w - G^T w)
inline Twist calc_frame_force(const Angular& w, const Position& S, const Angular& Theta_w,
                              const Position& S_rate, const Matrix3& G) {
  return make_twist(-cross(w, cross(w, S) + 2.0 * S_rate),
                    -cross(w, Theta_w) - 2.0 * (G.trace() * w - G.transpose().lazyProduct(w)));
}

/// The inertia of the hub of a rotor on a support, with what the rotor's subsystems add to it.
struct CarriedInertia {
  SymmetricTwistMatrix mass;     ///< about the hub's origin, in its frame
  SymmetricTwistMatrix inverse;  ///< its inverse; not in the augmented formulation
  Twist force = Twist::Zero();   ///< added to the hub's right-hand side [N, N m]
};

/// Results of condensing a body besides its multi-port.
struct Condensed {
  SymmetricTwistMatrix S_inverse;  ///< inverse of S_R = M_RR - C Mhat^-1 C^T
  Twist p = Twist::Zero();         ///< Q_R - C z [N, N m]
  TwistMatrix* X = nullptr;        ///< X_h by handle: its acceleration per X, deformation following
};

/// A slot and its rate, side by side: x, y, z, x', y', z'.
inline constexpr int kSlot = 6;
/// Values of a node in BodyWork::rows.
inline constexpr int kNodeRows = 4 * kTwist;

/// Values by node of one component, in BodyScratch::lanes: node k stands at 1 + k, and zeros
/// around.
inline std::size_t lane_stride(const FlexibleBody& body) {
  return static_cast<std::size_t>(body.node_count()) + 8;
}
/// Six components of three flex vectors, and of the forces of both ends of elements.
inline constexpr int kLaneRows = 5 * kTwist;
inline std::size_t count_lanes(const FlexibleBody& body) {
  return body.directions ? kLaneRows * lane_stride(body) : 0;
}

/// Memory of a body's kernels, all of doubles; see place_work().
struct BodyWork {
  /// By node six rows of four: rows of C_w^T (x, y, z), and of the right-hand side Q_f. Rows of
  /// coordinates that the frame fixes are meaningless until condensed, and then zero.
  double* rows = nullptr;
  double* half = nullptr;           ///< L^-1 of the rows, by node six rows of four
  HandleMotion* handles = nullptr;  ///< motions that calc_handles() has set
  Condensed condensed;
  tree::MultiPort<Space> port;
  Twist* wrenches = nullptr;  ///< wrenches of the joints on the handles
  /// Memory within one kernel only, of reduced solids and of beams of many elements: see
  /// body_scratch.h.
  double* scratch = nullptr;

  // Of solids in nodal coordinates (nodal_memory.h).
  NodalWork tiles;             ///< memory of the terms, with `rows`
  NodalWork observed;          ///< the same for what sensors show; without rows
  double* products = nullptr;  ///< products of half solutions, by slice and of what is between
  double* solution = nullptr;  ///< accelerations of the deformation coordinates
};

/// Counts the doubles of BodyWork::scratch; none where the stack has room.
std::size_t count_scratch(const FlexibleBody& body);
/// Count the doubles of a body's work, and place the work in so much memory, aligned to 16 bytes.
std::size_t count_work(const FlexibleBody& body);
BodyWork place_work(const FlexibleBody& body, double* memory);

/// Count and place the work of a rigid body, which has handles and a multi-port only.
std::size_t count_work(const RigidBody& body);
BodyWork place_work(const RigidBody& body, double* memory);

/// Count and place the work of a solid: rows of four by coordinate, handles and a multi-port. Of a
/// reduced one `scratch` is memory for kSolidVectors vectors, padded as in reduced_products.h. Of
/// one in nodal coordinates rows and all that depends on tiles have memory of their own
/// (nodal_memory.h).
inline constexpr int kSolidVectors = 24;
std::size_t count_scratch(const Solid& body);  ///< doubles of `scratch`
std::size_t count_work(const Solid& body);
BodyWork place_work(const Solid& body, double* memory);

/// Copy a flex vector to values by node, six each, with zeros where the frame fixes coordinates;
/// and back.
void expand(const FlexibleBody& body, const double* flex, double* nodal) noexcept;
void compress(const FlexibleBody& body, const double* nodal, double* flex) noexcept;
/// Copies those values of the two nodes of an element only.
void expand_element(const FlexibleBody& body, int element, const double* flex,
                    double* nodal) noexcept;

}  // namespace spoke::space
