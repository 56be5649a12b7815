// The choice of a share by the contraction seen, and corrections by it.

#include "engine/integrator/relaxation.h"

#include <algorithm>
#include <cmath>

namespace spoke {

double choose_relaxation(double change, double tolerance, StepProgress& progress) noexcept {
  const double before = progress.change;
  const bool was_plain = progress.control.relaxation == 1.0;
  // Changes compare as the correction of the pass before has it: of the first one, or of a plain
  // one that a relaxed one has followed.
  if ((progress.passes == 2 || !was_plain) && before > 0.0)
    progress.contraction = std::max(progress.contraction, change / before);
  if (!was_plain || change * progress.contraction <= tolerance) return 1.0;
  return 1.0 / (1.0 + progress.contraction);
}

Correction correct_relaxed(const GeneralizedAlpha& method, double share, const double* a,
                           CoordinateBlock& block) noexcept {
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
