// Makes the shape functions of an element at a section, from its slots.

#include "engine/bodies/space/section.h"

#include <algorithm>
#include <cassert>
#include <utility>

#include "engine/bodies/space/element_products.h"
#include "engine/bodies/space/nonlinear_strain.h"
#include "models/space/rotation_vector.h"
#include "models/support/gauss_rule.h"
#include "models/support/simd.h"

namespace spoke::space {
namespace {

/// Returns the displacement of the point at the offset o from the chord at xi, in the element's
/// axes.
ElementShape displacement_shape(double xi, double l, const Position& o) {
  const Eigen::Vector4d h = hermite(xi, l);
  ElementShape N = ElementShape::Zero();
  // Place r and tangent t follow Hermite's cubics; along the chord, t is 1 + (u_2 - u_1)/l at both
  // nodes.
  const double stretch = (h[1] + h[3]) / l;
  for (int node = 0; node < 2; ++node) {
    const int u = kTwist * node, th = u + kRotation;
    const double place = h[2 * node], tangent = h[2 * node + 1];
    const double linear = node == 0 ? 1.0 - xi : xi;
    N(0, u) = place + (node == 0 ? -stretch : stretch);
    N(1, u + 1) = N(2, u + 2) = place;
    N(1, th + 2) = tangent;
    N(2, th + 1) = -tangent;
    // The offset turns by o_2 (th x e2) + o_3 (th x e3), linear between the nodes.
    N(0, th + 1) += linear * o.z();
    N(0, th + 2) -= linear * o.y();
    N(1, th) -= linear * o.z();
    N(2, th) += linear * o.y();
  }
  return N;
}

/// Returns Section::slopes.
std::array<double, 6> integrate_slopes(double xi, double length) {
  std::array<double, 6> sums{};
  for (std::size_t k = 0; k < GaussRule<6>::places.size(); ++k) {
    const Eigen::Vector4d h = hermite_slope(xi * GaussRule<6>::places[k], length);
    const double shape[] = {h[2], h[1], h[3]};
    const double weight = GaussRule<6>::weights[k] * xi * length;
    std::size_t at = 0;
    for (int i = 0; i < 3; ++i)
      for (int j = i; j < 3; ++j) sums[at++] += weight * shape[i] * shape[j];
  }
  return sums;
}

/// Returns products of a shape with coordinates and with their rates, side by side.
std::array<Double2, 3> multiply_pairs(const ElementShape& N, const double* x, const double* rate) {
  std::array<Double2, 3> sums{};
  for (int c = 0; c < 2 * kTwist; ++c) {
    const Double2 pair{x[c], rate[c]};
    for (int i = 0; i < 3; ++i) sums[static_cast<std::size_t>(i)] += N(i, c) * pair;
  }
  return sums;
}

/// Coordinates of both nodes of an element, in B.
struct ElementCoordinates {
  double values[2 * kTwist];

  ElementCoordinates(const FlexibleBody& body, int element, const double* flex) {
    expand_element(body, element, flex, values);
  }
  Position times(const ElementShape& N) const {
    return N.lazyProduct(Eigen::Map<const Eigen::Matrix<double, 2 * kTwist, 1>>(values));
  }
};

}  // namespace

Section make_section(const Beam& beam, const FlexibleBody& body, double station) {
  assert(body.stations.size() == body.nodes.size() && body.stations.size() > 1);
  const auto end = std::lower_bound(body.stations.begin() + 1, body.stations.end() - 1, station);
  Section section;
  section.element = static_cast<int>(end - body.stations.begin()) - 1;
  const auto e = static_cast<std::size_t>(section.element);
  const BeamElement& element = body.beam[e];
  const SectionAt at = beam.geometry(station);
  const Rotation to_B = body.pose.R.inverse();
  section.s0 = to_B * Position(at.p - body.pose.p);
  section.axes = to_B * at.axes;
  section.compliance = beam.section(station).compliance;

  const Position along = section.s0 - body.nodes[e];
  const double xi = element.axes.col(0).dot(along) / element.length;
  const Position offset = element.axes.transpose() * (along - xi * element.chord);
  section.N = to_body(element, displacement_shape(xi, element.length, offset));
  section.N_th = section_rotation(element, xi);
  section.xi = xi;
  section.slopes = integrate_slopes(xi, element.length);
  const Matrix3 turn = section.axes.axes.transpose();
  section.W.topLeftCorner<3, 3>() = section.W.bottomRightCorner<3, 3>() = turn;
  section.W.bottomLeftCorner<3, 3>() = turn * skew(body.nodes[e + 1] - section.s0);
  return section;
}

double place_in_element(const FlexibleBody& body, const Section& section) noexcept {
  assert(section.element >= 0 && section.element < body.elements);
  const auto e = static_cast<std::size_t>(section.element);
  const BeamElement& element = body.beam[e];
  return element.axes.col(0).dot(section.s0 - body.nodes[e]) / element.length;
}

Section make_rigid_section(const Position& place) {
  Section section;
  section.s0 = place;
  return section;
}

Section make_solid_section(const Solid& body, int place) {
  assert(place >= 0 && std::cmp_less(place, body.constants->places.size()));
  Section section;
  const auto& places = body.constants->places;
  // The constants are kept alive with the place.
  section.place = {body.constants, &places[static_cast<std::size_t>(place)]};
  section.place_number = place;
  section.s0 = section.place->p;
  return section;
}

Section make_node_section(const Solid& body, int node) {
  Section section;
  section.place = std::make_shared<const SolidPlace>(make_node_place(*body.constants, node));
  section.s0 = section.place->p;
  return section;
}

HandleMotion calc_section_motion(const FlexibleBody& body, const Section& section, const double* q,
                                 const double* v) noexcept {
  const ElementCoordinates x(body, section.element, q), rate(body, section.element, v);
  const auto [u1, u2, u3] = multiply_pairs(section.N, x.values, rate.values);
  const auto [th1, th2, th3] = multiply_pairs(section.N_th, x.values, rate.values);
  return {section.s0 + Position(u1[0], u2[0], u3[0]), Position(u1[1], u2[1], u3[1]),
          calc_rotation_vector_motion({th1[0], th2[0], th3[0]}, {th1[1], th2[1], th3[1]})};
}

Twist calc_section_acceleration(const FlexibleBody& body, const Section& section,
                                const HandleMotion& motion, const Twist& X, const Angular& w,
                                const double* a) noexcept {
  const ElementCoordinates acceleration(body, section.element, a);
  const Twist relative =
      make_twist(acceleration.times(section.N),
                 motion.turn.H.lazyProduct(acceleration.times(section.N_th)).eval());
  return motion.carry(X) + relative + motion.bias(w);
}

void add_section_wrench(const Section& section, const HandleMotion& motion, const Twist& wrench,
                        BodyTerms& terms, const BodyWork& work) noexcept {
  terms.Q += translate(motion.s, wrench);
  const Position moment = motion.turn.H.transpose().lazyProduct(angular(wrench));
  const Eigen::Matrix<double, 2 * kTwist, 1> force =
      section.N.transpose().lazyProduct(linear(wrench)) +
      section.N_th.transpose().lazyProduct(moment);
  double* rows = work.rows + kNodeRows * section.element;
  for (int i = 0; i < 2 * kTwist; ++i) rows[4 * i + 3] += force[i];
}

namespace {

const BeamElement& element_of(const FlexibleBody& body, const Section& section) {
  assert(section.element >= 0 && section.element < body.elements);
  return body.beam[static_cast<std::size_t>(section.element)];
}

/// Returns how the outer node of the section's element moves against the inner one, to first order.
Twist calc_linear_strain(const FlexibleBody& body, const Section& section, const double* flex) {
  const ElementCoordinates x(body, section.element, flex);
  Twist d;
  calc_relative(element_of(body, section), x.values, d.data());
  return d;
}

Twist resultants_of(const Section& section, const TwistMatrix& matrix, const Twist& d) {
  Twist wrench;
  multiply(matrix.data(), d.data()).store_to(wrench.data());
  return section.W.lazyProduct(wrench);
}

}  // namespace

Twist calc_section_damping(const FlexibleBody& body, const Section& section,
                           double stiffness_factor, const double* q, const double* v) noexcept {
  const BeamElement& element = element_of(body, section);
  const Twist rate = body.is_nonlinear() ? calc_strain_rate(body, section.element, q, v)
                                         : calc_linear_strain(body, section, v);
  Twist sum = stiffness_factor * resultants_of(section, element.stiffness, rate);
  if (body.is_damped) sum += resultants_of(section, element.damping, rate);
  return sum;
}

Twist calc_section_stress(const FlexibleBody& body, const Section& section,
                          const double* flex) noexcept {
  return resultants_of(section, element_of(body, section).stiffness,
                       calc_linear_strain(body, section, flex));
}

SectionLoad calc_section_load(const FlexibleBody& body, const Section& section,
                              const double* q) noexcept {
  const Twist d = body.is_nonlinear() ? calc_strain(body, section.element, q)
                                      : calc_linear_strain(body, section, q);
  SectionLoad load;
  load.resultants = resultants_of(section, element_of(body, section).stiffness, d);
  load.strains = section.compliance.lazyProduct(load.resultants);
  return load;
}

}  // namespace spoke::space
