#pragma once

// Wind: what a scenario says of it, and its velocity as a function of place and time. docs/wind.md
// has the models and their sources.

#include <Eigen/Core>
#include <array>
#include <functional>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "models/curve.h"
#include "spoke/export.h"

namespace spoke::air {
class KeptWind;
}

namespace spoke {

/// Velocity of the air where no rotor disturbs it. Used by several threads at a time.
class SPOKE_EXPORT WindField {
 public:
  virtual ~WindField() = default;
  /// Returns the velocity at a place at time t [s], inertial frame [m, m/s]. A function of its
  /// arguments alone; neither allocates nor locks.
  virtual Eigen::Vector3d velocity(const Eigen::Vector3d& place, double t) const = 0;
  /// Returns the velocity at a place without gusts and turbulence, of which steady operation knows
  /// nothing: of wind in a file, the mean over its time; of other wind with a course over time,
  /// that at t = 0. By default velocity() at t = 0.
  virtual Eigen::Vector3d mean(const Eigen::Vector3d& place) const { return velocity(place, 0.0); }
  /// Returns the time up to which the wind is known [s]; it does not change afterwards. By default
  /// there is no end.
  virtual double end() const { return std::numeric_limits<double>::infinity(); }
  /// Returns the memory that the wind takes [bytes], about. By default none.
  virtual double memory() const { return 0.0; }
};

/// The shape of a gust over its duration T, amplitude A: with s the share of T that is over.
enum class GustShape {
  one_minus_cosine,  ///< A/2 (1 - cos 2 pi s)
  operating,         ///< -0.37 A sin(3 pi s) (1 - cos 2 pi s): extreme operating gust, IEC 61400-1
  rise               ///< A/2 (1 - cos pi s), and A ever after
};
/// What a gust changes.
enum class GustOf {
  speed,            ///< the speed along the wind, everywhere alike [m/s]
  direction,        ///< the direction of the wind, about `up` [rad]
  vertical_shear,   ///< Wind::vertical_shear [1/m]
  horizontal_shear  ///< Wind::horizontal_shear [1/m]
};

/// A change of the wind over a while, everywhere at once.
struct WindGust {
  double amplitude = 0.0;  ///< in the unit of what it changes
  double start = 0.0;      ///< [s]
  double duration = 10.5;  ///< [s]
  GustShape shape = GustShape::one_minus_cosine;
  GustOf of = GustOf::speed;

  friend bool operator==(const WindGust&, const WindGust&) = default;
};

/// The spectrum of turbulence.
enum class TurbulenceSpectrum {
  kaimal  ///< of IEC 61400-1, after Kaimal et al. (1972)
};
/// The components of turbulence that are alike at places close by.
enum class Coherence {
  longitudinal,  ///< that along the wind, as IEC 61400-1 has it; the others are independent
  all            ///< all three, by the same function
};

/// What the deviations of turbulence are asked of.
enum class TurbulenceScale {
  centre,  ///< the centre of the box: velocities are scaled to have them there, exactly
  none     ///< the spectrum: those of a box differ, and lack what its duration does not hold
};

/// Turbulence of the program's own: a box of velocities on a grid across the wind, which the mean
/// wind carries past the rotor (Taylor 1938) and which repeats after its duration.
struct WindTurbulence {
  /// Standard deviation along the wind at the reference height, over the mean speed there.
  double intensity = 0.0;
  int seed = 1;  ///< equal seeds give equal turbulence
  TurbulenceSpectrum spectrum = TurbulenceSpectrum::kaimal;
  /// Longitudinal turbulence scale parameter Lambda_1 [m]; none: by IEC 61400-1, 0.7 times the
  /// reference height, 42 m at most. The components' length scales are 8.1, 2.7 and 0.66 times it.
  std::optional<double> length_scale{};
  /// Standard deviations along the wind, across it and upwards, over the first.
  std::array<double, 3> deviation_ratio{1.0, 0.8, 0.5};
  TurbulenceScale scale = TurbulenceScale::centre;
  Coherence coherence = Coherence::longitudinal;
  double coherence_decay = 12.0;      ///< in the exponent of coherence
  double width = 0.0;                 ///< of the box, across the wind [m]
  std::optional<double> height{};     ///< of the box [m]; none: its width
  std::array<int, 2> points{15, 15};  ///< of the grid, across the wind and upwards
  double time_step = 0.1;             ///< [s]
  double duration = 600.0;            ///< after which it repeats, at least [s]

  friend bool operator==(const WindTurbulence&, const WindTurbulence&) = default;
};

/// Wind as a scenario describes it. Heights are along `up`, from the ground.
struct Wind {
  /// Mean velocity at the reference height, inertial frame [m/s]. Where another member gives the
  /// speed (`speed`, `file`), only its direction counts; +x if it is zero.
  Eigen::Vector3d velocity = Eigen::Vector3d::Zero();
  /// Speed over time, along the direction of `velocity` [m/s]; none: that of `velocity`.
  std::optional<Curve> speed{};
  /// File of wind in place of speed and turbulence: TurbSim's binary if its name ends in .bts, else
  /// a table of text. Empty: none.
  std::string file{};
  /// Exponent of the power law: speed = that at the reference height times (height/reference
  /// height)^exponent.
  double shear_exponent = 0.0;
  /// Linear shear: share of the speed at the reference height by which it grows on a metre upwards,
  /// and on one across, to the left for who looks along the wind, from the origin [1/m].
  double vertical_shear = 0.0, horizontal_shear = 0.0;
  std::optional<double> reference_height{};       ///< [m]; of shear and turbulence
  Eigen::Vector3d up = Eigen::Vector3d::UnitZ();  ///< of any length but zero
  double ground = 0.0;                            ///< coordinate of the ground along `up` [m]
  std::vector<WindGust> gusts{};                  ///< whose changes add up
  std::optional<WindTurbulence> turbulence{};
  /// Whether the program gives the wind, as `field`, in place of all else.
  bool by_program = false;
  std::shared_ptr<const WindField> field{};  ///< wind of the program's own; may be null
  /// What was made of it, kept by what reads it, so that it is made once; of use as long as nothing
  /// has been changed. May be null.
  std::shared_ptr<const air::KeptWind> kept{};
};

/// Whether two descriptions are equal; what they keep does not count.
SPOKE_EXPORT bool operator==(const Wind& a, const Wind& b);

/// Returns "one_minus_cosine", "operating" or "rise".
SPOKE_EXPORT std::string_view name_of(GustShape shape);
/// Returns "speed", "direction", "vertical_shear" or "horizontal_shear".
SPOKE_EXPORT std::string_view name_of(GustOf of);
/// Returns "kaimal".
SPOKE_EXPORT std::string_view name_of(TurbulenceSpectrum spectrum);
/// Returns "centre" or "none".
SPOKE_EXPORT std::string_view name_of(TurbulenceScale scale);
/// Returns "longitudinal" or "all".
SPOKE_EXPORT std::string_view name_of(Coherence coherence);

/// Makes the wind of a description: reads its file, generates its turbulence. A wind that the
/// description keeps is returned again. Throws InputError: with the key and what is wrong with it,
/// "wind.turbulence.width: is 0, expected ..."; of a file, with its name and the place in it.
SPOKE_EXPORT std::shared_ptr<const WindField> make_wind(const Wind& wind);

/// Makes a wind of a function of place [m] and time [s] in the inertial frame, which returns a
/// velocity [m/s]. Several threads call it at a time; it must depend on its arguments alone.
SPOKE_EXPORT std::shared_ptr<const WindField> make_wind_field(
    std::function<Eigen::Vector3d(const Eigen::Vector3d& place, double t)> velocity);

}  // namespace spoke
