#pragma once

// The shift of nodes along the axis on the left-hand side of an implicit step: strains of second
// order depend on u* = u - psi(q) (nonlinear_strain.h), and psi ties nodes that are not neighbours.
// In the coordinates q* the matrix is block-tridiagonal; with Psi = dpsi/dq and S = 1 + Psi,
//   Mhat = S^-T Mhat* S^-1,   S^-1 = 1 - Psi,
// so that each right-hand side is taken by S^T before, and each solution by S after. S^-1 is exact:
// psi moves nodes along the elements as they stand, and does not depend on places along these.

#include <array>
#include <vector>

#include "models/space/vectors.h"

namespace spoke::space {

struct ImplicitShift {
  /// Derivatives of psi of a node by the coordinates of its neighbours and its own, from the inner
  /// one; zero for coordinates that the frame fixes, whose values are not read, and at both ends of
  /// the body.
  struct Node {
    Position axis = Position::Zero();  ///< where psi moves the node to, about 1 long
    std::array<double, 3 * kTwist> gradient{};
  };
  std::vector<Node> nodes;

  /// x = S x, values by node.
  void apply(double* x) const { add(1.0, x); }
  /// x = S^-1 x.
  void apply_inverse(double* x) const { add(-1.0, x); }
  /// b = S^T b, `kColumns` values a row, six rows a node.
  template <int kColumns>
  void apply_transposed(double* b) const {
    add_transposed<kColumns>(1.0, b);
  }
  /// The same of rows that begin at node `from`, all zero but for those of node `from` or of the
  /// next one, `node`.
  template <int kColumns>
  void apply_transposed(int node, int from, double* b) const {
    add_node_transposed<kColumns>(1.0, static_cast<std::size_t>(node),
                                  static_cast<std::size_t>(from), b);
  }
  /// b = S^-T b.
  void apply_inverse_transposed(double* b) const { add_transposed<1>(-1.0, b); }

 private:
  void add(double sign, double* x) const {
    for (std::size_t k = 1; k + 1 < nodes.size(); ++k) {
      const Node& node = nodes[k];
      const double* from = x + kTwist * (k - 1);
      double psi = 0.0;
      for (std::size_t i = 0; i < node.gradient.size(); ++i)
        if (node.gradient[i] != 0.0) psi += node.gradient[i] * from[i];
      for (int c = 0; c < kPosition; ++c)
        x[kTwist * k + static_cast<std::size_t>(c)] += sign * psi * node.axis[c];
    }
  }
  template <int kColumns>
  void add_transposed(double sign, double* b) const {
    for (std::size_t k = 1; k + 1 < nodes.size(); ++k)
      add_node_transposed<kColumns>(sign, k, k - 1, b + kTwist * kColumns * (k - 1));
  }
  /// Node k alone, of rows that begin at node `from`, k - 1 or k.
  template <int kColumns>
  void add_node_transposed(double sign, std::size_t k, std::size_t from, double* b) const {
    const Node& node = nodes[k];
    const double* own = b + kTwist * kColumns * (k - from);
    double along[kColumns];
    for (int j = 0; j < kColumns; ++j) {
      along[j] = 0.0;
      for (int c = 0; c < kPosition; ++c) along[j] += node.axis[c] * own[kColumns * c + j];
    }
    const std::size_t first = kTwist * (from + 1 - k);
    for (std::size_t i = first; i < node.gradient.size(); ++i, b += kColumns)
      for (int j = 0; node.gradient[i] != 0.0 && j < kColumns; ++j)
        b[j] += sign * node.gradient[i] * along[j];
  }
};

}  // namespace spoke::space
