// Statistics of turbulence against the formulas of IEC 61400-1, written here once more, and equal
// bits. Seeds are fixed: what is random has bounds of some standard errors, and passes always.

#include "models/air/turbulence.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <cstddef>
#include <numbers>
#include <set>
#include <vector>

#include "models/air/turbulence_coherence.h"
#include "models/air/turbulence_random.h"
#include "models/wind.h"

using namespace spoke;
using namespace spoke::air;

namespace {

constexpr double kSpeed = 12.0;
constexpr double kHeight = 90.0;
// Kaimal's length scales at 90 m, IEC 61400-1 annex C.
constexpr std::array<double, 3> kLengths = {8.1 * 42.0, 2.7 * 42.0, 0.66 * 42.0};

WindTurbulence make_small() {
  return {.intensity = 0.15, .width = 40.0, .points = {3, 3}, .time_step = 0.25, .duration = 128.0};
}

WindBox make(const WindTurbulence& turbulence) {
  return make_turbulence(turbulence, kSpeed, kHeight);
}

/// f S(f)/sigma^2 = 4 f L/V/(1 + 6 f L/V)^(5/3).
double kaimal(double f, double length) {
  return 4.0 * length / kSpeed / std::pow(1.0 + 6.0 * f * length / kSpeed, 5.0 / 3.0);
}

/// Fourier coefficient of a point's course at the k-th frequency: amplitude/2 e^(i phase).
std::complex<double> transform(const WindBox& box, std::size_t point, std::size_t component,
                               std::size_t k) {
  std::complex<double> sum = 0.0;
  const double angle =
      -2.0 * std::numbers::pi * static_cast<double>(k) / static_cast<double>(box.n_t);
  const std::complex<double> turn = std::polar(1.0, angle);
  std::complex<double> phasor = 1.0;
  for (std::size_t t = 0; t < box.n_t; ++t, phasor *= turn)
    sum +=
        static_cast<double>(box.values[3 * (t * box.n_y * box.n_z + point) + component]) * phasor;
  return sum / static_cast<double>(box.n_t);
}

double variance(const WindBox& box, std::size_t point, std::size_t component) {
  double sum = 0.0;
  for (std::size_t t = 0; t < box.n_t; ++t) {
    const double value = box.values[3 * (t * box.n_y * box.n_z + point) + component];
    sum += value * value;
  }
  return sum / static_cast<double>(box.n_t);
}

}  // namespace

TEST_CASE("Kaimal's spectrum is that of IEC 61400-1 and its integral is closed") {
  const auto spectra = make_spectra(make_small(), kSpeed, kHeight);
  for (std::size_t c = 0; c < 3; ++c) {
    double sum = 0.0;
    constexpr int kParts = 20000;
    constexpr double kTo = 2.0;
    for (int i = 0; i < kParts; ++i) sum += kaimal(kTo * (i + 0.5) / kParts, kLengths[c]);
    CHECK(spectra[c].integral(kTo) == doctest::Approx(sum * kTo / kParts).epsilon(1e-5));
    CHECK(spectra[c].density(0.3) == doctest::Approx(kaimal(0.3, kLengths[c])).epsilon(1e-12));
    CHECK(spectra[c].integral(1e12) == doctest::Approx(1.0).epsilon(1e-6));
  }
  CHECK(calc_length_scale(90.0) == doctest::Approx(42.0));
  CHECK(calc_length_scale(30.0) == doctest::Approx(21.0));
}

TEST_CASE("at the centre turbulence has the intensity asked for and no mean") {
  for (const int points : {2, 3, 4}) {  // four points about the centre, or one
    WindTurbulence turbulence = make_small();
    turbulence.points = {points, points};
    const WindBox box = make(turbulence);
    const auto n = static_cast<std::size_t>(points);
    std::array<double, 3> sums{};
    std::size_t count = 0;
    for (std::size_t z = (n - 1) / 2; z <= n / 2; ++z)
      for (std::size_t y = (n - 1) / 2; y <= n / 2; ++y, ++count)
        for (std::size_t c = 0; c < 3; ++c) sums[c] += variance(box, z * n + y, c);
    const std::array<double, 3> ratios = {1.0, 0.8, 0.5};
    for (std::size_t c = 0; c < 3; ++c) {
      CHECK(std::sqrt(sums[c] / static_cast<double>(count)) ==
            doctest::Approx(0.15 * kSpeed * ratios[c]).epsilon(1e-5));
      for (std::size_t p = 0; p < n * n; ++p) CHECK(std::abs(transform(box, p, c, 0)) < 1e-6);
    }
  }
}

TEST_CASE("components that are not coherent have exactly the spectrum of their band") {
  const WindBox box = make(make_small());
  const double spacing = 1.0 / (static_cast<double>(box.n_t) * box.dt);
  const std::size_t last = box.n_t / 2 - 1;
  for (std::size_t c = 1; c < 3; ++c) {
    // Variance between two frequencies, over that of the band: by the trapezoidal rule.
    const auto share = [&](double from, double to) {
      constexpr int kParts = 200;
      double sum = 0.0;
      for (int i = 0; i < kParts; ++i)
        sum += kaimal(from + (to - from) * (i + 0.5) / kParts, kLengths[c]);
      return sum * (to - from) / kParts;
    };
    double band = 0.0;
    for (std::size_t k = 1; k <= last; ++k)
      band +=
          share((static_cast<double>(k) - 0.5) * spacing, (static_cast<double>(k) + 0.5) * spacing);
    const double total = variance(box, 4, c);
    for (const std::size_t k : {std::size_t{1}, std::size_t{7}, std::size_t{40}, last})
      for (const std::size_t point : {0, 4, 5}) {
        const double found = 2.0 * std::norm(transform(box, point, c, k));
        const double expected = total / band *
                                share((static_cast<double>(k) - 0.5) * spacing,
                                      (static_cast<double>(k) + 0.5) * spacing);
        CHECK(found == doctest::Approx(expected).epsilon(1e-3));
      }
  }
}

TEST_CASE("without a scale the spectrum is Kaimal's, and the variance that of its bands") {
  WindTurbulence turbulence = make_small();
  turbulence.scale = TurbulenceScale::none;
  const WindBox box = make(turbulence);
  const double spacing = 1.0 / (static_cast<double>(box.n_t) * box.dt);
  const std::size_t last = box.n_t / 2 - 1;
  for (std::size_t c = 1; c < 3; ++c) {
    const double sigma = 0.15 * kSpeed * turbulence.deviation_ratio[c];
    const auto up_to = [&](double k) {
      return 1.0 - std::pow(1.0 + 6.0 * k * spacing * kLengths[c] / kSpeed, -2.0 / 3.0);
    };
    for (const std::size_t k : {std::size_t{1}, std::size_t{7}, std::size_t{40}, last}) {
      const auto number = static_cast<double>(k);
      CHECK(2.0 * std::norm(transform(box, 4, c, k)) ==
            doctest::Approx(sigma * sigma * (up_to(number + 0.5) - up_to(number - 0.5)))
                .epsilon(1e-4));
    }
    CHECK(variance(box, 4, c) ==
          doctest::Approx(sigma * sigma * (up_to(static_cast<double>(last) + 0.5) - up_to(0.5)))
              .epsilon(1e-5));
  }
}

TEST_CASE("over seeds the longitudinal component has its spectrum and IEC's coherence") {
  constexpr int kSeeds = 300;
  const std::vector<std::size_t> frequencies = {2, 5, 12, 25, 60};
  std::vector<double> power(frequencies.size(), 0.0);
  std::vector<double> corner(frequencies.size(), 0.0);
  std::vector<std::complex<double>> cross(frequencies.size(), 0.0);
  WindTurbulence turbulence = make_small();
  double spacing = 0.0, band = 0.0;
  for (int seed = 0; seed < kSeeds; ++seed) {
    turbulence.seed = seed;
    const WindBox box = make(turbulence);
    spacing = 1.0 / (static_cast<double>(box.n_t) * box.dt);
    band = 0.5 * static_cast<double>(box.n_t) * spacing;
    for (std::size_t i = 0; i < frequencies.size(); ++i) {
      const auto at_center = transform(box, 4, 0, frequencies[i]);
      const auto at_corner = transform(box, 0, 0, frequencies[i]);
      power[i] += std::norm(at_center) / kSeeds;
      corner[i] += std::norm(at_corner) / kSeeds;
      cross[i] += at_corner * std::conj(at_center) / static_cast<double>(kSeeds);
    }
  }
  const double tau = kLengths[0] / kSpeed;
  const double inside = std::pow(1.0 + 3.0 * spacing * tau, -2.0 / 3.0) -
                        std::pow(1.0 + 6.0 * band * tau, -2.0 / 3.0);
  const double sigma = 0.15 * kSpeed;
  for (std::size_t i = 0; i < frequencies.size(); ++i) {
    const double f = static_cast<double>(frequencies[i]) * spacing;
    const double expected =
        sigma * sigma * kaimal(f, kLengths[0]) * spacing / inside;  // variance of this frequency
    // Of 300 seeds the standard error is 6 %.
    CHECK(2.0 * power[i] == doctest::Approx(expected).epsilon(0.2));
    const double r = std::hypot(20.0, 20.0);
    const double coherence = std::exp(-12.0 * std::hypot(f * r / kSpeed, 0.12 * r / kLengths[0]));
    const std::complex<double> found = cross[i] / std::sqrt(power[i] * corner[i]);
    INFO("frequency " << f << ", coherence " << coherence);
    CHECK(std::abs(found.real() - coherence) < 0.17);  // three standard errors of no coherence
    CHECK(std::abs(found.imag()) < 0.17);
  }
}

TEST_CASE("phasors on a grid are coherent by their distance whatever the symmetry of the grid") {
  constexpr double kRate = 0.08;
  for (const auto& [n_y, n_z] : {std::pair<std::size_t, std::size_t>{3, 2}, {4, 3}, {2, 2}}) {
    CoherentDraw grid(n_y, n_z, 7.0, 4.0);
    REQUIRE(grid.factorise(kRate));
    RandomStream random(11);
    const std::size_t points = n_y * n_z;
    std::vector<std::complex<double>> products(points * points, 0.0);
    constexpr int kDraws = 20000;
    for (int i = 0; i < kDraws; ++i) {
      const auto& drawn = grid.draw(random);
      for (std::size_t a = 0; a < points; ++a)
        for (std::size_t b = 0; b < points; ++b)
          products[a * points + b] += drawn[a] * std::conj(drawn[b]) / double{kDraws};
    }
    double largest = 0.0;
    for (std::size_t a = 0; a < points; ++a)
      for (std::size_t b = 0; b < points; ++b) {
        const double y = 7.0 * (static_cast<double>(a % n_y) - static_cast<double>(b % n_y));
        const double z = 4.0 * (static_cast<double>(a / n_y) - static_cast<double>(b / n_y));
        largest = std::max(
            largest, std::abs(products[a * points + b] - std::exp(-kRate * std::hypot(y, z))));
      }
    CHECK(largest < 0.04);  // the standard error is at most 0.01
  }
}

TEST_CASE("all components are coherent if asked") {
  WindTurbulence turbulence = make_small();
  turbulence.width = 0.4;
  turbulence.time_step = 1.0;  // slow eddies alone, far larger than the grid
  const auto correlation = [&](Coherence coherence) {
    turbulence.coherence = coherence;
    const WindBox box = make(turbulence);
    double product = 0.0;
    for (std::size_t t = 0; t < box.n_t; ++t)
      product += static_cast<double>(box.values[box.index(t, 0, 0) + 2]) *
                 box.values[box.index(t, 0, 1) + 2];
    return product / static_cast<double>(box.n_t) / std::sqrt(variance(box, 0, 2)) /
           std::sqrt(variance(box, 1, 2));
  };
  CHECK(correlation(Coherence::all) > 0.9);
  CHECK(std::abs(correlation(Coherence::longitudinal)) < 0.4);
}

TEST_CASE("equal seeds give equal bits and others another turbulence") {
  WindTurbulence turbulence = make_small();
  const WindBox one = make(turbulence);
  CHECK(one.values == make(turbulence).values);
  turbulence.seed = 2;
  const WindBox other = make(turbulence);
  double product = 0.0;
  for (std::size_t t = 0; t < one.n_t; ++t)
    product += static_cast<double>(one.values[one.index(t, 1, 1) + 2]) *
               other.values[other.index(t, 1, 1) + 2];
  CHECK(std::abs(product / static_cast<double>(one.n_t)) < 0.3 * variance(one, 4, 2));
}

TEST_CASE("random numbers are the published generators'") {
  // splitmix64 from 1234567 gives 6457827717110365317, 3203168211198807973, 9817491932198370423 and
  // 4593380528125082431, of which xoshiro256++ makes these.
  RandomStream reference(1234567);
  CHECK(reference.bits() == 437095814655224680u);
  CHECK(reference.bits() == 8127161015984454572u);
  RandomStream random(3);
  std::set<std::uint64_t> seen;
  double sum = 0.0, squares = 0.0;
  std::complex<double> phasors = 0.0;
  constexpr int kDraws = 20000;
  for (int i = 0; i < kDraws; ++i) {
    seen.insert(random.bits());
    const double x = random.symmetric();
    REQUIRE(x >= -1.0);
    REQUIRE(x < 1.0);
    sum += x;
    squares += x * x;
    std::complex<double> phasor;
    random.draw_phasors({&phasor, 1});
    REQUIRE(std::abs(std::abs(phasor) - 1.0) < 1e-14);
    phasors += phasor;
  }
  CHECK(seen.size() == kDraws);
  CHECK(std::abs(sum / kDraws) < 0.02);
  CHECK(std::abs(squares / kDraws - 1.0 / 3.0) < 0.01);
  CHECK(std::abs(phasors) / kDraws < 0.03);
}

TEST_CASE("a box lasts as long as asked, in a number of steps that transforms quickly") {
  WindTurbulence turbulence = make_small();
  turbulence.duration = 600.0;
  turbulence.time_step = 0.1;
  CHECK(count_steps(turbulence) == 6000);
  turbulence.duration = 600.2;
  CHECK(count_steps(turbulence) == 6144);  // 2^11 3: none of 6002, 6004, ... is smooth before
}
