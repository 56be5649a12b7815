// Kirchhoff's flow: the separation point from the lift.

#include "models/air/separation.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace spoke::air {
namespace {

constexpr double kOneDegree = std::numbers::pi / 180.0;
constexpr double kZeroLiftLimit = 20.0 * kOneDegree;  // sought no farther from 0
constexpr double kSlopeBegin = 3.0 * kOneDegree;      // the slope is that between, from zero lift
constexpr double kSlopeEnd = 8.0 * kOneDegree;
constexpr double kFadeBegin = 50.0 * kOneDegree;  // beyond, flow separates whatever the lift is
constexpr double kFadeEnd = 60.0 * kOneDegree;

/// Returns the rising zero of lift nearest to 0 into `zero`; false if there is none.
bool find_zero_lift(std::span<const double> angle, std::span<const double> lift, double& zero) {
  bool found = false;
  for (std::size_t i = 0; i + 1 < angle.size(); ++i) {
    if (lift[i] > 0.0 || lift[i + 1] < 0.0 || lift[i] == lift[i + 1]) continue;
    const double at = angle[i] - lift[i] * (angle[i + 1] - angle[i]) / (lift[i + 1] - lift[i]);
    if (std::abs(at) > kZeroLiftLimit || (found && std::abs(at) >= std::abs(zero))) continue;
    zero = at;
    found = true;
  }
  return found;
}

/// Returns the lift at an angle between the first and the last.
double interpolate_lift(std::span<const double> angle, std::span<const double> lift, double at) {
  const auto above = std::upper_bound(angle.begin(), angle.end(), at) - angle.begin();
  const auto i =
      static_cast<std::size_t>(std::clamp<std::ptrdiff_t>(above, 1, std::ssize(angle) - 1));
  return lift[i - 1] + (at - angle[i - 1]) / (angle[i] - angle[i - 1]) * (lift[i] - lift[i - 1]);
}

/// Returns the steepest line from zero lift to places 3 to 8 degrees from there: nearer, the
/// quotient is of rounded numbers, farther, flow separates.
double find_slope(std::span<const double> angle, std::span<const double> lift, double zero) {
  double slope = 0.0;
  for (int half_degrees = 6; half_degrees <= 16; ++half_degrees)
    for (const double side : {-0.5, 0.5}) {
      const double from_zero = side * half_degrees * kOneDegree;
      slope =
          std::max(slope, interpolate_lift(angle, lift, zero + from_zero) / std::sin(from_zero));
    }
  return slope;
}

/// Sets f, attached and separated lift of one angle. Their sum is the lift.
void split(double lift, double from_zero, Separation& out, std::size_t i) {
  const double potential = out.slope * std::sin(from_zero);
  const double share = potential == 0.0 ? 1.0 : lift / potential;
  const double far = std::abs(from_zero);
  const double most = std::clamp((kFadeEnd - far) / (kFadeEnd - kFadeBegin), 0.0, 1.0);
  if (share >= 1.0 && most == 1.0) {  // more than the line: attached
    out.point[i] = 1.0;
    out.attached[i] = lift;
    out.separated[i] = 0.5 * lift;
    return;
  }
  const double root = std::clamp(2.0 * std::sqrt(std::max(share, 0.0)) - 1.0, 0.0, 1.0);
  const double f = std::min(root * root, most);
  out.point[i] = f;
  out.attached[i] = potential;
  if (f == 0.0)
    out.separated[i] = lift;
  else if (f < root * root)
    out.separated[i] = (lift - f * potential) / (1.0 - f);
  else  // the same without a difference of nearly equal numbers
    out.separated[i] = potential * (1.0 + 3.0 * root) / (4.0 * (1.0 + root));
}

/// Keeps only the flow that is attached in one piece around zero lift; there, where lift is small
/// and its quotient is of rounded numbers, f may be zero.
void keep_inner_part(std::span<const double> angle, std::span<const double> lift, Separation& out) {
  const auto go_outward = [&](auto begin, auto end, int step) {
    bool ended = false;
    for (auto i = begin; i != end; i += step) {
      const bool is_far = std::abs(angle[i] - out.zero_lift) > kSlopeEnd;
      ended = ended || (is_far && out.point[i] == 0.0);
      if (!ended) continue;
      out.point[i] = 0.0;
      out.separated[i] = lift[i];
    }
  };
  const auto inner = std::lower_bound(angle.begin(), angle.end(), out.zero_lift) - angle.begin();
  go_outward(inner, std::ssize(angle), 1);
  go_outward(inner - 1, std::ptrdiff_t{-1}, -1);
}

}  // namespace

Separation separate(std::span<const double> angle, std::span<const double> lift) {
  Separation out;
  out.point.assign(angle.size(), 0.0);
  out.attached.assign(lift.begin(), lift.end());
  out.separated = out.attached;
  if (!find_zero_lift(angle, lift, out.zero_lift)) return out;
  out.slope = find_slope(angle, lift, out.zero_lift);
  if (out.slope == 0.0) return out;
  for (std::size_t i = 0; i < angle.size(); ++i) split(lift[i], angle[i] - out.zero_lift, out, i);
  keep_inner_part(angle, lift, out);
  return out;
}

}  // namespace spoke::air
