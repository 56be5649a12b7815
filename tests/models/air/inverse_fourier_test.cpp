// Fast transforms of eight series against the sums that they are.

#include "models/air/inverse_fourier.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <cstddef>
#include <numbers>
#include <vector>

#include "models/air/turbulence_random.h"
#include "models/support/instructions.h"

using namespace spoke;
using namespace spoke::air;

namespace {

using Coefficients = std::array<std::complex<double>, EightSeries::kCount>;

/// The sum over frequencies, which are real with those of opposite sign.
double sum(const std::vector<Coefficients>& all, std::size_t series, std::size_t t,
           std::size_t length) {
  double value = 0.0;
  for (std::size_t k = 1; k < length / 2; ++k)
    value += 2.0 * (all[k][series] *
                    std::polar(1.0, 2.0 * std::numbers::pi * static_cast<double>(k * t % length) /
                                        static_cast<double>(length)))
                       .real();
  return value;
}

}  // namespace

TEST_CASE("eight series are the sums of their frequencies") {
  for (const Kernels kernels : {Kernels::avx512, Kernels::avx2, Kernels::baseline}) {
    const Kernels before = use_kernels(kernels);
    for (const std::size_t length : {4, 6, 8, 10, 30, 48, 90, 200, 360}) {
      CAPTURE(length);
      RandomStream random(length);
      EightSeries series(length);
      std::vector<Coefficients> all(length / 2);
      for (std::size_t k = 1; k < length / 2; ++k) {
        random.draw_phasors(all[k]);
        series.set(k, all[k]);
      }
      InverseFourier(length).transform(series);
      double largest = 0.0;
      for (std::size_t i = 0; i < EightSeries::kCount; ++i)
        for (std::size_t t = 0; t < length; ++t)
          largest = std::max(largest, std::abs(series.value(t, i) - sum(all, i, t, length)));
      CHECK(largest < 1e-12);
    }
    use_kernels(before);
  }
}
