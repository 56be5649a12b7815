// Converts sections given by values or by matrices; stiffness and mass may each be either.

#include "models/tree/space_beam.h"

#include <algorithm>
#include <cassert>
#include <functional>
#include <utility>

namespace spoke::spatial {
namespace {

double value_at(const std::vector<double>& values, std::size_t i) {
  return values.empty() ? 0.0 : values[i];
}

Offset offset_at(const std::vector<Offset>& offsets, std::size_t i) {
  return offsets.empty() ? Offset(0.0, 0.0) : offsets[i];
}

/// Returns the inertia that is given, or that of a section of one material.
double inertia_at(const std::vector<double>& given, const std::vector<double>& stiffness,
                  const Sections& s, std::size_t i) {
  return given.empty() ? s.mass_per_length[i] * stiffness[i] / s.axial_stiffness[i] : given[i];
}

void set_stiffness(const Sections& s, std::size_t i, space::SectionProperties& section) {
  section.axial_stiffness = s.axial_stiffness[i];
  section.lag_stiffness = s.lag_stiffness[i];
  section.flap_stiffness = s.flap_stiffness[i];
  section.torsion_stiffness = s.torsion_stiffness[i];
  section.shear_stiffness_y = value_at(s.lag_shear_stiffness, i);
  section.shear_stiffness_z = value_at(s.flap_shear_stiffness, i);
  const Offset tension = offset_at(s.tension_center, i), shear = offset_at(s.shear_center, i);
  section.tension_centre_y = tension.x();
  section.tension_centre_z = tension.y();
  section.shear_centre_y = shear.x();
  section.shear_centre_z = shear.y();
}

void set_mass(const Sections& s, std::size_t i, space::SectionProperties& section) {
  if (s.mass_6x6.empty()) {
    const Offset center = offset_at(s.mass_center, i);
    section.mass_per_length = s.mass_per_length[i];
    section.mass_centre_y = center.x();
    section.mass_centre_z = center.y();
    section.lag_inertia = inertia_at(s.lag_inertia, s.lag_stiffness, s, i);
    section.flap_inertia = inertia_at(s.flap_inertia, s.flap_stiffness, s, i);
    return;
  }
  const space::MassMoments moments = space::moments_of(s.mass_6x6[i]);
  const double y = moments.first.y() / moments.mass, z = moments.first.z() / moments.mass;
  section.mass_per_length = moments.mass;
  section.mass_centre_y = y;
  section.mass_centre_z = z;
  section.lag_inertia = moments.second(1, 1) - moments.mass * y * y;
  section.flap_inertia = moments.second(2, 2) - moments.mass * z * z;
  section.product_inertia = moments.second(1, 2) - moments.mass * y * z;
}

/// Returns the mass of a section beside a stiffness matrix.
space::MassMoments make_moments(const Sections& s, std::size_t i) {
  if (!s.mass_6x6.empty()) return space::moments_of(s.mass_6x6[i]);
  const double mass = s.mass_per_length[i];
  const Offset c = offset_at(s.mass_center, i);
  const space::Position center(0.0, c.x(), c.y());
  space::MassMoments moments;
  moments.mass = mass;
  moments.first = mass * center;
  moments.second = mass * center * center.transpose();
  moments.second(1, 1) += s.lag_inertia[i];
  moments.second(2, 2) += s.flap_inertia[i];
  return moments;
}

space::ReferenceCurve make_curve(const Sections& s) {
  if (s.sweep.empty() && s.prebend.empty()) return {};
  std::vector<space::Position> points;
  for (std::size_t i = 0; i < s.station.size(); ++i)
    points.emplace_back(s.station[i], value_at(s.sweep, i), value_at(s.prebend, i));
  return space::ReferenceCurve(std::move(points));
}

/// Moments about the section's point of the axis, in section axes, from those in the beam's axes.
space::MassMoments make_moments(const PointMass& point, const space::Rotation& axes) {
  const Tensor second = 0.5 * point.inertia.trace() * Tensor::Identity() - point.inertia +
                        point.mass * point.offset * point.offset.transpose();
  const space::Matrix3 back = axes.axes.transpose();
  space::MassMoments moments;
  moments.mass = point.mass;
  moments.first = point.mass * (back * point.offset);
  moments.second = back * second * axes.axes;
  return moments;
}

/// Returns the factors by strain: stretch, two shears, twist, two curvatures.
space::Twist make_strain_factors(const DirectionDamping& damping) {
  space::Twist factors;
  factors << damping.axial, damping.lag_shear.value_or(damping.lag),
      damping.flap_shear.value_or(damping.flap), damping.torsion, damping.flap, damping.lag;
  return factors;
}

/// Whether the stations ascend from 0, and there are as many stiffnesses and masses as stations.
[[maybe_unused]] bool has_fine_stations(const Beam& beam) {
  const Sections& s = beam.sections;
  const std::size_t n = s.station.size();
  const std::size_t stiffnesses =
      s.stiffness_6x6.empty() ? s.axial_stiffness.size() : s.stiffness_6x6.size();
  const std::size_t masses = s.mass_6x6.empty() ? s.mass_per_length.size() : s.mass_6x6.size();
  return n > 1 && stiffnesses == n && masses == n && s.station.front() == 0.0 &&
         std::adjacent_find(s.station.begin(), s.station.end(), std::greater_equal<>()) ==
             s.station.end();
}

}  // namespace

Vector find_axis_begin(const Sections& sections) {
  return {0.0, value_at(sections.sweep, 0), value_at(sections.prebend, 0)};
}

space::Beam make_space_beam(const Beam& beam, const DirectionDamping& damping) {
  assert(has_fine_stations(beam));
  const Sections& s = beam.sections;
  space::Beam made;
  made.station = s.station;
  for (std::size_t i = 0; i < s.station.size(); ++i) {
    if (s.stiffness_6x6.empty()) {
      space::SectionProperties& section = made.properties.emplace_back();
      set_stiffness(s, i, section);
      set_mass(s, i, section);
    } else {
      made.matrices.push_back({s.stiffness_6x6[i], make_moments(s, i)});
    }
  }
  made.twist = s.twist;
  made.curve = make_curve(s);
  for (const PointMass& point : beam.point_masses)
    made.masses.push_back(
        {point.position, make_moments(point, made.geometry(point.position).axes)});
  made.damping = make_strain_factors(damping);
  made.is_nonlinear = beam.strain == BeamStrain::nonlinear;
  return made;
}

}  // namespace spoke::spatial
