// Evaluates places by the columns of E that are not zero.

#include "engine/bodies/kinds/solid/solid_places.h"

#include <cassert>

namespace spoke::space {
namespace {

/// Returns E x.
Twist multiply_columns(const SolidPlace& place, const double* x) {
  Twist sum = Twist::Zero();
  for (std::size_t i = 0; i < place.at.size(); ++i) sum += x[place.at[i]] * place.columns[i];
  return sum;
}

}  // namespace

HandleMotion calc_place_motion(const SolidPlace& place, const double* q, const double* v) noexcept {
  assert(q && v && place.at.size() == place.columns.size());
  if (place.is_fixed()) return make_fixed_handle(place.p);
  const Twist moved = multiply_columns(place, q), rate = multiply_columns(place, v);
  return {place.p + linear(moved), linear(rate),
          calc_rotation_vector_motion(angular(moved), angular(rate))};
}

void calc_handles(const Solid& body, const double* q, const double* v,
                  HandleMotion* handles) noexcept {
  for (std::size_t h = 0; h < body.handles.size(); ++h)
    handles[h] = calc_place_motion(body.handle(h), q, v);
}

Twist calc_place_deformation(const SolidPlace& place, const HandleMotion& motion,
                             const double* a) noexcept {
  const Twist moved = multiply_columns(place, a);
  return make_twist(linear(moved), motion.turn.H.lazyProduct(angular(moved)));
}

void add_place_wrench(const SolidPlace& place, const HandleMotion& motion, const Twist& wrench,
                      BodyTerms& terms, const BodyWork& work) noexcept {
  terms.Q += translate(motion.s, wrench);
  const Twist turned =
      make_twist(linear(wrench), motion.turn.H.transpose().lazyProduct(Angular(angular(wrench))));
  for (std::size_t i = 0; i < place.at.size(); ++i)
    work.rows[4 * place.at[i] + 3] += place.columns[i].dot(turned);
}

}  // namespace spoke::space
