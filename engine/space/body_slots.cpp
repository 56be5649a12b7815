// Slots from coordinates, and products with their scalar mass matrix, node by node.

#include "engine/space/body_slots.h"

#include "engine/space/element_products.h"
#include "engine/support/wide_kernels.h"
#include "models/support/unroll.h"

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

/// Whether the momentum of slot i depends on slot j of a node.
template <bool kIsDecoupled>
constexpr bool slots_meet(int i, int j) {
  return !kIsDecoupled || i == j || (i < 2 && j < 2);
}

/// Adds row i of a block of masses, whose entries are `stride` apart, times the slots of a node.
template <bool kIsDecoupled, int i, int stride>
[[gnu::always_inline]] inline void add_row(const double* m, const double* slots, Double6& sum) {
  unroll<kNodeSlots>([&](auto slot) {
    constexpr int j = slot;
    if constexpr (slots_meet<kIsDecoupled>(i, j)) sum.add(m[stride * j], slots + kSlot * j);
  });
}

/// Momenta of the slots of node k.
template <bool kIsDecoupled>
void calc_node_momenta(const FlexibleBody& body, int k, const double* slots, double* momenta) {
  constexpr int kNode = kNodeSlots * kSlot;
  const auto node = static_cast<std::size_t>(k);
  const double* x = slots + kNode * k;
  const SlotMasses& m = body.slots;
  const bool has_next = k<body.elements, has_before = k> 0;
  unroll<kNodeSlots>([&](auto slot) {
    constexpr int i = slot;
    constexpr bool is_stretched = slots_meet<kIsDecoupled>(0, i);
    Double6 sum;
    add_row<kIsDecoupled, i, 1>(m.own[node].data() + kNodeSlots * i, x, sum);
    if (has_next) {
      add_row<kIsDecoupled, i, 1>(m.next[node].data() + kNodeSlots * i, x + kNode, sum);
      if constexpr (is_stretched)
        sum.add(m.stretch[node].data()[i], slots + stretch_place(body, k));
    }
    if (has_before) {
      add_row<kIsDecoupled, i, kNodeSlots>(m.next[node - 1].data() + i, x - kNode, sum);
      if constexpr (is_stretched)
        sum.add(m.stretch[node - 1].data()[kNodeSlots + i], slots + stretch_place(body, k - 1));
    }
    sum.store_to(momenta + kNode * k + kSlot * i);
  });
}

template <bool kIsDecoupled>
void calc_stretch_momentum(const FlexibleBody& body, int e, const double* slots, double* momenta) {
  const auto element = static_cast<std::size_t>(e);
  const double* m = body.slots.stretch[element].data();
  const double* x = slots + kNodeSlots * kSlot * e;
  Double6 sum;
  add_row<kIsDecoupled, 0, 1>(m, x, sum);
  add_row<kIsDecoupled, 0, 1>(m + kNodeSlots, x + kNodeSlots * kSlot, sum);
  sum.add(body.slots.stretch_own[element], slots + stretch_place(body, e));
  sum.store_to(momenta + stretch_place(body, e));
}

template <bool kIsDecoupled>
void calc_momenta(const FlexibleBody& body, const double* slots, double* momenta) {
  for (int k = 0; k < body.node_count(); ++k)
    calc_node_momenta<kIsDecoupled>(body, k, slots, momenta);
  for (int e = 0; e < body.elements; ++e)
    calc_stretch_momentum<kIsDecoupled>(body, e, slots, momenta);
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

SlotSums calc(const FlexibleBody& body, const double* q, const double* v, const BodyWork& work) {
  set_slots(body, q, v, work.slots);
  if (body.is_decoupled)
    calc_momenta<true>(body, work.slots, work.momenta);
  else
    calc_momenta<false>(body, work.slots, work.momenta);
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

}  // namespace

SlotSums calc_slots(const FlexibleBody& body, const double* q, const double* v,
                    const BodyWork& work) noexcept {
  return run_large_kernel([&]() noexcept { return calc(body, q, v, work); });
}

}  // namespace spoke::space
