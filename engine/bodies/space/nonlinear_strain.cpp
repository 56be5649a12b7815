// First the h of all elements, then their strains and forces, then those by the change of tension.

#include "engine/bodies/space/nonlinear_strain.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <vector>

#include "engine/bodies/space/varying_tension.h"

namespace spoke::space {
namespace {

PlaneCoordinates planes_of(const FlexibleBody& body, int e, const double* x) {
  return in_axes_of(body.beam[static_cast<std::size_t>(e)], body.is_straight, x + kTwist * e);
}

/// Values by element in scratch memory.
struct ElementValues {
  double *h, *h_rate, *tension;

  ElementValues(const FlexibleBody& body, double* scratch)
      : h(scratch), h_rate(h + body.elements), tension(h_rate + body.elements) {}
};

/// Sets h of all elements, and its rate if there are velocities.
void set_slope_moments(const FlexibleBody& body, const NodalMotion& at, ElementValues& values) {
  for (int e = 0; e < body.elements; ++e) {
    const BeamElement& element = body.beam[static_cast<std::size_t>(e)];
    const PlaneCoordinates x = planes_of(body, e, at.q);
    values.h[e] = calc_slope_moment(element, x);
    values.h_rate[e] = at.v ? calc_slope_moment_rate(element, x, planes_of(body, e, at.v)) : 0.0;
  }
}

/// Returns psi of the inner node of element e less that of its outer one, from `h` of the elements.
template <class SlopeMoment>
double sum_shift(const FlexibleBody& body, int e, const SlopeMoment& h) {
  double shift = 0.0;
  if (e > 0) {
    const ShiftWeights w = shift_weights(body, e);
    shift += w.inboard * h(e - 1) + w.outboard * h(e);
  }
  if (e + 1 < body.elements) {
    const ShiftWeights w = shift_weights(body, e + 1);
    shift -= w.inboard * h(e) + w.outboard * h(e + 1);
  }
  return shift;
}
double calc_shift(const FlexibleBody& body, int e, const double* h) {
  return sum_shift(body, e, [h](int of) { return h[of]; });
}

/// Returns the factor of h of element e in the energy: what tension(e) rises along it.
template <class Tension>
double calc_rise(const FlexibleBody& body, int e, Tension&& tension) {
  double rise = 0.0;
  if (e > 0) rise += shift_weights(body, e).outboard * (tension(e) - tension(e - 1));
  if (e + 1 < body.elements)
    rise += shift_weights(body, e + 1).inboard * (tension(e + 1) - tension(e));
  return rise;
}

/// Calls `visit(e, element strain, axis)` for all elements, from the inboard end.
template <class Visit>
void visit_strains(const FlexibleBody& body, const double* q, Visit&& visit) {
  NodeTurn turns[2];
  turns[0] = calc_node_turn(Eigen::Map<const Angular>(q + kRotation));
  for (int e = 0; e < body.elements; ++e) {
    const auto at = static_cast<std::size_t>(e);
    const NodeTurn& inner = turns[e % 2];
    NodeTurn& outer = turns[1 - e % 2];
    outer = calc_node_turn(Eigen::Map<const Angular>(q + kTwist * (e + 1) + kRotation));
    const ElementStrain strain(body.beam[at], body.second_order[at], inner, outer, q + kTwist * e);
    visit(e, strain, Position(body.beam[at].axes.col(0)));
  }
}

void add_along(const Position& axis, double shift, Twist& d) { linear(d) += shift * axis; }

/// Calls `visit(e, d)` for the strains of all elements, from the inboard end, without what forces
/// need of them.
template <class Visit>
void visit_shifted_strains(const FlexibleBody& body, const double* q, double* scratch,
                           Visit&& visit) {
  ElementValues values(body, scratch);
  set_slope_moments(body, {q, nullptr}, values);
  Matrix3 turns[2];
  turns[0] = calc_node_rotation(Eigen::Map<const Angular>(q + kRotation));
  for (int e = 0; e < body.elements; ++e) {
    const auto at = static_cast<std::size_t>(e);
    const double* nodes = q + kTwist * e;
    turns[1 - e % 2] = calc_node_rotation(Eigen::Map<const Angular>(nodes + kTwist + kRotation));
    Twist d = calc_element_strain(body.beam[at], body.second_order[at], turns[e % 2],
                                  turns[1 - e % 2], nodes);
    add_along(Position(body.beam[at].axes.col(0)), calc_shift(body, e, values.h), d);
    visit(e, d);
  }
}

/// A flex vector by node at an element and its neighbours.
class NodesAround {
 public:
  NodesAround(const FlexibleBody& body, int e, const double* flex)
      : body_(body), e_(e), first_(std::max(e - 1, 0)) {
    const int last = std::min(e + 2, body.elements);
    for (int i = 0; i < kTwist * (last - first_ + 1); ++i) {
      const int at = body.coordinate(first_ + i / kTwist, i % kTwist);
      values_[static_cast<std::size_t>(i)] = at >= 0 ? flex[at] : 0.0;
    }
  }
  /// Returns the values of both nodes of an element.
  const double* of(int element) const { return values_.data() + kTwist * (element - first_); }
  PlaneCoordinates planes(int element) const {
    return in_axes_of(body_.beam[static_cast<std::size_t>(element)], body_.is_straight,
                      of(element));
  }
  /// Calls `visit(strain of the element)`.
  template <class Visit>
  auto visit(const Visit& visit) const {
    const double* q = of(e_);
    const NodeTurn inner = calc_node_turn(Eigen::Map<const Angular>(q + kRotation));
    const NodeTurn outer = calc_node_turn(Eigen::Map<const Angular>(q + kTwist + kRotation));
    const auto at = static_cast<std::size_t>(e_);
    return visit(ElementStrain(body_.beam[at], body_.second_order[at], inner, outer, q));
  }

 private:
  const FlexibleBody& body_;
  int e_, first_;
  std::array<double, 4 * kTwist> values_{};
};

/// Subtracts the forces by the change of tension along the elements.
void subtract_rises(const FlexibleBody& body, const double* q, const double* tension,
                    double* force) {
  if (body.elements < 2) return;
  const auto tension_of = [tension](int e) { return tension[e]; };
  for (int e = 0; e < body.elements; ++e) {
    const BeamElement& element = body.beam[static_cast<std::size_t>(e)];
    subtract_forces_of(
        element, body.is_straight,
        differ_slope_moment(element, calc_rise(body, e, tension_of), planes_of(body, e, q)),
        force + kTwist * e);
  }
}

TwistMatrix damping_of(const BeamElement& element, double stiffness_factor) {
  return element.damping + stiffness_factor * element.stiffness;
}

double subtract_forces(const FlexibleBody& body, double stiffness_factor,
                       const NodalMotion& elastic, const NodalMotion& motion, double* scratch,
                       double* force) {
  const bool is_damped = body.is_damped || stiffness_factor != 0.0;
  ElementValues values(body, scratch);
  set_slope_moments(body, {elastic.q, is_damped ? elastic.v : nullptr}, values);
  double power = 0.0;
  visit_strains(body, elastic.q, [&](int e, const ElementStrain& strain, const Position& axis) {
    const BeamElement& element = body.beam[static_cast<std::size_t>(e)];
    Twist d = strain.d();
    add_along(axis, calc_shift(body, e, values.h), d);
    Twist sigma = element.stiffness.lazyProduct(d);
    if (is_damped) {
      Twist rate = strain.rate(elastic.v + kTwist * e);
      add_along(axis, calc_shift(body, e, values.h_rate), rate);
      const Twist damping = damping_of(element, stiffness_factor).lazyProduct(rate);
      sigma += damping;
      if (elastic.v == motion.v) power += damping.dot(rate);
    }
    values.tension[e] = axis.dot(linear(sigma));
    strain.subtract_force(sigma, force + kTwist * e);
  });
  subtract_rises(body, elastic.q, values.tension, force);
  if (!is_damped || elastic.v == motion.v) return power;
  set_slope_moments(body, motion, values);
  visit_strains(body, motion.q, [&](int e, const ElementStrain& strain, const Position& axis) {
    Twist rate = strain.rate(motion.v + kTwist * e);
    add_along(axis, calc_shift(body, e, values.h_rate), rate);
    const BeamElement& element = body.beam[static_cast<std::size_t>(e)];
    power += rate.dot(damping_of(element, stiffness_factor).lazyProduct(rate));
  });
  return power;
}

TurnedMasses turned_masses(const FlexibleBody& body, int e) {
  const ElementSecondOrder& second = body.second_order[static_cast<std::size_t>(e)];
  return {second.turning, second.inertias};
}

/// Adds a matrix over the nodes from `first` on to one over the flex vector.
void add_nodes(const FlexibleBody& body, int first, const Eigen::MatrixXd& matrix,
               Eigen::MatrixXd& sum) {
  const auto coordinate = [&](Eigen::Index i) {
    return body.coordinate(first + static_cast<int>(i) / kTwist, static_cast<int>(i) % kTwist);
  };
  for (Eigen::Index r = 0; r < matrix.rows(); ++r)
    for (Eigen::Index c = 0; c < matrix.cols(); ++c)
      if (coordinate(r) >= 0 && coordinate(c) >= 0)
        sum(coordinate(r), coordinate(c)) += matrix(r, c);
}

/// Returns the gradient of h of an element at the coordinates of its nodes.
Eigen::Matrix<double, kBothNodes, 1> gradient(const BeamElement& element, bool is_straight,
                                              const double* q) {
  Eigen::Matrix<double, kBothNodes, 1> force = Eigen::Matrix<double, kBothNodes, 1>::Zero();
  const PlaneCoordinates x = in_axes_of(element, is_straight, q);
  subtract_forces_of(element, is_straight, differ_slope_moment(element, 1.0, x), force.data());
  return -force;
}

/// Returns the direction from the inner to the outer node of an element as they stand.
Position chord_direction(const BeamElement& element, const double* q) {
  return (element.chord + Eigen::Map<const Position>(q + kTwist) - Eigen::Map<const Position>(q))
      .normalized();
}

/// Returns D of an element with the shift, over the nodes of its neighbours, too; `first`: the
/// first of these.
Eigen::MatrixXd map_with_shift(const FlexibleBody& body, int e, const ElementStrain& strain,
                               const double* q, int& first) {
  first = std::max(e - 1, 0);
  const int last = std::min(e + 2, body.elements);
  Eigen::MatrixXd D = Eigen::MatrixXd::Zero(kTwist, kTwist * (last - first + 1));
  D.middleCols<kBothNodes>(kTwist * (e - first)) = strain.map();
  const Position axis = body.beam[static_cast<std::size_t>(e)].axes.col(0);
  const auto add = [&](int of, double weight) {
    D.block<3, kBothNodes>(0, kTwist * (of - first)) +=
        weight * axis *
        gradient(body.beam[static_cast<std::size_t>(of)], body.is_straight, q + kTwist * of)
            .transpose();
  };
  if (e > 0) {
    const ShiftWeights w = shift_weights(body, e);
    add(e - 1, w.inboard);
    add(e, w.outboard);
  }
  if (e + 1 < body.elements) {
    const ShiftWeights w = shift_weights(body, e + 1);
    add(e, -w.inboard);
    add(e + 1, -w.outboard);
  }
  return D;
}

}  // namespace

double subtract_strain_forces(const FlexibleBody& body, double stiffness_factor,
                              const NodalMotion& elastic, const NodalMotion& motion,
                              double* scratch, double* force) noexcept {
  assert(body.is_nonlinear() && elastic.q && elastic.v && motion.q && motion.v);
  return subtract_forces(body, stiffness_factor, elastic, motion, scratch, force);
}

Twist calc_strain(const FlexibleBody& body, int e, const double* q) noexcept {
  assert(body.is_nonlinear() && e >= 0 && e < body.elements);
  const NodesAround at(body, e, q);
  Twist d = at.visit([](const ElementStrain& strain) { return strain.d(); });
  const auto h = [&](int of) {
    return calc_slope_moment(body.beam[static_cast<std::size_t>(of)], at.planes(of));
  };
  add_along(body.beam[static_cast<std::size_t>(e)].axes.col(0), sum_shift(body, e, h), d);
  return d;
}

Twist calc_strain_rate(const FlexibleBody& body, int e, const double* q, const double* v) noexcept {
  assert(body.is_nonlinear() && e >= 0 && e < body.elements);
  const NodesAround at(body, e, q), moving(body, e, v);
  Twist rate = at.visit([&](const ElementStrain& strain) { return strain.rate(moving.of(e)); });
  const auto h = [&](int of) {
    return calc_slope_moment_rate(body.beam[static_cast<std::size_t>(of)], at.planes(of),
                                  moving.planes(of));
  };
  add_along(body.beam[static_cast<std::size_t>(e)].axes.col(0), sum_shift(body, e, h), rate);
  return rate;
}

void calc_strain_wrenches(const FlexibleBody& body, const double* q, double* scratch,
                          Twist* wrenches) noexcept {
  assert(body.is_nonlinear());
  visit_shifted_strains(body, q, scratch, [&](int e, const Twist& d) {
    wrenches[e] = body.beam[static_cast<std::size_t>(e)].stiffness.lazyProduct(d);
  });
}

double calc_nonlinear_energy(const FlexibleBody& body, const double* q, double* scratch) noexcept {
  assert(body.is_nonlinear());
  double sum = 0.0;
  visit_shifted_strains(body, q, scratch, [&](int e, const Twist& d) {
    sum += 0.5 * d.dot(body.beam[static_cast<std::size_t>(e)].stiffness.lazyProduct(d));
  });
  return sum;
}

void add_tangents(const FlexibleBody& body, const BlockFactors& factors, double gain,
                  const double* q, const Twist* wrenches, BlockTridiagonal& sum) noexcept {
  const auto tension = [&](int e) {
    const auto at = static_cast<std::size_t>(e);
    return body.beam[at].axes.col(0).dot(linear(wrenches[at]));
  };
  visit_strains(body, q, [&](int e, const ElementStrain& strain, const Position&) {
    const BeamElement& element = body.beam[static_cast<std::size_t>(e)];
    const TwistMatrix K = factors.stiffness * element.stiffness + factors.damping * element.damping;
    NodesMatrix tangent = strain.tangent(K, gain * wrenches[e]);
    if (body.elements > 1)
      add_slope_curvature(element, gain * calc_rise(body, e, tension), tangent);
    sum.add(e, tangent);
  });
}

void set_shift(const FlexibleBody& body, const double* q, ImplicitShift& shift) noexcept {
  for (int k = 1; k < body.elements; ++k) {
    ImplicitShift::Node& node = shift.nodes[static_cast<std::size_t>(k)];
    node = {};
    const BeamElement& inner = body.beam[static_cast<std::size_t>(k - 1)];
    const BeamElement& outer = body.beam[static_cast<std::size_t>(k)];
    // Stretches both elements by as much as psi does, however far they are turned.
    const Position a = chord_direction(inner, q + kTwist * (k - 1));
    const Position b = chord_direction(outer, q + kTwist * k);
    node.axis = (a + b) / (1.0 + a.dot(b));
    const ShiftWeights w = shift_weights(body, k);
    Eigen::Map<Eigen::Matrix<double, 3 * kTwist, 1>> slope(node.gradient.data());
    slope.head<kBothNodes>() = w.inboard * gradient(inner, body.is_straight, q + kTwist * (k - 1));
    slope.tail<kBothNodes>() += w.outboard * gradient(outer, body.is_straight, q + kTwist * k);
    for (int i = 0; i < 3 * kTwist; ++i)
      if (body.coordinate(k - 1 + i / kTwist, i % kTwist) < 0) slope[i] = 0.0;
  }
  // What psi has of places along these directions, which is little, is left out.
  for (int k = 1; k < body.elements; ++k)
    for (int j = k - 1; j <= k + 1; ++j) {
      const Position& axis = shift.nodes[static_cast<std::size_t>(j)].axis;
      if (axis.isZero(0.0)) continue;
      Eigen::Map<Position> place(shift.nodes[static_cast<std::size_t>(k)].gradient.data() +
                                 kTwist * (j - k + 1));
      place -= axis.dot(place) / axis.squaredNorm() * axis;
    }
}

TurnedInertia subtract_turning(const FlexibleBody& body, const Angular& w,
                               const NodalMotion& motion, double* force) noexcept {
  TurnedInertia sum;
  for (int e = 0; e < body.elements; ++e) {
    const int node = kTwist * e;
    subtract_turned(turned_masses(body, e), w, motion.q + node, motion.v + node, force + node, sum);
  }
  return sum;
}

Matrix3 calc_turned_inertia(const FlexibleBody& body, const double* q) noexcept {
  Matrix3 sum = Matrix3::Zero();
  for (int e = 0; e < body.elements; ++e) add_turned(turned_masses(body, e), q + kTwist * e, sum);
  return sum;
}

StrainMatrices calc_strain_matrices(const FlexibleBody& body, double stiffness_factor,
                                    const double* q) {
  const Eigen::Index n = body.coordinates();
  StrainMatrices sum{Eigen::MatrixXd::Zero(n, n), Eigen::MatrixXd::Zero(n, n)};
  std::vector<Twist> wrenches(static_cast<std::size_t>(body.elements));
  std::vector<double> scratch(3 * wrenches.size());
  calc_strain_wrenches(body, q, scratch.data(), wrenches.data());
  std::vector<double> tension;
  visit_strains(body, q, [&](int e, const ElementStrain& strain, const Position& axis) {
    const auto at = static_cast<std::size_t>(e);
    tension.push_back(axis.dot(linear(wrenches[at])));
    int first = 0;
    const Eigen::MatrixXd D = map_with_shift(body, e, strain, q, first);
    const BeamElement& element = body.beam[at];
    add_nodes(body, first, D.transpose() * element.stiffness * D, sum.stiffness);
    add_nodes(body, first, D.transpose() * damping_of(element, stiffness_factor) * D, sum.damping);
    add_nodes(body, e, strain.tangent(TwistMatrix::Zero(), wrenches[at]), sum.stiffness);
  });
  const auto tension_of = [&tension](int e) { return tension[static_cast<std::size_t>(e)]; };
  for (int e = 0; e < body.elements; ++e) {
    NodesMatrix by_rise = NodesMatrix::Zero();
    add_slope_curvature(body.beam[static_cast<std::size_t>(e)], calc_rise(body, e, tension_of),
                        by_rise);
    add_nodes(body, e, by_rise, sum.stiffness);
  }
  return sum;
}

}  // namespace spoke::space
