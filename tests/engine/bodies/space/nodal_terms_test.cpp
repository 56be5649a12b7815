// Terms of a solid in the coordinates of its nodes against their definitions in dense matrices.

#include "engine/bodies/space/nodal_terms.h"

#include <doctest/doctest.h>

#include <Eigen/Dense>

#include "models/solid/order_coordinates.h"
#include "models/space/nodal_mass.h"
#include "tests/engine/bodies/space/lattice_solid.h"

namespace spoke::space {
namespace {

using Rows = Eigen::Matrix<double, Eigen::Dynamic, 4, Eigen::RowMajor>;
using Nodes = Eigen::Matrix<double, Eigen::Dynamic, 3, Eigen::RowMajor>;

struct State {
  Eigen::VectorXd q, v, q_elastic, v_elastic;
  Angular w{1.3, -0.7, 2.1};
  Damping damping;

  explicit State(int n)
      : q(0.01 * Eigen::VectorXd::Random(n)),
        v(Eigen::VectorXd::Random(n)),
        q_elastic(0.01 * Eigen::VectorXd::Random(n)),
        v_elastic(Eigen::VectorXd::Random(n)) {}
};

std::vector<Eigen::VectorXd> make_forms(const NodalSolid& solid) {
  std::vector<Eigen::VectorXd> forms;
  for (int k = 0; k < 9; ++k) {
    Eigen::SparseMatrix<double> kg = solid.m;
    const double factor = 1.0 + k;
    for (int j = 0; j < kg.outerSize(); ++j)
      for (Eigen::SparseMatrix<double>::InnerIterator e(kg, j); e; ++e)
        e.valueRef() = std::cos(factor * static_cast<double>(e.row() + j + e.row() * j));
    forms.push_back(Eigen::Map<Eigen::VectorXd>(kg.valuePtr(), kg.nonZeros()));
  }
  return forms;
}

const std::vector<double>& weights() {
  static const std::vector<double> values{1.7, -0.4, 0.9, 2.2, -1.1, 0.3, 5.0, -9.81, 0.6};
  return values;
}

/// The terms, and the order in which tiles are done.
struct Evaluated {
  NodalTiles tiles;
  std::vector<double> rows, memory;
  NodalSums sums;
  std::vector<double> forms;

  Evaluated(const SolidConstants& solid, const State& s, bool is_reversed)
      : tiles(make_nodal_tiles(solid, make_forms(*solid.nodal()))),
        rows(static_cast<std::size_t>(4 * tiles.rows()), 99.0),
        memory(count_nodal_work(tiles), 99.0) {
    const NodalWork work = place_nodal_work(tiles, rows.data(), memory.data());
    const BodyState state{s.q.data(), s.v.data(), s.q_elastic.data(), s.v_elastic.data()};
    for (int k = 0; k < tiles.count(); ++k)
      calc_tile_terms(tiles, is_reversed ? tiles.count() - 1 - k : k, state, s.w, s.damping,
                      weights().data(), work);
    sums = sum_tile_terms(tiles, work);
    const double* total = total_forms(tiles, work);
    forms.assign(total, total + 18);
    rows.resize(static_cast<std::size_t>(4 * tiles.coordinates));
  }
};

Nodes by_node(const Eigen::VectorXd& u) {
  return Eigen::Map<const Nodes>(u.data(), u.size() / 3, 3);
}
Eigen::VectorXd stack(const Nodes& u) {
  return Eigen::Map<const Eigen::VectorXd>(u.data(), u.size());
}

void check(const SolidConstants& solid, const State& s) {
  const NodalSolid& nodal = *solid.nodal();
  const Eigen::MatrixXd Xi = nodal.Xi, m = nodal.m, K = nodal.K;
  Nodes x(m.rows(), 3);
  for (Eigen::Index i = 0; i < m.rows(); ++i)
    x.row(i) = solid.nodes[static_cast<std::size_t>(i)].transpose();
  const Nodes u = by_node(Xi * s.q), r = x + u, rate = by_node(Xi * s.v);
  const Nodes mu = m * r, mu_rate = m * rate;
  const Evaluated terms(solid, s, false);
  const auto is_near = [](const auto& a, const auto& b) {
    return (a - b).norm() <= 1e-12 * (1.0 + b.norm());
  };
  CHECK(is_near(terms.sums.S, Position(mu.colwise().sum())));
  CHECK(is_near(terms.sums.S_rate, Position(mu_rate.colwise().sum())));
  CHECK(is_near(terms.sums.J, Matrix3(r.transpose() * mu)));
  CHECK(is_near(terms.sums.G, Matrix3(r.transpose() * mu_rate)));

  const Matrix3 A = s.w * s.w.transpose() - s.w.squaredNorm() * Matrix3::Identity();
  Nodes b = -(mu * A.transpose());
  for (Eigen::Index i = 0; i < b.rows(); ++i)
    b.row(i) -= 2.0 * cross(s.w, Position(mu_rate.row(i))).transpose();
  const std::vector<Eigen::VectorXd> forms = make_forms(nodal);
  for (std::size_t k = 0; k < 9; ++k) {
    Eigen::SparseMatrix<double> kg = nodal.m;
    std::copy_n(forms[k].data(), kg.nonZeros(), kg.valuePtr());
    const Nodes force = kg * u;
    b -= weights()[k] * force;
    CHECK(terms.forms[k] == doctest::Approx(stack(u).dot(stack(force))).epsilon(1e-9));
    CHECK(terms.forms[9 + k] == doctest::Approx(stack(rate).dot(stack(force))).epsilon(1e-9));
  }
  Rows expected(solid.coordinates, 4);
  for (int a = 0; a < 3; ++a) {
    Nodes turned(mu.rows(), 3);
    for (Eigen::Index i = 0; i < mu.rows(); ++i)
      turned.row(i) = cross(Position(Position::Unit(a)), Position(mu.row(i))).transpose();
    expected.col(a) = Xi.transpose() * stack(turned);
  }
  Eigen::MatrixXd D = s.damping.stiffness_factor * K;
  D += s.damping.mass_factor * Eigen::MatrixXd(calc_flexible_mass(nodal));
  expected.col(3) = Xi.transpose() * stack(b) - K * s.q_elastic - D * s.v_elastic;
  CHECK(is_near(Eigen::Map<const Rows>(terms.rows.data(), solid.coordinates, 4), expected));
  CHECK(terms.sums.dissipation == doctest::Approx(s.v.dot(D * s.v)).epsilon(1e-12));

  const Evaluated again(solid, s, true);
  CHECK(again.rows == terms.rows);
  CHECK(again.forms == terms.forms);
  CHECK(again.sums.J == terms.sums.J);
}

}  // namespace

TEST_CASE("nodal solid: Mff is Xi^T (m (x) 1) Xi") {
  const SolidConstants solid = test::make_lattice({3, 1, 2, true});
  const Eigen::MatrixXd Xi = solid.nodal()->Xi, m = solid.nodal()->m;
  Eigen::MatrixXd wide = Eigen::MatrixXd::Zero(Xi.rows(), Xi.rows());
  for (Eigen::Index i = 0; i < m.rows(); ++i)
    for (Eigen::Index j = 0; j < m.cols(); ++j)
      wide.block<3, 3>(3 * i, 3 * j) = m(i, j) * Eigen::Matrix3d::Identity();
  const Eigen::MatrixXd expected = Xi.transpose() * wide * Xi;
  CHECK((Eigen::MatrixXd(calc_flexible_mass(*solid.nodal())) - expected).norm() <
        1e-13 * expected.norm());
}

TEST_CASE("nodal solid: tiles yield the terms of the definition, in any order with the same bits") {
  for (const bool has_rigid_end : {true, false})
    for (const int slices : {1, 2, 4, 8}) {
      CAPTURE(has_rigid_end);
      CAPTURE(slices);
      SolidConstants solid = test::make_lattice({24, 1, 2, has_rigid_end});
      solid::order_coordinates(solid, slices);
      State state(solid.coordinates);
      check(solid, state);
      state.damping = {0.3, 2e-4};
      check(solid, state);
    }
  const SolidConstants unordered = test::make_lattice({4, 2, 1, true});
  check(unordered, State(unordered.coordinates));
}

}  // namespace spoke::space
