// Exact solutions of first-order filters whose input is linear in time.

#include "engine/bodies/air/inflow.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numbers>

namespace spoke::air {
namespace {

/// Returns (1 - exp(-x)) / x.
double mean_decay(double x) noexcept { return x > 0.0 ? -std::expm1(-x) / x : 1.0; }

}  // namespace

InflowState rest_inflow(double steady) noexcept { return {(1.0 - kDirectShare) * steady, steady}; }

InflowState advance_inflow(InflowState state, double begin, double end, double turns,
                           double ratio) noexcept {
  assert(!(turns < 0.0) && ratio < 1.0);
  constexpr double rest = 1.0 - kDirectShare;
  const double fast = turns / ratio;
  const double decay = std::exp(-turns), fast_decay = std::exp(-fast);
  const double mean = mean_decay(turns), fast_mean = mean_decay(fast);
  const double change = end - begin;
  const double own = state.own - rest * begin;  // what decays
  const double lag =
      (rest / ratio + 1.0) * fast_mean - rest / (1.0 - ratio) * (fast_mean / ratio - mean);
  return {rest * end + own * decay - rest * change * mean,
          end + (state.induced - begin) * fast_decay + own / (1.0 - ratio) * (decay - fast_decay) -
              change * lag};
}

double calc_inflow_rate(double axial, double in_plane, double steady, double induced,
                        double radius) noexcept {
  assert(radius > 0.0);
  constexpr double least = 1e-3;  // m/s: in still air
  constexpr double share = 1.3;   // of induced velocity in the speed of the wake
  constexpr double high = 0.35;   // 1 - 1.3 a at a = 0.5
  const double along = std::max(
      {std::abs(axial - share * steady), high * std::abs(axial), 2.0 * high * std::abs(induced)});
  const double speed = std::sqrt(along * along + in_plane * in_plane);
  return std::max(speed, least) / (1.1 * radius);
}

double calc_skew_factor(double through, double in_plane, double downstream,
                        double span_ratio) noexcept {
  if (!(in_plane > 0.0)) return 1.0;
  const double size = std::abs(through);
  const double half_tangent = in_plane / (std::sqrt(in_plane * in_plane + size * size) + size);
  return 1.0 + 15.0 * std::numbers::pi / 32.0 * half_tangent * span_ratio *
                   std::clamp(downstream / in_plane, -1.0, 1.0);
}

double advance_filter(double state, double begin, double end, double turns) noexcept {
  assert(!(turns < 0.0));
  return end + (state - begin) * std::exp(-turns) - (end - begin) * mean_decay(turns);
}

}  // namespace spoke::air
