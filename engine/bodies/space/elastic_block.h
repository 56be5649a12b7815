#pragma once

// The constant block Mhat = Mff (+ the implicit shares of K and D) of a spatial body, factorised
// once, or anew with the tension of another speed: Mhat = L L^T by blocks of six, a node each.

#include <vector>

#include "engine/bodies/space/implicit_shift.h"
#include "engine/bodies/tree/multi_port.h"
#include "models/space/flexible_body.h"
#include "models/space/space.h"

namespace spoke::space {

/// Factors of Mff, K and the damping D in Mhat, which is that of sections or of a solid's modes. An
/// explicit evaluation has (1, 0, 0).
struct BlockFactors {
  double mass = 1.0;
  double stiffness = 0.0;
  double damping = 0.0;
};

/// Solutions are kept half done, y = L^-1 b: a product a^T Mhat^-1 b is that of two halves, so that
/// only the accelerations themselves are ever carried through L^T.
struct ElasticBlock {
  static constexpr int kBlock = kTwist * kTwist;

  /// By node, row by row. Rows and columns of coordinates that the frame fixes are those of the
  /// identity; nodes before the body's first_node() are unused.
  std::vector<double> inverse;  ///< inverse of L's diagonal block; zero right of the diagonal
  std::vector<double> below;    ///< L's block (k, k - 1)

  std::vector<double> W_t;        ///< L^-1 C_t^T: 3 columns, row by row
  Matrix3 C_W = Matrix3::Zero();  ///< C_t Mhat^-1 C_t^T [kg]
  /// By handle: L^-1 E^T for the six coordinates of its node, row by row, from first_of_handle()
  /// on. Empty if the frame fixes all of them.
  std::vector<std::vector<double>> Z;
  std::vector<NodeMomentum> Z_W;  ///< by handle: E Mhat^-1 C_t^T
  // Products E_a Mhat^-1 E_b^T, in the order of MultiPort.
  std::vector<SymmetricTwistMatrix> Z_diagonal;
  std::vector<TwistMatrix> Z_pairs;

  const double* inverse_of(int node) const { return &inverse[at(node)]; }
  const double* below_of(int node) const { return &below[at(node)]; }

 private:
  static std::size_t at(int node) { return static_cast<std::size_t>(node) * kBlock; }
};

/// Returns the node from which on the solutions of a handle stand: its own, or where strains of
/// second order shift nodes between others (implicit_shift.h), the one before.
int first_of_handle(const FlexibleBody& body, std::size_t handle);

ElasticBlock make_elastic_block(const FlexibleBody& body, const BlockFactors& factors);
/// Makes such a block anew of Mhat + `added`, in its memory. Returns whether the sum is positive
/// definite; if not, the block is not to be used. Preconditions: the block is one of the body's,
/// and `added` is symmetric over the body's nodes. `shift`: that of the block, whose matrix this is
/// in shifted coordinates; null: none.
bool factorise_anew(const FlexibleBody& body, const BlockFactors& factors,
                    const BlockTridiagonal& added, const ImplicitShift* shift,
                    ElasticBlock& block) noexcept;

}  // namespace spoke::space
