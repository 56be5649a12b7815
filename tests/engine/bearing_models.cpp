#include "tests/engine/bearing_models.h"

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <cmath>
#include <complex>
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

Eigen::Vector2d advance_undamped(const Eigen::Matrix2d& A, const Eigen::Vector2d& start, double t) {
  const Eigen::EigenSolver<Eigen::Matrix2d> eigen(A);
  const Eigen::Matrix2cd shapes = eigen.eigenvectors();
  Eigen::Vector2cd share = shapes.fullPivLu().solve(start.cast<std::complex<double>>());
  for (int k = 0; k < 2; ++k) share[k] *= std::cos(std::sqrt(eigen.eigenvalues()[k]) * t);
  return (shapes * share).real();
}

}  // namespace spoke::test
