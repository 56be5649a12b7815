// Integrals of section data along the axis.

#include "models/tree/mass_properties.h"

#include <algorithm>
#include <array>

#include "models/tree/beam_axis.h"
#include "models/tree/section_mass.h"

namespace spoke::spatial {
namespace {

/// |p|^2 1 - p p^T.
Tensor point_inertia(const Vector& p) {
  return p.squaredNorm() * Tensor::Identity() - p * p.transpose();
}

// Gauss's rule of six points on [-1, 1].
constexpr std::array<double, 6> kPlaces{-0.932469514203152, -0.661209386466265, -0.238619186083197,
                                        0.238619186083197,  0.661209386466265,  0.932469514203152};
constexpr std::array<double, 6> kWeights{0.171324492379170, 0.360761573048139, 0.467913934572691,
                                         0.467913934572691, 0.360761573048139, 0.171324492379170};

/// Of a slice, by its length along x.
MassProperties calc_slice(const SectionMass& section, const BeamAxis& axis, double x) {
  const Tensor R = axis.axes(x);
  const Vector p = axis.place(x), first = R * section.first_moment;
  MassProperties slice;
  slice.mass = section.mass;
  slice.first_moment = section.mass * p + first;
  // About the origin: the slice's own about p, and the terms of p and the first moment.
  const Tensor mixed = p * first.transpose() + first * p.transpose();
  slice.inertia = R * section.inertia * R.transpose() + section.mass * point_inertia(p) +
                  mixed.trace() * Tensor::Identity() - mixed;
  const double stretch = axis.stretch(x);
  slice.mass *= stretch;
  slice.first_moment *= stretch;
  slice.inertia *= stretch;
  return slice;
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
  return {mass, mass * center, inertia + mass * point_inertia(center)};
}

MassProperties calc_mass_properties(const Beam& beam, double from, double to) {
  const BeamAxis axis(beam.sections);
  const SectionMasses masses(beam.sections);
  const std::vector<double>& station = beam.sections.station;
  MassProperties total;
  for (std::size_t i = 1; i < station.size(); ++i) {
    const double begin = std::max(from, station[i - 1]), end = std::min(to, station[i]);
    if (end <= begin) continue;
    const double half = 0.5 * (end - begin);
    for (std::size_t k = 0; k < kPlaces.size(); ++k) {
      const double x = begin + half * (1.0 + kPlaces[k]);
      MassProperties slice = calc_slice(masses.at(x), axis, x);
      const double weight = half * kWeights[k];
      total += {weight * slice.mass, weight * slice.first_moment, weight * slice.inertia};
    }
  }
  return total;
}

}  // namespace spoke::spatial
