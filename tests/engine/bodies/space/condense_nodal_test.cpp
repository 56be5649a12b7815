// A solid in nodal coordinates, condensed and recovered by slices, against one dense system.

#include <doctest/doctest.h>

#include <Eigen/Dense>

#include "engine/bodies/kinds/solid/condense_solid.h"
#include "engine/bodies/kinds/solid/solid_places.h"
#include "engine/bodies/space/nodal_memory.h"
#include "models/solid/order_coordinates.h"
#include "models/space/nodal_mass.h"
#include "tests/engine/bodies/space/lattice_solid.h"

namespace spoke::space {
namespace {

/// A lattice in slices, held at both ends, in some state.
struct CondensedLattice {
  Solid body;
  BlockFactors factors{1.1, 0.02, 0.0};
  SolidBlock block;
  NodalTiles tiles;
  NodalMemory memory;
  std::vector<double> storage;
  BodyWork work;
  BodyTerms terms;
  Angular w{0.3, -0.5, 0.9};

  CondensedLattice(const test::Lattice& lattice, int slices) {
    SolidConstants constants = test::make_lattice(lattice);
    solid::order_coordinates(constants, slices);
    set_derived(constants);
    body.constants = std::make_shared<const SolidConstants>(std::move(constants));
    body.handles = {0, 1, 1};  // a child, and a loop at the same place
    block = make_solid_block(body, factors);
    tiles = make_nodal_tiles(*body.constants, nullptr);
    storage.resize(count_work(body) + 2);
    work = place_work(body, storage.data());
    place_nodal_work(body, tiles, block, block, memory, work);
    set_state();
  }

  int n() const { return body.coordinates(); }

  void set_state() {
    const Eigen::VectorXd q = 0.02 * Eigen::VectorXd::Random(n()), v = Eigen::VectorXd::Random(n());
    calc_handles(body, q.data(), v.data(), work.handles);
    const SolidConstants& constants = *body.constants;
    terms.S = constants.S0;
    terms.Theta = constants.J0.trace() * Matrix3::Identity() - constants.J0;
    terms.Q = Twist::Random();
    for (int k = 0; k < n(); ++k)
      for (int c = 0; c < 4; ++c)
        work.rows[4 * k + c] = (c < 3 ? 0.1 : 50.0) * std::sin(3.0 * k + 1.7 * c);
  }

  /// The matrix of (X; q'').
  Eigen::MatrixXd dense_mass() const {
    Eigen::MatrixXd M(kTwist + n(), kTwist + n());
    M.setZero();
    M.topLeftCorner<3, 3>() = body.constants->mass * Matrix3::Identity();
    M.block<3, 3>(0, 3) = -skew(terms.S);
    M.block<3, 3>(3, 0) = skew(terms.S);
    M.block<3, 3>(3, 3) = terms.Theta;
    for (int k = 0; k < n(); ++k) {
      M.block<1, 3>(kTwist + k, 0) = body.constants->C_t().row(k);
      for (int c = 0; c < 3; ++c) M(kTwist + k, 3 + c) = work.rows[4 * k + c];
    }
    M.topRightCorner(kTwist, n()) = M.bottomLeftCorner(n(), kTwist).transpose();
    const NodalSolid& nodal = *body.constants->nodal();
    M.bottomRightCorner(n(), n()) = factors.mass * Eigen::MatrixXd(calc_flexible_mass(nodal)) +
                                    factors.stiffness * Eigen::MatrixXd(nodal.K);
    return M;
  }
  Eigen::MatrixXd jacobian(std::size_t h) const {
    Eigen::MatrixXd J = Eigen::MatrixXd::Zero(kTwist, kTwist + n());
    const HandleMotion& motion = work.handles[h];
    J.leftCols<kTwist>().setIdentity();
    J.block<3, 3>(0, 3) = -skew(motion.s);
    const SolidPlace& place = body.handle(h);
    for (std::size_t i = 0; i < place.at.size(); ++i) {
      J.col(kTwist + place.at[i]).head<3>() = linear(place.columns[i]);
      J.col(kTwist + place.at[i]).tail<3>() = motion.turn.H * angular(place.columns[i]);
    }
    return J;
  }
};

void check(CondensedLattice& lattice) {
  BodyWork& work = lattice.work;
  const int n = lattice.n();
  condense_solid(lattice.body, lattice.block, lattice.terms, lattice.w, work);
  const std::vector<Twist> wrenches{40.0 * Twist::Random(), 30.0 * Twist::Random(),
                                    20.0 * Twist::Random()};
  Eigen::VectorXd a(n);
  const Twist X = recover_solid(lattice.body, lattice.block, wrenches.data(), work, a.data());

  Eigen::VectorXd force(kTwist + n);
  force.head<kTwist>() = lattice.terms.Q;
  for (int k = 0; k < n; ++k) force[kTwist + k] = work.rows[4 * k + 3];
  for (std::size_t h = 0; h < 3; ++h) force += lattice.jacobian(h).transpose() * wrenches[h];
  const Eigen::VectorXd x = lattice.dense_mass().ldlt().solve(force);
  CHECK((X - x.head<kTwist>()).norm() < 1e-9 * x.head<kTwist>().norm());
  CHECK((a - x.tail(n)).norm() < 1e-9 * x.tail(n).norm());

  for (std::size_t h = 0; h < 3; ++h) {
    Twist found = work.port.free[h];
    for (std::size_t b = 0; b < 3; ++b) {
      const auto i = static_cast<int>(h), j = static_cast<int>(b);
      if (i == j) found += work.port.diagonal[h] * wrenches[b];
      if (i < j) found += work.port.between(i, j) * wrenches[b];
      if (i > j) found += work.port.between(j, i).transpose() * wrenches[b];
    }
    const Twist expected = lattice.jacobian(h) * x + work.handles[h].bias(lattice.w);
    CHECK((found - expected).norm() < 1e-9 * (1.0 + expected.norm()));
  }
}

}  // namespace

TEST_CASE("nodal solid: condensing by slices is elimination from the dense system") {
  for (const bool has_rigid_end : {true, false})
    for (const int slices : {1, 2, 4}) {
      CAPTURE(has_rigid_end);
      CAPTURE(slices);
      CondensedLattice lattice({24, 1, 1, has_rigid_end}, slices);
      REQUIRE(lattice.tiles.count() == slices);
      check(lattice);
    }
}

TEST_CASE("nodal solid: slices are condensed and recovered in any order with the same bits") {
  CondensedLattice a({24, 1, 1, true}, 4), b({24, 1, 1, true}, 4);
  std::copy_n(a.work.rows, 4 * a.n(), b.work.rows);
  b.terms = a.terms;
  std::copy_n(a.work.handles, 3, b.work.handles);
  const std::vector<Twist> wrenches(3, Twist::LinSpaced(1.0, 6.0));
  condense_solid(a.body, a.block, a.terms, a.w, a.work);
  std::vector<double> whole(static_cast<std::size_t>(a.n()));
  recover_solid(a.body, a.block, wrenches.data(), a.work, whole.data());
  for (const int p : {2, 0, 3, 1}) condense_slice(b.body, b.block, p, b.work);
  condense_between(b.body, b.block, b.terms, b.w, b.work);
  const Twist X = recover_between(b.body, b.block, wrenches.data(), b.work);
  for (const int p : {1, 3, 0, 2}) recover_slice(b.body, b.block, p, X, wrenches.data(), b.work);
  CHECK(std::equal(whole.begin(), whole.end(), b.work.solution));
  CHECK(a.work.port.free[1] == b.work.port.free[1]);
}

}  // namespace spoke::space
