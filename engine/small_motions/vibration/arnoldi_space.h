#pragma once

// The space of a block Arnoldi iteration.

#include <Eigen/Core>
#include <random>

namespace spoke::vibration {

/// The space that an operator spans from a block of vectors on, with an orthonormal basis. Where
/// the operator yields nothing new, the space goes on from other vectors, until it is complete. The
/// first vectors are random, the same each time.
class ArnoldiSpace {
 public:
  /// Makes an empty space for vectors of `size` values, in blocks of `width`.
  ArnoldiSpace(Eigen::Index size, Eigen::Index width);

  Eigen::Index size() const { return basis_.cols(); }
  bool is_all() const { return basis_.cols() == basis_.rows(); }
  const Eigen::MatrixXd& basis() const { return basis_; }
  const Eigen::MatrixXd& image() const { return image_; }  ///< the operator times the basis
  /// Returns the projection of the operator on the space, in its basis.
  Eigen::MatrixXd projected() const { return basis_.transpose() * image_; }

  /// Adds a block: the image of the last one, cut to the room that is left. `map` is linear, the
  /// same each time, and takes a matrix column by column. Precondition: the space is not complete.
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
