#pragma once

// The constant elastic block of a body, Mff or its implicit form, factorised once: two bands, one
// for the axial and one for the bending coordinates.

#include <Eigen/Core>
#include <array>
#include <vector>

#include "models/plane/flexible_body.h"
#include "models/plane/plane.h"
#include "models/support/simd.h"

namespace spoke::plane {

/// L D L^T of a symmetric positive definite band, for solving two right-hand sides at once.
template <int Half>
class BandFactor {
 public:
  BandFactor() = default;
  explicit BandFactor(const SymmetricBand<Half>& matrix);

  int size() const { return n_; }
  /// Returns A^-1 b; with a zero more if n is odd.
  Eigen::VectorXd solve(const Eigen::VectorXd& b) const;

  /// Returns row i of L, left of the diagonal: L(i, i - Half) ... L(i, i - 1), each twice, as a
  /// pair. It is zero left of the matrix; Half rows of zeros follow the last.
  const Double2* row(int i) const { return lower_.data() + Half * i; }
  const double* inverse_diagonal() const { return inverse_diagonal_.data(); }

 private:
  int n_ = 0;
  std::vector<Double2> lower_;
  std::vector<double> inverse_diagonal_;
};

/// A system x = A^-1 a, y = A^-1 b: n values each, x and y 16-byte aligned and with room for one
/// more if n is odd, which is set to zero.
template <int Half>
struct BandSystem {
  const BandFactor<Half>* factor;
  const double* a;
  const double* b;
  double* x;
  double* y;
};

/// Solves the axial and the bending system of a body row by row in turns: each solution is one long
/// chain of dependent operations, and the processor follows both at once. The bending system has
/// twice the rows. `scratch`: 3E pairs.
void solve_together(const BandSystem<1>& axial, const BandSystem<3>& bending,
                    Double2* scratch) noexcept;

/// The constant block Mhat = mass_factor Mff + stiffness_factor K + damping_factor D of a body, D
/// its own damping, factorised, with its constant solutions. An explicit evaluation has factors (1,
/// 0); one of the linearly implicit generalized-alpha adds its step's shares of D and K
/// (docs/formulation.md, section 5).
struct ElasticBlock {
  BandFactor<1> axial;
  BandFactor<3> bending;

  // Axial vectors have a zero more if E is odd, as those of FlexibleBody.
  Eigen::VectorXd W_x;  ///< Mhat^-1 S_x^T, axial: the response to a translation along x
  Eigen::VectorXd W_y;  ///< Mhat^-1 S_y^T, bending (2E)
  double S_Wx = 0.0;    ///< S_x W_x [kg]
  double S_Wy = 0.0;    ///< S_y W_y [kg]

  /// A bending coordinate at a handle, and the response Z = Mhat^-1 e to a unit force on it.
  struct BendingColumn {
    bool outboard = true;
    int component = kRotation;  ///< component of the handle's wrench
    int coordinate = 0;         ///< place among the bending coordinates
    Eigen::VectorXd Z;          ///< 2E
  };
  int axial_coordinate = 0;  ///< u of the outboard node
  Eigen::VectorXd Z_axial;
  std::array<BendingColumn, 2> columns;

  // Compliance of the deformation at the two handles, E_a Mhat^-1 E_b^T. Inboard only the rotation
  // can be free: Z_ii is one number, Z_io one row.
  double Z_ii = 0.0;
  Twist Z_io = Twist::Zero();
  SymmetricTwistMatrix Z_oo;
};

ElasticBlock make_elastic_block(const FlexibleBody& body, double mass_factor,
                                double stiffness_factor, double damping_factor = 0.0);

}  // namespace spoke::plane
