#include "models/system/solid_tension.h"

#include <doctest/doctest.h>

#include <Eigen/Geometry>
#include <random>
#include <vector>

#include "models/space/rotation_vector.h"

using namespace spoke;

namespace {

constexpr int kAnyModes = 3;

struct LooseRandom {
  std::mt19937 engine{7};
  double operator()() { return std::uniform_real_distribution<double>(-1.0, 1.0)(engine); }
  space::Position vector() { return {(*this)(), (*this)(), (*this)()}; }
  Eigen::MatrixXd matrix() {
    Eigen::MatrixXd m(kAnyModes, kAnyModes);
    for (Eigen::Index i = 0; i < m.size(); ++i) m(i) = (*this)();
    return m + m.transpose();
  }
};

struct LoosePoint {
  double mass;
  space::Position r;  ///< from the centre of rotation, in B
};

/// A solid with three places, the first of which the frame holds; any matrices do, since stresses
/// are linear in the loads.
space::SolidConstants make_any_solid(LooseRandom& random) {
  space::SolidConstants made;
  made.is_stiffened = true;
  space::ReducedSolid reduced;
  for (Eigen::MatrixXd& m : reduced.own) m = random.matrix();
  for (Eigen::MatrixXd& m : reduced.translation) m = random.matrix();
  made.places.resize(3);
  reduced.places.resize(3);
  for (std::size_t p = 1; p < 3; ++p) {
    made.places[p].p = random.vector();
    made.places[p].at = {0};
    made.places[p].columns.resize(1);
    for (Eigen::MatrixXd& m : reduced.places[p]) m = random.matrix();
  }
  made.matrices = reduced;
  return made;
}

OutboardMass sum_of(std::size_t place, const std::vector<LoosePoint>& points) {
  OutboardMass made{place};
  for (const LoosePoint& point : points) {
    made.mass += point.mass;
    made.first += point.mass * point.r;
    made.second += point.mass * point.r * point.r.transpose();
  }
  return made;
}

/// Adds what a wrench on a place makes, from forces on points that are rigidly joined to it.
template <class Acceleration>
void add_forces(const space::ReducedSolid& solid, std::size_t place, const space::Position& p,
                const std::vector<LoosePoint>& points, const Acceleration& force_per_mass,
                Eigen::MatrixXd& K) {
  space::Position force = space::Position::Zero(), moment = space::Position::Zero();
  for (const LoosePoint& point : points) {
    const space::Position f = point.mass * force_per_mass(point.r);
    force += f;
    moment += space::Position(point.r - p).cross(f);
  }
  for (std::size_t c = 0; c < 3; ++c) {
    K += force[static_cast<Eigen::Index>(c)] * solid.places[place][c];
    K += moment[static_cast<Eigen::Index>(c)] * solid.places[place][c + 3];
  }
}

}  // namespace

TEST_CASE("the tension of a solid in its tree is that of the forces of inertia on all outboard") {
  LooseRandom random;
  const space::SolidConstants constants = make_any_solid(random);
  const space::ReducedSolid& solid = *constants.reduced();
  const space::Position origin = random.vector(), w = random.vector(), g = random.vector();
  std::vector<std::vector<LoosePoint>> outboard(3);
  for (auto& points : outboard)
    for (int i = 0; i < 4; ++i) points.push_back({1.5 + random(), 2.0 * random.vector()});
  const auto made = make_solid_tension(
      constants, origin, {sum_of(0, outboard[0]), sum_of(1, outboard[1]), sum_of(2, outboard[2])});

  const auto inertia = [&](const space::Position& r) -> space::Position {
    return -w.cross(w.cross(r));
  };
  const auto weight = [&](const space::Position&) -> space::Position { return g; };
  const std::array<double, 6> monomials = space::spin_monomials(w);
  Eigen::MatrixXd spin = Eigen::MatrixXd::Zero(kAnyModes, kAnyModes), gravity = spin, sums = spin,
                  fields = spin;
  for (std::size_t k = 0; k < 6; ++k) {
    sums += monomials[k] * made->spin[k];
    spin += monomials[k] * solid.own[k];
  }
  for (std::size_t c = 0; c < 3; ++c) {
    const auto i = static_cast<Eigen::Index>(c);
    fields += g[i] * made->gravity[c];
    // A load -M e_c is that of the acceleration e_c.
    spin += space::Position(-inertia(origin))[i] * solid.translation[c];
    gravity -= g[i] * solid.translation[c];
  }
  for (std::size_t p = 1; p < 3; ++p) {  // the frame holds place 0
    const space::Position at = origin + constants.places[p].p;
    add_forces(solid, p, at, outboard[p], inertia, spin);
    add_forces(solid, p, at, outboard[p], weight, gravity);
  }
  CHECK((sums - spin).norm() <= 1e-13 * spin.norm());
  CHECK((fields - gravity).norm() <= 1e-13 * gravity.norm());
}

TEST_CASE("what hangs outboard is seen from the centre of rotation, in the axes of the solid") {
  LooseRandom random;
  const space::Rotation to_axis = space::exponential(random.vector());
  const space::Rotation to_body = space::exponential(random.vector());
  const space::Position centre = random.vector();
  spatial::MassProperties mass;
  std::vector<LoosePoint> points;
  for (int i = 0; i < 5; ++i) {
    const space::Position r = random.vector();  // in the hub's frame of the description
    const double m = 1.5 + random();
    mass += spatial::make_mass_properties(m, r, spatial::Tensor::Zero());
    points.push_back({m, to_body * space::Position(to_axis * r - centre)});
  }
  const OutboardMass made = make_outboard_mass(2, mass, to_axis, centre, to_body);
  const OutboardMass expected = sum_of(2, points);
  CHECK(made.place == 2);
  CHECK(made.mass == doctest::Approx(expected.mass).epsilon(1e-14));
  CHECK((made.first - expected.first).norm() <= 1e-13 * expected.first.norm());
  CHECK((made.second - expected.second).norm() <= 1e-13 * expected.second.norm());
}
