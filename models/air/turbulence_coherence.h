#pragma once

// Random numbers on a grid that are coherent as e^(-c r) with their distance r.

#include <Eigen/Core>
#include <complex>
#include <cstddef>
#include <vector>

#include "models/air/turbulence_random.h"

namespace spoke::air {

/// Draws coherent random phasors on a grid of points. The coherence matrix of a grid does not
/// change where the grid is mirrored in either of its axes: on the grid's symmetric and
/// antisymmetric patterns it falls into four blocks, whose Cholesky factors cost a sixteenth of
/// the whole one's.
class CoherentDraw {
 public:
  /// Makes the draw for a grid of n_y by n_z points, dy and dz apart [m].
  CoherentDraw(std::size_t n_y, std::size_t n_z, double dy, double dz);

  /// Factorises the coherence e^(-rate r) [1/m]. Returns false if rounding makes it singular.
  bool factorise(double rate);
  /// Draws one complex number for each point, row by row (z outer): zero on average, of unit mean
  /// square, and coherent.
  const std::vector<std::complex<double>>& draw(RandomStream& random);

 private:
  /// The patterns of one symmetry: even or odd along each axis.
  struct Block {
    bool is_odd_y, is_odd_z;
    std::size_t count_y, count_z;            ///< patterns along each axis
    Eigen::MatrixXd factor;                  ///< lower triangle
    Eigen::MatrixX2d independent, coherent;  ///< by pattern: real and imaginary part
  };

  double coherence(std::size_t y, std::size_t other_y, std::size_t z, std::size_t other_z) const;
  double entry(const Block& block, std::size_t row, std::size_t column) const;
  void add(const Block& block);
  /// Returns the weight of a pattern at its two points, which are one in the middle of a row.
  static double weight(std::size_t place, std::size_t count);

  std::size_t n_y_, n_z_;
  double dy_, dz_;
  bool is_independent_ = true;
  std::vector<double> table_;  ///< coherence by distance along z and y, in points
  std::vector<Block> blocks_;
  std::vector<std::complex<double>> drawn_;
};

}  // namespace spoke::air
