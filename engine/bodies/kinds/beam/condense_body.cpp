// Goes outward once with four right-hand sides side by side, and back once with one.

#include "engine/bodies/kinds/beam/condense_body.h"

#include <algorithm>
#include <cassert>
#include <utility>

#include "engine/bodies/space/body_scratch.h"
#include "engine/bodies/space/element_products.h"
#include "models/support/unroll.h"
#include "models/support/wide_kernels.h"

namespace spoke::space {
namespace {

/// Four values: of the three columns of C_w^T, and of Q_f.
struct PortLanes {
  Double4 all{};

  [[gnu::always_inline]] void add(double factor, const PortLanes& x) { all += factor * x.all; }
  [[gnu::always_inline]] void subtract(double factor, const PortLanes& x) { all -= factor * x.all; }
  [[gnu::always_inline]] static PortLanes from(const double* x) { return {load4(x)}; }
  [[gnu::always_inline]] void store_to(double* x) const { store(all, x); }
  [[gnu::always_inline]] double operator[](int i) const { return all[i]; }
};

/// Sums over all rows of y_C^T (y_w, y_Q): three rows of translation, three of rotation.
struct Products {
  PortLanes t[3], w[3];

  Matrix3 columns(const PortLanes (&rows)[3]) const {
    Matrix3 m;
    for (int i = 0; i < 3; ++i) m.row(i) << rows[i][0], rows[i][1], rows[i][2];
    return m;
  }
};

void clear_fixed_rows(const FlexibleBody& body, double* rows) {
  if (body.reference_frame == ReferenceFrame::clamped) return;
  // These are u, v, w, tx of node 0, and v, w of the last.
  std::fill_n(rows, 4 * 4, 0.0);
  std::fill_n(rows + kNodeRows * body.elements + 4, 2 * 4, 0.0);
}

/// Returns the right-hand sides: the rows, or those in shifted coordinates, where the half
/// solutions will be.
double* take_rows(const FlexibleBody& body, const ImplicitShift* shift, const BodyWork& work) {
  double* rows = work.rows;
  if (shift) {
    const int first = kNodeRows * body.first_node(), end = kNodeRows * body.node_count();
    std::copy(work.rows + first, work.rows + end, work.half + first);
    rows = work.half;
    shift->apply_transposed<4>(rows);
  }
  clear_fixed_rows(body, rows);
  return rows;
}

/// Whether places (i, j) of a node's blocks may hold more than a zero.
template <bool kIsDecoupled>
constexpr bool meet(int i, int j) {
  return !kIsDecoupled || is_one_direction(i, j);
}
/// Whether coordinate i moves the body's mass along component c.
template <bool kIsDecoupled>
constexpr bool moves_mass(int i, int c) {
  return !kIsDecoupled || (i != kRotation && is_one_direction(i, c));
}

/// Solves y_k = L_kk^-1 (b_k - L_k,k-1 y_k-1) for one node; adds its products with y_C.
template <bool kIsDecoupled>
void solve_node(const double* below, const double* inverse, const double* b, const double* before,
                const double* W_t, double* y, Products& products) {
  PortLanes rest[kTwist];
  unroll<kTwist>([&](auto row) {
    constexpr int i = row;
    rest[i] = PortLanes::from(b + 4 * i);
  });
  if (before)
    unroll<kTwist>([&](auto column) {
      const PortLanes x = PortLanes::from(before + 4 * column);
      unroll<kTwist>([&](auto row) {
        constexpr int i = row, j = column;
        if constexpr (meet<kIsDecoupled>(i, j)) rest[i].subtract(below[kTwist * i + j], x);
      });
    });
  unroll<kTwist>([&](auto row) {
    constexpr int i = row;
    PortLanes sum;
    unroll<i + 1>([&](auto column) {
      constexpr int j = column;
      if constexpr (meet<kIsDecoupled>(i, j)) sum.add(inverse[kTwist * i + j], rest[j]);
    });
    sum.store_to(y + 4 * i);
    unroll<3>([&](auto component) {
      constexpr int c = component;
      if constexpr (moves_mass<kIsDecoupled>(i, c)) products.t[c].add(W_t[3 * i + c], sum);
      products.w[c].add(sum[c], sum);
    });
  });
}

/// (1) Calculates the half solutions of C_w^T and Q_f, and their products with those of C.
template <bool kIsDecoupled>
Products solve_half(const FlexibleBody& body, const ElasticBlock& block, const double* rows,
                    const BodyWork& work) {
  Products products;
  const int first = body.first_node();
  for (int k = first; k < body.node_count(); ++k)
    solve_node<kIsDecoupled>(block.below_of(k), block.inverse_of(k), rows + kNodeRows * k,
                             k > first ? work.half + kNodeRows * (k - 1) : nullptr,
                             &block.W_t[static_cast<std::size_t>(3 * kTwist * k)],
                             work.half + kNodeRows * k, products);
  return products;
}

/// Calculates E_h (W_w, z) = y_E^T (y_w, y_Q): six rows, at the node of a handle.
template <bool kIsDecoupled>
void calc_handle_response(const FlexibleBody& body, const ElasticBlock& block, std::size_t h,
                          const BodyWork& work, PortLanes (&response)[kTwist]) {
  const double* Z = block.Z[h].data();
  const int first = first_of_handle(body, h);
  const double* y = work.half + kNodeRows * first;
  for (int k = first; k < body.node_count(); ++k, y += kNodeRows)
    unroll<kTwist>([&](auto row) {
      constexpr int i = row;
      const PortLanes lanes = PortLanes::from(y + 4 * i);
      unroll<kTwist>([&](auto component) {
        constexpr int c = component;
        if constexpr (meet<kIsDecoupled>(i, c)) response[c].add(Z[c], lanes);
      });
      Z += kTwist;
    });
}

/// (3) Calculates X_h = J_h - E_h W and b_h + E_h z of one handle.
void calc_handle_map(const FlexibleBody& body, const ElasticBlock& block, std::size_t h,
                     const Angular& w, const BodyWork& work) {
  PortLanes response[kTwist]{};
  if (body.is_decoupled)
    calc_handle_response<true>(body, block, h, work, response);
  else
    calc_handle_response<false>(body, block, h, work, response);
  const HandleMotion& handle = work.handles[h];
  const Matrix3 s = skew(handle.s);
  const HalfMap turn{handle.turn.H};
  double* X = work.condensed.X[h].data();
  // The columns are J - E W, the lower half turned by H: those of translation, then those of
  // rotation.
  unroll<3>([&](auto column) {
    constexpr int j = column;
    const auto& Z_W = block.Z_W[h];
    TwistColumn t{{(j == 0) - Z_W(0, j), (j == 1) - Z_W(1, j), (j == 2) - Z_W(2, j), 0.0}, {}};
    const double lower[3] = {-Z_W(3, j), -Z_W(4, j), -Z_W(5, j)};
    turn.add_lower(lower, t);
    t.store_to(X + kTwist * j);
    TwistColumn r{{-s(0, j) - response[0][j], -s(1, j) - response[1][j], -s(2, j) - response[2][j],
                   j == 0 ? 1.0 : 0.0},
                  {j == 1 ? 1.0 : 0.0, j == 2 ? 1.0 : 0.0}};
    const double turned[3] = {-response[3][j], -response[4][j], -response[5][j]};
    turn.add_lower(turned, r);
    r.store_to(X + kTwist * (kRotation + j));
  });
  Twist z;
  for (int i = 0; i < kTwist; ++i) z[i] = response[i][3];
  angular(z) = Angular(handle.turn.H.lazyProduct(angular(z)));
  work.port.free[h] = handle.bias(w) + z;
}

/// (3) Calculates P_ab = diag(1, H_a) Z_ab diag(1, H_b^T) + X_a S_R^-1 X_b^T for all handles a < b,
/// and for b with itself.
void calc_compliances(const ElasticBlock& block, std::size_t b, const BodyWork& work) {
  const TwistMatrix& X_b = work.condensed.X[b];
  const Matrix3& H_b = work.handles[b].turn.H;
  const TwistMatrix S_X = multiply_transposed(work.condensed.S_inverse.matrix(), X_b);
  for (std::size_t a = 0; a < b; ++a) {
    const int pair = tree::MultiPort<Space>::count_pairs(static_cast<int>(b)) + static_cast<int>(a);
    TwistMatrix& P = work.port.pairs[pair];
    if (block.Z[a].empty()) {
      copy(S_X, P);
      continue;
    }
    const TwistMatrix& Z = block.Z_pairs[static_cast<std::size_t>(pair)];
    copy(add_product(turn_columns(turn_rows(work.handles[a].turn.H, Z), H_b), work.condensed.X[a],
                     S_X),
         P);
  }
  const TwistMatrix Z = turn_columns(turn_rows(H_b, block.Z_diagonal[b].matrix()), H_b);
  work.port.diagonal[b] = {add_product(Z, X_b, S_X)};
}

/// (3) Places a handle where the frame is clamped: X_h = 1.
void place_frame_handle(std::size_t h, const Twist& X_free, const BodyWork& work) {
  const SymmetricTwistMatrix& S_inverse = work.condensed.S_inverse;
  work.condensed.X[h].setIdentity();
  work.port.free[h] = X_free;
  work.port.diagonal[h] = S_inverse;
  for (std::size_t a = 0; a < h; ++a)
    work.port.between(static_cast<int>(a), static_cast<int>(h)) =
        space::multiply(work.condensed.X[a], S_inverse.matrix());
}

void condense(const BodyModel& model, const BodyTerms& terms, const Angular& w, bool implicit,
              BodyWork& work) {
  assert(model.body && model.blocks[implicit]);
  assert(std::cmp_equal(model.body->handles.size(), work.port.handles));
  assert(model.blocks[implicit]->Z.size() == model.body->handles.size());
  const FlexibleBody& body = *model.body;
  const ElasticBlock& block = *model.blocks[implicit];
  double* const rows = take_rows(body, implicit ? model.shift : nullptr, work);
  const Products products = body.is_decoupled ? solve_half<true>(body, block, rows, work)
                                              : solve_half<false>(body, block, rows, work);
  // (2) S_R = M_RR - C W and p = Q - C z follow, with M_RR = [m 1, -S~; S~, Theta].
  work.condensed.S_inverse = invert(
      SymmetricTwistMatrix::from_blocks(body.mass * Matrix3::Identity() - block.C_W,
                                        skew(terms.S) - products.columns(products.t).transpose(),
                                        terms.Theta - products.columns(products.w)));
  unroll<3>([&](auto component) {
    constexpr int c = component;
    work.condensed.p[c] = terms.Q[c] - products.t[c][3];
    work.condensed.p[kRotation + c] = terms.Q[kRotation + c] - products.w[c][3];
  });
  const Twist X_free = work.condensed.S_inverse * work.condensed.p;
  for (std::size_t h = 0; h < body.handles.size(); ++h) {
    if (block.Z[h].empty()) {
      place_frame_handle(h, X_free, work);
      continue;
    }
    calc_handle_map(body, block, h, w, work);
    work.port.free[h] += work.condensed.X[h].lazyProduct(X_free);
    calc_compliances(block, h, work);
  }
}

/// Combines the right-hand sides of the pass back: y_Q - y_C X, by node.
template <bool kIsDecoupled>
void combine_halves(const FlexibleBody& body, const ElasticBlock& block, const Twist& X,
                    const BodyWork& work, double* b) {
  const int first = body.first_node();
  const double* t = block.W_t.data() + 3 * kTwist * first;
  const double* w = work.half + kNodeRows * first;
  const double x[kTwist] = {X[0], X[1], X[2], X[3], X[4], X[5]};
  b += kTwist * first;
  for (int k = first; k < body.node_count(); ++k, t += 3 * kTwist, w += kNodeRows, b += kTwist)
    unroll<kTwist>([&](auto row) {
      constexpr int i = row;
      double sum = w[4 * i + 3];
      unroll<3>([&](auto component) {
        constexpr int c = component;
        if constexpr (moves_mass<kIsDecoupled>(i, c)) sum -= t[3 * i + c] * x[c];
      });
      b[i] = sum - (w[4 * i] * x[3] + w[4 * i + 1] * x[4] + w[4 * i + 2] * x[5]);
    });
}

/// Adds y_E f, of the six coordinates at one handle, to b.
template <bool kIsDecoupled>
void add_wrench(const FlexibleBody& body, const ElasticBlock& block, std::size_t h, const Twist& f,
                double* b) {
  const double* Z = block.Z[h].data();
  const int end = kTwist * body.node_count();
  for (int node = kTwist * first_of_handle(body, h); node < end; node += kTwist)
    unroll<kTwist>([&](auto row) {
      constexpr int i = row;
      double sum = 0.0;
      unroll<kTwist>([&](auto component) {
        constexpr int c = component;
        if constexpr (meet<kIsDecoupled>(i, c)) sum += Z[c] * f[c];
      });
      b[node + i] += sum;
      Z += kTwist;
    });
}

/// Solves one node of L^T x = b in place; `outer`: the solution of its outer neighbour, if there is
/// one, which becomes its own.
void solve_back_coupled(const double* below_outer, const double* inverse, double* x,
                        double (&outer)[kTwist]) {
  Double6 rest{load(x), load(x + 2), load(x + 4)};
  if (below_outer)
    for (int j = 0; j < kTwist; ++j) rest.add(-outer[j], below_outer + kTwist * j);
  double sums[kTwist];
  rest.store_to(sums);
  // The rows of the inverse are the columns of its transpose.
  const Double6 solution = multiply(inverse, sums);
  solution.store_to(x);
  solution.store_to(outer);
}

void solve_back_decoupled(const double* below_outer, const double* inverse, double* x,
                          double (&outer)[kTwist]) {
  double rest[kTwist];
  unroll<kTwist>([&](auto row) {
    constexpr int i = row;
    rest[i] = x[i];
    if (below_outer)
      unroll<kTwist>([&](auto column) {
        constexpr int j = column;
        if constexpr (is_one_direction(i, j)) rest[i] -= below_outer[kTwist * j + i] * outer[j];
      });
  });
  unroll<kTwist>([&](auto row) {
    constexpr int i = row;
    double sum = 0.0;
    unroll<kTwist>([&](auto column) {
      constexpr int j = column;
      if constexpr (j >= i && is_one_direction(i, j)) sum += inverse[kTwist * j + i] * rest[j];
    });
    x[i] = outer[i] = sum;
  });
}

/// Solves L^T x = b in place.
template <bool kIsDecoupled>
void solve_back(const FlexibleBody& body, const ElasticBlock& block, double* b) {
  constexpr auto solve_one = kIsDecoupled ? solve_back_decoupled : solve_back_coupled;
  double outer[kTwist]{};
  for (int k = body.elements; k >= body.first_node(); --k)
    solve_one(k < body.elements ? block.below_of(k + 1) : nullptr, block.inverse_of(k),
              b + kTwist * k, outer);
}

/// Calculates the accelerations by node, from those of the frame and the wrenches on the handles:
/// L^T q'' = y_Q - y_C X + sum y_E,h f_h.
template <bool kIsDecoupled>
void recover_deformation(const FlexibleBody& body, const ElasticBlock& block, const Twist& X,
                         const Twist* wrenches, const BodyWork& work, double* x) {
  combine_halves<kIsDecoupled>(body, block, X, work, x);
  for (std::size_t h = 0; h < body.handles.size(); ++h) {
    if (block.Z[h].empty()) continue;
    Twist f = wrenches[h];
    angular(f) = work.handles[h].turn.H.transpose().lazyProduct(angular(wrenches[h]));
    add_wrench<kIsDecoupled>(body, block, h, f, x);
  }
  solve_back<kIsDecoupled>(body, block, x);
}

Twist recover(const BodyModel& model, const Twist* wrenches, bool implicit, const BodyWork& work,
              double* a) {
  assert(model.body && model.blocks[implicit] && wrenches && a);
  const FlexibleBody& body = *model.body;
  const ElasticBlock& block = *model.blocks[implicit];
  const Condensed& condensed = work.condensed;
  Twist force = condensed.p;
  for (std::size_t h = 0; h < body.handles.size(); ++h)
    if (block.Z[h].empty())
      force += wrenches[h];
    else
      force += condensed.X[h].transpose().lazyProduct(wrenches[h]);
  Twist X = condensed.S_inverse * force;
  const ScratchRoom scratch(body, work);
  double* x = scratch->nodal[0];
  if (body.is_decoupled)
    recover_deformation<true>(body, block, X, wrenches, work, x);
  else
    recover_deformation<false>(body, block, X, wrenches, work, x);
  if (implicit && model.shift) model.shift->apply(x);
  compress(body, x, a);
  return X;
}

}  // namespace

void condense_body(const BodyModel& model, const BodyTerms& terms, const Angular& w, bool implicit,
                   BodyWork& work) noexcept {
  run_large_kernel([&]() noexcept { condense(model, terms, w, implicit, work); });
}

Twist recover_body(const BodyModel& model, const Twist* wrenches, bool implicit,
                   const BodyWork& work, double* a) noexcept {
  return run_large_kernel([&]() noexcept { return recover(model, wrenches, implicit, work, a); });
}

}  // namespace spoke::space
