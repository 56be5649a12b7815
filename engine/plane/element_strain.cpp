// Differentiates the strain by the displacement against the inner section, and this by the nodes.

#include "engine/plane/element_strain.h"

namespace spoke::plane {

ElementStrain::ElementStrain(double length, const NodesVector& q) noexcept
    : length_(length), R_(Rotation::from_angle(q[kRotation])) {
  const double l = length;
  y_ = R_.inverse() * Position(l + q[3] - q[0], q[4] - q[1]);
  const double e_x = y_.x() - l, e_y = y_.y(), p = q[5] - q[2];
  d_ = {e_x + e_y * (0.6 * e_y / l - 0.1 * p) + l * p * p / 15.0, e_y - e_x * e_y / l, p};
  T_ << 1.0, 1.2 * e_y / l - 0.1 * p, 2.0 * l * p / 15.0 - 0.1 * e_y,  //
      -e_y / l, 1.0 - e_x / l, 0.0,                                    //
      0.0, 0.0, 1.0;
}

StrainMap ElementStrain::map_to_e() const noexcept {
  const double c = R_.cosine, s = R_.sine;
  StrainMap map;
  map << -c, -s, y_.y(), c, s, 0.0,  //
      s, -c, -y_.x(), -s, c, 0.0,    //
      0.0, 0.0, -1.0, 0.0, 0.0, 1.0;
  return map;
}

NodesMatrix ElementStrain::geometric_stiffness(const Twist& sigma) const noexcept {
  // Second derivatives of d by (e, p).
  TwistMatrix forms;
  const double l = length_, across = -sigma[1] / l;
  forms << 0.0, across, 0.0,                        //
      across, 1.2 * sigma[0] / l, -0.1 * sigma[0],  //
      0.0, -0.1 * sigma[0], 2.0 * l * sigma[0] / 15.0;
  const StrainMap e = map_to_e();
  NodesMatrix K = e.transpose().lazyProduct(StrainMap(forms.lazyProduct(e)));
  // Second derivatives of (e, p) by the nodes: of the turn of the inner one alone.
  const Twist on_e = T_.transpose().lazyProduct(sigma);
  const Position F = on_e.head<kPosition>(), turned = R_ * quarter_turn(F);
  K(kRotation, kRotation) -= F.dot(y_);
  for (int c = 0; c < kPosition; ++c) {
    K(kRotation, kTwist + c) += turned[c];
    K(kTwist + c, kRotation) += turned[c];
    K(kRotation, c) -= turned[c];
    K(c, kRotation) -= turned[c];
  }
  return K;
}

}  // namespace spoke::plane
