// Calculates the rows of closures. With d from the place of `to` to that of `from`, w of `to`, w_r
// = (w of `from`) - w, all against the inertial frame:

#include "engine/bodies/kernels/loops/loop_rows.h"

#include <Eigen/LU>

namespace spoke {
namespace space {
namespace {

/// The motion of `from` against `to`.
struct Relative {
  Position d, v;  ///< place, and its rate as the inertial frame sees it
  Angular w, w_r;
};

Relative compare(const PlaceMotion& from, const PlaceMotion& to) {
  return {from.p - to.p, Position(linear(from.twist)) - Position(linear(to.twist)),
          angular(to.twist), Angular(angular(from.twist)) - Angular(angular(to.twist))};
}

/// phi = e . d:  phi' = e . d',  phi'' = e . (a - alpha x d) - e . (2 w x d' + w x (w x d))
/// with d' = v - w x d as `to` sees it, a and alpha of `from` less those of `to`.
RowMotion calc_displacement(const LoopRow& row, const Relative& m, const PlaceMotion& to) {
  const Position e = to.R * row.axis;
  const Position rate = m.v - cross(m.w, m.d);
  return {make_twist(e, Position::Zero()), e.dot(m.d), e.dot(rate),
          -e.dot(Position(2.0 * cross(m.w, rate) + cross(m.w, cross(m.w, m.d))))};
}

/// phi = e . b - rest, b fixed to `from`:  phi' = u . w_r,  u = b x e,
/// phi'' = u . alpha_r + (b' x e + b x e') . w_r
RowMotion calc_alignment(const LoopRow& row, const Relative& m, const PlaceMotion& from,
                         const PlaceMotion& to) {
  const Position e = to.R * row.axis, b = from.R * row.other;
  const Position u = cross(b, e);
  const Position u_rate = cross(cross(Angular(m.w + m.w_r), b), e) + cross(b, cross(m.w, e));
  return {make_twist(Position::Zero(), u), e.dot(b) - row.rest, u.dot(m.w_r), u_rate.dot(m.w_r)};
}

/// phi = n . theta, exp(theta~) = R:  R_to H theta' = w_r,  u = R_to H^-T n,
/// phi'' = u . (alpha_r - w x w_r) - (H^-T n) . H' theta'
RowMotion calc_turn(const LoopRow& row, const Relative& m, const PlaceMotion& from,
                    const PlaceMotion& to) {
  const Rotation back = to.R.inverse();
  const Angular theta = logarithm(back * from.R);
  const Matrix3 inverse = calc_tangent(theta).inverse();
  const Angular rate = inverse.lazyProduct(back * m.w_r);
  const Angular n = inverse.transpose().lazyProduct(row.axis);
  const Angular u = to.R * n;
  const Angular convective = calc_rotation_vector_motion(theta, rate).convective;
  return {make_twist(Position::Zero(), u), row.axis.dot(theta), row.axis.dot(rate),
          -u.dot(cross(m.w, m.w_r)) - n.dot(convective)};
}

/// phi = l - rest, l = |d|:  e = d/l,  phi' = e . v,  phi'' = e . a + (|v|^2 - phi'^2)/l
RowMotion calc_distance(const LoopRow& row, const Relative& m) {
  const double length = m.d.norm();
  const Position e = m.d / length;
  const double rate = e.dot(m.v);
  return {make_twist(e, Position::Zero()), length - row.rest, rate,
          (m.v.squaredNorm() - rate * rate) / length};
}

}  // namespace
}  // namespace space

RowMotion calc_loop_row(const LoopRow& row, const PlaceMotion& from,
                        const PlaceMotion& to) noexcept {
  const space::Relative m = space::compare(from, to);
  switch (row.kind) {
    case LoopRow::Kind::displacement:
      return space::calc_displacement(row, m, to);
    case LoopRow::Kind::alignment:
      return space::calc_alignment(row, m, from, to);
    case LoopRow::Kind::rotation:
      return space::calc_turn(row, m, from, to);
    case LoopRow::Kind::distance:
    case LoopRow::Kind::coupling:  // has no places
      break;
  }
  return space::calc_distance(row, m);
}

}  // namespace spoke
