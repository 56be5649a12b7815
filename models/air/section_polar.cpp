// Tables of a section on the angles of both its aerofoils, and the look-up in them.

#include "models/air/section_polar.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "models/air/separation.h"

namespace spoke::air {
namespace {

using spatial::Airfoil;
using spatial::Polar;

constexpr double kPi = std::numbers::pi;
constexpr double kLeastGap = 1e-9;  // nearer angles are the same [rad]

/// Returns the angles of all polars, ascending.
std::vector<double> unite_angles(const Airfoil& inner, const Airfoil& outer) {
  std::vector<double> all;
  for (const Airfoil* airfoil : {&inner, &outer})
    for (const Polar& polar : airfoil->polars)
      all.insert(all.end(), polar.angle.begin(), polar.angle.end());
  std::sort(all.begin(), all.end());
  std::vector<double> angles;
  for (const double angle : all)
    if (angles.empty() || angle - angles.back() > kLeastGap) angles.push_back(angle);
  angles.front() = -kPi;
  angles.back() = kPi;
  return angles;
}

/// Returns the level of one of several polars: linear between levels are coefficients.
double level_of(const Polar& polar) { return polar.mach ? *polar.mach : std::log(polar.reynolds); }

/// Returns the levels of all polars, ascending; one if none is given.
std::vector<double> unite_levels(const Airfoil& inner, const Airfoil& outer) {
  std::vector<double> all;
  for (const Airfoil* airfoil : {&inner, &outer}) {
    if (airfoil->polars.size() == 1) continue;
    for (const Polar& polar : airfoil->polars) all.push_back(level_of(polar));
  }
  if (all.empty()) all.push_back(0.0);
  std::sort(all.begin(), all.end());
  all.erase(std::unique(all.begin(), all.end()), all.end());
  return all;
}

double interpolate(const std::vector<double>& x, const std::vector<double>& y, double at) {
  if (y.empty()) return 0.0;
  const auto above = std::upper_bound(x.begin(), x.end(), at) - x.begin();
  const auto i = std::clamp<std::ptrdiff_t>(above - 1, 0, std::ssize(x) - 2);
  const double share = std::clamp((at - x[i]) / (x[i + 1] - x[i]), 0.0, 1.0);
  return y[i] + share * (y[i + 1] - y[i]);
}

/// Adds `weight` times a polar to the rows.
void add_polar(const Polar& polar, double weight, const std::vector<double>& angles,
               std::vector<PolarValues>& rows) {
  if (weight == 0.0) return;
  for (std::size_t i = 0; i < angles.size(); ++i) {
    rows[i].lift += weight * interpolate(polar.angle, polar.lift, angles[i]);
    rows[i].drag += weight * interpolate(polar.angle, polar.drag, angles[i]);
    rows[i].moment += weight * interpolate(polar.angle, polar.moment, angles[i]);
  }
}

/// Adds `weight` times an aerofoil at a level to the rows.
void add_airfoil(const Airfoil& airfoil, double level, double weight,
                 const std::vector<double>& angles, std::vector<PolarValues>& rows) {
  std::size_t above = 0;
  while (above < airfoil.polars.size() && airfoil.polars.size() > 1 &&
         level_of(airfoil.polars[above]) <= level)
    ++above;
  const std::size_t last = airfoil.polars.size() - 1;
  const Polar& lower = airfoil.polars[above == 0 ? 0 : std::min(above - 1, last)];
  const Polar& upper = airfoil.polars[std::min(above, last)];
  double share = 0.0;
  if (&lower != &upper) {
    const double from = level_of(lower);
    share = (level - from) / (level_of(upper) - from);
  }
  add_polar(lower, weight * (1.0 - share), angles, rows);
  add_polar(upper, weight * share, angles, rows);
}

/// Completes rows of steady coefficients by the split of their lift; returns the angle of zero
/// lift.
double add_separation(const std::vector<double>& angles, std::vector<PolarValues>& rows) {
  std::vector<double> lift;
  for (const PolarValues& row : rows) lift.push_back(row.lift);
  const Separation split = separate(angles, lift);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    rows[i].separation = split.point[i];
    rows[i].recovery = split.attached[i] - split.separated[i];
  }
  return split.zero_lift;
}

PolarValues between(const PolarValues& a, const PolarValues& b, double share) {
  return {a.lift + share * (b.lift - a.lift), a.drag + share * (b.drag - a.drag),
          a.moment + share * (b.moment - a.moment),
          a.separation + share * (b.separation - a.separation),
          a.recovery + share * (b.recovery - a.recovery)};
}

}  // namespace

ChosenBy find_choice(const Airfoil& airfoil) {
  if (airfoil.polars.size() < 2) return ChosenBy::nothing;
  return airfoil.polars.front().mach ? ChosenBy::mach : ChosenBy::reynolds;
}

SectionPolar::SectionPolar(const Airfoil& inner, const Airfoil& outer, double share)
    : angles_(unite_angles(inner, outer)),
      by_(std::max(find_choice(inner), find_choice(outer))),
      levels_(unite_levels(inner, outer)) {
  for (const double level : levels_) {
    std::vector<PolarValues>& rows = tables_.emplace_back(angles_.size(), PolarValues{});
    add_airfoil(inner, level, 1.0 - share, angles_, rows);
    add_airfoil(outer, level, share, angles_, rows);
    const double zero_lift = add_separation(angles_, rows);
    if (tables_.size() == 1) zero_lift_ = zero_lift;
  }
  std::int32_t row = 0;
  const auto last = static_cast<std::int32_t>(angles_.size()) - 2;
  for (int bin = 0; bin < kBins; ++bin) {
    const double begin = -kPi + bin * (2.0 * kPi / kBins);
    while (row < last && angles_[row + 1] <= begin - kLeastGap) ++row;
    first_[bin] = row;
  }
}

SectionPolar::Level SectionPolar::level(double reynolds, double mach) const noexcept {
  const PolarValues* first = tables_.front().data();
  if (tables_.size() == 1 || !(reynolds > 0.0)) return {first, first, 0.0};
  const double place = by_ == ChosenBy::mach ? mach : std::log(reynolds);
  if (place <= levels_.front()) return {first, first, 0.0};
  std::size_t above = 1;
  while (above < levels_.size() && levels_[above] <= place) ++above;
  const PolarValues* lower = tables_[above - 1].data();
  if (above == levels_.size()) return {lower, lower, 0.0};
  const double from = levels_[above - 1];
  return {lower, tables_[above].data(), (place - from) / (levels_[above] - from)};
}

PolarValues SectionPolar::values(const Level& level, double angle) const noexcept {
  const Place at = find(angle);
  const PolarValues lower = between(level.lower[at.row], level.lower[at.row + 1], at.share);
  if (level.share == 0.0) return lower;
  const PolarValues upper = between(level.upper[at.row], level.upper[at.row + 1], at.share);
  return between(lower, upper, level.share);
}

}  // namespace spoke::air
