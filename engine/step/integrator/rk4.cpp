// The stages of the classical Runge-Kutta method.

#include "engine/step/integrator/rk4.h"

#include <algorithm>
#include <cassert>

namespace spoke {
namespace {

// Parameters that promise not to overlap let the compiler take several coordinates at a time.

/// Begins stage 1: remembers the step's start, opens the sums.
void open_step(double h, int n, double* __restrict q, double* __restrict v,
               const double* __restrict a, double* __restrict q0, double* __restrict v0,
               double* __restrict sum_q, double* __restrict sum_v) noexcept {
  for (int i = 0; i < n; ++i) {
    q0[i] = q[i];
    v0[i] = v[i];
    sum_q[i] = Rk4::weights[0] * v[i];
    sum_v[i] = Rk4::weights[0] * a[i];
    q[i] = q0[i] + Rk4::nodes[1] * h * v0[i];
    v[i] = v0[i] + Rk4::nodes[1] * h * a[i];
  }
}

/// Begins stages 2 and 3: adds the rates of the stage before to the sums, and takes them from the
/// step's start over `span`.
void go_on(double weight, double span, int n, double* __restrict q, double* __restrict v,
           const double* __restrict a, const double* __restrict q0, const double* __restrict v0,
           double* __restrict sum_q, double* __restrict sum_v) noexcept {
  for (int i = 0; i < n; ++i) {
    const double rate_q = v[i], rate_v = a[i];
    sum_q[i] += weight * rate_q;
    sum_v[i] += weight * rate_v;
    q[i] = q0[i] + span * rate_q;
    v[i] = v0[i] + span * rate_v;
  }
}

/// Begins stage 0: adds the last rates, and takes the weighted sum from the step's start over the
/// step.
void close_step(double h, int n, double* __restrict q, double* __restrict v,
                const double* __restrict a, const double* __restrict q0,
                const double* __restrict v0, double* __restrict sum_q,
                double* __restrict sum_v) noexcept {
  constexpr double kWeight = Rk4::weights[Rk4::kStages - 1];
  for (int i = 0; i < n; ++i) {
    sum_q[i] += kWeight * v[i];
    sum_v[i] += kWeight * a[i];
    q[i] = q0[i] + h * sum_q[i];
    v[i] = v0[i] + h * sum_v[i];
  }
}

/// Copies accelerations to where stage 0 needs them.
void keep(int n, const double* __restrict a, double* __restrict kept) noexcept {
  std::copy_n(a, n, kept);
}

/// Begins stage 0 with projection.
void project(double h, int n, double* __restrict q, double* __restrict v,
             const double* __restrict a, const double* __restrict a_0,
             const double* __restrict a_1) noexcept {
  for (int i = 0; i < n; ++i) {
    q[i] += h * h * (a_1[i] - a_0[i]);
    v[i] += h * (a[i] - a_0[i]);
  }
}

}  // namespace

void advance(const Rk4& method, int stage, CoordinateBlock& block) noexcept {
  assert(method.step > 0.0 && stage >= 0 && stage < method.passes());
  assert(block.history[Rk4::sum_v]);
  const double h = method.step;
  const auto k = static_cast<std::size_t>(stage);
  block.for_parts([&](int first, int n) {
    double *q = block.q + first, *v = block.v + first, *a = block.a + first;
    double *q0 = block.history[Rk4::start_q] + first, *v0 = block.history[Rk4::start_v] + first;
    double *sum_q = block.history[Rk4::sum_q] + first, *sum_v = block.history[Rk4::sum_v] + first;
    if (stage == 0 && method.projects)
      project(h, n, q, v, a, q0, v0);
    else if (stage == Rk4::kClosing)
      keep(n, a, q0);
    else if (stage == Rk4::kBraking)
      keep(n, a, v0);
    else if (stage == 0 || stage == Rk4::kAtEnd)
      close_step(h, n, q, v, a, q0, v0, sum_q, sum_v);
    else if (stage == 1)
      open_step(h, n, q, v, a, q0, v0, sum_q, sum_v);
    else
      go_on(Rk4::weights[k - 1], Rk4::nodes[k] * h, n, q, v, a, q0, v0, sum_q, sum_v);
  });
}

}  // namespace spoke
