// Integrals of section data along the axis.

#include "models/tree/mass_properties.h"

#include <array>
#include <cassert>

namespace spoke::spatial {
namespace {

/// |p|^2 1 - p p^T.
Tensor point_inertia(const Vector& p) {
  return p.squaredNorm() * Tensor::Identity() - p * p.transpose();
}

// Gauss's rule of six points on [-1, 1], with 15 digits: more would change the bits of masses.
constexpr std::array<double, 6> kPlaces{-0.932469514203152, -0.661209386466265, -0.238619186083197,
                                        0.238619186083197,  0.661209386466265,  0.932469514203152};
constexpr std::array<double, 6> kWeights{0.171324492379170, 0.360761573048139, 0.467913934572691,
                                         0.467913934572691, 0.360761573048139, 0.171324492379170};

/// Converts moments about a point of the beam in section axes there to the beam's frame.
MassProperties place(const space::MassMoments& moments, const space::SectionAt& at) {
  MassProperties own;
  own.mass = moments.mass;
  own.first_moment = moments.first;
  own.inertia = moments.second.trace() * Tensor::Identity() - moments.second;
  return own.seen_from_outside({at.p, at.axes.axes});
}

}  // namespace

MassProperties& MassProperties::operator+=(const MassProperties& other) {
  mass += other.mass;
  first_moment += other.first_moment;
  inertia += other.inertia;
  return *this;
}

MassProperties MassProperties::seen_from_outside(const Placement& placement) const {
  const Vector p = placement.position, first = placement.rotation * first_moment;
  const Tensor mixed = p * first.transpose() + first * p.transpose();
  MassProperties seen;
  seen.mass = mass;
  seen.first_moment = mass * p + first;
  seen.inertia = placement.rotation * inertia * placement.rotation.transpose() +
                 mass * point_inertia(p) + mixed.trace() * Tensor::Identity() - mixed;
  return seen;
}

MassProperties make_mass_properties(double mass, const Vector& center, const Tensor& inertia) {
  assert(mass >= 0.0);
  return {mass, mass * center, inertia + mass * point_inertia(center)};
}

MassProperties calc_mass_properties(const space::Beam& beam, double from, double to) {
  assert(from < to);
  const std::vector<double> breaks = beam.breaks(from, to);
  MassProperties total;
  for (std::size_t i = 1; i < breaks.size(); ++i) {
    const double half = 0.5 * (breaks[i] - breaks[i - 1]);
    for (std::size_t k = 0; k < kPlaces.size(); ++k) {
      const double x = breaks[i - 1] + half * (1.0 + kPlaces[k]);
      const space::SectionAt at = beam.geometry(x);
      const MassProperties slice = place(beam.section(x).mass, at);
      const double weight = half * kWeights[k] * at.tangent.norm();
      total += {weight * slice.mass, weight * slice.first_moment, weight * slice.inertia};
    }
  }
  const bool is_root = from <= beam.station.front();
  for (const space::PointMass& point : beam.masses)
    if (point.station <= to && (point.station > from || is_root))
      total += place(point.moments, beam.geometry(point.station));
  return total;
}

}  // namespace spoke::spatial
