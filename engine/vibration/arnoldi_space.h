#pragma once

// The space of a block Arnoldi iteration.

#include <Eigen/Core>
#include <random>

namespace spoke::vibration {

/// The space that an operator spans from a block of vectors on, with an orthonormal basis. Where
/// the operator leads to nothing new, the space goes on from other vectors, until it is all. The
/// first vectors are random, the same each time.
class ArnoldiSpace {
 public:
  /// Of vectors of `size` values, in blocks of `width`.
  ArnoldiSpace(Eigen::Index size, Eigen::Index width);

  Eigen::Index size() const { return basis_.cols(); }
  bool is_all() const { return basis_.cols() == basis_.rows(); }
  const Eigen::MatrixXd& basis() const { return basis_; }
  const Eigen::MatrixXd& image() const { return image_; }  ///< of the basis, by the operator
  /// The operator as the space has it, in its basis.
  Eigen::MatrixXd projected() const { return basis_.transpose() * image_; }

  /// Adds a block: the last one's image, or what there is room for. `map` is linear, the same each
  /// time, and takes a matrix column by column. The space is not all.
  template <class Operator>
  void grow(const Operator& map) {
    add_block();
    add_image(map * block_);
  }

 private:
  void add_block();
  void add_image(const Eigen::MatrixXd& image);

  std::mt19937 dice_{1};
  Eigen::MatrixXd block_, basis_, image_;
};

}  // namespace spoke::vibration
