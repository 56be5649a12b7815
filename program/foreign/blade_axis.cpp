// Splines of the axis, quadrature of their arc length, and stations of both lists.

#include "program/foreign/blade_axis.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "models/support/gauss_rule.h"

namespace spoke::foreign {
namespace {

space::ReferenceCurve make_axis(const std::vector<KeyPoint>& points) {
  std::vector<space::Position> places;
  for (const KeyPoint& point : points) places.emplace_back(point.x, point.sweep, point.prebend);
  return space::ReferenceCurve(std::move(places));
}

/// The twist over x as a curve: the same spline as that of the axis.
space::ReferenceCurve make_twist(const std::vector<KeyPoint>& points) {
  std::vector<space::Position> places;
  for (const KeyPoint& point : points) places.emplace_back(point.x, point.twist, 0.0);
  return space::ReferenceCurve(std::move(places));
}

/// Returns the sections at a share of the arc length, linear between those that are given.
FoundSection interpolate(const std::vector<FoundSection>& sections, double eta) {
  const auto above =
      std::upper_bound(sections.begin() + 1, sections.end() - 1, eta,
                       [](double value, const FoundSection& s) { return value < s.eta; });
  const FoundSection& b = *above;
  const FoundSection& a = *(above - 1);
  const double t = (eta - a.eta) / (b.eta - a.eta);
  FoundSection section;
  section.eta = eta;
  section.stiffness = (1.0 - t) * a.stiffness + t * b.stiffness;
  section.mass = (1.0 - t) * a.mass + t * b.mass;
  return section;
}

void add_station(const KeyPoint& point, const FoundSection& section, const std::string& from,
                 BeamTable& beam) {
  beam.station.push_back(point.x);
  beam.sweep.push_back(point.sweep);
  beam.prebend.push_back(point.prebend);
  beam.twist.push_back(point.twist);
  beam.stiffness.push_back(section.stiffness);
  beam.mass.push_back(section.mass);
  beam.station_from.push_back(from);
}

}  // namespace

bool is_at_root(const KeyPoint& point) {
  constexpr double small = 1e-6;  // [m]
  return std::abs(point.x) < small && std::abs(point.sweep) < small &&
         std::abs(point.prebend) < small;
}

BladeAxis::BladeAxis(std::vector<KeyPoint> points)
    : points_(std::move(points)), axis_(make_axis(points_)), twist_(make_twist(points_)) {
  assert(points_.size() > 1 && points_.front().x == 0.0);
  lengths_.push_back(0.0);
  for (std::size_t k = 1; k < points_.size(); ++k)
    lengths_.push_back(lengths_.back() + measure(points_[k - 1].x, points_[k].x));
}

KeyPoint BladeAxis::at(double x) const {
  const space::Position p = axis_.at(x);
  KeyPoint point;
  point.x = x;
  point.sweep = p.y();
  point.prebend = p.z();
  point.twist = twist_.at(x).y();
  return point;
}

double BladeAxis::measure(double from, double to) const {
  using Rule = GaussRule<6>;
  constexpr int parts = 8;  // errors are those of round-off for blades that bend by their length
  const double width = (to - from) / parts;
  double length = 0.0;
  for (int part = 0; part < parts; ++part)
    for (std::size_t k = 0; k < Rule::kPoints; ++k)
      length +=
          width * Rule::weights[k] * axis_.slope(from + width * (part + Rule::places[k])).norm();
  return length;
}

double BladeAxis::arc_length(double x) const {
  const auto above = std::upper_bound(points_.begin() + 1, points_.end() - 1, x,
                                      [](double place, const KeyPoint& p) { return place < p.x; });
  const auto k = static_cast<std::size_t>(above - points_.begin()) - 1;
  return lengths_[k] + measure(points_[k].x, x);
}

double BladeAxis::find_x(double arc_length) const {
  const auto above = std::upper_bound(lengths_.begin() + 1, lengths_.end() - 1, arc_length);
  const auto k = static_cast<std::size_t>(above - lengths_.begin()) - 1;
  double low = points_[k].x, high = points_[k + 1].x;
  double x =
      low + (high - low) *
                std::clamp((arc_length - lengths_[k]) / (lengths_[k + 1] - lengths_[k]), 0.0, 1.0);
  constexpr int most = 60;  // a safe bound: each halves the interval at least
  for (int i = 0; i < most; ++i) {
    const double excess = lengths_[k] + measure(points_[k].x, x) - arc_length;
    if (excess > 0.0)
      high = x;
    else
      low = x;
    double next = x - excess / axis_.slope(x).norm();
    if (!(next >= low && next <= high)) next = 0.5 * (low + high);
    if (std::abs(next - x) <= 1e-16 * points_.back().x) return next;
    x = next;
  }
  return x;
}

BeamTable merge_stations(const BladeAxis& axis, const std::vector<FoundSection>& sections) {
  assert(sections.size() > 1 && sections.front().eta == 0.0 && sections.back().eta == 1.0);
  const std::vector<KeyPoint>& points = axis.points();
  const double length = points.back().x, whole = axis.whole_arc_length();
  const double close = 1e-9 * length;  // stations that are so close are one
  BeamTable beam;
  std::size_t p = 0, s = 0;
  while (p < points.size() || s < sections.size()) {
    double x = length;
    if (s + 1 < sections.size()) x = s == 0 ? 0.0 : axis.find_x(sections[s].eta * whole);
    const bool has_point = p < points.size(), has_section = s < sections.size();
    const double gap = has_point && has_section ? points[p].x - x : 0.0;
    if (has_point && has_section && std::abs(gap) <= close) {
      add_station(points[p], sections[s], points[p].from + "; " + sections[s].from, beam);
      ++p, ++s;
    } else if (has_point && (!has_section || gap < 0.0)) {
      const double eta = axis.arc_length(points[p].x) / whole;
      add_station(points[p], interpolate(sections, eta), points[p].from, beam);
      ++p;
    } else {
      add_station(axis.at(x), sections[s], sections[s].from, beam);
      ++s;
    }
  }
  return beam;
}

}  // namespace spoke::foreign
