// Mass matrices of thin slices.

#include "models/tree/section_mass.h"

#include "models/tree/by_station.h"

namespace spoke::spatial {
namespace {

/// The moments of mass of a thin slice about the axis: int rho (1, y, z, y^2, z^2, y z) dA.
struct SliceMoments {
  double mass, y, z, yy, zz, yz;
};

SliceMoments calc_moments(const Sections& s, std::size_t i) {
  const double mass = s.mass_per_length[i];
  const Offset c = s.mass_center.empty() ? Offset(0.0, 0.0) : s.mass_center[i];
  const auto inertia = [&](const std::vector<double>& given, const std::vector<double>& stiffness) {
    return given.empty() ? mass * stiffness[i] / s.axial_stiffness[i] : given[i];
  };
  return {mass,
          mass * c.x(),
          mass * c.y(),
          inertia(s.lag_inertia, s.lag_stiffness) + mass * c.x() * c.x(),
          inertia(s.flap_inertia, s.flap_stiffness) + mass * c.y() * c.y(),
          mass * c.x() * c.y()};
}

SectionMatrix make_matrix(const SliceMoments& m) {
  SectionMatrix matrix = SectionMatrix::Zero();
  matrix.diagonal() << m.mass, m.mass, m.mass, m.yy + m.zz, m.zz, m.yy;
  const auto set = [&](int r, int c, double value) { matrix(r, c) = matrix(c, r) = value; };
  set(0, 4, m.z);
  set(0, 5, -m.y);
  set(1, 3, -m.z);
  set(2, 3, m.y);
  set(4, 5, -m.yz);
  return matrix;
}

}  // namespace

std::vector<SectionMatrix> make_mass_matrices(const Sections& sections) {
  if (!sections.mass_6x6.empty()) return sections.mass_6x6;
  std::vector<SectionMatrix> matrices;
  for (std::size_t i = 0; i < sections.station.size(); ++i)
    matrices.push_back(make_matrix(calc_moments(sections, i)));
  return matrices;
}

SectionMasses::SectionMasses(const Sections& sections)
    : station_(sections.station), matrices_(make_mass_matrices(sections)) {}

SectionMass SectionMasses::at(double x) const {
  const SectionMatrix m = ByStation(station_, x).of(matrices_);
  return {m(0, 0), {0.0, m(2, 3), m(0, 4)}, m.bottomRightCorner<3, 3>()};
}

}  // namespace spoke::spatial
