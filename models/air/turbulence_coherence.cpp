// Factorises coherence on the symmetric and antisymmetric patterns of a grid.

#include "models/air/turbulence_coherence.h"

#include <cmath>

#include "models/support/simd.h"
#include "models/support/wide_kernels.h"

namespace spoke::air {
namespace {

/// Below this coherence of neighbours, points are independent.
constexpr double kIndependent = 1e-8;

}  // namespace

// An odd pattern is 0 in the middle of a row.
CoherentDraw::Axis::Axis(std::size_t number, bool is_odd)
    : points(number), count(is_odd ? number / 2 : (number + 1) / 2), sign(is_odd ? -1.0 : 1.0) {}

double CoherentDraw::Axis::weight(std::size_t place) const {
  return 2 * place + 1 == points ? 0.5 : std::sqrt(0.5);
}

CoherentDraw::CoherentDraw(std::size_t n_y, std::size_t n_z, double dy, double dz)
    : n_y_(n_y), n_z_(n_z), table_(n_y * n_z), drawn_(n_y * n_z) {
  for (std::size_t k = 0; k < n_z; ++k)
    for (std::size_t j = 0; j < n_y; ++j)
      distances_.push_back(std::hypot(static_cast<double>(j) * dy, static_cast<double>(k) * dz));
  for (const bool is_odd_z : {false, true})
    for (const bool is_odd_y : {false, true}) {
      const Axis y(n_y, is_odd_y), z(n_z, is_odd_z);
      const std::size_t size = y.count * z.count;
      const std::vector<std::complex<double>> patterns(size);
      blocks_.push_back({y, z, LowerFactor(size), patterns, patterns});
      rows_[is_odd_y].resize(n_z * y.count * round_up_to_four(y.count));
    }
}

/// Sets the coherence of patterns along y, each of which is its points' numbers times weight and
/// sign, for each distance of their rows: twice the sum for one of the first's points, by symmetry.
void CoherentDraw::fill_rows(const Axis& axis) {
  const std::size_t stride = round_up_to_four(axis.count);
  for (std::size_t k = 0; k < n_z_; ++k) {
    const double* along = &table_[k * n_y_];
    for (std::size_t other = 0; other < axis.count; ++other) {
      double* row = &rows_[axis.is_odd()][(k * axis.count + other) * stride];
      const double weight = 2.0 * axis.weight(other);
      for (std::size_t y = 0; y < axis.count; ++y) {
        const double near = along[y > other ? y - other : other - y];
        const double mirrored = along[n_y_ - 1 - other - y];
        row[y] = weight * axis.weight(y) * (near + axis.sign * mirrored);
      }
    }
  }
}

/// Sets the lower triangle of a block: patterns along z of those along y, likewise. Four rows at a
/// time, beyond a pattern's last into those of the next, which then are set.
void CoherentDraw::fill(Block& block) const noexcept {
  const std::size_t count = block.y.count, stride = round_up_to_four(count);
  const std::vector<double>& rows = rows_[block.y.is_odd()];
  for (std::size_t other = 0; other < block.z.count; ++other)
    for (std::size_t z = other; z < block.z.count; ++z) {
      const double weight = 2.0 * block.z.weight(z) * block.z.weight(other);
      const double* near = &rows[(z - other) * count * stride];
      const double* mirrored = &rows[(n_z_ - 1 - other - z) * count * stride];
      for (std::size_t column = 0; column < count; ++column) {
        double* out = block.factor.column(other * count + column) + z * count;
        for (std::size_t y = 0; y < stride; y += 4)
          store(weight * (load4(near + column * stride + y) +
                          block.z.sign * load4(mirrored + column * stride + y)),
                out + y);
      }
    }
}

bool CoherentDraw::factorise(double rate) {
  for (std::size_t i = 0; i < table_.size(); ++i) table_[i] = std::exp(-rate * distances_[i]);
  is_independent_ = table_[1] < kIndependent && table_[n_y_] < kIndependent;
  if (is_independent_) return true;
  for (const Block& block : blocks_)
    if (!block.z.is_odd()) fill_rows(block.y);
  for (Block& block : blocks_) {
    run_kernel([&]() noexcept { fill(block); });
    if (!block.factor.factorise()) return false;
  }
  return true;
}

/// Adds a block's patterns to the points.
void CoherentDraw::add(const Block& block) {
  const Axis &along_y = block.y, &along_z = block.z;
  const std::complex<double>* pattern = block.coherent.data();
  for (std::size_t z = 0; z < along_z.count; ++z)
    for (std::size_t y = 0; y < along_y.count; ++y, ++pattern) {
      const std::complex<double> value = *pattern * along_y.weight(y) * along_z.weight(z);
      const std::size_t mirror_y = n_y_ - 1 - y, mirror_z = n_z_ - 1 - z;
      drawn_[z * n_y_ + y] += value;
      drawn_[z * n_y_ + mirror_y] += along_y.sign * value;
      drawn_[mirror_z * n_y_ + y] += along_z.sign * value;
      drawn_[mirror_z * n_y_ + mirror_y] += along_y.sign * along_z.sign * value;
    }
}

const std::vector<std::complex<double>>& CoherentDraw::draw(RandomStream& random) {
  if (is_independent_) {
    random.draw_phasors(drawn_);
    return drawn_;
  }
  drawn_.assign(drawn_.size(), 0.0);
  for (Block& block : blocks_) {
    random.draw_phasors(block.independent);
    block.factor.multiply(block.independent, block.coherent);
    add(block);
  }
  return drawn_;
}

}  // namespace spoke::air
