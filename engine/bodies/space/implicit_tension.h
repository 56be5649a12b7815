#pragma once

// The tension of rotation on the left-hand side of an implicit step (docs/formulation.md, section
// 5).
//
// In a body under tension T the deflections and the rotation of its frame are stiffened alike: the
// slope against the direction of T is that of the frame's rotation and the deformation together,
//   V = 1/2 int T (slope of frame + slope of deformation)^2 ds = 1/2 y^T K y,  y = (rotation; q)
// The bodies that hang at it pull from outside, so that is how the motion of the bodies of a chain
// feels its tension, each by itself. A step adds beta' h^2 K (A - A_k) to the equations, with A_k
// the accelerations of the iterate before: where the iteration has converged, nothing; but its
// errors no longer grow with the tension. K need not be exact: it is that of a speed near the
// hub's, so that the factors stay while the speed hardly changes.

#include "engine/bodies/space/body_data.h"

namespace spoke::space {

struct ImplicitTension {
  /// Tension matrices of an element, weighted and times beta' h^2.
  struct Element {
    Matrix4 bending = Matrix4::Zero();
    double torsion = 0.0;
  };

  BlockFactors factors;  ///< factors of Mff, K and D in Mhat besides
  double gain = 0.0;     ///< beta' h^2 [s^2]
  double least = 0.0;    ///< speed of the hub below which tension is left out [rad/s]

  /// Angular velocity of the hub, in H, for which all below is made; zero: there is no tension,
  /// NaN: none yet [rad/s].
  Angular w;
  std::vector<Element> elements;
  BlockTridiagonal stiffness;      ///< beta' h^2 K of the deformation
  std::vector<NodeMomentum> lean;  ///< by node: coupling with the frame's rotation
  Matrix3 turn;                    ///< stiffness of the frame's rotation [kg m^2]
  ElasticBlock block;              ///< factors of Mhat with the tension

  /// Whether there is any: not at a low speed.
  bool is_on() const { return w != Angular::Zero(); }
  /// Whether there will be tension, at a speed of the hub.
  bool counts_at(const Angular& hub_w) const { return hub_w.norm() >= least; }
};

/// Allocates the tension of a body, for no speed yet; `block`: that of the factors alone, `gain`:
/// beta' h^2 [s^2].
ImplicitTension make_implicit_tension(const FlexibleBody& body, const TensionPlace& place,
                                      const BlockFactors& factors, double gain,
                                      const ElasticBlock& block);

/// Adds how the tension of element e acts on the rotation of the frame: coupling with the nodes,
/// and stiffness; `bending`: its tension matrix.
void add_lean(const BeamElement& element, int e, const Matrix4& bending, bool is_straight,
              std::vector<NodeMomentum>& lean, Matrix3& turn) noexcept;

/// Makes it that of a speed near that of the hub, w in H, unless it is.
void follow_speed(const FlexibleBody& body, const TensionPlace& place, const Angular& w,
                  ImplicitTension& tension) noexcept;

/// Adds beta' h^2 K to the frame's mass terms and beta' h^2 K A_k to the right-hand side, in the
/// terms of a body and the rows of `work`, which are those of the state; `a`: the accelerations of
/// the iterate A_k (flex vector), `turn`: the angular one of the frame.
void add_implicit_tension(const FlexibleBody& body, const ImplicitTension& tension, const double* a,
                          const Angular& turn, const BodyWork& work, BodyTerms& terms) noexcept;

}  // namespace spoke::space
