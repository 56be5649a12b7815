// Numbers coordinates by nodes, and eliminates from the inner to the outer end.

#include "engine/bodies/plane/nodal_band.h"

#include <algorithm>
#include <cassert>

#include "models/support/wide_kernels.h"

namespace spoke::plane {

NodalBand::NodalBand(const FlexibleBody& body)
    : values_(static_cast<std::size_t>((kHalf + 1) * body.coordinates()), 0.0),
      coordinate_(static_cast<std::size_t>(body.coordinates())),
      at_(coordinate_.size()) {
  const FlexLayout layout{body.axial(), body.bending()};
  for (int node = 0; node <= body.elements; ++node)
    for (int c = 0; c < kTwist; ++c)
      if (const int place = place_by_node(body, node, c); place >= 0) {
        coordinate_[static_cast<std::size_t>(place)] = body.coordinate(node, c);
        at_[static_cast<std::size_t>(place)] = layout.offset(body.coordinate(node, c));
      }
}

void NodalBand::set_zero() { std::fill(values_.begin(), values_.end(), 0.0); }

void NodalBand::add_product(const double* x, double* y) const noexcept {
  for (int i = 0; i < size(); ++i) {
    const double* values = row(i);
    double sum = values[i] * x[at(i)];
    for (int j = std::max(0, i - kHalf); j < i; ++j) {
      sum += values[j] * x[at(j)];
      y[at(j)] += values[j] * x[at(i)];
    }
    y[at(i)] += sum;
  }
}

void NodalBand::add_to(Eigen::Ref<Eigen::MatrixXd> dense) const {
  assert(dense.rows() == size() && dense.cols() == size());
  for (int i = 0; i < size(); ++i)
    for (int j = std::max(0, i - kHalf); j <= i; ++j) {
      dense(coordinate(i), coordinate(j)) += row(i)[j];
      if (i != j) dense(coordinate(j), coordinate(i)) += row(i)[j];
    }
}

void NodalBand::factorise(const NodalBand& a, const NodalBand& b) noexcept {
  assert(a.size() == size() && b.size() == size());
  run_kernel([&]() noexcept {
    const int n = size();
    for (std::size_t i = 0; i < values_.size(); ++i) values_[i] = a.values_[i] + b.values_[i];
    for (int k = 0; k < n; ++k) {
      const double inverse = 1.0 / row(k)[k];
      row(k)[k] = inverse;
      double column[kHalf];
      const int rest = std::min(kHalf, n - 1 - k);
      for (int i = 0; i < rest; ++i) {
        double* const below = row(k + 1 + i) + k;
        column[i] = below[0];
        const double share = below[0] *= inverse;
        for (int j = 0; j <= i; ++j) below[1 + j] -= share * column[j];
      }
    }
  });
}

void NodalBand::solve(Double2* x) const noexcept {
  run_kernel([&]() noexcept {
    const int n = size();
    for (int k = 0; k < n; ++k) {
      const int end = std::min(k + kHalf + 1, n);
      for (int i = k + 1; i < end; ++i) x[i] -= row(i)[k] * x[k];
    }
    for (int k = 0; k < n; ++k) x[k] *= row(k)[k];
    for (int k = n - 1; k > 0; --k)
      for (int j = std::max(0, k - kHalf); j < k; ++j) x[j] -= row(k)[j] * x[k];
  });
}

NodalBand make_mass_band(const FlexibleBody& body) {
  NodalBand mass(body);
  const int axial = body.axial();
  for (int i = 0; i < mass.size(); ++i)
    for (int j = std::max(0, i - NodalBand::kHalf); j <= i; ++j) {
      const int r = mass.coordinate(i), c = mass.coordinate(j);
      if (r < axial && c < axial) mass.add(i, j, body.M_axial(r, c));
      if (r >= axial && c >= axial) mass.add(i, j, body.M_bending(r - axial, c - axial));
    }
  return mass;
}

}  // namespace spoke::plane
