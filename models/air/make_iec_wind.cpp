// Formulas of IEC 61400-1, third edition, section 6.3.

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <string>

#include "models/air/iec_wind.h"
#include "models/air/turbulence.h"
#include "models/air/wind_rules.h"
#include "spoke/error.h"

namespace spoke {
namespace {

/// The numbers of a class.
struct IecNumbers {
  double reference;  ///< V_ref, the extreme mean of ten minutes [m/s]
  double intensity;  ///< I_ref, of turbulence at 15 m/s

  explicit IecNumbers(IecClass turbine) {
    constexpr std::array<double, 3> references{50.0, 42.5, 37.5};
    constexpr std::array<double, 3> intensities{0.16, 0.14, 0.12};
    const auto index = static_cast<std::size_t>(turbine);
    reference = references[index / 3];
    intensity = intensities[index % 3];
  }
  double average() const { return 0.2 * reference; }
  /// Returns the deviation of normal turbulence, its quantile of 90 %.
  double normal_deviation(double speed) const { return intensity * (0.75 * speed + 5.6); }
  double extreme_deviation(double speed) const {
    constexpr double c = 2.0;  // m/s
    return c * intensity * (0.072 * (average() / c + 3.0) * (speed / c - 4.0) + 10.0);
  }
  /// Returns the extreme gust's speed at the hub that recurs in so many years.
  double extreme(int period) const { return (period == 1 ? 1.12 : 1.4) * reference; }
};

constexpr double kNormalExponent = 0.2;    // of the normal wind profile
constexpr double kExtremeExponent = 0.11;  // of the extreme one

[[noreturn]] void refuse_iec(const std::string& key, const std::string& what) {
  throw InputError(what, {.key = "iec." + key});
}

/// Makes the wind of a condition step by step.
class IecMaker {
 public:
  IecMaker(const IecWind& iec, const Wind& along)
      : iec_(iec),
        numbers_(iec.turbine),
        wind_(along),
        height_(*along.reference_height),
        scale_(air::calc_length_scale(height_)) {}

  Wind make() {
    const bool is_extreme = iec_.condition == IecCase::ewm;
    if (is_extreme)
      speed_ = iec_.turbulent ? numbers_.extreme(iec_.period) / 1.4 : numbers_.extreme(iec_.period);
    else
      speed_ = *iec_.speed;
    wind_.velocity = speed_ * air::direction_of(wind_);
    wind_.shear_exponent = is_extreme ? kExtremeExponent : kNormalExponent;
    if (has_turbulence(iec_)) wind_.turbulence = make_turbulence();
    add_gusts();
    return wind_;
  }

 private:
  double deviation() const {
    if (iec_.condition == IecCase::ewm) return 0.11 * speed_;
    return iec_.condition == IecCase::etm ? numbers_.extreme_deviation(speed_)
                                          : numbers_.normal_deviation(speed_);
  }

  WindTurbulence make_turbulence() const {
    WindTurbulence turbulence{.intensity = deviation() / speed_, .seed = iec_.seed};
    turbulence.width = 1.2 * diameter();
    if (turbulence.width > 2.0 * height_) turbulence.height = 2.0 * height_;
    return turbulence;
  }

  double diameter() const {
    if (!iec_.rotor_diameter)
      refuse_iec("rotor_diameter",
                 "is missing, expected one (m), as the model has no blades that tell it");
    return *iec_.rotor_diameter;
  }

  /// Returns the deviation over the rotor, which averages out part of turbulence.
  double averaged_deviation() const { return deviation() / (1.0 + 0.1 * diameter() / scale_); }

  void add(GustOf of, GustShape shape, double amplitude, double duration) {
    wind_.gusts.push_back({amplitude, iec_.start, duration, shape, of});
  }

  void add_gusts() {
    switch (iec_.condition) {
      case IecCase::eog:
        add_operating_gust();
        break;
      case IecCase::edc:
        add(GustOf::direction, GustShape::rise,
            iec_.sign * std::min(4.0 * std::atan(averaged_deviation() / speed_), std::numbers::pi),
            6.0);
        break;
      case IecCase::ecd:
        add_coherent_gust();
        break;
      case IecCase::ews:
        add_shear();
        break;
      default:
        break;
    }
  }

  void add_operating_gust() {
    const double most = numbers_.extreme(1);
    if (speed_ >= most)
      refuse_iec("speed", "is " + describe(speed_) + ", expected less than " + describe(most) +
                              " (m/s), the extreme speed of a year");
    add(GustOf::speed, GustShape::operating,
        std::min(1.35 * (most - speed_), 3.3 * averaged_deviation()), 10.5);
  }

  void add_coherent_gust() {
    constexpr double rise = 15.0, duration = 10.0;
    const double degrees = speed_ < 4.0 ? 180.0 : 720.0 / speed_;
    add(GustOf::speed, GustShape::rise, rise, duration);
    add(GustOf::direction, GustShape::rise, iec_.sign * degrees * std::numbers::pi / 180.0,
        duration);
  }

  void add_shear() {
    constexpr double beta = 6.4;
    const double over_rotor = 2.5 + 0.2 * beta * deviation() * std::pow(diameter() / scale_, 0.25);
    add(iec_.shear == IecShear::vertical ? GustOf::vertical_shear : GustOf::horizontal_shear,
        GustShape::one_minus_cosine, iec_.sign * 2.0 * over_rotor / (diameter() * speed_), 12.0);
  }

  const IecWind& iec_;
  IecNumbers numbers_;
  Wind wind_;
  double height_, scale_;  // of the hub; Lambda_1
  double speed_ = 0.0;
};

void check_iec(const IecWind& iec) {
  keys::visit_numbers<void>(
      keys::kIecRows, iec,
      [](std::string_view key, const auto& value, const auto& range, Presence) {
        if constexpr (requires { range.expectation_instead_of(value); }) {
          const std::string expected = range.expectation_instead_of(value);
          if (!expected.empty())
            refuse_iec(std::string(key), "is " + describe(value) + ", expected " + expected);
        } else if (!range.holds(value)) {
          refuse_iec(std::string(key),
                     "is " + std::to_string(value) + ", expected " + range.expectation());
        }
      });
  keys::visit_options(
      keys::kIecRows, iec, [](std::string_view key, const auto& value, const Quantity& range) {
        const std::string expected = value ? range.expectation_instead_of(*value) : std::string();
        if (!expected.empty())
          refuse_iec(std::string(key), "is " + describe(*value) + ", expected " + expected);
      });
  const bool is_extreme = iec.condition == IecCase::ewm;
  if (!is_extreme && !iec.speed)
    refuse_iec("speed", "is missing, expected the mean speed at the hub (m/s)");
  if (is_extreme && iec.speed)
    refuse_iec("speed", "given along with case \"EWM\", whose speed is that of the class");
  if (iec.sign == 0) refuse_iec("sign", "is 0, expected 1 or -1");
  if (iec.period != 1 && iec.period != 50)
    refuse_iec("period", "is " + std::to_string(iec.period) + ", expected 1 or 50 years");
}

}  // namespace

std::string_view name_of(IecClass turbine) {
  constexpr std::array<std::string_view, 9> names{"IA",  "IB",   "IC",   "IIA", "IIB",
                                                  "IIC", "IIIA", "IIIB", "IIIC"};
  return names[static_cast<std::size_t>(turbine)];
}

std::string_view name_of(IecCase condition) {
  constexpr std::array<std::string_view, 8> names{"NWP", "NTM", "ETM", "EOG",
                                                  "EDC", "ECD", "EWS", "EWM"};
  return names[static_cast<std::size_t>(condition)];
}

std::string_view name_of(IecShear shear) {
  return shear == IecShear::vertical ? "vertical" : "horizontal";
}

bool has_turbulence(const IecWind& iec) {
  return iec.condition == IecCase::ntm || iec.condition == IecCase::etm ||
         (iec.condition == IecCase::ewm && iec.turbulent);
}

Wind make_iec_wind(const IecWind& iec, const Wind& along) {
  check_iec(iec);
  if (!along.reference_height || !(*along.reference_height > 0.0))
    throw InputError("is missing, expected the height of the hub over the ground (m), for iec",
                     {.key = "reference_height"});
  return IecMaker(iec, along).make();
}

}  // namespace spoke
