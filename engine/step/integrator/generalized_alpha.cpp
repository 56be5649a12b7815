// The coefficients of the method, its predictor and its corrector (docs/formulation.md, section 5).

#include "engine/step/integrator/generalized_alpha.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "models/support/simd.h"

namespace spoke {
namespace {

/// Returns the greater of two values, place by place; of `b` and NaN, b.
Double2 greater(Double2 a, Double2 b) { return a > b ? a : b; }

// Parameters that promise not to overlap let the compiler take several coordinates at a time.

/// Weights of the differences that a prediction goes on with.
struct Foresight {
  double slope, bend;
};

inline void predict_values(const GeneralizedAlpha m, Foresight ahead_by, int n,
                           double* __restrict q, double* __restrict v, double* __restrict a,
                           double* __restrict qp, double* __restrict vp, double* __restrict carry,
                           double* __restrict last, double* __restrict last_but_one) noexcept {
  const double h = m.step;
  for (int i = 0; i < n; ++i) {
    const double al = carry[i] + m.k * a[i];
    const double next = m.af_share * a[i] - m.am_share * al;
    carry[i] = next;
    qp[i] = q[i] + h * v[i] + h * h * ((0.5 - m.beta) * al + m.beta * next);
    vp[i] = v[i] + h * ((1.0 - m.gamma) * al + m.gamma * next);
    const double slope = a[i] - last[i];
    const double bend = slope - (last[i] - last_but_one[i]);
    const double ahead = a[i] + ahead_by.slope * slope + ahead_by.bend * bend;
    last_but_one[i] = last[i];
    last[i] = a[i];
    a[i] = ahead;
    q[i] = qp[i] + m.position_gain * ahead;
    v[i] = vp[i] + m.velocity_gain * ahead;
  }
}

/// Maxima and sums that a correction collects, place by place.
struct Corrected {
  Double2 change{};   // largest change of an acceleration; those that are NaN do not count
  Double2 squares{};  // sum of the squares of the coordinates
};

void correct_values(const GeneralizedAlpha m, int n, const double* __restrict a_new,
                    const double* __restrict qp, const double* __restrict vp, double* __restrict q,
                    double* __restrict v, double* __restrict a, Corrected& corrected) noexcept {
  Corrected found = corrected;
  int i = 0;
  for (; i + 2 <= n; i += 2) {
    const Double2 next = load(a_new + i);
    const Double2 change = next - load(a + i);
    found.change = greater(-change, greater(change, found.change));
    const Double2 q_next = load(qp + i) + m.position_gain * next;
    found.squares += q_next * q_next;
    store(q_next, q + i);
    store(load(vp + i) + m.velocity_gain * next, v + i);
    store(next, a + i);
  }
  if (i < n) {
    found.change[0] = std::max(found.change[0], std::abs(a_new[i] - a[i]));
    q[i] = qp[i] + m.position_gain * a_new[i];
    found.squares[0] += q[i] * q[i];
    v[i] = vp[i] + m.velocity_gain * a_new[i];
    a[i] = a_new[i];
  }
  corrected = found;
}

}  // namespace

GeneralizedAlpha make_generalized_alpha(double radius, double step) {
  assert(radius >= 0.0 && radius <= 1.0 && step > 0.0);
  const double am = (2.0 * radius - 1.0) / (1.0 + radius);
  const double af = radius / (1.0 + radius);
  GeneralizedAlpha method;
  method.step = step;
  method.gamma = 0.5 - am + af;
  method.beta = 0.25 * (1.0 - am + af) * (1.0 - am + af);
  method.k = (1.0 - af) / (1.0 - am);
  method.af_share = af / (1.0 - am);
  method.am_share = am / (1.0 - am);
  method.position_gain = method.beta * method.k * step * step;
  method.velocity_gain = method.gamma * method.k * step;
  method.error_share = (method.beta - 0.5 * (af - am) - 1.0 / 6.0) / (method.beta * method.k);
  return method;
}

void hold(CoordinateBlock& block) {
  block.for_parts([&](int first, int n) {
    std::copy_n(block.q + first, n, block.history[GeneralizedAlpha::predicted_q] + first);
    std::copy_n(block.v + first, n, block.history[GeneralizedAlpha::predicted_v] + first);
  });
}

void clear_accelerations(CoordinateBlock& block) {
  block.for_parts([&](int first, int n) {
    std::fill_n(block.a + first, n, 0.0);
    std::fill_n(block.history[GeneralizedAlpha::carry_over] + first, n, 0.0);
    std::fill_n(block.history[GeneralizedAlpha::last_a] + first, n, 0.0);
    std::fill_n(block.history[GeneralizedAlpha::last_but_one_a] + first, n, 0.0);
  });
}

void begin_restart(const GeneralizedAlpha& method, CoordinateBlock& block) {
  double *qp = block.history[GeneralizedAlpha::predicted_q],
         *vp = block.history[GeneralizedAlpha::predicted_v];
  block.for_parts([&](int first, int n) {
    for (int i = first; i < first + n; ++i) {
      qp[i] = block.q[i] - method.position_gain * block.a[i];
      vp[i] = block.v[i] - method.velocity_gain * block.a[i];
    }
  });
}

void complete_restart(const GeneralizedAlpha& method, const double* a,
                      CoordinateBlock& block) noexcept {
  assert(block.history[GeneralizedAlpha::last_a] && a);
  double *carry = block.history[GeneralizedAlpha::carry_over],
         *last = block.history[GeneralizedAlpha::last_a];
  block.for_parts([&](int first, int n) {
    for (int i = first; i < first + n; ++i) {
      carry[i] += (1.0 - method.k) * (a[i] - block.a[i]);  // al = carry + k A
      block.a[i] = last[i] = a[i];
    }
  });
}

void predict(const GeneralizedAlpha& method, int order, CoordinateBlock& block) noexcept {
  assert(method.step > 0.0 && order >= 1 && block.history[GeneralizedAlpha::last_but_one_a]);
  const Foresight ahead_by{order >= 2 ? 1.0 : 0.0, order >= 3 ? 1.0 : 0.0};
  double *qp = block.history[GeneralizedAlpha::predicted_q],
         *vp = block.history[GeneralizedAlpha::predicted_v],
         *carry = block.history[GeneralizedAlpha::carry_over],
         *last = block.history[GeneralizedAlpha::last_a],
         *last_but_one = block.history[GeneralizedAlpha::last_but_one_a];
  block.for_parts([&](int first, int n) {
    predict_values(method, ahead_by, n, block.q + first, block.v + first, block.a + first,
                   qp + first, vp + first, carry + first, last + first, last_but_one + first);
  });
}

double calc_step_change(const GeneralizedAlpha& method, const double* a,
                        const CoordinateBlock& block) noexcept {
  assert(block.history[GeneralizedAlpha::last_a] && a);
  const double* last = block.history[GeneralizedAlpha::last_a];
  Double2 most{};
  block.for_parts([&](int first, int n) {
    const int end = first + n;
    int i = first;
    for (; i + 2 <= end; i += 2) {
      const Double2 change = load(a + i) - load(last + i);
      most = greater(-change, greater(change, most));
    }
    if (i < end) most[0] = std::max(most[0], std::abs(a[i] - last[i]));
  });
  return method.position_gain * std::max(most[0], most[1]);
}

Correction correct(const GeneralizedAlpha& method, const double* a_new,
                   CoordinateBlock& block) noexcept {
  assert(block.history[GeneralizedAlpha::last_a] && a_new);
  const double *qp = block.history[GeneralizedAlpha::predicted_q],
               *vp = block.history[GeneralizedAlpha::predicted_v];
  Corrected sum;
  block.for_parts([&](int first, int n) {
    correct_values(method, n, a_new + first, qp + first, vp + first, block.q + first,
                   block.v + first, block.a + first, sum);
  });
  return {method.position_gain * std::max(sum.change[0], sum.change[1]), total(sum.squares)};
}

}  // namespace spoke
