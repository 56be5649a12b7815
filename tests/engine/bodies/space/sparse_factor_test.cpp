// The sparse Cholesky factor: dense solutions, independence of slices, any order of the slices.

#include "engine/bodies/space/sparse_factor.h"

#include <doctest/doctest.h>

#include <Eigen/Dense>
#include <algorithm>

#include "engine/bodies/space/sparse_solve.h"
#include "models/solid/order_coordinates.h"
#include "tests/engine/bodies/space/lattice_solid.h"

namespace spoke::space {
namespace {

using Rows = Eigen::Matrix<double, Eigen::Dynamic, 4, Eigen::RowMajor>;

Eigen::SparseMatrix<double> identity_and(const NodalSolid& solid) {
  Eigen::SparseMatrix<double> sum = solid.K;
  for (int k = 0; k < sum.cols(); ++k) sum.coeffRef(k, k) += 1e4;
  sum.makeCompressed();
  return sum;
}

NodalSolid make_ordered(const test::Lattice& lattice, int slices) {
  SolidConstants solid = test::make_lattice(lattice);
  solid::order_coordinates(solid, slices);
  return *solid.nodal();
}

Rows pad(const SparseFactor& factor, const Rows& b) {
  Rows y = Rows::Constant(factor.half_rows(), 4, 7.0);
  y.topRows(b.rows()) = b;
  return y;
}

void check_solutions(const NodalSolid& solid) {
  const Eigen::SparseMatrix<double> matrix = identity_and(solid);
  const Eigen::MatrixXd dense = matrix;
  const SparseFactor factor = factorise(matrix, solid.slices);
  const auto n = static_cast<Eigen::Index>(factor.size);
  const Eigen::MatrixXd L = Eigen::LLT<Eigen::MatrixXd>(dense).matrixL();
  const Rows b = Rows::Random(n, 4);
  Rows y = pad(factor, b);
  solve_half(factor, y.data(), y.data());
  const Rows expected = L.triangularView<Eigen::Lower>().solve(b);
  CHECK((y.topRows(n) - expected).norm() < 1e-12 * expected.norm());
  Eigen::VectorXd x = Eigen::VectorXd::Random(n);
  const Eigen::VectorXd back = L.transpose().triangularView<Eigen::Upper>().solve(x);
  solve_back(factor, x.data());
  CHECK((x - back).norm() < 1e-12 * back.norm());
}

}  // namespace

TEST_CASE("sparse factor: solutions are those of a dense one") {
  for (const int slices : {1, 2, 4, 8}) {
    CAPTURE(slices);
    check_solutions(make_ordered({24, 2, 2, true}, slices));
    check_solutions(make_ordered({24, 1, 2, false}, slices));
  }
  check_solutions(*test::make_lattice({6, 2, 2, true}).nodal());  // in no order, without slices
  check_solutions(make_ordered({1, 1, 1, true}, 16));
}

TEST_CASE("sparse factor: slices stand alone, in any order, with the same bits") {
  const NodalSolid solid = make_ordered({32, 2, 2, true}, 8);
  REQUIRE(solid.slices.size() == 9);
  const SparseFactor factor = factorise(identity_and(solid), solid.slices);
  REQUIRE(factor.slices.size() == 8);
  const Rows b = Rows::Random(factor.size, 4);
  Rows y = pad(factor, b), z = pad(factor, b);
  solve_half(factor, y.data(), y.data());
  for (const int p : {3, 0, 7, 6, 1, 5, 2, 4}) solve_half_slice(factor, p, b.data(), z.data());
  solve_half_between(factor, b.data(), z.data());
  CHECK(y == z);
  Eigen::VectorXd x = Eigen::VectorXd::Random(factor.size), w = x;
  solve_back(factor, x.data());
  solve_back_between(factor, w.data());
  for (const int p : {3, 0, 7, 6, 1, 5, 2, 4}) solve_back_slice(factor, p, w.data());
  CHECK(x == w);
}

TEST_CASE("sparse factor: cuts of a bar are its cross sections, wherever its axis lies") {
  for (const test::Lattice& lattice :
       {test::Lattice{32, 2, 1, true}, test::Lattice{40, 1, 2, false}}) {
    SolidConstants solid = test::make_lattice(lattice);
    solid::order_coordinates(solid, 4);
    const int between = solid.coordinates - solid.nodal()->slices.back();
    CHECK(between == 3 * 3 * 6);  // three planes of six nodes
    const std::vector<int>& slices = solid.nodal()->slices;
    for (std::size_t p = 0; p + 1 < slices.size(); ++p) {
      CHECK(slices[p + 1] - slices[p] > solid.coordinates / 6);
      CHECK(slices[p + 1] - slices[p] < solid.coordinates / 3);
    }
  }
}

TEST_CASE("order of coordinates: matrices and places follow it") {
  const SolidConstants before = test::make_lattice({12, 2, 2, true});
  SolidConstants after = before;
  solid::order_coordinates(after, 2);
  const NodalSolid &a = *before.nodal(), &b = *after.nodal();
  // Of the tip's six coordinates the places tell where they have gone.
  Eigen::VectorXd x = Eigen::VectorXd::Zero(before.coordinates), y = x;
  for (std::size_t k = 0; k < 6; ++k) {
    x[before.places[1].at[k]] = before.places[1].columns[k].dot(Twist::LinSpaced(1.0, 6.0));
    y[after.places[1].at[k]] = after.places[1].columns[k].dot(Twist::LinSpaced(1.0, 6.0));
  }
  CHECK(std::is_sorted(after.places[1].at.begin(), after.places[1].at.end()));
  CHECK((a.Xi * x - b.Xi * y).norm() == 0.0);
  CHECK(x.dot(a.K * x) == doctest::Approx(y.dot(b.K * y)).epsilon(1e-13));
  CHECK(Eigen::MatrixXd(b.K).trace() ==
        doctest::Approx(Eigen::MatrixXd(a.K).trace()).epsilon(1e-13));
  // C_t, which is derived in the new order, yields the momentum of the nodes.
  set_derived(after);
  const Eigen::VectorXd u = b.Xi * y, me = b.m * Eigen::VectorXd::Ones(b.m.cols());
  for (int axis = 0; axis < 3; ++axis) {
    const double momentum = me.dot(u(Eigen::seqN(axis, me.size(), 3)));
    CHECK(after.C_t().col(axis).dot(y) == doctest::Approx(momentum).epsilon(1e-13));
  }
}

}  // namespace spoke::space
