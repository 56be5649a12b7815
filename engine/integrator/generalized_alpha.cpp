#include "engine/integrator/generalized_alpha.h"

#include <algorithm>
#include <cmath>

namespace spoke {

GeneralizedAlpha make_generalized_alpha(double radius, double step) {
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
  return method;
}

void start(const GeneralizedAlpha& method, CoordinateBlock& block) {
  // al_0 = A_0
  for (int i = 0; i < block.size; ++i)
    block.history[GeneralizedAlpha::carry][i] = (1.0 - method.k) * block.a[i];
}

void hold(CoordinateBlock& block) {
  std::copy_n(block.q, block.size, block.history[GeneralizedAlpha::predicted_q]);
  std::copy_n(block.v, block.size, block.history[GeneralizedAlpha::predicted_v]);
}

void predict(const GeneralizedAlpha& method, CoordinateBlock& block) noexcept {
  double* __restrict q = block.q;
  double* __restrict v = block.v;
  const double* __restrict a = block.a;
  double* __restrict qp = block.history[GeneralizedAlpha::predicted_q];
  double* __restrict vp = block.history[GeneralizedAlpha::predicted_v];
  double* __restrict carry = block.history[GeneralizedAlpha::carry];
  const double h = method.step;
  for (int i = 0; i < block.size; ++i) {
    const double al = carry[i] + method.k * a[i];
    const double next = method.af_share * a[i] - method.am_share * al;
    carry[i] = next;
    qp[i] = q[i] + h * v[i] + h * h * ((0.5 - method.beta) * al + method.beta * next);
    vp[i] = v[i] + h * ((1.0 - method.gamma) * al + method.gamma * next);
    q[i] = qp[i] + method.position_gain * a[i];
    v[i] = vp[i] + method.velocity_gain * a[i];
  }
}

double correct(const GeneralizedAlpha& method, const double* a_new,
               CoordinateBlock& block) noexcept {
  double* __restrict q = block.q;
  double* __restrict v = block.v;
  double* __restrict a = block.a;
  const double* __restrict qp = block.history[GeneralizedAlpha::predicted_q];
  const double* __restrict vp = block.history[GeneralizedAlpha::predicted_v];
  double change = 0.0;
  for (int i = 0; i < block.size; ++i) {
    change = std::max(change, std::abs(a_new[i] - a[i]));
    a[i] = a_new[i];
    q[i] = qp[i] + method.position_gain * a[i];
    v[i] = vp[i] + method.velocity_gain * a[i];
  }
  return method.position_gain * change;
}

}  // namespace spoke
