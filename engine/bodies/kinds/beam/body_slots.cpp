// Calculates slots from coordinates, and products with their scalar mass matrix, node by node.

#include "engine/bodies/kinds/beam/body_slots.h"

#include <cassert>
#include <utility>

#include "models/support/simd.h"
#include "models/support/unroll.h"
#include "models/support/wide_kernels.h"

namespace spoke::space {
namespace {

/// A slot with its rate, in two registers.
struct SlotValues {
  Double4 a{};
  Double2 b{};

  [[gnu::always_inline]] static SlotValues from(const double* x) { return {load4(x), load(x + 4)}; }
  [[gnu::always_inline]] void add(double factor, const SlotValues& x) {
    a += factor * x.a;
    b += factor * x.b;
  }
  [[gnu::always_inline]] void store_to(double* x) const {
    store(a, x);
    store(b, x + 4);
  }
};

/// Sets place and axes of a node, each with its rate: r = s + u, and e + th x e for e along x, y,
/// z.
void set_node(const Position& s, const double* q, const double* v, double* slots) {
  const SlotValues values[kNodeSlots] = {
      {{s.x() + q[0], s.y() + q[1], s.z() + q[2], v[0]}, {v[1], v[2]}},
      {{1.0, q[5], -q[4], 0.0}, {v[5], -v[4]}},
      {{-q[5], 1.0, q[3], -v[5]}, {0.0, v[3]}},
      {{q[4], -q[3], 1.0, v[4]}, {-v[3], 0.0}}};
  for (int i = 0; i < kNodeSlots; ++i) values[i].store_to(slots + kSlot * i);
}

/// Sets sigma = e1 e1.(u_2 - u_1)/l and its rate.
void set_stretch(const BeamElement& element, const double* q, const double* v, double* slot) {
  const Position e1 = element.axes.col(0);
  const auto stretch = [&](const double* x) {
    return (e1[0] * (x[6] - x[0]) + e1[1] * (x[7] - x[1]) + e1[2] * (x[8] - x[2])) / element.length;
  };
  const double value = stretch(q), rate = stretch(v);
  SlotValues{{value * e1[0], value * e1[1], value * e1[2], rate * e1[0]},
             {rate * e1[1], rate * e1[2]}}
      .store_to(slot);
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

/// Momenta of a node's slots, which grow together: a slot is loaded once for all of them.
template <bool kIsDecoupled>
struct NodeMomenta {
  SlotValues sums[kNodeSlots];

  /// Adds m rho of the slots of a node. The mass of momentum i and slot j is at
  /// row * i + column * j.
  template <int row, int column>
  [[gnu::always_inline]] void add(const double* m, const double* slots) {
    unroll<kNodeSlots>([&](auto slot) {
      constexpr int j = slot;
      const SlotValues x = SlotValues::from(slots + kSlot * j);
      unroll<kNodeSlots>([&](auto momentum) {
        constexpr int i = momentum;
        if constexpr (slots_meet<kIsDecoupled>(i, j)) sums[i].add(m[row * i + column * j], x);
      });
    });
  }
  /// Adds m sigma of the stretch of an element at the node, by slot.
  [[gnu::always_inline]] void add_stretch(const double* m, const double* slot) {
    const SlotValues x = SlotValues::from(slot);
    unroll<kNodeSlots>([&](auto momentum) {
      constexpr int i = momentum;
      if constexpr (slots_meet<kIsDecoupled>(0, i)) sums[i].add(m[i], x);
    });
  }
};

/// Calculates the momenta mu_i = sum_j m_ij rho_j of the slots of node k.
template <bool kIsDecoupled>
void calc_node_momenta(const FlexibleBody& body, int k, const double* slots, double* momenta) {
  constexpr int kNode = kNodeSlots * kSlot;
  const auto node = static_cast<std::size_t>(k);
  const double* x = slots + kNode * k;
  const SlotMasses& m = body.slots;
  NodeMomenta<kIsDecoupled> mu;
  mu.template add<kNodeSlots, 1>(m.own[node].data(), x);
  if (k < body.elements) {
    mu.template add<kNodeSlots, 1>(m.next[node].data(), x + kNode);
    mu.add_stretch(m.stretch[node].data(), slots + stretch_place(body, k));
  }
  if (k > 0) {
    mu.template add<1, kNodeSlots>(m.next[node - 1].data(), x - kNode);
    mu.add_stretch(m.stretch[node - 1].data() + kNodeSlots, slots + stretch_place(body, k - 1));
  }
  unroll<kNodeSlots>(
      [&](auto slot) { mu.sums[slot].store_to(momenta + kNode * k + kSlot * slot); });
}

template <bool kIsDecoupled>
void calc_stretch_momentum(const FlexibleBody& body, int e, const double* slots, double* momenta) {
  const auto element = static_cast<std::size_t>(e);
  const double* m = body.slots.stretch[element].data();
  const double* x = slots + kNodeSlots * kSlot * e;
  SlotValues sum;
  for (int node = 0; node < 2; ++node)
    unroll<kNodeSlots>([&](auto slot) {
      constexpr int j = slot;
      if constexpr (slots_meet<kIsDecoupled>(0, j))
        sum.add(m[kNodeSlots * node + j], SlotValues::from(x + kSlot * (kNodeSlots * node + j)));
    });
  sum.add(body.slots.stretch_own[element], SlotValues::from(slots + stretch_place(body, e)));
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
  SlotValues rows[3];

  void add(const double* rho, const double* mu, int count) {
    SlotValues x = rows[0], y = rows[1], z = rows[2];
    for (int i = 0; i < count; ++i, rho += kSlot, mu += kSlot) {
      const SlotValues momentum = SlotValues::from(mu);
      x.add(rho[0], momentum);
      y.add(rho[1], momentum);
      z.add(rho[2], momentum);
    }
    rows[0] = x;
    rows[1] = y;
    rows[2] = z;
  }
  void take_apart(Matrix3& J, Matrix3& G) const {
    for (int i = 0; i < 3; ++i) {
      const SlotValues& row = rows[i];
      J.row(i) << row.a[0], row.a[1], row.a[2];
      G.row(i) << row.a[3], row.b[0], row.b[1];
    }
  }
};

SlotSums calc(const FlexibleBody& body, const double* q, const double* v,
              const BodyScratch& scratch) {
  assert(std::cmp_equal(body.slots.own.size(), body.node_count()));
  assert(std::cmp_equal(body.slots.stretch.size(), body.elements));
  set_slots(body, q, v, scratch.slots);
  if (body.is_decoupled)
    calc_momenta<true>(body, scratch.slots, scratch.momenta);
  else
    calc_momenta<false>(body, scratch.slots, scratch.momenta);
  OuterProducts products;
  products.add(scratch.slots, scratch.momenta, kNodeSlots * body.node_count() + body.elements);
  SlotSums sums;
  products.take_apart(sums.J, sums.G);
  SlotValues places;
  for (int k = 0; k < body.node_count(); ++k)
    places.add(1.0, SlotValues::from(scratch.momenta + kNodeSlots * kSlot * k));
  sums.S = Position(places.a[0], places.a[1], places.a[2]);
  sums.S_rate = Position(places.a[3], places.b[0], places.b[1]);
  return sums;
}

}  // namespace

SlotSums calc_slots(const FlexibleBody& body, const double* q, const double* v,
                    const BodyScratch& scratch) noexcept {
  return run_large_kernel([&]() noexcept { return calc(body, q, v, scratch); });
}

}  // namespace spoke::space
