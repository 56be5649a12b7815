// Calculates the foreshortening between the handles.

#include "engine/bodies/kernels/plane/handle_motion.h"

#include <cassert>

#include "engine/bodies/plane/band_products.h"

namespace spoke::plane {

double calc_foreshortening(const BodyData<Plane>& body) noexcept {
  assert(!body.model->stiffening.slope_integral ||
         body.model->stiffening.slope_integral->size() == body.layout.bending);
  const SymmetricBand<3>* slopes = body.model->stiffening.slope_integral.get();
  if (!slopes) return 0.0;
  const double* v = body.coordinates.q + body.layout.v();
  const double* rows = slopes->pairs();
  double sum = 0.0;
  for (int i = 0; i < slopes->size(); i += 2, rows += 2 * SymmetricBand<3>::kWidth)
    add_in_order(load_aligned(v + i) * band_rows<3>(rows, i, v), sum);
  return 0.5 * sum;
}

}  // namespace spoke::plane
