#include "tests/engine/bearing_models.h"

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <cmath>
#include <complex>
#include <numbers>
#include <sstream>

namespace spoke::test {

std::string matrix_key(const std::string& key, double xx, double xy, double yx, double yy) {
  std::ostringstream text;
  text.precision(17);
  text << ", " << key << "=[[" << xx << ',' << xy << "],[" << yx << ',' << yy << "]]";
  return text.str();
}

std::string make_sliding_mass(const std::string& keys, const Eigen::Vector2d& place,
                              const Eigen::Vector2d& speed, double spin, double turn,
                              const std::string& gravity) {
  std::ostringstream text;
  text.precision(17);
  text << "world='space'\n[hub]\ninertia=1\n[hub.drive]\nkind='constant'\nspeed=0\n"
       << "[gravity]\nacceleration=" << gravity << "\n[[subsystem]]\nname='s'\n"
       << "body=[ { name='slide', kind='rigid', mass=10, inertia=1 }, { name='mass', kind='rigid', "
          "mass=20, inertia=1 }, { name='rotor', kind='rigid', mass=10, inertia=1 } ]\n"
       << "joint=[ { parent='hub', child='slide', kind='prismatic', axis=[1,0,0], initial="
       << place.x() << ", initial_speed=" << speed.x()
       << " }, { parent='slide', child='mass', kind='prismatic', axis=[0,1,0], initial="
       << place.y() << ", initial_speed=" << speed.y() << " }, { parent='mass', child='rotor', "
       << (spin == 0.0 ? "kind='fixed'" : "kind='revolute', axis=[0,0,1], initial_speed=");
  if (spin != 0.0) text << spin;
  text << " } ]\n"
       << "loop=[ { name='bearing', kind='bearing', from={ body='rotor' }, to={ body='hub', "
          "orientation=[0,0,"
       << turn << "] }, axis=[0,0,1]" << keys << " } ]\n"
       << "[integration]\nstep=1e-3\nduration=1\n";
  return text.str();
}

namespace {

constexpr double kDensity = 7810.0, kShaft = 0.05;

std::string make_disc(const std::string& name, double diameter) {
  constexpr double kThickness = 0.07;
  const double outer = diameter * diameter, inner = kShaft * kShaft;
  const double mass = kDensity * std::numbers::pi / 4.0 * (outer - inner) * kThickness;
  const double polar = mass * (outer + inner) / 8.0;
  const double across = 0.5 * polar + mass * kThickness * kThickness / 12.0;
  std::ostringstream text;
  text.precision(17);
  text << "{ name='" << name << "', kind='rigid', mass=" << mass << ", inertia=[" << polar << ','
       << across << ',' << across << "] }";
  return text.str();
}

}  // namespace

std::string make_rotor_on_bearings(const std::string& keys) {
  constexpr double E = 211e9, G = 81.2e9;
  const double area = std::numbers::pi / 4.0 * kShaft * kShaft;
  const double second = area * kShaft * kShaft / 16.0, nu = 0.5 * E / G - 1.0;
  const double shear = 6.0 * (1.0 + nu) / (7.0 + 6.0 * nu) * G * area;
  std::ostringstream text;
  text.precision(17);
  text << "world='space'\n[hub]\ninertia=1\n[hub.drive]\nkind='constant'\nspeed=0\n"
       << "[[subsystem]]\nname='rotor'\nbody=[ { name='y', kind='rigid', mass=1e-6, "
          "inertia=1e-9 }, { name='z', kind='rigid', mass=1e-6, inertia=1e-9 }, { name='shaft', "
          "kind='beam', length=1.5, bodies=1, elements=24, strain='linear', "
          "sections={ mass_per_length="
       << kDensity * area << ", axial_stiffness=" << E * area << ", flap_stiffness=" << E * second
       << ", lag_stiffness=" << E * second << ", torsion_stiffness=" << 2.0 * G * second
       << ", flap_inertia=" << kDensity * second << ", lag_inertia=" << kDensity * second
       << ", flap_shear_stiffness=" << shear << ", lag_shear_stiffness=" << shear << " } }, "
       << make_disc("small", 0.28) << ", " << make_disc("large", 0.35) << " ]\n"
       << "joint=[ { parent='hub', child='y', kind='prismatic', axis=[0,1,0] }, { parent='y', "
          "child='z', kind='prismatic', axis=[0,0,1] }, { parent='z', child='shaft', "
          "kind='universal', axes=[[0,1,0],[0,0,1]] }, { parent='shaft', station=0.5, "
          "child='small', kind='fixed' }, { parent='shaft', station=1.0, child='large', "
          "kind='fixed' } ]\nloop=[ ";
  for (const std::string end : {"0", "1.5"})
    text << "{ name='bearing" << end << "', kind='bearing', from={ body='shaft', station=" << end
         << " }, to={ body='hub', point=[" << end << ",0,0] }, axis=[1,0,0]" << keys
         << (end == "0" ? " }, " : " } ]\n");
  text << "[integration]\nstep=1e-3\nduration=1\n";
  return text.str();
}

Eigen::Vector2d advance_undamped(const Eigen::Matrix2d& A, const Eigen::Vector2d& start, double t) {
  const Eigen::EigenSolver<Eigen::Matrix2d> eigen(A);
  const Eigen::Matrix2cd shapes = eigen.eigenvectors();
  Eigen::Vector2cd share = shapes.fullPivLu().solve(start.cast<std::complex<double>>());
  for (int k = 0; k < 2; ++k) share[k] *= std::cos(std::sqrt(eigen.eigenvalues()[k]) * t);
  return (shapes * share).real();
}

}  // namespace spoke::test
