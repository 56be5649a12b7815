#pragma once

// One finite element of a beam in space, as constants in the frame B of its body: stiffness from
// the flexibility of its sections, and the masses of its slots (docs/formulation.md, section 10).
//
// The slots of a node are its place r and its three axes t, d, g in the element's directions e1,
// e2, e3, as far as they are linear in the node's rotation:
//   r = s + u,   t = e1 + th x e1 + e1 stretch,   d = e2 + th x e2,   g = e3 + th x e3
// with stretch = e1.(u_2 - u_1)/l of the element.

#include <array>
#include <vector>

#include "models/space/beam.h"

namespace spoke::space {

/// Slots of a node, and of an element: (r, t, d, g) of its inner node, then of its outer one.
inline constexpr int kNodeSlots = 4;
inline constexpr int kElementSlots = 2 * kNodeSlots;
using SlotMatrix = Eigen::Matrix<double, kElementSlots, kElementSlots, Eigen::DontAlign>;
using Matrix4 = Eigen::Matrix<double, 4, 4, Eigen::DontAlign>;

/// Terms that tension and rotation add to an element's stiffness, to second order: quadratic forms
/// in the coordinates along the element's axes.
struct ElementStiffening {
  /// The weights of a tension: 1 (N), the mass outboard within the body m1(x) = int_x m (kg), and
  /// its first moment m2(x) = int_x m x (kg m), x along the body's axis.
  static constexpr int kWeights = 3;
  /// int weight N'^T N' dx on (v, tz) of both nodes, and on (w, -ty).
  std::array<Matrix4, kWeights> bending{};
  /// int weight (EIy + EIz)/EA dx / l^2, the factor of (tx_2 - tx_1)^2: the trapeze effect.
  std::array<double, kWeights> torsion{};
  /// int P dx of the second moments of sections along the element's axes 2 and 3, in B [kg m^2].
  Matrix3 turning = Matrix3::Zero();
};

/// A linear map of an element's coordinates (u, th of both nodes) to a vector.
using ElementShape = Eigen::Matrix<double, 3, 2 * kTwist, Eigen::DontAlign>;

/// The rotary inertia of a small rigid mass on an element.
struct PointInertia {
  ElementShape rotation;  ///< rotation of its section by the element's coordinates, in B
  Matrix3 second;         ///< P: second moment about the chord's point, in B [kg m^2]
};

struct BeamElement {
  double length = 0.0;  ///< distance between its nodes [m]
  Matrix3 axes;         ///< columns: e1 (from node to node), e2, e3, in B
  Position chord;       ///< vector from its inner to its outer node, in B [m]
  /// Wrench on the outer node per displacement and rotation relative to the inner node, in B: the
  /// inverse of the flexibility int W^T C^-1 W ds.
  TwistMatrix stiffness;
  TwistMatrix damping;  ///< wrench per relative velocity [N s/m, N s, N m s]
  /// One matrix for each of the three components of the slots [kg, kg m, kg m^2].
  SlotMatrix mass;
  ElementStiffening stiffening;
  std::vector<PointInertia> inertias;
};

/// The place of a body on a beam: stations of its nodes, and its frame B in the beam's.
struct BodyGeometry {
  std::vector<double> station;  ///< stations, one more than elements, ascending [m]
  Pose pose;                    ///< pose of B in the beam's frame
  std::vector<Position> nodes;  ///< places of the nodes in B [m]
};

/// Places B at the first node, with x towards the last, y and z by the smallest rotation from the
/// beam's. Precondition: two stations or more, within the beam.
BodyGeometry make_body_geometry(const Beam& beam, std::vector<double> stations);

/// Makes the elements of a body from its inboard end.
std::vector<BeamElement> make_beam_elements(const Beam& beam, const BodyGeometry& geometry);

/// Returns the share in BeamElement::mass of the mass outboard of a station within the element,
/// point masses at the station included.
SlotMatrix calc_outboard_mass(const Beam& beam, const BodyGeometry& geometry,
                              const BeamElement& element, std::size_t e, double station);

/// Returns the values of Hermite's cubics for (r, t) of both nodes at xi, 0 to 1, of an element, or
/// of their derivatives along it.
Eigen::Vector4d hermite(double xi, double length);
Eigen::Vector4d hermite_slope(double xi, double length);

/// Returns the rotation of the section at xi by the element's coordinates, in B: linear between the
/// nodes about the chord, the slope of the cubics across it.
ElementShape section_rotation(const BeamElement& element, double xi);

/// Converts a map whose rows and coordinates are in the element's axes to B.
ElementShape to_body(const BeamElement& element, const ElementShape& local);

}  // namespace spoke::space
