// Solves the boundary-value problem by shooting from the clamped end.

#include "tests/engine/small_motions/steady/elastic_rod.h"

#include <Eigen/LU>

namespace spoke::test {
namespace {

using Eigen::Quaterniond;
using Eigen::Vector3d;

/// State of a cross section, or its derivative along the rod.
struct Section {
  Vector3d p = Vector3d::Zero();
  Eigen::Vector4d turn{0.0, 0.0, 0.0, 1.0};  ///< a quaternion: x, y, z, w
  Vector3d m = Vector3d::Zero();
};

Section operator+(const Section& a, const Section& b) {
  return {a.p + b.p, a.turn + b.turn, a.m + b.m};
}
Section operator*(double factor, const Section& a) {
  return {factor * a.p, factor * a.turn, factor * a.m};
}

Section differentiate(const ElasticRod& rod, const Vector3d& force, const Section& section) {
  const Quaterniond Q = Quaterniond(section.turn).normalized();
  const Vector3d t = Q * Vector3d::UnitX();
  const Vector3d kappa = (Q.conjugate() * section.m).cwiseQuotient(rod.stiffness);
  Section rate;
  rate.p = (1.0 + force.dot(t) / rod.axial) * t;
  rate.turn = 0.5 * (Q * Quaterniond(0.0, kappa.x(), kappa.y(), kappa.z())).coeffs();
  rate.m = -rate.p.cross(force);
  return rate;
}

/// Integrates from the clamped end, with this moment there, to the tip.
Section integrate(const ElasticRod& rod, const Vector3d& force, const Vector3d& moment) {
  constexpr int kSteps = 400;
  const double h = rod.length / kSteps;
  Section now;
  now.m = moment;
  for (int k = 0; k < kSteps; ++k) {
    const Section a = differentiate(rod, force, now);
    const Section b = differentiate(rod, force, now + 0.5 * h * a);
    const Section c = differentiate(rod, force, now + 0.5 * h * b);
    const Section d = differentiate(rod, force, now + h * c);
    now = now + h / 6.0 * (a + 2.0 * b + 2.0 * c + d);
  }
  return now;
}

}  // namespace

RodTip solve_rod(const ElasticRod& rod, const Vector3d& force) {
  constexpr int kLoadSteps = 10, kIterations = 8;
  const double scale = force.norm() * rod.length;
  Vector3d moment = Vector3d::Zero();
  for (int step = 1; step <= kLoadSteps; ++step) {
    const Vector3d share = force * step / kLoadSteps;
    for (int k = 0; k < kIterations; ++k) {
      const Vector3d rest = integrate(rod, share, moment).m;
      Eigen::Matrix3d slope;
      for (int c = 0; c < 3; ++c) {
        const Vector3d change = 1e-6 * scale * Vector3d::Unit(c);
        slope.col(c) = (integrate(rod, share, moment + change).m - rest) / (1e-6 * scale);
      }
      moment -= slope.inverse() * rest;
    }
  }
  const Section tip = integrate(rod, force, moment);
  return {tip.p - Vector3d(rod.length, 0.0, 0.0), Quaterniond(tip.turn).normalized()};
}

}  // namespace spoke::test
