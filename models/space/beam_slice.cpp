// Resolves sections in the frame of a body, and masses in the axes of an element.

#include "models/space/beam_slice.h"

namespace spoke::space {

Slice make_slice(const Beam& beam, const BodyGeometry& geometry, double station, double dx) {
  const SectionAt at = beam.geometry(station);
  const Rotation to_body = geometry.pose.R.inverse();
  return {station, at.tangent.norm() * dx, to_body * Position(at.p - geometry.pose.p),
          (to_body * at.axes).axes, beam.section(station)};
}

Slice make_slice(const Beam& beam, const BodyGeometry& geometry, const PointMass& point) {
  Slice slice = make_slice(beam, geometry, point.station, 0.0);
  slice.ds = 1.0;
  slice.section = {};
  slice.section.mass = point.moments;
  return slice;
}

bool is_outboard(double from, double to, const PointMass& point) {
  const double rounding = 1e-12 * (to - from);
  return point.station > from + rounding && point.station <= to + rounding;
}

bool holds(const Beam& beam, double from, double to, const PointMass& point) {
  const bool is_at_start = from == beam.station.front() && point.station <= from;
  return is_at_start || is_outboard(from, to, point);
}

Matrix6 resultants_of(const Slice& slice, const Position& outer) {
  const Matrix3 axes = slice.axes.transpose();
  Matrix6 W = Matrix6::Zero();
  W.topLeftCorner<3, 3>() = axes;
  W.bottomLeftCorner<3, 3>() = axes * skew(outer - slice.p);
  W.bottomRightCorner<3, 3>() = axes;
  return W;
}

PlacedMass place(const BeamElement& element, const Position& inner, const Slice& slice) {
  const double xi = element.axes.col(0).dot(slice.p - inner) / element.length;
  const Matrix3 to_element = element.axes.transpose();
  const Matrix3 A = to_element * slice.axes;
  const Position o = to_element * (slice.p - inner - xi * element.chord);
  const MassMoments& section = slice.section.mass;
  const Position S = A * section.first;
  const double dm = slice.ds * section.mass;
  return {xi,
          {dm, slice.ds * S + dm * o,
           slice.ds * (A * section.second * A.transpose() + o * S.transpose() + S * o.transpose()) +
               dm * o * o.transpose()}};
}

}  // namespace spoke::space
