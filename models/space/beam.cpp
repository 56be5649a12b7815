// Cross sections of a beam between its stations.

#include "models/space/beam.h"

#include <algorithm>
#include <cassert>

#include "models/space/rotation_vector.h"

namespace spoke::space {

std::size_t Beam::interval(double x) const {
  assert(station.size() > 1);
  const auto beyond = std::upper_bound(station.begin() + 1, station.end() - 1, x);
  return static_cast<std::size_t>(beyond - station.begin()) - 1;
}

SectionMatrices Beam::section(double x) const {
  assert((matrices.empty() ? properties.size() : matrices.size()) == station.size());
  const std::size_t k = interval(x);
  const double t = (x - station[k]) / (station[k + 1] - station[k]);
  if (!matrices.empty()) return reduce(interpolate(matrices[k], matrices[k + 1], t));
  return reduce(interpolate(properties[k], properties[k + 1], t));
}

double Beam::twist_at(double x) const {
  assert(twist.empty() || twist.size() == station.size());
  if (twist.empty()) return 0.0;
  const std::size_t k = interval(x);
  const double t = (x - station[k]) / (station[k + 1] - station[k]);
  return twist[k] + t * (twist[k + 1] - twist[k]);
}

SectionAt Beam::geometry(double x) const {
  SectionAt at{curve.at(x), curve.slope(x), {}};
  at.axes = smallest_rotation(Position::UnitX(), at.tangent.normalized()) *
            exponential(Position(twist_at(x), 0.0, 0.0));
  return at;
}

std::vector<double> Beam::breaks(double from, double to) const {
  assert(from < to);
  std::vector<double> places{from, to};
  const auto add = [&](double x) {
    if (x > from && x < to) places.push_back(x);
  };
  for (const double x : station) add(x);
  for (const Position& point : curve.points()) add(point.x());
  for (const PointMass& point : masses) add(point.station);
  std::sort(places.begin(), places.end());
  // Stations closer together than this are one place, rounded.
  const double shortest = 1e-12 * (to - from);
  const auto last = std::unique(places.begin(), places.end(),
                                [&](double a, double b) { return b - a < shortest; });
  places.erase(last, places.end());
  places.back() = to;
  return places;
}

std::optional<std::size_t> Beam::uniform_stretch(double from, double to) const {
  assert(from < to);
  const double rounding = 1e-12 * (to - from);  // as of is_outboard()
  const auto has_mass = [&](const PointMass& point) {
    return point.station >= from - rounding && point.station <= to + rounding;
  };
  if (!curve.is_straight() || std::any_of(masses.begin(), masses.end(), has_mass)) return {};
  // Whether nothing changes from station k to the next.
  const auto stays = [this](std::size_t k) {
    return (matrices.empty() ? properties[k] == properties[k + 1]
                             : matrices[k] == matrices[k + 1]) &&
           (twist.empty() || twist[k] == twist[k + 1]);
  };
  std::size_t first = interval(from);
  for (std::size_t k = first; k + 1 < station.size() && (k == first || station[k] < to); ++k)
    if (!stays(k)) return {};
  while (first > 0 && stays(first - 1)) --first;
  return first;
}

Beam Beam::uniform_piece(std::size_t stretch, double length) const {
  assert(stretch < station.size() && length > 0.0);
  Beam piece;
  piece.station = {0.0, length};
  if (!properties.empty()) piece.properties.assign(2, properties[stretch]);
  if (!matrices.empty()) piece.matrices.assign(2, matrices[stretch]);
  if (!twist.empty()) piece.twist.assign(2, twist[stretch]);
  piece.damping = damping;
  piece.stiffness_damping = stiffness_damping;
  piece.is_nonlinear = is_nonlinear;
  return piece;
}

}  // namespace spoke::space
