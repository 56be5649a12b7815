// Sums the strain of each element and the shifts of its ends, and takes forces back to the nodes.

#include "engine/bodies/plane/nonlinear_strain.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <vector>

#include "models/support/wide_kernels.h"

namespace spoke::plane {
namespace {

double length_of(const FlexibleBody& body) { return body.length / body.elements; }

/// Where the coordinates of nodes stand in flex vectors. Those that the frame fixes at the first
/// node have places in the zeros before each part.
class NodePlaces {
 public:
  NodePlaces(const FlexibleBody& body, const FlexLayout& layout)
      : is_chord_(body.reference_frame == ReferenceFrame::chord),
        last_(is_chord_ ? body.elements : -1),
        u_(layout.u() - 1),
        v_(layout.v() - (is_chord_ ? 1 : 2)) {}

  /// Returns the values of both nodes of an element.
  NodesVector take(int e, const double* flex) const {
    NodesVector values;
    for (int side = 0; side < 2; ++side) {
      const int k = e + side;
      const double* const bending = flex + v_ + 2 * k;
      const bool is_last = k == last_;
      values.segment<kTwist>(kTwist * side) << flex[u_ + k], is_last ? 0.0 : bending[0],
          is_last ? bending[0] : bending[1];
    }
    return values;
  }
  /// Subtracts forces on both nodes of an element.
  void subtract(int e, const NodesVector& force, double* flex) const {
    for (int side = 0; side < 2; ++side) {
      const int k = e + side;
      const double* const of_node = force.data() + kTwist * side;
      double* const bending = flex + v_ + 2 * k;
      if (k > 0) flex[u_ + k] -= of_node[0];
      if (k > 0 && k != last_) bending[0] -= of_node[1];
      if (k > 0 || is_chord_) bending[k == last_ ? 0 : 1] -= of_node[kRotation];
    }
  }

 private:
  bool is_chord_;
  int last_, u_, v_;
};

/// Returns the derivatives of h of an element of length l: h is half their product with x.
NodesVector differ_slope_moment(double l, const NodesVector& x) {
  const double rise = x[4] - x[1], bend = (x[5] - x[2]) / 20.0;
  NodesVector slope;
  slope << 0.0, -bend, -rise / 20.0 - l * x[2] / 30.0, 0.0, bend, rise / 20.0 + l * x[5] / 30.0;
  return slope;
}

/// Returns the factor of h of element f in d_x of element e: psi of its inner node has h of the
/// element before, psi of its outer node h of the next. Precondition: they are neighbours, or one.
double shift_weight(const FlexibleBody& body, int e, int f) {
  if (body.elements == 1) return 0.0;
  const bool is_first = f == 0, is_last = f + 1 == body.elements;
  const double weight = is_first || is_last ? 1.0 : 0.5;
  if (f != e) return f < e ? weight : -weight;
  return is_first ? -1.0 : is_last ? 1.0 : 0.0;
}

/// Calls visit(f) for an element and its neighbours.
template <class Visit>
void visit_neighbours(const FlexibleBody& body, int e, const Visit& visit) {
  for (int f = std::max(e - 1, 0); f <= std::min(e + 1, body.elements - 1); ++f) visit(f);
}

/// Returns psi of the inner node of element e less that of its outer one; `rates`: its rate.
double calc_shift(const FlexibleBody& body, const NodePlaces& nodes, int e, const double* q,
                  const double* rates = nullptr) {
  double shift = 0.0;
  visit_neighbours(body, e, [&](int f) {
    const NodesVector x = nodes.take(f, q);
    const NodesVector slope = differ_slope_moment(length_of(body), x);
    const double h = rates ? slope.dot(nodes.take(f, rates)) : 0.5 * slope.dot(x);
    shift += shift_weight(body, e, f) * h;
  });
  return shift;
}

/// Returns the factor of h of element e in the energy: how much tension(f) rises along it.
template <class Tension>
double calc_rise(const FlexibleBody& body, int e, const Tension& tension) {
  double rise = 0.0;
  visit_neighbours(body, e, [&](int f) { rise += shift_weight(body, f, e) * tension(f); });
  return rise;
}

/// Returns factors.stiffness K + factors.damping K_D of an element.
TwistMatrix weigh_stiffness(const FlexibleBody& body, int e, double stiffness, double damping) {
  const TwistMatrix& K = body.strain_stiffness[static_cast<std::size_t>(e)];
  const Twist factors(stiffness + damping * body.damping.axial,
                      stiffness + damping * body.damping.bending,
                      stiffness + damping * body.damping.bending);
  return factors.asDiagonal() * K;
}

/// The nodes of an element and of both its neighbours.
constexpr int kAllNodes = kBothNodes + 2 * kTwist;
using WideMap = Eigen::Matrix<double, kTwist, kAllNodes>;

/// Returns D of an element, the shifts included, over nodes e - 1 to e + 2.
WideMap calc_wide_map(const FlexibleBody& body, const NodePlaces& nodes, int e,
                      const ElementStrain& strain, const double* q) {
  WideMap D = WideMap::Zero();
  D.middleCols<kBothNodes>(kTwist) = strain.map();
  visit_neighbours(body, e, [&](int f) {
    D.block<1, kBothNodes>(0, kTwist * (f - e + 1)) +=
        shift_weight(body, e, f) *
        differ_slope_moment(length_of(body), nodes.take(f, q)).transpose();
  });
  return D;
}

/// Adds a symmetric matrix, entry(i, j), over `kCount` coordinates of nodes from `first` on.
template <int kCount, class Entry>
void add_nodes(const FlexibleBody& body, int first, const Entry& entry, NodalBand& sum) {
  int places[kCount];
  for (int i = 0; i < kCount; ++i) places[i] = place_by_node(body, first + i / kTwist, i % kTwist);
  for (int i = 0; i < kCount; ++i)
    for (int j = 0; j <= i; ++j)
      if (places[i] >= 0 && places[j] >= 0) sum.add(places[i], places[j], entry(i, j));
}

double subtract_forces(const FlexibleBody& body, const FlexLayout& layout, double stiffness_factor,
                       const double* q, const double* v, double* Q) {
  const bool is_damped = stiffness_factor != 0.0 || !body.damping.is_zero();
  const NodePlaces nodes(body, layout);
  const double l = length_of(body);
  double power = 0.0;
  double tensions[3]{};  // of an element and its neighbours
  const auto tension = [&tensions](int f) { return tensions[f % 3]; };
  for (int e = 0; e <= body.elements; ++e) {
    if (e < body.elements) {
      const ElementStrain strain(l, nodes.take(e, q));
      const StrainMap D = strain.map();
      Twist d = strain.d();
      d[0] += calc_shift(body, nodes, e, q);
      Twist sigma = body.strain_stiffness[static_cast<std::size_t>(e)].lazyProduct(d);
      if (is_damped) {
        Twist rate = D.lazyProduct(nodes.take(e, v));
        rate[0] += calc_shift(body, nodes, e, q, v);
        const Twist damping = weigh_stiffness(body, e, stiffness_factor, 1.0).lazyProduct(rate);
        power += damping.dot(rate);
        sigma += damping;
      }
      tensions[e % 3] = sigma[0];
      nodes.subtract(e, D.transpose().lazyProduct(sigma), Q);
    }
    if (e == 0) continue;
    nodes.subtract(
        e - 1, calc_rise(body, e - 1, tension) * differ_slope_moment(l, nodes.take(e - 1, q)), Q);
  }
  return power;
}

void add_all_tangents(const FlexibleBody& body, const FlexLayout& layout,
                      const TangentFactors& factors, const double* q, const Twist* wrenches,
                      NodalBand& sum) {
  const NodePlaces nodes(body, layout);
  const double l = length_of(body);
  NodesMatrix slope_forms;
  for (int c = 0; c < kBothNodes; ++c)
    slope_forms.col(c) = differ_slope_moment(l, NodesVector::Unit(c));
  const auto tension = [wrenches](int f) { return wrenches[f][0]; };
  for (int e = 0; e < body.elements; ++e) {
    const ElementStrain strain(l, nodes.take(e, q));
    const WideMap D = calc_wide_map(body, nodes, e, strain, q);
    const WideMap K_D = weigh_stiffness(body, e, factors.stiffness, factors.damping).lazyProduct(D);
    add_nodes<kAllNodes>(
        body, e - 1, [&](int i, int j) { return D.col(i).dot(K_D.col(j)); }, sum);
    if (factors.geometric == 0.0) continue;
    const NodesMatrix K = factors.geometric * (strain.geometric_stiffness(wrenches[e]) +
                                               calc_rise(body, e, tension) * slope_forms);
    add_nodes<kBothNodes>(
        body, e, [&](int i, int j) { return K(i, j); }, sum);
  }
}

Eigen::MatrixXd to_dense(const FlexibleBody& body, const NodalBand& band) {
  Eigen::MatrixXd dense = Eigen::MatrixXd::Zero(body.coordinates(), body.coordinates());
  band.add_to(dense);
  return dense;
}

}  // namespace

double subtract_strain_forces(const FlexibleBody& body, const FlexLayout& layout,
                              double stiffness_factor, const double* q, const double* v,
                              double* Q) noexcept {
  assert(body.is_nonlinear() && q && v && Q);
  return run_kernel(
      [&]() noexcept { return subtract_forces(body, layout, stiffness_factor, q, v, Q); });
}

Twist calc_strain(const FlexibleBody& body, const FlexLayout& layout, int e,
                  const double* q) noexcept {
  const NodePlaces nodes(body, layout);
  Twist d = ElementStrain(length_of(body), nodes.take(e, q)).d();
  d[0] += calc_shift(body, nodes, e, q);
  return d;
}

Twist calc_strain_rate(const FlexibleBody& body, const FlexLayout& layout, int e, const double* q,
                       const double* v) noexcept {
  const NodePlaces nodes(body, layout);
  const ElementStrain strain(length_of(body), nodes.take(e, q));
  Twist rate = strain.map() * nodes.take(e, v);
  rate[0] += calc_shift(body, nodes, e, q, v);
  return rate;
}

Twist calc_strain_wrench(const FlexibleBody& body, const FlexLayout& layout, int e,
                         const double* q) noexcept {
  return body.strain_stiffness[static_cast<std::size_t>(e)] * calc_strain(body, layout, e, q);
}

double calc_nonlinear_energy(const FlexibleBody& body, const FlexLayout& layout,
                             const double* q) noexcept {
  double sum = 0.0;
  for (int e = 0; e < body.elements; ++e) {
    const Twist d = calc_strain(body, layout, e, q);
    sum += 0.5 * d.dot(body.strain_stiffness[static_cast<std::size_t>(e)] * d);
  }
  return sum;
}

void add_tangents(const FlexibleBody& body, const FlexLayout& layout, const TangentFactors& factors,
                  const double* q, const Twist* wrenches, NodalBand& sum) noexcept {
  run_kernel([&]() noexcept { add_all_tangents(body, layout, factors, q, wrenches, sum); });
}

Eigen::MatrixXd calc_strain_stiffness(const FlexibleBody& body, const FlexLayout& layout,
                                      const double* q) {
  std::vector<Twist> wrenches;
  for (int e = 0; e < body.elements; ++e)
    wrenches.push_back(calc_strain_wrench(body, layout, e, q));
  NodalBand band(body);
  add_tangents(body, layout, {1.0, 0.0, 1.0}, q, wrenches.data(), band);
  return to_dense(body, band);
}

Eigen::MatrixXd calc_strain_damping(const FlexibleBody& body, const FlexLayout& layout,
                                    double stiffness_factor, const double* q) {
  NodalBand band(body);
  add_tangents(body, layout, {stiffness_factor, 1.0, 0.0}, q, nullptr, band);
  return to_dense(body, band);
}

}  // namespace spoke::plane
