// Veers' method (1988): coherent random phases by frequency, then an inverse Fourier transform at
// each point.

#include "models/air/turbulence.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <complex>
#include <cstdint>
#include <numbers>
#include <vector>

#include "models/air/inverse_fourier.h"
#include "models/air/turbulence_coherence.h"
#include "models/support/quantity.h"
#include "spoke/error.h"

namespace spoke::air {
namespace {

/// Length scales of the components over Lambda_1 (IEC 61400-1, kaimal).
constexpr std::array<double, 3> kLengthScales = {8.1, 2.7, 0.66};
/// In the coherence, of r over its length scale (IEC 61400-1).
constexpr double kCoherenceOffset = 0.12;

bool is_smooth(std::size_t number) {
  for (const std::size_t factor : {std::size_t{2}, std::size_t{3}, std::size_t{5}})
    while (number % factor == 0) number /= factor;
  return number == 1;
}

double length_scale_of(const WindTurbulence& turbulence, double reference_height) {
  return turbulence.length_scale.value_or(calc_length_scale(reference_height));
}

/// Fourier coefficients of one component at all points, then its courses.
class FourierComponent {
 public:
  FourierComponent(std::size_t points, std::size_t length) : points_(points) {
    for (std::size_t p = 0; p < points; p += kGroup) groups_.emplace_back(length);
  }

  /// Sets coefficients of a frequency at all points.
  void set(std::size_t frequency, double amplitude,
           const std::vector<std::complex<double>>& phasors) {
    std::array<std::complex<double>, kGroup> group{};
    for (std::size_t g = 0; g < groups_.size(); ++g) {
      const std::size_t begin = g * kGroup, count = std::min(kGroup, points_ - begin);
      for (std::size_t i = 0; i < count; ++i) group[i] = amplitude * phasors[begin + i];
      groups_[g].set(frequency, group);
    }
  }

  /// Transforms to times and writes the component of the box, with the standard deviation
  /// `deviation` at the centre of the grid, or of the spectrum. The coefficients are gone then.
  void write(double deviation, TurbulenceScale scale, std::size_t component,
             InverseFourier& fourier, WindBox& box) {
    for (EightSeries& group : groups_) {
      // The mean, and the frequency of two steps, whose phase is not free.
      group.places.front() = group.places[box.n_t / 2] = EightSeries::Place{};
      fourier.transform(group);
    }
    // A frequency of amplitude a, with its conjugate, has the variance 2 a^2, see amplitude().
    const double drawn = scale == TurbulenceScale::centre
                             ? std::sqrt(calc_center_variance(box))
                             : std::numbers::sqrt2 / static_cast<double>(box.n_t);
    const auto factor = static_cast<float>(deviation / drawn);
    // Some times of all points after some others: both sides stay in the cache.
    constexpr std::size_t times = 16;
    for (std::size_t t = 0; t < box.n_t; t += times)
      for (std::size_t g = 0; g < groups_.size(); ++g)
        for (std::size_t i = t; i < std::min(t + times, box.n_t); ++i)
          write_group(g, i, factor, &box.values[3 * i * points_ + component]);
  }

 private:
  static constexpr std::size_t kGroup = EightSeries::kCount;

  float value(std::size_t t, std::size_t point) const {
    return static_cast<float>(groups_[point / kGroup].value(t, point % kGroup));
  }

  /// Writes the values of a group at a time, of which point 0 is at `out`.
  void write_group(std::size_t g, std::size_t t, float factor, float* out) const {
    std::array<float, kGroup> values;
    const EightSeries::Place& place = groups_[g].places[t];
    for (std::size_t i = 0; i < 4; ++i) {
      values[i] = static_cast<float>(place.first[i]) * factor;
      values[i + 4] = static_cast<float>(place.last[i]) * factor;
    }
    const std::size_t count = std::min(kGroup, points_ - g * kGroup);
    for (std::size_t i = 0; i < count; ++i) out[3 * (g * kGroup + i)] = values[i];
  }

  /// Returns the mean variance of the points next to the centre: of one, two or four.
  double calc_center_variance(const WindBox& box) const {
    double sum = 0.0;
    std::size_t count = 0;
    for (std::size_t z = (box.n_z - 1) / 2; z <= box.n_z / 2; ++z)
      for (std::size_t y = (box.n_y - 1) / 2; y <= box.n_y / 2; ++y, ++count)
        for (std::size_t t = 0; t < box.n_t; ++t) {
          const double course = value(t, z * box.n_y + y);
          sum += course * course;
        }
    return sum / static_cast<double>(count * box.n_t);
  }

  std::size_t points_;
  std::vector<EightSeries> groups_;
};

/// Returns a box of zeros.
WindBox make_box(const WindTurbulence& turbulence, double speed, double reference_height) {
  WindBox box;
  box.n_y = static_cast<std::size_t>(turbulence.points[0]);
  box.n_z = static_cast<std::size_t>(turbulence.points[1]);
  box.n_t = count_steps(turbulence);
  const double height = turbulence.height.value_or(turbulence.width);
  box.dy = turbulence.width / static_cast<double>(box.n_y - 1);
  box.dz = height / static_cast<double>(box.n_z - 1);
  box.dt = turbulence.time_step;
  box.speed = speed;
  box.bottom = reference_height - 0.5 * height;
  box.values.assign(3 * box.n_t * box.n_z * box.n_y, 0.0f);
  return box;
}

}  // namespace

BoxCost estimate_cost(const WindTurbulence& turbulence) {
  assert(turbulence.points[0] > 1 && turbulence.points[1] > 1 && turbulence.time_step > 0.0);
  const double points =
      static_cast<double>(turbulence.points[0]) * static_cast<double>(turbulence.points[1]);
  const double steps = turbulence.duration / turbulence.time_step;
  const double block = std::ceil(points / 4.0);
  return {points * steps, 0.5 * steps * 4.0 * block * block * block / 3.0};
}

std::size_t count_steps(const WindTurbulence& turbulence) {
  auto steps = static_cast<std::size_t>(
      std::ceil(turbulence.duration / turbulence.time_step * (1.0 - 1e-12)));
  steps += steps % 2;
  while (!is_smooth(steps)) steps += 2;
  return steps;
}

double calc_length_scale(double height) { return 0.7 * std::fmin(height, 60.0); }

double KaimalSpectrum::density(double frequency) const {
  return 4.0 * tau * std::pow(1.0 + 6.0 * frequency * tau, -5.0 / 3.0);
}

double KaimalSpectrum::integral(double frequency) const {
  return 1.0 - std::pow(1.0 + 6.0 * frequency * tau, -2.0 / 3.0);
}

std::array<KaimalSpectrum, 3> make_spectra(const WindTurbulence& turbulence, double speed,
                                           double reference_height) {
  const double scale = length_scale_of(turbulence, reference_height);
  std::array<KaimalSpectrum, 3> spectra{};
  for (std::size_t c = 0; c < 3; ++c) spectra[c] = {kLengthScales[c] * scale / speed};
  return spectra;
}

double calc_coherence_rate(const WindTurbulence& turbulence, double speed, double reference_height,
                           double frequency) {
  const double length = kLengthScales[0] * length_scale_of(turbulence, reference_height);
  return turbulence.coherence_decay * std::hypot(frequency / speed, kCoherenceOffset / length);
}

namespace {

/// Draws components of turbulence. What is coherent is drawn by frequency for all of them, since
/// the coherence of a frequency is that of each.
class Drawing {
 public:
  Drawing(const WindTurbulence& turbulence, double reference_height, WindBox& box)
      : turbulence_(turbulence),
        reference_height_(reference_height),
        box_(box),
        spectra_(make_spectra(turbulence, box.speed, reference_height)),
        grid_(box.n_y, box.n_z, box.dy, box.dz),
        fourier_(box.n_t) {}

  /// Draws the components from `begin` to before `end`.
  void draw(std::size_t begin, std::size_t end, bool is_coherent) {
    while (components_.size() < end - begin)
      components_.emplace_back(box_.n_y * box_.n_z, box_.n_t);
    std::vector<RandomStream> random;
    for (std::size_t c = begin; c < end; ++c)
      random.emplace_back(4 * static_cast<std::uint64_t>(turbulence_.seed) + c);
    for (std::size_t k = 1; k < box_.n_t / 2; ++k) {
      if (is_coherent) factorise(static_cast<double>(k) * spacing());
      for (std::size_t c = begin; c < end; ++c)
        components_[c - begin].set(k, amplitude(c, k), grid_.draw(random[c - begin]));
    }
    for (std::size_t c = begin; c < end; ++c)
      components_[c - begin].write(
          turbulence_.intensity * box_.speed * turbulence_.deviation_ratio[c], turbulence_.scale, c,
          fourier_, box_);
  }

 private:
  double spacing() const { return 1.0 / (static_cast<double>(box_.n_t) * box_.dt); }

  /// Returns the amplitude of a frequency, by the sum over all that the transform is.
  double amplitude(std::size_t component, std::size_t k) const {
    const double frequency = static_cast<double>(k) * spacing();
    const KaimalSpectrum& spectrum = spectra_[component];
    return std::sqrt(spectrum.integral(frequency + 0.5 * spacing()) -
                     spectrum.integral(frequency - 0.5 * spacing())) /
           static_cast<double>(box_.n_t);
  }

  void factorise(double frequency) {
    if (!grid_.factorise(
            calc_coherence_rate(turbulence_, box_.speed, reference_height_, frequency)))
      throw InputError("is " + describe(turbulence_.width) +
                           ", and the points of the grid lie too close for their coherence; "
                           "expected a wider box or fewer points",
                       {.key = "turbulence.width"});
  }

  const WindTurbulence& turbulence_;
  double reference_height_;
  WindBox& box_;
  std::array<KaimalSpectrum, 3> spectra_;
  CoherentDraw grid_;
  InverseFourier fourier_;
  std::vector<FourierComponent> components_;
};

}  // namespace

WindBox make_turbulence(const WindTurbulence& turbulence, double speed, double reference_height) {
  WindBox box = make_box(turbulence, speed, reference_height);
  Drawing drawing(turbulence, reference_height, box);
  if (turbulence.coherence == Coherence::all) {
    drawing.draw(0, 3, true);
    return box;
  }
  // One after the other they need a third of the memory. A grid without factors is independent.
  drawing.draw(1, 2, false);
  drawing.draw(2, 3, false);
  drawing.draw(0, 1, true);
  return box;
}

}  // namespace spoke::air
