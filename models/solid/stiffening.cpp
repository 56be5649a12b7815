#include "models/solid/stiffening.h"

#include <cassert>

namespace spoke::solid {
namespace {

/// Returns the places of nodes, a row each: n x 3 [m].
Eigen::MatrixXd places_by_axis(const std::vector<space::Position>& x) {
  Eigen::MatrixXd columns(static_cast<Eigen::Index>(x.size()), 3);
  for (std::size_t i = 0; i < x.size(); ++i)
    columns.row(static_cast<Eigen::Index>(i)) = x[i].transpose();
  return columns;
}

/// The rows of each axis of shapes by node.
std::array<Eigen::MatrixXd, 3> split_axes(const Eigen::MatrixXd& shapes) {
  std::array<Eigen::MatrixXd, 3> axes;
  const Eigen::Index n = shapes.rows() / 3;
  for (int a = 0; a < 3; ++a) {
    Eigen::MatrixXd& axis = axes[static_cast<std::size_t>(a)];
    axis.resize(n, shapes.cols());
    for (Eigen::Index i = 0; i < n; ++i) axis.row(i) = shapes.row(3 * i + a);
  }
  return axes;
}

/// Projects scalar matrices kg with the pattern of m on shapes: Phi^T (kg (x) 1_3) Phi.
class Projector {
 public:
  Projector(const Sparse& m, const Eigen::MatrixXd& shapes)
      : kg_(m), axes_(split_axes(shapes)), size_(shapes.cols()) {}

  Eigen::MatrixXd project(const Eigen::Ref<const Eigen::VectorXd>& values) {
    assert(values.size() == kg_.nonZeros());
    std::copy(values.begin(), values.end(), kg_.valuePtr());
    Eigen::MatrixXd sum = Eigen::MatrixXd::Zero(size_, size_);
    for (const Eigen::MatrixXd& axis : axes_) {
      const Eigen::MatrixXd product = kg_ * axis;
      sum.noalias() += axis.transpose() * product;
    }
    return 0.5 * (sum + sum.transpose());
  }

 private:
  Sparse kg_;
  std::array<Eigen::MatrixXd, 3> axes_;
  Eigen::Index size_;
};

}  // namespace

Eigen::MatrixXd spin_loads(const Sparse& m, const std::vector<space::Position>& x) {
  const Eigen::MatrixXd mx = m * places_by_axis(x);
  Eigen::MatrixXd loads(3 * m.rows(), space::kSpins);
  for (int k = 0; k < space::kSpins; ++k) {
    const Eigen::Matrix3d A = space::spin_matrix(k);
    for (Eigen::Index i = 0; i < m.rows(); ++i)
      loads.col(k).segment<3>(3 * i) = -A * mx.row(i).transpose();
  }
  return loads;
}

Eigen::MatrixXd translation_loads(const Sparse& m) {
  const Eigen::VectorXd masses = m * Eigen::VectorXd::Ones(m.cols());
  Eigen::MatrixXd loads = Eigen::MatrixXd::Zero(3 * m.rows(), 3);
  for (Eigen::Index i = 0; i < m.rows(); ++i)
    for (int c = 0; c < 3; ++c) loads(3 * i + c, c) = -masses[i];
  return loads;
}

Eigen::MatrixXd place_loads(const space::SolidPlace& place, Eigen::Index coordinates) {
  Eigen::MatrixXd loads = Eigen::MatrixXd::Zero(coordinates, space::kTwist);
  for (std::size_t k = 0; k < place.at.size(); ++k)
    loads.row(place.at[k]) = place.columns[k].transpose();
  return loads;
}

void write_stiffening(const StressMatrices& stresses, const Sparse& m, space::ReducedSolid& solid) {
  Projector projector(m, solid.shapes);
  for (std::size_t k = 0; k < solid.own.size(); ++k)
    solid.own[k] = projector.project(stresses.own.col(static_cast<Eigen::Index>(k)));
  for (std::size_t c = 0; c < solid.translation.size(); ++c)
    solid.translation[c] =
        projector.project(stresses.translation.col(static_cast<Eigen::Index>(c)));
  for (const Eigen::MatrixXd& values : stresses.places) {
    solid.places.emplace_back();
    for (std::size_t c = 0; c < 6; ++c)
      solid.places.back()[c] = projector.project(values.col(static_cast<Eigen::Index>(c)));
  }
}

void write_stiffening(const StressMatrices& stresses, space::NodalSolid& solid) {
  for (std::size_t k = 0; k < solid.own.size(); ++k)
    solid.own[k] = stresses.own.col(static_cast<Eigen::Index>(k));
  for (std::size_t c = 0; c < solid.translation.size(); ++c)
    solid.translation[c] = stresses.translation.col(static_cast<Eigen::Index>(c));
  for (const Eigen::MatrixXd& values : stresses.places) {
    solid.places.emplace_back();
    for (std::size_t c = 0; c < 6; ++c)
      solid.places.back()[c] = values.col(static_cast<Eigen::Index>(c));
  }
}

}  // namespace spoke::solid
