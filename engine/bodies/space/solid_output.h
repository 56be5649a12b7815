#pragma once

// What a solid's coordinates say of its nodes: displacements and stresses, for output and sensors.

#include <Eigen/Core>
#include <Eigen/SparseCore>
#include <array>
#include <cstddef>
#include <vector>

#include "models/space/solid.h"

namespace spoke::space {

/// Stress (xx, yy, zz, yz, xz, xy) [Pa].
using Stress = std::array<double, 6>;
/// Returns the square of the von Mises stress [Pa^2].
double square_von_mises(const Stress& stress) noexcept;
/// Returns the von Mises stress [Pa].
double calc_von_mises(const Stress& stress) noexcept;

/// Maps the coordinates of a solid to displacements and stresses of some of its nodes. Nothing is
/// allocated but by the constructor.
class NodeRecovery {
 public:
  using Dense = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
  using Sparse = Eigen::SparseMatrix<double, Eigen::RowMajor>;
  /// The largest value, and its place among the nodes.
  struct Largest {
    double value = 0.0;
    int at = 0;
  };

  /// Makes the maps of nodes of a solid; stresses only if it has them.
  NodeRecovery(const SolidConstants& solid, const std::vector<int>& nodes);
  /// Makes the maps of all nodes.
  explicit NodeRecovery(const SolidConstants& solid);

  int size() const { return size_; }  ///< number of nodes
  int coordinates() const { return coordinates_; }
  std::size_t bytes() const;  ///< memory of the maps
  bool has_stress() const { return has_stress_; }
  bool is_reduced() const { return is_reduced_; }
  /// Return the maps of a reduced solid: 3 rows by node [m], 6 by node [Pa].
  const Dense& shapes() const { return shapes_; }
  const Dense& stresses() const { return stresses_; }

  // k counts the nodes asked for; q: coordinates, or their rates. Precondition for stresses:
  // has_stress().
  Position displacement(int k, const double* q) const noexcept;  ///< in B [m]
  Stress stress(int k, const double* q) const noexcept;          ///< in B [Pa]
  double von_mises(int k, const double* q) const noexcept { return calc_von_mises(stress(k, q)); }
  /// Returns the largest von Mises stress of these nodes; of equal ones that of the first.
  Largest largest_von_mises(const double* q) const noexcept;

 private:
  int size_ = 0, coordinates_ = 0;
  bool has_stress_ = false, is_reduced_ = false;
  Dense shapes_, stresses_;               ///< of a reduced solid
  Sparse nodal_shapes_, nodal_stresses_;  ///< of a nodal one
};

}  // namespace spoke::space
