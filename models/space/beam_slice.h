#pragma once

// Slices of a beam: the points at which integrals along its elements are taken.

#include "models/space/beam_element.h"
#include "models/support/gauss_rule.h"

namespace spoke::space {

using Matrix6 = Eigen::Matrix<double, kTwist, kTwist>;

/// A piece of the beam in B, so short that its middle stands for it.
struct Slice {
  double station = 0.0;  ///< [m]
  double ds = 0.0;       ///< length along the curve [m]
  Position p;            ///< place of its reference point [m]
  Matrix3 axes;          ///< axes of its section
  SectionMatrices section;
};

Slice make_slice(const Beam& beam, const BodyGeometry& geometry, double station, double dx);
/// Makes a slice of a point mass in B, without anything but mass.
Slice make_slice(const Beam& beam, const BodyGeometry& geometry, const PointMass& point);

/// The rule by which a piece between two breaks of a beam is integrated.
using SliceRule = GaussRule<6>;

/// Calls `visit(slice)` for the Gauss points between two stations without a break between them.
template <class Visit>
void visit_slices(const Beam& beam, const BodyGeometry& geometry, double from, double to,
                  Visit&& visit) {
  for (int i = 0; i < SliceRule::kPoints; ++i)
    visit(make_slice(beam, geometry, from + SliceRule::places[i] * (to - from),
                     SliceRule::weights[i] * (to - from)));
}

/// Whether a point mass lies between two stations, or at the second.
bool is_outboard(double from, double to, const PointMass& point);
/// Whether a point mass belongs to the part between two stations; at a boundary, it belongs to the
/// inboard part.
bool holds(const Beam& beam, double from, double to, const PointMass& point);

/// Returns W: resultants of a section, in its axes, per wrench on the outer node.
Matrix6 resultants_of(const Slice& slice, const Position& outer);

/// A slice's mass within an element: its place along the chord, and its moments about that place in
/// the element's axes.
struct PlacedMass {
  double xi;  ///< 0 at the inner node, 1 at the outer
  MassMoments moments;
};
PlacedMass place(const BeamElement& element, const Position& inner, const Slice& slice);

}  // namespace spoke::space
