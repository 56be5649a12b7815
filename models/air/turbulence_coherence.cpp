// Factorises coherence on the symmetric and antisymmetric patterns of a grid.

#include "models/air/turbulence_coherence.h"

#include <Eigen/Cholesky>
#include <cmath>

namespace spoke::air {
namespace {

/// Below this coherence of neighbours, points are independent.
constexpr double kIndependent = 1e-8;

}  // namespace

double CoherentDraw::weight(std::size_t place, std::size_t count) {
  return 2 * place + 1 == count ? 0.5 : std::sqrt(0.5);
}

CoherentDraw::CoherentDraw(std::size_t n_y, std::size_t n_z, double dy, double dz)
    : n_y_(n_y), n_z_(n_z), dy_(dy), dz_(dz), table_(n_y * n_z), drawn_(n_y * n_z) {
  for (const bool is_odd_z : {false, true})
    for (const bool is_odd_y : {false, true}) {
      // An odd pattern is 0 in the middle of a row.
      const std::size_t count_y = is_odd_y ? n_y / 2 : (n_y + 1) / 2;
      const std::size_t count_z = is_odd_z ? n_z / 2 : (n_z + 1) / 2;
      const auto size = static_cast<Eigen::Index>(count_y * count_z);
      blocks_.push_back({is_odd_y, is_odd_z, count_y, count_z, Eigen::MatrixXd(size, size),
                         Eigen::MatrixX2d(size, 2), Eigen::MatrixX2d(size, 2)});
    }
}

double CoherentDraw::coherence(std::size_t y, std::size_t other_y, std::size_t z,
                               std::size_t other_z) const {
  const std::size_t k = z > other_z ? z - other_z : other_z - z;
  const std::size_t j = y > other_y ? y - other_y : other_y - y;
  return table_[k * n_y_ + j];
}

/// Returns the coherence of two patterns, each of which is its points' numbers times weight and
/// sign: twice the sum for one of the first's points along each axis, by symmetry.
double CoherentDraw::entry(const Block& block, std::size_t row, std::size_t column) const {
  const std::size_t y = row % block.count_y, z = row / block.count_y;
  const std::size_t other_y = column % block.count_y, other_z = column / block.count_y;
  const std::size_t mirror_y = n_y_ - 1 - other_y, mirror_z = n_z_ - 1 - other_z;
  const double sign_y = block.is_odd_y ? -1.0 : 1.0;
  const double sign_z = block.is_odd_z ? -1.0 : 1.0;
  const double sum =
      coherence(y, other_y, z, other_z) + sign_y * coherence(y, mirror_y, z, other_z) +
      sign_z * (coherence(y, other_y, z, mirror_z) + sign_y * coherence(y, mirror_y, z, mirror_z));
  return 4.0 * weight(y, n_y_) * weight(other_y, n_y_) * weight(z, n_z_) * weight(other_z, n_z_) *
         sum;
}

bool CoherentDraw::factorise(double rate) {
  for (std::size_t k = 0; k < n_z_; ++k)
    for (std::size_t j = 0; j < n_y_; ++j)
      table_[k * n_y_ + j] =
          std::exp(-rate * std::hypot(static_cast<double>(j) * dy_, static_cast<double>(k) * dz_));
  is_independent_ = table_[1] < kIndependent && table_[n_y_] < kIndependent;
  if (is_independent_) return true;
  for (Block& block : blocks_) {
    const std::size_t size = block.count_y * block.count_z;
    for (std::size_t column = 0; column < size; ++column)
      for (std::size_t row = column; row < size; ++row)
        block.factor(static_cast<Eigen::Index>(row), static_cast<Eigen::Index>(column)) =
            entry(block, row, column);
    const Eigen::LLT<Eigen::Ref<Eigen::MatrixXd>> in_place(block.factor);
    if (in_place.info() != Eigen::Success) return false;
  }
  return true;
}

/// Adds a block's patterns to the points.
void CoherentDraw::add(const Block& block) {
  const double sign_y = block.is_odd_y ? -1.0 : 1.0;
  const double sign_z = block.is_odd_z ? -1.0 : 1.0;
  for (std::size_t z = 0; z < block.count_z; ++z)
    for (std::size_t y = 0; y < block.count_y; ++y) {
      const auto pattern = static_cast<Eigen::Index>(z * block.count_y + y);
      const std::complex<double> value =
          std::complex(block.coherent(pattern, 0), block.coherent(pattern, 1)) * weight(y, n_y_) *
          weight(z, n_z_);
      const std::size_t mirror_y = n_y_ - 1 - y, mirror_z = n_z_ - 1 - z;
      drawn_[z * n_y_ + y] += value;
      drawn_[z * n_y_ + mirror_y] += sign_y * value;
      drawn_[mirror_z * n_y_ + y] += sign_z * value;
      drawn_[mirror_z * n_y_ + mirror_y] += sign_y * sign_z * value;
    }
}

const std::vector<std::complex<double>>& CoherentDraw::draw(RandomStream& random) {
  if (is_independent_) {
    for (std::complex<double>& point : drawn_) point = random.phasor();
    return drawn_;
  }
  drawn_.assign(drawn_.size(), 0.0);
  for (Block& block : blocks_) {
    for (Eigen::Index pattern = 0; pattern < block.independent.rows(); ++pattern) {
      const std::complex<double> phasor = random.phasor();
      block.independent.row(pattern) << phasor.real(), phasor.imag();
    }
    block.coherent.noalias() = block.factor.triangularView<Eigen::Lower>() * block.independent;
    add(block);
  }
  return drawn_;
}

}  // namespace spoke::air
