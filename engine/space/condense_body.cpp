// One pass outward with four right-hand sides side by side, and one pass back with one.

#include "engine/space/condense_body.h"

#include <algorithm>

#include "engine/space/element_products.h"

namespace spoke::space {
namespace {

/// Four values, of the columns of C_w^T and of Q_f.
struct Lanes {
  Double2 a{}, b{};

  [[gnu::always_inline]] void add(double factor, const Lanes& x) {
    const Double2 f = broadcast(factor);
    a += f * x.a;
    b += f * x.b;
  }
  [[gnu::always_inline]] void subtract(double factor, const Lanes& x) {
    const Double2 f = broadcast(factor);
    a -= f * x.a;
    b -= f * x.b;
  }
  [[gnu::always_inline]] static Lanes from(const double* x) {
    return {load_aligned(x), load_aligned(x + 2)};
  }
  [[gnu::always_inline]] void store_to(double* x) const {
    store_aligned(a, x);
    store_aligned(b, x + 2);
  }
  double operator[](int i) const { return i < 2 ? a[i] : b[i - 2]; }
};

/// Sums over all rows of y_C^T (y_w, y_Q): three rows of translation, three of rotation.
struct Products {
  Lanes t[3], w[3];

  Matrix3 columns(const Lanes (&rows)[3]) const {
    Matrix3 m;
    for (int i = 0; i < 3; ++i) m.row(i) << rows[i][0], rows[i][1], rows[i][2];
    return m;
  }
  Position last(const Lanes (&rows)[3]) const { return {rows[0][3], rows[1][3], rows[2][3]}; }
};

void clear_fixed_rows(const FlexibleBody& body, double* rows) {
  if (body.reference_frame == ReferenceFrame::clamped) return;
  // u, v, w, tx of node 0, and v, w of the last.
  std::fill_n(rows, 4 * 4, 0.0);
  std::fill_n(rows + kNodeRows * body.elements + 4, 2 * 4, 0.0);
}

/// y_k = L_kk^-1 (b_k - L_k,k-1 y_k-1) for one node; adds its products with y_C.
void solve_node(const double* below, const double* inverse, const double* b, const double* before,
                const double* W_t, double* y, Products& products) {
  Lanes rest[kTwist];
  for (int i = 0; i < kTwist; ++i) {
    rest[i] = Lanes::from(b + 4 * i);
    if (!before) continue;
    for (int j = 0; j < kTwist; ++j)
      rest[i].subtract(below[kTwist * i + j], Lanes::from(before + 4 * j));
  }
  for (int i = 0; i < kTwist; ++i) {
    Lanes sum;
    for (int j = 0; j <= i; ++j) sum.add(inverse[kTwist * i + j], rest[j]);
    sum.store_to(y + 4 * i);
    for (int c = 0; c < 3; ++c) {
      products.t[c].add(W_t[3 * i + c], sum);
      products.w[c].add(sum[c], sum);
    }
  }
}

/// (1) The half solutions of C_w^T and Q_f, and their products with those of C.
Products solve_half(const FlexibleBody& body, const ElasticBlock& block, const BodyWork& work) {
  Products products;
  const int first = body.first_node();
  for (int k = first; k < body.node_count(); ++k)
    solve_node(block.below_of(k), block.inverse_of(k), work.rows + kNodeRows * k,
               k > first ? work.half + kNodeRows * (k - 1) : nullptr,
               &block.W_t[static_cast<std::size_t>(3 * kTwist * k)], work.half + kNodeRows * k,
               products);
  return products;
}

/// E_h (W_w, z) = y_E^T (y_w, y_Q): six rows, at the node of a handle.
void calc_handle_response(const FlexibleBody& body, const ElasticBlock& block, std::size_t h,
                          const BodyWork& work, Lanes (&response)[kTwist]) {
  const int node = body.handles[h];
  const double* Z = block.Z[h].data();
  const double* y = work.half + kNodeRows * node;
  for (int row = kTwist * node; row < kTwist * body.node_count(); ++row, Z += kTwist, y += 4) {
    const Lanes lanes = Lanes::from(y);
    for (int c = 0; c < kTwist; ++c) response[c].add(Z[c], lanes);
  }
}

/// diag(1, H) m.
template <class Matrix>
Matrix turn_rows(const Matrix3& H, const Matrix& m) {
  Matrix turned = m;
  turned.template bottomRows<3>() = H.lazyProduct(m.template bottomRows<3>());
  return turned;
}

/// (3) X_h = J_h - E_h W and b_h + E_h z of one handle.
void calc_handle_map(const FlexibleBody& body, const ElasticBlock& block, std::size_t h,
                     const Angular& w, const BodyWork& work) {
  Lanes response[kTwist]{};
  calc_handle_response(body, block, h, work, response);
  const HandleMotion& handle = work.handles[h];
  TwistMatrix EW;
  EW.leftCols<3>() = block.Z_W[h];
  Twist z;
  for (int i = 0; i < kTwist; ++i) {
    EW.row(i).tail<3>() << response[i][0], response[i][1], response[i][2];
    z[i] = response[i][3];
  }
  TwistMatrix& X = work.condensed.X[h];
  X = -turn_rows(handle.turn.H, EW);
  X.diagonal().array() += 1.0;
  X.topRightCorner<3, 3>() -= skew(handle.s);
  work.port.free[h] = handle.bias(w) + turn_rows(handle.turn.H, z);
}

/// diag(1, H) A diag(1, H^T).
SymmetricTwistMatrix turn_handle(const Matrix3& H, const SymmetricTwistMatrix& A) {
  const Matrix3 half = H.lazyProduct(A.rr);
  return {A.tt, H.lazyProduct(A.rt), half.lazyProduct(H.transpose())};
}

/// A B^T, of which the result is known to be symmetric.
SymmetricTwistMatrix symmetric_product(const TwistMatrix& A, const TwistMatrix& B) {
  const auto top = B.topRows<3>().transpose(), bottom = B.bottomRows<3>().transpose();
  return {A.topRows<3>().lazyProduct(top), A.bottomRows<3>().lazyProduct(top),
          A.bottomRows<3>().lazyProduct(bottom)};
}

/// (3) P_ab = diag(1, H_a) Z_ab diag(1, H_b^T) + X_a S_R^-1 X_b^T for all handles a < b, and of b
/// with itself.
void calc_compliances(const ElasticBlock& block, std::size_t b, const BodyWork& work) {
  const TwistMatrix& X_b = work.condensed.X[b];
  const Matrix3& H_b = work.handles[b].turn.H;
  const TwistMatrix S_X = work.condensed.S_inverse.matrix().lazyProduct(X_b.transpose());
  for (std::size_t a = 0; a < b; ++a) {
    const int pair = tree::MultiPort<Space>::count_pairs(static_cast<int>(b)) + static_cast<int>(a);
    TwistMatrix& P = work.port.pairs[pair];
    if (block.Z[a].empty()) {
      P = S_X;
      continue;
    }
    P = work.condensed.X[a].lazyProduct(S_X);
    const TwistMatrix Z =
        turn_rows(work.handles[a].turn.H, block.Z_pairs[static_cast<std::size_t>(pair)]);
    P.leftCols<3>() += Z.leftCols<3>();
    P.rightCols<3>() += Z.rightCols<3>().lazyProduct(H_b.transpose());
  }
  work.port.diagonal[b] =
      turn_handle(H_b, block.Z_diagonal[b]) + symmetric_product(X_b, S_X.transpose());
}

/// (3) of a handle that stands where the frame is clamped: X_h = 1.
void place_frame_handle(std::size_t h, const Twist& X_free, const BodyWork& work) {
  const SymmetricTwistMatrix& S_inverse = work.condensed.S_inverse;
  work.condensed.X[h].setIdentity();
  work.port.free[h] = X_free;
  work.port.diagonal[h] = S_inverse;
  for (std::size_t a = 0; a < h; ++a)
    work.port.between(static_cast<int>(a), static_cast<int>(h)) =
        work.condensed.X[a].lazyProduct(S_inverse.matrix());
}

}  // namespace

void condense_body(const BodyModel& model, const BodyTerms& terms, const Angular& w, bool implicit,
                   BodyWork& work) noexcept {
  const FlexibleBody& body = *model.body;
  const ElasticBlock& block = *model.blocks[implicit];
  clear_fixed_rows(body, work.rows);
  const Products products = solve_half(body, block, work);
  // (2) S_R = M_RR - C W and p = Q - C z, M_RR = [m 1, -S~; S~, Theta].
  SymmetricTwistMatrix S_R;
  S_R.tt = body.mass * Matrix3::Identity() - block.C_W;
  S_R.rt = skew(terms.S) - products.columns(products.t).transpose();
  S_R.rr = terms.Theta - products.columns(products.w);
  work.condensed.S_inverse = invert(S_R);
  work.condensed.p = terms.Q - make_twist(products.last(products.t), products.last(products.w));
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

namespace {

/// Right-hand sides of the pass back: y_Q - y_C X, by node.
void combine_halves(const FlexibleBody& body, const ElasticBlock& block, const Twist& X,
                    const BodyWork& work, double* b) {
  const double* W_t = block.W_t.data();
  for (int row = kTwist * body.first_node(); row < kTwist * body.node_count(); ++row) {
    const double *t = W_t + 3 * row, *w = work.half + 4 * row;
    b[row] = w[3] - (t[0] * X[0] + t[1] * X[1] + t[2] * X[2]) -
             (w[0] * X[3] + w[1] * X[4] + w[2] * X[5]);
  }
}

/// b += y_E f, of the six coordinates at one handle.
void add_wrench(const FlexibleBody& body, const ElasticBlock& block, std::size_t h, const Twist& f,
                double* b) {
  const double* Z = block.Z[h].data();
  for (int row = kTwist * body.handles[h]; row < kTwist * body.node_count(); ++row, Z += kTwist)
    b[row] += (Z[0] * f[0] + Z[1] * f[1] + Z[2] * f[2]) + (Z[3] * f[3] + Z[4] * f[4] + Z[5] * f[5]);
}

/// Solves L^T x = b in place.
void solve_back(const FlexibleBody& body, const ElasticBlock& block, double* b) {
  for (int k = body.elements; k >= body.first_node(); --k) {
    double* x = b + kTwist * k;
    Double6 rest{load(x), load(x + 2), load(x + 4)};
    if (k < body.elements)
      for (int j = 0; j < kTwist; ++j) rest.add(-x[kTwist + j], block.below_of(k + 1) + kTwist * j);
    double sums[kTwist];
    rest.store_to(sums);
    // The rows of the inverse are the columns of its transpose.
    multiply(block.inverse_of(k), sums).store_to(x);
  }
}

}  // namespace

Twist recover_body(const BodyModel& model, const Twist* wrenches, bool implicit,
                   const BodyWork& work, double* a) noexcept {
  const FlexibleBody& body = *model.body;
  const ElasticBlock& block = *model.blocks[implicit];
  const Condensed& condensed = work.condensed;
  Twist force = condensed.p;
  for (std::size_t h = 0; h < body.handles.size(); ++h)
    if (block.Z[h].empty())
      force += wrenches[h];
    else
      force += condensed.X[h].transpose().lazyProduct(wrenches[h]);
  const Twist X = condensed.S_inverse * force;
  double* x = work.nodal[0];
  combine_halves(body, block, X, work, x);
  for (std::size_t h = 0; h < body.handles.size(); ++h) {
    if (block.Z[h].empty()) continue;
    Twist f = wrenches[h];
    angular(f) = work.handles[h].turn.H.transpose().lazyProduct(angular(wrenches[h]));
    add_wrench(body, block, h, f, x);
  }
  solve_back(body, block, x);
  compress(body, x, a);
  return X;
}

}  // namespace spoke::space
