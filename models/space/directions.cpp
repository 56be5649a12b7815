// Sorts the masses of slots and the matrices of elements by direction.

#include "models/space/directions.h"

#include <algorithm>
#include <cassert>

namespace spoke::space {
namespace {

constexpr int kLanes = 4;

/// Masses between slots of neighbouring nodes, zero beyond the ends.
class Masses {
 public:
  explicit Masses(const DirectedBody& body)
      : body_(body), elements_(static_cast<int>(body.beam.size())) {}

  bool has(int node) const { return node >= 0 && node <= elements_; }
  double x_of(int node) const { return has(node) ? body_.nodes[index(node)].x() : 0.0; }
  /// Returns the mass between slot i of node k and slot j of node k + step.
  double between(int k, int i, int step, int j) const {
    if (!has(k) || !has(k + step)) return 0.0;
    if (step == 0) return body_.slots.own[index(k)][at(i, j)];
    return step > 0 ? body_.slots.next[index(k)][at(i, j)]
                    : body_.slots.next[index(k - 1)][at(j, i)];
  }
  /// Returns the mass between element e's stretch and slot j of its inner (0) or outer (1) node.
  double stretch(int e, int node, int j) const {
    if (e < 0 || e >= elements_) return 0.0;
    return body_.slots.stretch[index(e)][static_cast<std::size_t>(kNodeSlots * node + j)];
  }
  double stretch_own(int e) const {
    return e < 0 || e >= elements_ ? 0.0 : body_.slots.stretch_own[index(e)];
  }
  /// Returns 1 / l of an element, zero beyond the ends.
  double per_length(int e) const {
    return e < 0 || e >= elements_ ? 0.0 : 1.0 / body_.beam[index(e)].length;
  }

 private:
  static std::size_t index(int i) { return static_cast<std::size_t>(i); }
  static std::size_t at(int i, int j) { return static_cast<std::size_t>(kNodeSlots * i + j); }

  const DirectedBody& body_;
  int elements_;
};

/// Factors by which a momentum of node k follows from its neighbours.
struct Row {
  double inner = 0.0, own = 0.0, outer = 0.0;

  void add(double factor, const Row& row) {
    inner += factor * row.inner;
    own += factor * row.own;
    outer += factor * row.outer;
  }
  void put(int lane, Band& band) const {
    const auto n = static_cast<std::size_t>(lane);
    band.inner[n] = inner;
    band.own[n] = own;
    band.outer[n] = outer;
  }
};

/// Returns the row of the momentum of slot i of node k, by the slots j of nodes.
Row row_of_slot(const Masses& m, int k, int i, int j) {
  return {m.between(k, i, -1, j), m.between(k, i, 0, j), m.between(k, i, 1, j)};
}
/// Returns the row of the momentum of the stretch of the element inboard (-1) or outboard (0) of
/// node k.
Row row_of_stretch(const Masses& m, int k, int side, int j) {
  if (side < 0) return {m.stretch(k - 1, 0, j), m.stretch(k - 1, 1, j), 0.0};
  return {0.0, m.stretch(k, 0, j), m.stretch(k, 1, j)};
}

/// Returns the row that the stretches of the elements at node k, as functions of u, add to a
/// momentum with the masses `inboard` and `outboard` for them.
Row row_of_stretching(const Masses& m, int k, double inboard, double outboard) {
  const double a = inboard * m.per_length(k - 1), b = outboard * m.per_length(k);
  return {-a, a - b, b};
}

constexpr int kPlace = 0, kAxis = 1;  // slots r and t

void put_slot(const Masses& m, int k, int i, int lane, NodeLanes::Momentum& momentum) {
  Row axial = row_of_slot(m, k, i, kPlace);
  axial.add(1.0, row_of_stretching(m, k, m.stretch(k - 1, 1, i), m.stretch(k, 0, i)));
  axial.put(lane, momentum.axial);
  row_of_slot(m, k, i, kPlace).put(lane, momentum.place);
  row_of_slot(m, k, i, kAxis).put(lane, momentum.slope);
  double& undeformed = momentum.undeformed[static_cast<std::size_t>(lane)];
  for (int step = -1; step <= 1; ++step)
    undeformed += m.between(k, i, step, kPlace) * m.x_of(k + step) + m.between(k, i, step, kAxis);
}

/// Puts the momentum of the places, with sigma_e/l of the element inboard and -sigma_e/l of the one
/// outboard, sigma the momentum of a stretch.
void put_stretched(const Masses& m, int k, int lane, NodeLanes::Momentum& momentum) {
  put_slot(m, k, kPlace, lane, momentum);
  const auto n = static_cast<std::size_t>(lane);
  Row axial{momentum.axial.inner[n], momentum.axial.own[n], momentum.axial.outer[n]};
  Row place = row_of_slot(m, k, kPlace, kPlace), slope = row_of_slot(m, k, kPlace, kAxis);
  for (const int side : {-1, 0}) {
    const int e = k + side;
    const double factor = (side < 0 ? 1.0 : -1.0) * m.per_length(e);
    const Row by_place = row_of_stretch(m, k, side, kPlace);
    axial.add(factor, by_place);
    place.add(factor, by_place);
    slope.add(factor, row_of_stretch(m, k, side, kAxis));
    const double own = m.stretch_own(e);
    axial.add(factor, row_of_stretching(m, k, side < 0 ? own : 0.0, side < 0 ? 0.0 : own));
    for (int node = 0; node < 2; ++node)
      momentum.undeformed[n] +=
          factor * (m.stretch(e, node, kPlace) * m.x_of(e + node) + m.stretch(e, node, kAxis));
  }
  axial.put(lane, momentum.axial);
  place.put(lane, momentum.place);
  slope.put(lane, momentum.slope);
}

void put_node(const DirectedBody& body, const Masses& m, int k, int lane, NodeLanes& lanes) {
  const auto n = static_cast<std::size_t>(lane);
  put_slot(m, k, kPlace, lane, lanes.r);
  put_slot(m, k, kAxis, lane, lanes.t);
  put_stretched(m, k, lane, lanes.stretched);
  const Row d = row_of_slot(m, k, 2, 2), g = row_of_slot(m, k, 3, 3);
  d.put(lane, lanes.d);
  g.put(lane, lanes.g);
  lanes.d_undeformed[n] = d.inner + d.own + d.outer;
  lanes.g_undeformed[n] = g.inner + g.own + g.outer;
  const NodeMomentum& C_t = body.C_t[static_cast<std::size_t>(k)];
  lanes.axial[n] = C_t(0, 0);
  lanes.place[n] = C_t(1, 1);
  lanes.slope[n] = C_t(5, 1);
}

void put_element(const BeamElement& element, std::size_t n, ElementLanes& lanes) {
  const TwistMatrix& K = element.stiffness;
  lanes.length[n] = element.chord.x();
  lanes.axial[n] = K(0, 0);
  lanes.torsion[n] = K(3, 3);
  const auto put_bending = [n](double shear, double mixed, double moment,
                               ElementLanes::Bending& to) {
    to.shear[n] = shear;
    to.mixed[n] = mixed;
    to.moment[n] = moment;
  };
  put_bending(K(1, 1), K(1, 5), K(5, 5), lanes.bending[0]);
  put_bending(K(2, 2), -K(2, 4), K(4, 4), lanes.bending[1]);
  for (std::size_t k = 0; k < ElementStiffening::kWeights; ++k) {
    const Matrix4& T = element.stiffening.bending[k];
    ElementLanes::Tension& to = lanes.tension[k];
    to.rise[n] = T(2, 2);
    to.rise_inner[n] = T(1, 2);
    to.rise_outer[n] = T(3, 2);
    to.inner[n] = T(1, 1);
    to.between[n] = T(3, 1);
    to.outer[n] = T(3, 3);
    to.torsion[n] = element.stiffening.torsion[k];
  }
  lanes.turning[0][n] = 0.25 * element.stiffening.turning(1, 1);
  lanes.turning[1][n] = 0.25 * element.stiffening.turning(2, 2);
}

std::size_t count_groups(int members) {
  return static_cast<std::size_t>((members + kLanes - 1) / kLanes);
}

}  // namespace

Directions make_directions(const DirectedBody& body) {
  assert(!body.beam.empty() && body.nodes.size() == body.beam.size() + 1);
  assert(body.C_t.size() == body.nodes.size() && (body.first_node == 0 || body.first_node == 1));
  assert(std::all_of(body.beam.begin(), body.beam.end(), [](const BeamElement& element) {
    return element.inertias.empty() && element.chord.y() == 0.0 && element.chord.z() == 0.0;
  }));
  Directions directions;
  const Masses masses(body);
  const int elements = static_cast<int>(body.beam.size());
  const int first = body.first_node, nodes = elements + 1 - first;
  directions.nodes.resize(count_groups(nodes));
  for (int k = 0; k < nodes; ++k)
    put_node(body, masses, first + k, k % kLanes,
             directions.nodes[static_cast<std::size_t>(k / kLanes)]);
  directions.elements.resize(count_groups(elements));
  for (int e = 0; e < elements; ++e)
    put_element(body.beam[static_cast<std::size_t>(e)], static_cast<std::size_t>(e % kLanes),
                directions.elements[static_cast<std::size_t>(e / kLanes)]);
  return directions;
}

}  // namespace spoke::space
