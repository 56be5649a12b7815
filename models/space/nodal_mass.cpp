#include "models/space/nodal_mass.h"

namespace spoke::space {

Eigen::SparseMatrix<double> calc_flexible_mass(const NodalSolid& solid) {
  using Sparse = NodalSolid::Sparse;
  std::vector<Eigen::Triplet<double>> axes[3];
  for (int c = 0; c < solid.Xi.outerSize(); ++c)
    for (Sparse::InnerIterator e(solid.Xi, c); e; ++e)
      axes[e.row() % 3].emplace_back(static_cast<int>(e.row() / 3), c, e.value());
  Sparse sum(solid.Xi.cols(), solid.Xi.cols());
  for (const auto& entries : axes) {
    Sparse Xi(solid.m.rows(), solid.Xi.cols());
    Xi.setFromTriplets(entries.begin(), entries.end());
    sum += Sparse(Sparse(Xi.transpose()) * Sparse(solid.m * Xi));
  }
  return sum;
}

}  // namespace spoke::space
