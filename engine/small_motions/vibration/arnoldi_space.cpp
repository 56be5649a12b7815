// Keeps the basis orthonormal.

#include "engine/small_motions/vibration/arnoldi_space.h"

#include <algorithm>
#include <cassert>

namespace spoke::vibration {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// Takes the part of a block that lies in a basis out of it.
void project_out(const MatrixXd& basis, MatrixXd& block) {
  block.noalias() -= basis * (basis.transpose() * block).eval();
}

/// Makes the columns of a block orthonormal to one another and to a basis. A column that depends on
/// others is replaced by a random one.
void orthonormalise(const MatrixXd& basis, std::mt19937& dice, MatrixXd& block) {
  std::normal_distribution<double> normal;
  for (int twice = 0; twice < 2; ++twice) {
    VectorXd before = block.colwise().norm();
    project_out(basis, block);
    for (Index k = 0; k < block.cols(); ++k)
      for (int trial = 0; trial < 3; ++trial) {
        VectorXd column = block.col(k);
        for (int again = 0; again < 2; ++again)
          column -= block.leftCols(k) * (block.leftCols(k).transpose() * column);
        const double after = column.norm();
        block.col(k) = column / after;
        if (after > 1e-12 * before[k]) break;
        MatrixXd thrown = MatrixXd::NullaryExpr(block.rows(), 1, [&] { return normal(dice); });
        project_out(basis, thrown);
        block.col(k) = thrown;
        before[k] = thrown.norm();
      }
  }
}

}  // namespace

ArnoldiSpace::ArnoldiSpace(Index size, Index width)
    : block_(size, width), basis_(size, 0), image_(size, 0) {
  assert(width > 0 && width <= size);
  std::normal_distribution<double> normal;
  for (Index k = 0; k < width; ++k)
    for (Index i = 0; i < size; ++i) block_(i, k) = normal(dice_);
}

void ArnoldiSpace::add_block() {
  assert(!is_all());
  const Index rows = basis_.rows(), used = basis_.cols();
  block_.conservativeResize(rows, std::min(block_.cols(), rows - used));
  orthonormalise(basis_, dice_, block_);
  basis_.conservativeResize(rows, used + block_.cols());
  basis_.rightCols(block_.cols()) = block_;
}

void ArnoldiSpace::add_image(const MatrixXd& image) {
  assert(image.rows() == basis_.rows() && image.cols() <= basis_.cols());
  image_.conservativeResize(basis_.rows(), basis_.cols());
  image_.rightCols(image.cols()) = image;
  block_ = image;
}

}  // namespace spoke::vibration
