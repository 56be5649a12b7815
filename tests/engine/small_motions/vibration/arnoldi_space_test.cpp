// Compares the space of an Arnoldi iteration with the matrix of its operator.

#include "engine/small_motions/vibration/arnoldi_space.h"

#include <doctest/doctest.h>

#include <Eigen/Eigenvalues>
#include <cmath>

using namespace spoke::vibration;
using Eigen::MatrixXd;

namespace {

// Round-off of a few dozen products of numbers of order one: some 100 units of 2e-16, with a
// margin.
void check_basis(const ArnoldiSpace& space, const MatrixXd& A) {
  const auto size = space.size();
  CHECK((space.basis().transpose() * space.basis() - MatrixXd::Identity(size, size)).norm() <
        1e-13);
  CHECK((space.image() - A * space.basis()).norm() < 1e-13 * A.norm());
}

}  // namespace

TEST_CASE("an Arnoldi space that is all has the eigenvalues of its operator") {
  const MatrixXd root = MatrixXd::NullaryExpr(
      11, 11, [](auto i, auto k) { return std::cos(static_cast<double>(i * i + 3 * k)); });
  const MatrixXd A = root + root.transpose();
  for (const int width : {1, 3}) {
    ArnoldiSpace space(11, width);
    space.grow(A);
    CHECK(space.size() == width);
    check_basis(space, A);
    while (!space.is_all()) space.grow(A);
    check_basis(space, A);
    const MatrixXd projected = space.projected();
    CHECK((Eigen::SelfAdjointEigenSolver<MatrixXd>(projected).eigenvalues() -
           Eigen::SelfAdjointEigenSolver<MatrixXd>(A).eigenvalues())
              .norm() < 1e-12);
  }
}

TEST_CASE("an Arnoldi space goes on where its operator leads to nothing new") {
  const MatrixXd A = 2.0 * MatrixXd::Identity(6, 6);
  ArnoldiSpace space(6, 2);
  while (!space.is_all()) space.grow(A);
  check_basis(space, A);
}
