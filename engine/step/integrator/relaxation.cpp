// The choice of a share by the contraction seen, and corrections by it.

#include "engine/step/integrator/relaxation.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace spoke {

void learn_contraction(double change, StepProgress& progress) noexcept {
  const bool is_comparable =
      progress.passes > 1 && progress.share_before == 1.0 && progress.change > 0.0;
  if (is_comparable)
    progress.contraction = std::max(progress.contraction, change / progress.change);
}

double choose_share(const StepProgress& progress) noexcept {
  constexpr double kFast = 0.25;  // also for errors that do not swing
  const bool was_plain = progress.control.relaxation == 1.0;
  if (progress.passes < 2 || !was_plain || progress.contraction < kFast) return 1.0;
  return 1.0 / (1.0 + progress.contraction);
}

Correction correct_relaxed(const GeneralizedAlpha& method, double share, const double* a,
                           CoordinateBlock& block) noexcept {
  assert(share > 0.0 && share <= 1.0 && a);
  const double *qp = block.history[GeneralizedAlpha::predicted_q],
               *vp = block.history[GeneralizedAlpha::predicted_v];
  double most = 0.0, squares = 0.0;
  block.for_parts([&](int first, int n) {
    for (int i = first; i < first + n; ++i) {
      const double change = a[i] - block.a[i];
      most = std::max(most, std::abs(change));
      block.a[i] += share * change;
      block.q[i] = qp[i] + method.position_gain * block.a[i];
      block.v[i] = vp[i] + method.velocity_gain * block.a[i];
      squares += block.q[i] * block.q[i];
    }
  });
  return {method.position_gain * most, squares};
}

}  // namespace spoke
