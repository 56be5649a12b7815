#pragma once

// Matrices in which axial and bending coordinates of a body are coupled, by nodes.

#include <Eigen/Core>
#include <vector>

#include "engine/bodies/plane/flex_layout.h"
#include "models/plane/flexible_body.h"
#include "models/support/simd.h"

namespace spoke::plane {

/// Returns the place of a node's coordinate in the order of nodes, (u, v, psi) of each; -1 for one
/// that the reference frame fixes.
inline int place_by_node(const FlexibleBody& body, int node, int component) {
  if (node < 0 || node > body.elements) return -1;
  if (body.reference_frame == ReferenceFrame::clamped)
    return node == 0 ? -1 : kTwist * (node - 1) + component;
  // A chord frame leaves psi of the first node, and u and psi of the last.
  if (node == 0) return component == kRotation ? 0 : -1;
  const int first = 1 + kTwist * (node - 1);
  if (node < body.elements || component == 0) return first + component;
  return component == kRotation ? first + 1 : -1;
}

/// A symmetric band over the coordinates of a body in the order of nodes: strains of second order
/// tie those of four nodes that follow one another.
class NodalBand {
 public:
  static constexpr int kHalf = 4 * kTwist - 1;

  NodalBand() = default;
  explicit NodalBand(const FlexibleBody& body);

  void set_zero();
  /// Adds at (i, j). Precondition: i - kHalf <= j <= i.
  void add(int i, int j, double value) { row(i)[j] += value; }
  /// y += A x (flex vectors).
  void add_product(const double* x, double* y) const noexcept;
  /// Adds the matrix to one over the coordinates in the order "axial, then bending".
  void add_to(Eigen::Ref<Eigen::MatrixXd> dense) const;

  /// Becomes the factors L D L^T of a + b.
  void factorise(const NodalBand& a, const NodalBand& b) noexcept;
  /// x = A^-1 x by the factors, two columns at once, in the order of nodes.
  void solve(Double2* x) const noexcept;

  int size() const { return static_cast<int>(at_.size()); }
  /// Returns the index of coordinate i in the order "axial, then bending", and its place in flex
  /// vectors.
  int coordinate(int i) const { return coordinate_[static_cast<std::size_t>(i)]; }
  int at(int i) const { return at_[static_cast<std::size_t>(i)]; }
  /// The memory of its values.
  std::vector<double>& values() { return values_; }

 private:
  /// Returns row i, of which the entry of column j stands at [j], from i - kHalf to i.
  double* row(int i) { return values_.data() + kHalf * (i + 1); }
  const double* row(int i) const { return values_.data() + kHalf * (i + 1); }

  std::vector<double> values_;
  std::vector<int> coordinate_, at_;
};

/// Returns Mff.
NodalBand make_mass_band(const FlexibleBody& body);

}  // namespace spoke::plane
