// Whole bodies by band matrices, forces by Gauss's rule up to where they act.

#include "engine/kernels/axial_tension.h"

#include <algorithm>

#include "engine/kernels/band_products.h"
#include "engine/kernels/blade_loads.h"
#include "models/system/gauss_rule.h"

namespace spoke {
namespace {

/// What tension does: a moment on the hub, and power on the deformation.
struct TensionSums {
  double moment = 0.0;  ///< [N m]
  double power = 0.0;   ///< [W]
};

/// Adds the tension of a force along and across the blade over an element up to `s`, 0 to 1. The
/// square of a slope is of degree four: three points are exact.
void add_stretch(int e, double s, const Position& force, BodyData<Plane>& body, TensionSums& sums) {
  using Rule = GaussRuleOfThree;
  const FlexibleBody& model = *body.model->body;
  const double length = s * model.length / model.elements;
  for (std::size_t k = 0; k < Rule::kPoints; ++k) {
    const Section at = make_section(model, body.layout, e, s * Rule::places[k]);
    const double slope = value_at(at.slope, at.bending_at, body.coordinates.q);
    const double rate = value_at(at.slope, at.bending_at, body.coordinates.v);
    const double weight = Rule::weights[k] * length;
    for (std::size_t c = 0; c < at.slope.size(); ++c)
      if (const int place = at.bending_at[c]; place > 0)
        body.Q_f[place] -= weight * force.x() * slope * at.slope[c];
    sums.moment -= 0.5 * weight * slope * slope * force.y();
    sums.power -= weight * force.x() * slope * rate;
  }
}

}  // namespace

Position calc_tension_field(const System<Plane>& system, double t,
                            const SubsystemData<Plane>& data) noexcept {
  if (system.hub.support == HubSupport::axle) return data.hub->R.inverse() * system.gravity_at(t);
  return data.flight_acceleration ? Position(-*data.flight_acceleration) : Position::Zero();
}

namespace {

/// Collects forces along and across an axis of a body, by element, and adds their tension.
class AppliedTension {
 public:
  explicit AppliedTension(BodyData<Plane>& body) : body_(body), model_(*body.model->body) {
    std::fill(body.element_forces.begin(), body.element_forces.end(), Position::Zero());
  }
  void add_at_tip(const Position& force) { body_.element_forces.back() += force; }
  void add_at(const Section& section, const Position& force) {
    const double along = section.x / model_.length * model_.elements;
    const int e = std::min(static_cast<int>(along), model_.elements - 1);
    add_stretch(e, along - e, force, body_, sums_);
    body_.element_forces[static_cast<std::size_t>(e)] += force;
  }
  /// When all forces are known: their sums on all elements inboard of them.
  TensionSums add_beyond() {
    Position beyond = Position::Zero();
    for (int e = model_.elements - 1; e >= 0; --e) {
      beyond += body_.element_forces[static_cast<std::size_t>(e) + 1];
      if (!beyond.isZero(0.0)) add_stretch(e, 1.0, beyond, body_, sums_);
    }
    return sums_;
  }

 private:
  BodyData<Plane>& body_;
  const FlexibleBody& model_;
  TensionSums sums_;
};

}  // namespace

void add_applied_tension(double t, const Rotation& R_HB, int j,
                         SubsystemData<Plane>& data) noexcept {
  BodyData<Plane>& body = data.bodies[static_cast<std::size_t>(j)];
  if (!body.model->stiffening || !body.forces) return;
  const Rotation to_blade = R_HB.inverse();
  AppliedTension tension(body);
  if (body.forces.carried)
    for (const int child : body.model->children)
      tension.add_at_tip(to_blade * data.applied_forces[static_cast<std::size_t>(child)]);
  visit_forces(t, j, data, [&](const Section& section, const Position& force) {
    tension.add_at(section, to_blade * force);
  });
  const TensionSums sums = tension.add_beyond();
  body.terms.stiffening.moment += sums.moment;
  body.terms.load_power += sums.power + sums.moment * data.hub->twist[kRotation];
}

double add_field_tension(const Position& field, double hub_speed, BodyData<Plane>& body) noexcept {
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
  const SymmetricBand<3>& mass = *body.model->stiffening.outboard_mass;
  const double* v = body.coordinates.q + body.layout.v();
  const double* rows = mass.pairs();
  double sum = 0.0;
  for (int i = 0; i < mass.size(); i += 2, rows += 2 * SymmetricBand<3>::kWidth)
    add_in_order(load_aligned(v + i) * band_rows<3>(rows, i, v), sum);
  return 0.5 * sum;
}

}  // namespace spoke
