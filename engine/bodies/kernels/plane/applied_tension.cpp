// Takes whole bodies by band matrices, forces by the integrals of their element's slope.

#include "engine/bodies/kernels/plane/applied_tension.h"

#include <algorithm>
#include <cassert>
#include <utility>

#include "engine/bodies/plane/band_products.h"

namespace spoke::plane {

Position calc_tension_field(const System<Plane>& system, double t,
                            const SubsystemData<Plane>& data) noexcept {
  if (system.hub.support == HubSupport::axle) return data.hub->R.inverse() * system.gravity_at(t);
  return data.flight_acceleration ? Position(-*data.flight_acceleration) : Position::Zero();
}

namespace {

/// The slope of an element's cubic is a + b xi + c xi^2.
struct Slope {
  double a, b, c;

  /// Finds the slope from the rise of the outer node above the inner, and the slopes of both.
  Slope(double rise, double inner, double outer, double length)
      : a(inner),
        b(6.0 * rise / length - 4.0 * inner - 2.0 * outer),
        c(-6.0 * rise / length + 3.0 * (inner + outer)) {}
};

/// int (1, xi, xi^2) slope ds up to s, 0 to 1.
struct SlopeMoments {
  double zero, one, two;

  SlopeMoments(const Slope& f, double s, double length) {
    const double l = length * s, s2 = s * s;
    zero = l * (f.a + s * f.b / 2.0 + s2 * f.c / 3.0);
    one = l * s * (f.a / 2.0 + s * f.b / 3.0 + s2 * f.c / 4.0);
    two = l * s2 * (f.a / 3.0 + s * f.b / 4.0 + s2 * f.c / 5.0);
  }
  /// Returns int slope (another slope) ds.
  double times(const Slope& f) const { return zero * f.a + one * f.b + two * f.c; }
};

}  // namespace

AppliedTension::AppliedTension(const Rotation& turn, BodyData<Plane>& body) noexcept
    : body_(body), turn_(turn) {
  assert(body.model->stiffening && body.forces);
  std::fill(body.element_forces.begin(), body.element_forces.end(), Position::Zero());
}

void AppliedTension::add_at(const Section& section, const Position& force) noexcept {
  const FlexibleBody& model = *body_.model->body;
  const double along = section.x / model.length * model.elements;
  const int e = std::min(static_cast<int>(along), model.elements - 1);
  const Position turned = turn_ * force;
  add_stretch(e, along - e, turned);
  body_.element_forces[static_cast<std::size_t>(e)] += turned;
}

void AppliedTension::add_stretch(int e, double s, const Position& force) noexcept {
  assert(e >= 0 && e < body_.model->body->elements && s <= 1.0 + 1e-9);
  const FlexibleBody& model = *body_.model->body;
  const double length = model.length / model.elements;
  const int at[] = {body_.layout.offset(model.coordinate(e, 1)),
                    body_.layout.offset(model.coordinate(e, 2)),
                    body_.layout.offset(model.coordinate(e + 1, 1)),
                    body_.layout.offset(model.coordinate(e + 1, 2))};
  const auto slope_of = [&](const double* flex) {
    return Slope(flex[at[2]] - flex[at[0]], flex[at[1]], flex[at[3]], length);
  };
  const Slope slope = slope_of(body_.coordinates.q);
  const SlopeMoments moments(slope, s, length);
  const double shear = 6.0 * (moments.one - moments.two) / length;
  const double forces[] = {-shear, moments.zero - 4.0 * moments.one + 3.0 * moments.two, shear,
                           3.0 * moments.two - 2.0 * moments.one};
  for (std::size_t c = 0; c < 4; ++c)
    if (at[c] > 0) body_.Q_f[at[c]] -= force.x() * forces[c];
  moment_ -= 0.5 * moments.times(slope) * force.y();
  power_ -= moments.times(slope_of(body_.coordinates.v)) * force.x();
}

void AppliedTension::finish(double hub_speed) noexcept {
  assert(std::cmp_greater(body_.element_forces.size(), body_.model->body->elements));
  Position beyond = Position::Zero();
  for (int e = body_.model->body->elements - 1; e >= 0; --e) {
    beyond += body_.element_forces[static_cast<std::size_t>(e) + 1];
    if (!beyond.isZero(0.0)) add_stretch(e, 1.0, beyond);
  }
  body_.terms.stiffening.moment += moment_;
  body_.terms.load_power += power_ + moment_ * hub_speed;
}

double add_field_tension(const Position& field, double hub_speed, BodyData<Plane>& body) noexcept {
  assert(body.model->stiffening.outboard_mass);
  assert(body.model->stiffening.outboard_mass->size() == body.layout.bending);
  const SymmetricBand<3>& mass = *body.model->stiffening.outboard_mass;
  const double* v = body.coordinates.q + body.layout.v();
  const double* vd = body.coordinates.v + body.layout.v();
  double* Q = body.Q_f + body.layout.v();
  Double2 form{}, rate{};
  const double* rows = mass.pairs();
  for (int i = 0; i < mass.size(); i += 2, rows += 2 * SymmetricBand<3>::kWidth) {
    const Double2 k = band_rows<3>(rows, i, v);
    store_aligned(load_aligned(Q + i) - field.x() * k, Q + i);
    form += k * load_aligned(v + i);
    rate += k * load_aligned(vd + i);
  }
  const double moment = -0.5 * total(form) * field.y();
  body.terms.stiffening.moment += moment;
  return moment * hub_speed - field.x() * total(rate);
}

double calc_foreshortened_moment(const BodyData<Plane>& body) noexcept {
  assert(body.model->stiffening.outboard_mass);
  const SymmetricBand<3>& mass = *body.model->stiffening.outboard_mass;
  const double* v = body.coordinates.q + body.layout.v();
  const double* rows = mass.pairs();
  double sum = 0.0;
  for (int i = 0; i < mass.size(); i += 2, rows += 2 * SymmetricBand<3>::kWidth)
    add_in_order(load_aligned(v + i) * band_rows<3>(rows, i, v), sum);
  return 0.5 * sum;
}

}  // namespace spoke::plane
