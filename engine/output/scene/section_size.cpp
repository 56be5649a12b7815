// Interpolates chord and thickness between stations, or takes those of an ellipse with given
// inertias.

#include "engine/output/scene/section_size.h"

#include <algorithm>
#include <cmath>

namespace spoke::scene {
namespace {

/// Interpolates linearly between stations.
double value_at(const std::vector<double>& stations, const std::vector<double>& values, double x) {
  const auto beyond = std::upper_bound(stations.begin() + 1, stations.end() - 1, x);
  const auto k = static_cast<std::size_t>(beyond - stations.begin()) - 1;
  const double t = (x - stations[k]) / (stations[k + 1] - stations[k]);
  return values[k] + t * (values[k + 1] - values[k]);
}

/// Returns the semi-axis a of an ellipse, for which int y^2 dm = m a^2/4.
double semi_axis(double second_moment, double mass) {
  return 2.0 * std::sqrt(std::max(0.0, second_moment / mass));
}

}  // namespace

SectionSize find_section_size(const spatial::Beam& beam, const space::Beam& made, double x) {
  const spatial::Sections& s = beam.sections;
  const space::MassMoments mass = made.section(x).mass;
  const double y = mass.first.y() / mass.mass, z = mass.first.z() / mass.mass;
  SectionSize size{semi_axis(mass.second(1, 1) - mass.mass * y * y, mass.mass),
                   semi_axis(mass.second(2, 2) - mass.mass * z * z, mass.mass), y, z};
  if (s.chord.empty() && s.thickness.empty()) return size;
  size.center_y = size.center_z = 0.0;
  if (!s.chord.empty()) size.half_y = 0.5 * value_at(s.station, s.chord, x);
  if (!s.thickness.empty()) size.half_z = 0.5 * value_at(s.station, s.thickness, x);
  return size;
}

}  // namespace spoke::scene
