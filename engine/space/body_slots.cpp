// Slots from coordinates, and products with their scalar mass matrix, node by node.

#include "engine/space/body_slots.h"

#include "engine/space/element_products.h"

namespace spoke::space {
namespace {

/// Place and axes of a node, each with its rate: r = s + u, and e + th x e for e along x, y, z.
void set_node(const Position& s, const double* q, const double* v, double* slots) {
  const double values[kNodeSlots][kSlot] = {
      {s.x() + q[0], s.y() + q[1], s.z() + q[2], v[0], v[1], v[2]},
      {1.0, q[5], -q[4], 0.0, v[5], -v[4]},
      {-q[5], 1.0, q[3], -v[5], 0.0, v[3]},
      {q[4], -q[3], 1.0, v[4], -v[3], 0.0}};
  for (int i = 0; i < kNodeSlots; ++i)
    for (int c = 0; c < kSlot; c += 2)
      store_aligned(Double2{values[i][c], values[i][c + 1]}, slots + kSlot * i + c);
}

/// sigma = e1 e1.(u_2 - u_1)/l and its rate.
void set_stretch(const BeamElement& element, const double* q, const double* v, double* slot) {
  const Position e1 = element.axes.col(0);
  const auto stretch = [&](const double* x) {
    return (e1[0] * (x[6] - x[0]) + e1[1] * (x[7] - x[1]) + e1[2] * (x[8] - x[2])) / element.length;
  };
  const double value = stretch(q), rate = stretch(v);
  for (int c = 0; c < 3; ++c) {
    slot[c] = value * e1[c];
    slot[3 + c] = rate * e1[c];
  }
}

void set_slots(const FlexibleBody& body, const double* q, const double* v, double* slots) {
  double* slot = slots;
  for (const Position& s : body.nodes) {
    set_node(s, q, v, slot);
    q += kTwist;
    v += kTwist;
    slot += kNodeSlots * kSlot;
  }
  q -= kTwist * body.node_count();
  v -= kTwist * body.node_count();
  for (const BeamElement& element : body.beam) {
    set_stretch(element, q, v, slot);
    q += kTwist;
    v += kTwist;
    slot += kSlot;
  }
}

/// Adds one row of a block of masses, `stride` apart, times the slots of a node.
[[gnu::always_inline]] inline void add_row(const double* m, int stride, const double* slots,
                                           Double6& sum) {
  for (int j = 0; j < kNodeSlots; ++j) sum.add(m[stride * j], slots + kSlot * j);
}

/// Momenta of the slots of node k.
void calc_node_momenta(const FlexibleBody& body, int k, const double* slots, double* momenta) {
  constexpr int kNode = kNodeSlots * kSlot;
  const auto node = static_cast<std::size_t>(k);
  const double* x = slots + kNode * k;
  const SlotMasses& m = body.slots;
  for (int i = 0; i < kNodeSlots; ++i) {
    Double6 sum;
    add_row(&m.own[node][static_cast<std::size_t>(kNodeSlots * i)], 1, x, sum);
    if (k < body.elements) {
      add_row(&m.next[node][static_cast<std::size_t>(kNodeSlots * i)], 1, x + kNode, sum);
      sum.add(m.stretch[node][static_cast<std::size_t>(i)], slots + stretch_place(body, k));
    }
    if (k > 0) {
      add_row(&m.next[node - 1][static_cast<std::size_t>(i)], kNodeSlots, x - kNode, sum);
      sum.add(m.stretch[node - 1][static_cast<std::size_t>(kNodeSlots + i)],
              slots + stretch_place(body, k - 1));
    }
    sum.store_to(momenta + kNode * k + kSlot * i);
  }
}

void calc_stretch_momentum(const FlexibleBody& body, int e, const double* slots, double* momenta) {
  const auto element = static_cast<std::size_t>(e);
  const double* m = body.slots.stretch[element].data();
  const double* x = slots + kNodeSlots * kSlot * e;
  Double6 sum;
  for (int j = 0; j < kElementSlots; ++j) sum.add(m[j], x + kSlot * j);
  sum.add(body.slots.stretch_own[element], slots + stretch_place(body, e));
  sum.store_to(momenta + stretch_place(body, e));
}

/// Sums rho (mu, mu')^T over slots that lie one after another: J and G side by side.
struct OuterProducts {
  Double6 rows[3];

  void add(const double* rho, const double* mu, int count) {
    Double6 x = rows[0], y = rows[1], z = rows[2];
    for (int i = 0; i < count; ++i, rho += kSlot, mu += kSlot) {
      x.add(rho[0], mu);
      y.add(rho[1], mu);
      z.add(rho[2], mu);
    }
    rows[0] = x;
    rows[1] = y;
    rows[2] = z;
  }
  void take_apart(Matrix3& J, Matrix3& G) const {
    for (int i = 0; i < 3; ++i) {
      const Double6& row = rows[i];
      J.row(i) << row.a[0], row.a[1], row.b[0];
      G.row(i) << row.b[1], row.c[0], row.c[1];
    }
  }
};

}  // namespace

SlotSums calc_slots(const FlexibleBody& body, const double* q, const double* v,
                    const BodyWork& work) noexcept {
  set_slots(body, q, v, work.slots);
  for (int k = 0; k < body.node_count(); ++k) calc_node_momenta(body, k, work.slots, work.momenta);
  for (int e = 0; e < body.elements; ++e) calc_stretch_momentum(body, e, work.slots, work.momenta);
  OuterProducts products;
  products.add(work.slots, work.momenta, kNodeSlots * body.node_count() + body.elements);
  SlotSums sums;
  products.take_apart(sums.J, sums.G);
  Double6 places;
  for (int k = 0; k < body.node_count(); ++k)
    places.add(1.0, work.momenta + kNodeSlots * kSlot * k);
  sums.S = Position(places.a[0], places.a[1], places.b[0]);
  sums.S_rate = Position(places.b[1], places.c[0], places.c[1]);
  return sums;
}

}  // namespace spoke::space
