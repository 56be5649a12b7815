// Rotations of the handles, and the foreshortening between them.

#include "engine/kernels/planar_handles.h"

#include "engine/kernels/band_products.h"

namespace spoke {
namespace {

/// `at`: places of the handle's coordinates.
Rotation section_rotation(const Handle& handle, const std::array<int, kTwist>& at,
                          const double* q) {
  return handle.coordinate[kRotation] < 0 ? Rotation{} : Rotation::from_angle(q[at[kRotation]]);
}

}  // namespace

Rotation calc_inboard_rotation(const BodyData<Plane>& body) noexcept {
  return section_rotation(body.model->body->inboard, body.inboard_at, body.coordinates.q);
}

Rotation calc_outboard_rotation(const BodyData<Plane>& body) noexcept {
  return section_rotation(body.model->body->outboard, body.outboard_at, body.coordinates.q);
}

double calc_foreshortening(const BodyData<Plane>& body) noexcept {
  const SymmetricBand<3>* slopes = body.model->stiffening.slope_integral.get();
  if (!slopes) return 0.0;
  const double* v = body.coordinates.q + body.layout.v();
  const double* rows = slopes->pairs();
  double sum = 0.0;
  for (int i = 0; i < slopes->size(); i += 2, rows += 2 * SymmetricBand<3>::kWidth)
    add_in_order(load_aligned(v + i) * band_rows<3>(rows, i, v), sum);
  return 0.5 * sum;
}

}  // namespace spoke
