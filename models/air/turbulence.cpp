// Veers' method (1988): coherent random phases by frequency, then an inverse Fourier transform at
// each point.

#include "models/air/turbulence.h"

#include <cmath>
#include <complex>
#include <cstdint>
#include <unsupported/Eigen/FFT>
#include <vector>

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

/// Fourier coefficients of one component at all points, by point and frequency.
class FourierComponent {
 public:
  FourierComponent(const WindBox& box, std::size_t component)
      : component_(component),
        points_(box.n_y * box.n_z),
        coefficients_(points_ * (box.n_t / 2 + 1)) {}

  void set(std::size_t frequency, double amplitude,
           const std::vector<std::complex<double>>& phasors) {
    for (std::size_t p = 0; p < points_; ++p)
      coefficients_[p * stride() + frequency] = amplitude * phasors[p];
  }

  /// Transforms to times, with the standard deviation `deviation` at the centre of the grid.
  void write(double deviation, WindBox& box) {
    Eigen::FFT<double> transform;
    transform.SetFlag(Eigen::FFT<double>::HalfSpectrum);
    std::vector<double> course(box.n_t);
    for (std::size_t p = 0; p < points_; ++p) {
      transform.inv(course.data(), &coefficients_[p * stride()],
                    static_cast<Eigen::Index>(box.n_t));
      for (std::size_t t = 0; t < box.n_t; ++t)
        box.values[3 * (t * points_ + p) + component_] = static_cast<float>(course[t]);
    }
    const double found = std::sqrt(calc_center_variance(box));
    const auto factor = static_cast<float>(deviation / found);
    for (std::size_t i = component_; i < box.values.size(); i += 3) box.values[i] *= factor;
  }

 private:
  std::size_t stride() const { return coefficients_.size() / points_; }

  /// Returns the mean variance of the points next to the centre: of one, two or four.
  double calc_center_variance(const WindBox& box) const {
    double sum = 0.0;
    std::size_t count = 0;
    for (std::size_t z = (box.n_z - 1) / 2; z <= box.n_z / 2; ++z)
      for (std::size_t y = (box.n_y - 1) / 2; y <= box.n_y / 2; ++y, ++count)
        for (std::size_t t = 0; t < box.n_t; ++t) {
          const double value = box.values[box.index(t, z, y) + component_];
          sum += value * value;
        }
    return sum / static_cast<double>(count * box.n_t);
  }

  std::size_t component_, points_;
  std::vector<std::complex<double>> coefficients_;
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

WindBox make_turbulence(const WindTurbulence& turbulence, double speed, double reference_height) {
  WindBox box = make_box(turbulence, speed, reference_height);
  CoherentDraw grid(box.n_y, box.n_z, box.dy, box.dz);
  CoherentDraw alone(box.n_y, box.n_z, box.dy, box.dz);  // which stays independent
  const auto spectra = make_spectra(turbulence, speed, reference_height);
  const double spacing = 1.0 / (static_cast<double>(box.n_t) * box.dt);
  std::vector<FourierComponent> components;
  std::vector<RandomStream> random;
  for (std::size_t c = 0; c < 3; ++c) {
    components.emplace_back(box, c);
    random.emplace_back(4 * static_cast<std::uint64_t>(turbulence.seed) + c);
  }
  // The mean and the frequency of two steps, whose phase is not free, stay 0.
  for (std::size_t k = 1; k < box.n_t / 2; ++k) {
    const double frequency = static_cast<double>(k) * spacing;
    if (!grid.factorise(calc_coherence_rate(turbulence, speed, reference_height, frequency)))
      throw InputError("is " + describe(turbulence.width) +
                           ", and the points of the grid lie too close for their coherence; "
                           "expected a wider box or fewer points",
                       {.key = "turbulence.width"});
    for (std::size_t c = 0; c < 3; ++c) {
      const bool is_coherent = c == 0 || turbulence.coherence == Coherence::all;
      const double share = spectra[c].integral(frequency + 0.5 * spacing) -
                           spectra[c].integral(frequency - 0.5 * spacing);
      components[c].set(k, std::sqrt(share), (is_coherent ? grid : alone).draw(random[c]));
    }
  }
  for (std::size_t c = 0; c < 3; ++c)
    components[c].write(turbulence.intensity * speed * turbulence.deviation_ratio[c], box);
  return box;
}

}  // namespace spoke::air
