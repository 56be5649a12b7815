#pragma once

// The constant block Mhat = Mff (+ the implicit shares of K and D) of a solid, factorised once:
// Mhat = L L^T. Of a reduced solid it is diagonal, of one in nodal coordinates sparse.

#include <memory>
#include <optional>
#include <vector>

#include "engine/bodies/space/elastic_block.h"
#include "engine/bodies/space/sparse_factor.h"
#include "engine/bodies/tree/multi_port.h"
#include "models/space/solid.h"
#include "models/space/space.h"

namespace spoke::space {

/// Values of a coordinate in rows of half solutions of four columns.
inline constexpr int kSolidRow = 4;

/// Half solutions y = L^-1 b are kept, as for beams (elastic_block.h).
struct SolidBlock {
  std::vector<double> root;            ///< 1/L of a reduced solid, by mode
  std::optional<SparseFactor> factor;  ///< L of one in nodal coordinates
  std::vector<double> y_C;             ///< L^-1 C_t^T: rows of three and a zero
  Matrix3 C_W = Matrix3::Zero();       ///< C_t Mhat^-1 C_t^T [kg]
  /// By handle: L^-1 E^T, rows of six and two zeros. Empty if the frame fixes the handle.
  std::vector<std::vector<double>> y_E;
  /// By handle: E Mhat^-1 C_t^T.
  std::vector<Eigen::Matrix<double, kTwist, 3, Eigen::DontAlign>> E_W;
  // Products E_a Mhat^-1 E_b^T, in the order of MultiPort.
  std::vector<SymmetricTwistMatrix> Z_diagonal;
  std::vector<TwistMatrix> Z_pairs;
};

/// Values of a coordinate in rows of SolidBlock::y_E.
inline constexpr int kHandleRow = 8;

/// Makes it; factors: of Mff, K and the damping by modes.
SolidBlock make_solid_block(const Solid& body, const BlockFactors& factors);

/// Returns the rows that half solutions take: the coordinates, and the shares of slices.
int count_half_rows(const SolidBlock& block, int coordinates);

/// Solves L y = b for rows of four, in place or not; y has count_half_rows() of them.
void solve_half(const SolidBlock& block, int coordinates, const double* b, double* y) noexcept;
/// Solves L^T x = b in place.
void solve_back(const SolidBlock& block, int coordinates, double* x) noexcept;

}  // namespace spoke::space
