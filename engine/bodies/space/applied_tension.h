#pragma once

// The tension that applied forces put on a spatial body: they act at points that bending and
// twisting draw inward (docs/formulation.md, section 10).
//
// A point at the station x of a body has come nearer to the body's frame by
//   r(x) = -1/2 int_0^x (v'^2 + w'^2 + (EIy + EIz)/EA tx'^2) ds e1,
// with e1 the axis of each element, in the undeformed tree. A force N beyond x does work on it,
// which is
//   -(e1.N) K q on the deformation, with the K of that integral, and r x N on the hub's rotation.

#include <array>

#include "engine/bodies/space/body_scratch.h"
#include "engine/bodies/space/section.h"

namespace spoke::space {

/// Displacement r of a point toward the body's frame, and its rate, along the axes of the body.
struct DrawnInward {
  Position place = Position::Zero();  ///< [m]
  Position rate = Position::Zero();   ///< [m/s]
};
/// Return it for a node, and for a section, at the flex vectors q and v.
DrawnInward calc_drawn_inward(const FlexibleBody& body, int node, const double* q,
                              const double* v) noexcept;
DrawnInward calc_drawn_inward(const FlexibleBody& body, const Section& section, const double* q,
                              const double* v) noexcept;

/// Forces at sections of one element, along the axes of the body, with the tension of each: its
/// part along the element [N].
struct SectionForces {
  Position sum;                  ///< [N]
  std::array<double, 6> slopes;  ///< sum of Section::slopes times tension
  double along;                  ///< sum of the places within the element times tension [N]
  Position drawn;                ///< sum of the forces times twice the length drawn inward
};

/// Collects the forces beyond the elements of a body, and turns them to terms. It works in
/// BodyScratch::force and three of BodyScratch::nodal.
class AppliedTension {
 public:
  /// Begins for a body at a state, which has geometric stiffening.
  AppliedTension(const BodyModel& model, const BodyState& state, const BodyWork& work) noexcept;

  /// Adds a force [N], along the axes of the body, that acts on the bodies at a node.
  void add_at_node(int node, const Position& force) noexcept;
  /// Adds a force [N], along the axes of the body, at a section.
  void add_at(const Section& section, const Position& force) noexcept;
  void add_at_sections(int element, const SectionForces& forces) noexcept;
  /// Adds, when all forces are known, -(e1.N) K q to the right-hand side in the rows, and the power
  /// on the deformation. Returns the sum of r x N, the moment on the hub, along the axes of the
  /// forces.
  Angular add_to(BodyTerms& terms) noexcept;

 private:
  void add_element(int element, const Position& force) noexcept;
  /// Adds the product of an element up to xi; `multiply`: by its matrix.
  template <class Multiply>
  void add_product(int element, double xi, const Multiply& multiply,
                   const Position& force) noexcept;

  const FlexibleBody& body_;
  const BodyWork& work_;
  const ScratchRoom scratch_;
  Angular moment_ = Angular::Zero();
  double power_ = 0.0;  ///< power on the deformation [W]
};

}  // namespace spoke::space
