#include "engine/integrator/rk4.h"

namespace spoke {
namespace {

/// Stage 1: remembers the step's start, opens the sums.
void open_step(double h, CoordinateBlock& block) {
  double* q0 = block.history[Rk4::start_q];
  double* v0 = block.history[Rk4::start_v];
  double* sum_q = block.history[Rk4::sum_q];
  double* sum_v = block.history[Rk4::sum_v];
  for (int i = 0; i < block.size; ++i) {
    q0[i] = block.q[i];
    v0[i] = block.v[i];
    sum_q[i] = Rk4::weights[0] * block.v[i];
    sum_v[i] = Rk4::weights[0] * block.a[i];
    block.q[i] = q0[i] + Rk4::nodes[1] * h * v0[i];
    block.v[i] = v0[i] + Rk4::nodes[1] * h * block.a[i];
  }
}

}  // namespace

void advance(const Rk4& method, int stage, CoordinateBlock& block) noexcept {
  if (stage == 1) return open_step(method.step, block);
  const int last = stage == 0 ? Rk4::kStages - 1 : stage - 1;
  const double weight = Rk4::weights[last];
  const double* q0 = block.history[Rk4::start_q];
  const double* v0 = block.history[Rk4::start_v];
  double* sum_q = block.history[Rk4::sum_q];
  double* sum_v = block.history[Rk4::sum_v];
  for (int i = 0; i < block.size; ++i) {
    const double rate_q = block.v[i];
    const double rate_v = block.a[i];
    sum_q[i] += weight * rate_q;
    sum_v[i] += weight * rate_v;
    // The end of the step takes the weighted sum, a stage within it the last rates.
    const double span = stage == 0 ? method.step : Rk4::nodes[stage] * method.step;
    block.q[i] = q0[i] + span * (stage == 0 ? sum_q[i] : rate_q);
    block.v[i] = v0[i] + span * (stage == 0 ? sum_v[i] : rate_v);
  }
}

}  // namespace spoke
