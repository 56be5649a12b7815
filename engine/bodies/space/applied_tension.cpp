// Takes whole elements by their tension matrices, the element of a force by that up to it.

#include "engine/bodies/space/applied_tension.h"

#include <algorithm>
#include <cassert>

#include "engine/bodies/space/plane_coordinates.h"
#include "models/support/wide_kernels.h"

namespace spoke::space {
namespace {

double twist_of(const PlaneCoordinates& x) { return x.torsion[1] - x.torsion[0]; }

const BeamElement& element_of(const FlexibleBody& body, int e) {
  return body.beam[static_cast<std::size_t>(e)];
}

/// Returns K x for the matrix of Section::slopes.
PlaneCoordinates multiply_slopes(const std::array<double, 6>& K, const PlaneCoordinates& x) {
  const Double2 r = x.rise, a = x.slope[0], b = x.slope[1];
  return {K[0] * r + K[1] * a + K[2] * b,
          {K[1] * r + K[3] * a + K[4] * b, K[2] * r + K[4] * a + K[5] * b},
          {}};
}

/// Adds the displacement r by which an element draws points inward up to xi; `multiply`: by its
/// matrix up to there.
template <class Multiply>
void add_drawn(const FlexibleBody& body, int e, double xi, const Multiply& multiply,
               const double* q, const double* v, DrawnInward& drawn) {
  const BeamElement& beam = element_of(body, e);
  double values[2 * kTwist], rates[2 * kTwist];
  expand_element(body, e, q, values);
  expand_element(body, e, v, rates);
  const PlaneCoordinates x = in_axes_of(beam, body.is_straight, values);
  const PlaneCoordinates y = in_axes_of(beam, body.is_straight, rates);
  const PlaneCoordinates product = multiply(x);
  const double trapeze = xi * beam.stiffening.torsion[0] * twist_of(x);
  drawn.place -= 0.5 * (total(sum_products(product, x)) + trapeze * twist_of(x)) * beam.axes.col(0);
  drawn.rate -= (total(sum_products(product, y)) + trapeze * twist_of(y)) * beam.axes.col(0);
}

}  // namespace

DrawnInward calc_drawn_inward(const FlexibleBody& body, int node, const double* q,
                              const double* v) noexcept {
  DrawnInward drawn;
  for (int e = 0; e < node; ++e) {
    const Matrix4& K = element_of(body, e).stiffening.bending[0];
    add_drawn(
        body, e, 1.0, [&K](const PlaneCoordinates& x) { return multiply_planes(K, x); }, q, v,
        drawn);
  }
  return drawn;
}

DrawnInward calc_drawn_inward(const FlexibleBody& body, const Section& section, const double* q,
                              const double* v) noexcept {
  DrawnInward drawn = calc_drawn_inward(body, section.element, q, v);
  add_drawn(
      body, section.element, section.xi,
      [&section](const PlaneCoordinates& x) { return multiply_slopes(section.slopes, x); }, q, v,
      drawn);
  return drawn;
}

AppliedTension::AppliedTension(const BodyModel& model, const BodyState& state,
                               const BodyWork& work) noexcept
    : body_(*model.body), work_(work), scratch_(body_, work) {
  assert(model.tension);
  expand(body_, state.q, scratch_->nodal[0]);
  expand(body_, state.v, scratch_->nodal[1]);
  const int values = kTwist * body_.node_count();
  std::fill_n(scratch_->nodal[2], values,
              0.0);  // by node, the forces beyond the elements inboard of it
  std::fill_n(scratch_->force, values, 0.0);
}

void AppliedTension::add_at_node(int node, const Position& force) noexcept {
  assert(node >= 0 && node < body_.node_count());
  Eigen::Map<Position>(scratch_->nodal[2] + kTwist * node) += force;
}

void AppliedTension::add_at(const Section& section, const Position& force) noexcept {
  add_at_node(section.element, force);
  add_product(
      section.element, section.xi,
      [&section](const PlaneCoordinates& x) { return multiply_slopes(section.slopes, x); }, force);
}

void AppliedTension::add_element(int e, const Position& force) noexcept {
  const Matrix4& K = element_of(body_, e).stiffening.bending[0];
  add_product(
      e, 1.0, [&K](const PlaneCoordinates& x) { return multiply_planes(K, x); }, force);
}

template <class Multiply>
void AppliedTension::add_product(int e, double xi, const Multiply& multiply,
                                 const Position& force) noexcept {
  assert(e >= 0 && e < body_.elements);
  const BeamElement& element = element_of(body_, e);
  const PlaneCoordinates q =
      in_axes_of(element, body_.is_straight, scratch_->nodal[0] + kTwist * e);
  const PlaneCoordinates v =
      in_axes_of(element, body_.is_straight, scratch_->nodal[1] + kTwist * e);
  const double tension = element.axes.col(0).dot(force);
  PlaneCoordinates f = multiply(q);
  const double trapeze = xi * element.stiffening.torsion[0] * twist_of(q);
  const double form = total(sum_products(f, q)) + trapeze * twist_of(q);
  const double rate = total(sum_products(f, v)) + trapeze * twist_of(v);
  f.rise *= tension;
  for (Double2& slope : f.slope) slope *= tension;
  f.torsion[0] = -tension * trapeze;
  f.torsion[1] = tension * trapeze;
  subtract_forces_of(element, body_.is_straight, f, scratch_->force + kTwist * e);
  moment_ -= 0.5 * form * cross(Position(element.axes.col(0)), force);
  power_ -= tension * rate;
}

void AppliedTension::add_at_sections(int e, const SectionForces& forces) noexcept {
  assert(e >= 0 && e < body_.elements);
  add_at_node(e, forces.sum);
  run_large_kernel([&]() noexcept {
    const BeamElement& element = element_of(body_, e);
    const PlaneCoordinates q =
        in_axes_of(element, body_.is_straight, scratch_->nodal[0] + kTwist * e);
    const PlaneCoordinates v =
        in_axes_of(element, body_.is_straight, scratch_->nodal[1] + kTwist * e);
    PlaneCoordinates f = multiply_slopes(forces.slopes, q);
    const double torque = forces.along * element.stiffening.torsion[0] * twist_of(q);
    power_ -= total(sum_products(f, v)) + torque * twist_of(v);
    f.torsion[0] = -torque;
    f.torsion[1] = torque;
    subtract_forces_of(element, body_.is_straight, f, scratch_->force + kTwist * e);
    moment_ -= 0.5 * cross(Position(element.axes.col(0)), forces.drawn);
  });
}

Angular AppliedTension::add_to(BodyTerms& terms) noexcept {
  run_large_kernel([this]() noexcept {
    Position beyond = Position::Zero();
    for (int e = body_.elements - 1; e >= 0; --e) {
      beyond += Eigen::Map<const Position>(scratch_->nodal[2] + kTwist * (e + 1));
      if (!beyond.isZero(0.0)) add_element(e, beyond);
    }
    double* rows = work_.rows;
    const double* force = scratch_->force;
    for (int node = 0; node < body_.node_count(); ++node, rows += kNodeRows, force += kTwist)
      for (int c = 0; c < kTwist; ++c) rows[4 * c + 3] += force[c];
  });
  terms.load_power += power_;
  return moment_;
}

}  // namespace spoke::space
