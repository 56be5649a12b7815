#include "engine/bodies/kinds/solid/solid_model.h"

namespace spoke::space {

Matrix3 turn_tensor(const Rotation& R, const Matrix3& tensor) {
  const Matrix3 half = R.axes.lazyProduct(tensor);
  return half.lazyProduct(R.axes.transpose());
}

void put_stiffening(const TensionPlace& place, const SolidStiffening& sums, const Position& gravity,
                    BodyTerms& terms) noexcept {
  const Rotation& R = place.R_HB;
  terms.stiffening.inertia = turn_tensor(R, sums.Lambda);
  terms.stiffening.rate = turn_tensor(R, sums.Lambda_rate);
  terms.tension = {R * sums.gamma.value, R * sums.gamma.rate};
  terms.stiffening.moment = cross(gravity, terms.tension.value);
}

}  // namespace spoke::space
