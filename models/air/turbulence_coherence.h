#pragma once

// Random numbers on a grid that are coherent as e^(-c r) with their distance r.

#include <array>
#include <complex>
#include <cstddef>
#include <vector>

#include "models/air/lower_factor.h"
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
  /// Patterns along one axis that are even or odd.
  struct Axis {
    std::size_t points, count;  ///< of the axis; patterns
    double sign;                ///< 1 or -1

    Axis(std::size_t number, bool is_odd);
    /// Returns the weight of a pattern at its two points, which are one in the middle of a row.
    double weight(std::size_t place) const;
    bool is_odd() const { return sign < 0.0; }
  };
  /// The patterns of one symmetry.
  struct Block {
    Axis y, z;
    LowerFactor factor;
    std::vector<std::complex<double>> independent, coherent;  ///< by pattern
  };

  void fill_rows(const Axis& axis);
  void fill(Block& block) const noexcept;
  void add(const Block& block);

  std::size_t n_y_, n_z_;
  bool is_independent_ = true;
  std::vector<double> distances_;  ///< by number of points along z and y [m]
  std::vector<double> table_;      ///< coherence at these
  /// Coherence of even and of odd patterns along y, by the distance of their rows along z.
  std::array<std::vector<double>, 2> rows_;
  std::vector<Block> blocks_;
  std::vector<std::complex<double>> drawn_;
};

}  // namespace spoke::air
