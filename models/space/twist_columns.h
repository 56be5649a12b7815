#pragma once

// Products of maps of twists, column by column: a column of six is four values and two in vector
// registers, and no part of a map is stored in one shape and read in another, which would stall the
// processor.

#include "models/space/vectors.h"
#include "models/support/simd.h"
#include "models/support/unroll.h"

namespace spoke::space {

/// Six values.
struct TwistColumn {
  Double4 a{};
  Double2 b{};

  [[gnu::always_inline]] static TwistColumn from(const double* x) {
    return {load4(x), load(x + 4)};
  }
  [[gnu::always_inline]] void store_to(double* x) const {
    store(a, x);
    store(b, x + 4);
  }
  [[gnu::always_inline]] void add(double factor, const TwistColumn& x) {
    a += factor * x.a;
    b += factor * x.b;
  }
  [[gnu::always_inline]] void subtract(double factor, const TwistColumn& x) {
    a -= factor * x.a;
    b -= factor * x.b;
  }
  [[gnu::always_inline]] void scale(double factor) {
    a *= factor;
    b *= factor;
  }
  template <int i>
  [[gnu::always_inline]] double get() const {
    if constexpr (i < 4)
      return a[i];
    else
      return b[i - 4];
  }
  template <int i>
  [[gnu::always_inline]] void set(double value) {
    if constexpr (i < 4)
      a[i] = value;
    else
      b[i - 4] = value;
  }
};

/// The six columns of a map.
struct TwistColumns {
  TwistColumn at[kTwist];

  [[gnu::always_inline]] explicit TwistColumns(const TwistMatrix& m) {
    for (int j = 0; j < kTwist; ++j) at[j] = TwistColumn::from(m.data() + kTwist * j);
  }
  [[gnu::always_inline]] void store_to(TwistMatrix& m) const {
    for (int j = 0; j < kTwist; ++j) at[j].store_to(m.data() + kTwist * j);
  }
  /// The transpose of the lower left block of three becomes the upper right one.
  [[gnu::always_inline]] void mirror_lower_left() {
    const TwistColumn &t0 = at[0], &t1 = at[1], &t2 = at[2];
    at[3].a = Double4{t0.a[3], t1.a[3], t2.a[3], at[3].a[3]};
    at[4].a = Double4{t0.b[0], t1.b[0], t2.b[0], at[4].a[3]};
    at[5].a = Double4{t0.b[1], t1.b[1], t2.b[1], at[5].a[3]};
  }
  /// Adds this times the column of factors x, `stride` apart.
  [[gnu::always_inline]] void add_product(const double* x, int stride, TwistColumn& sum) const {
    for (int k = 0; k < kTwist; ++k) sum.add(x[stride * k], at[k]);
  }
};

/// A b.
inline Twist multiply(const TwistMatrix& A, const Twist& b) {
  TwistColumn sum;
  TwistColumns(A).add_product(b.data(), 1, sum);
  Twist product;
  sum.store_to(product.data());
  return product;
}

/// A B.
inline TwistMatrix multiply(const TwistMatrix& A, const TwistMatrix& B) {
  const TwistColumns a(A);
  TwistMatrix C;
  for (int j = 0; j < kTwist; ++j) {
    TwistColumn sum;
    a.add_product(B.data() + kTwist * j, 1, sum);
    sum.store_to(C.data() + kTwist * j);
  }
  return C;
}

/// A B^T.
inline TwistMatrix multiply_transposed(const TwistMatrix& A, const TwistMatrix& B) {
  const TwistColumns a(A);
  TwistMatrix C;
  for (int j = 0; j < kTwist; ++j) {
    TwistColumn sum;
    a.add_product(B.data() + j, kTwist, sum);
    sum.store_to(C.data() + kTwist * j);
  }
  return C;
}

/// C + A B.
inline TwistMatrix add_product(const TwistMatrix& C, const TwistMatrix& A, const TwistMatrix& B) {
  const TwistColumns a(A);
  TwistMatrix D;
  for (int j = 0; j < kTwist; ++j) {
    TwistColumn sum = TwistColumn::from(C.data() + kTwist * j);
    a.add_product(B.data() + kTwist * j, 1, sum);
    sum.store_to(D.data() + kTwist * j);
  }
  return D;
}

/// Returns the symmetric matrix C - A B^T, if C and A B^T are symmetric: the lower left block
/// stands for the upper right one, too.
inline TwistMatrix subtract_symmetric_product(const TwistMatrix& C, const TwistMatrix& A,
                                              const TwistMatrix& B) {
  const TwistColumns a(A);
  TwistColumns d(C);
  for (int j = 0; j < kTwist; ++j) {
    TwistColumn sum;
    a.add_product(B.data() + j, kTwist, sum);
    d.at[j].subtract(1.0, sum);
  }
  d.mirror_lower_left();
  TwistMatrix D;
  d.store_to(D);
  return D;
}

/// A map of three components, applied to one half of a twist or to both.
struct HalfMap {
  const Matrix3& R;

  /// Adds R t for the upper three, R r for the lower three of a column.
  [[gnu::always_inline]] void add_upper(const double* t, TwistColumn& sum) const {
    for (int k = 0; k < 3; ++k) sum.a += t[k] * Double4{R(0, k), R(1, k), R(2, k), 0.0};
  }
  [[gnu::always_inline]] void add_lower(const double* r, TwistColumn& sum) const {
    for (int k = 0; k < 3; ++k) {
      sum.a += r[k] * Double4{0.0, 0.0, 0.0, R(0, k)};
      sum.b += r[k] * Double2{R(1, k), R(2, k)};
    }
  }
};

/// diag(R, R) A diag(R, R)^T.
inline TwistMatrix turn_both(const Matrix3& R, const TwistMatrix& A) {
  const HalfMap map{R};
  TwistColumn half[kTwist];
  for (int j = 0; j < kTwist; ++j) {
    const double* column = A.data() + kTwist * j;
    map.add_upper(column, half[j]);
    map.add_lower(column + kRotation, half[j]);
  }
  TwistMatrix turned;
  for (int part = 0; part < kTwist; part += 3)
    for (int j = 0; j < 3; ++j) {
      TwistColumn sum;
      for (int k = 0; k < 3; ++k) sum.add(R(j, k), half[part + k]);
      sum.store_to(turned.data() + kTwist * (part + j));
    }
  return turned;
}

/// diag(1, H) A.
inline TwistMatrix turn_rows(const Matrix3& H, const TwistMatrix& A) {
  const HalfMap map{H};
  TwistMatrix turned;
  for (int j = 0; j < kTwist; ++j) {
    const double* column = A.data() + kTwist * j;
    TwistColumn sum{Double4{column[0], column[1], column[2], 0.0}, {}};
    map.add_lower(column + kRotation, sum);
    sum.store_to(turned.data() + kTwist * j);
  }
  return turned;
}

/// A diag(1, H^T).
inline TwistMatrix turn_columns(const TwistMatrix& A, const Matrix3& H) {
  const TwistColumns a(A);
  TwistMatrix turned;
  for (int j = 0; j < kRotation; ++j) a.at[j].store_to(turned.data() + kTwist * j);
  for (int j = 0; j < 3; ++j) {
    TwistColumn sum;
    for (int k = 0; k < 3; ++k) sum.add(H(j, k), a.at[kRotation + k]);
    sum.store_to(turned.data() + kTwist * (kRotation + j));
  }
  return turned;
}

/// Returns the inverse of a symmetric positive definite map by Gauss and Jordan's elimination in
/// place, two columns at a time, which needs no search for pivots. It is not finite if the map is
/// singular.
///
/// With u, v the pivot's columns and Q the inverse of its block, each other column m becomes m -
/// (u, v) Q m_P, with Q m_P in its rows P; the pivot's own columns become -(u, v) Q, with Q in rows
/// P.
inline TwistColumns invert_definite(const TwistMatrix& A) {
  TwistColumns m(A);
  unroll<kTwist / 2>([&m](auto pivot) __attribute__((always_inline)) {
    constexpr int k = 2 * pivot, l = k + 1;
    TwistColumn &u = m.at[k], &v = m.at[l];
    const double kk = u.template get<k>(), lk = u.template get<l>(), ll = v.template get<l>();
    const double r = 1.0 / (kk * ll - lk * lk);
    unroll<kTwist>([&](auto column) __attribute__((always_inline)) {
      constexpr int j = column;
      if constexpr (j != k && j != l) {
        TwistColumn& own = m.at[j];
        const double x = own.template get<k>(), y = own.template get<l>();
        const double f = (ll * x - lk * y) * r, g = (kk * y - lk * x) * r;
        own.subtract(f, u);
        own.subtract(g, v);
        own.template set<k>(f);
        own.template set<l>(g);
      }
    });
    const double q_kk = ll * r, q_lk = -lk * r, q_ll = kk * r;
    const TwistColumn before = u;
    u.scale(-q_kk);
    u.subtract(q_lk, v);
    v.scale(-q_ll);
    v.subtract(q_lk, before);
    u.template set<k>(q_kk);
    u.template set<l>(q_lk);
    v.template set<k>(q_lk);
    v.template set<l>(q_ll);
  });
  return m;
}

/// (A + A^T)/2.
inline TwistMatrix symmetric_mean(const TwistColumns& A) {
  const TwistColumn* c = A.at;
  TwistMatrix mean;
  unroll<kTwist>([&](auto column) __attribute__((always_inline)) {
    constexpr int j = column;
    TwistColumn half{{c[0].template get<j>(), c[1].template get<j>(), c[2].template get<j>(),
                      c[3].template get<j>()},
                     {c[4].template get<j>(), c[5].template get<j>()}};
    half.a = 0.5 * (c[j].a + half.a);
    half.b = 0.5 * (c[j].b + half.b);
    half.store_to(mean.data() + kTwist * j);
  });
  return mean;
}

/// A + factor B.
inline TwistMatrix add(const TwistMatrix& A, double factor, const TwistMatrix& B) {
  TwistMatrix sum;
  for (int j = 0; j < kTwist; ++j) {
    TwistColumn column = TwistColumn::from(A.data() + kTwist * j);
    column.add(factor, TwistColumn::from(B.data() + kTwist * j));
    column.store_to(sum.data() + kTwist * j);
  }
  return sum;
}
/// to = A.
inline void copy(const TwistMatrix& A, TwistMatrix& to) {
  for (int j = 0; j < kTwist; ++j)
    TwistColumn::from(A.data() + kTwist * j).store_to(to.data() + kTwist * j);
}

/// [tt, rt^T; rt, rr].
inline TwistMatrix join_blocks(const Matrix3& tt, const Matrix3& rt, const Matrix3& rr) {
  TwistMatrix m;
  for (int j = 0; j < 3; ++j) {
    const TwistColumn t{{tt(0, j), tt(1, j), tt(2, j), rt(0, j)}, {rt(1, j), rt(2, j)}};
    const TwistColumn r{{rt(j, 0), rt(j, 1), rt(j, 2), rr(0, j)}, {rr(1, j), rr(2, j)}};
    t.store_to(m.data() + kTwist * j);
    r.store_to(m.data() + kTwist * (kRotation + j));
  }
  return m;
}

}  // namespace spoke::space
