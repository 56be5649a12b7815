#pragma once

// Fields of a spatial body in the table: flexible or rigid, with the joint that carries it.

#include <optional>

#include "engine/bodies/body_types.h"
#include "engine/bodies/space/body_data.h"
#include "engine/bodies/space/hub_motion.h"
#include "engine/bodies/space/implicit_strain.h"
#include "engine/bodies/space/implicit_tension.h"
#include "engine/bodies/space/joint_terms.h"
#include "engine/bodies/space/reduced_products.h"
#include "engine/bodies/space/rigid_body_terms.h"
#include "engine/bodies/space/rotation_block.h"
#include "engine/bodies/space/section.h"
#include "engine/bodies/space/solid_block.h"
#include "engine/bodies/space/solid_tension.h"
#include "models/space/body.h"
#include "models/space/hub.h"
#include "models/space/tree_joint.h"

namespace spoke::space {

/// The deformation coordinates of a spatial body stand side by side.
struct Layout {
  int coordinates = 0;

  static constexpr int kPad = 0;
  int size() const { return coordinates; }
  /// Returns the distance from a vector to the next in storage: each begins at an even place.
  int stride() const { return coordinates + coordinates % 2; }
  int offset(int index) const { return index; }
  /// Calls `apply(first, n)` with the place of the first of n coordinates that stand side by side.
  template <class Apply>
  void for_parts(Apply&& apply) const {
    if (coordinates > 0) apply(0, coordinates);
  }
};

Layout make_layout(const Body& body);
/// Sets which places of flex vectors hold coordinates: all.
void set_extent(const Layout& layout, CoordinateBlock& block);
/// The constant block of a flexible body, or the multi-port of a rigid one.
struct Block {
  std::optional<ElasticBlock> elastic;
  std::optional<RigidPort> rigid;
  std::optional<SolidBlock> solid;
  std::optional<ReducedProducts> products;  ///< of a reduced solid, in its explicit block
};

/// An effort of an actor, on one of the coordinates.
struct AddedEffort {
  int coordinate = 0;
  const JointEffort* effort = nullptr;
};

/// Data of the joint that carries a body. Its arrays lie in the body's storage.
struct JointData {
  CoordinateBlock coordinates;
  double* a_found = nullptr;           ///< accelerations that the pass finds; for rk4 `a` itself
  PrescribedMotion* driven = nullptr;  ///< by driven component
  JointForces* forces = nullptr;
  std::vector<AddedEffort> added;     ///< by actors
  RotationState* rotation = nullptr;  ///< rotation of the spherical primitive
};

/// True place of a coordinate that slides: bodies inboard are drawn inward, their child is not.
struct SlideState {
  double shift = 0.0;   ///< true coordinate less the coordinate [m]
  double rate = 0.0;    ///< [m/s]
  double force = 0.0;   ///< force of springs, dampers, stops and motors there [N]
  double change = 0.0;  ///< change of the force by the shift [N]
};

/// Fields of a spatial body in the table.
struct BodyFields {
  const BodyKind<Space>* kind = nullptr;  ///< chosen once, when the table is allocated
  BodyWork work;
  ImplicitTension* tension = nullptr;  ///< tension in implicit steps; null: none
  ImplicitStrain* strain = nullptr;    ///< strains of second order in implicit steps; null: none
  const SolidTensionColumns* solid_tension = nullptr;  ///< stiffening of a solid; null: none
  const NodalTiles* tiles = nullptr;  ///< of a solid in nodal coordinates; else null
  /// Angular acceleration of the frame, in it, about which tension is taken; set only in subsystems
  /// with such tension [rad/s^2].
  Angular alpha = Angular::Zero();
  JointData joint;
  const CarriedInertia* carried = nullptr;  ///< of a hub on a support; else null
  SlideState slide;                         ///< slide of the joint that carries it, if it slides
};

/// Counts the doubles that the state of the joint that carries a body takes; `history`: vectors of
/// coordinates that the integrator keeps.
std::size_t count_state(const Joint& joint, int history);
/// Places it in so much memory, which is zero and aligned to 16 bytes.
void place_state(const Joint& joint, int history, double* memory, BodyFields& fields);

/// The wrench of the joint that carries a body on its inboard handle, in its frame: the multipliers
/// of (P 8).
struct JointWrench {
  Twist inboard;
};

/// The formulation `structured` keeps nothing of a body besides its fields.
struct NothingCondensed {};
inline std::size_t count_condensed(const Body&) { return 0; }
inline void place_condensed(const Body&, double*, NothingCondensed&) {}

}  // namespace spoke::space

namespace spoke {

template <>
struct BodyTypes<Space> {
  using Layout = space::Layout;
  using Block = space::Block;
  using Section = space::Section;
  using Terms = space::BodyTerms;
  using Fields = space::BodyFields;
  using Condensed = space::NothingCondensed;
  using HandleWrenches = space::JointWrench;
  using JointMotion = space::JointMotion;
  using ImplicitStrain = space::ImplicitStrain;
  using HubStiffening = space::HubStiffening;
  using Attitude = space::HubAttitude;
  using RecordedRotation = space::RecordedHub;
  using CarriedInertia = space::CarriedInertia;
};

}  // namespace spoke
