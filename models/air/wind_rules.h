#pragma once

// Ranges of the numbers of a wind, and the rules that its description keeps: the reader of files,
// the check of what is filled in code and make_wind() go by them.

#include <string>
#include <type_traits>

#include "models/support/quantity.h"
#include "models/wind.h"

namespace spoke::air {

/// A fault of a description: the path of its key, "turbulence.width", and what is wrong and
/// expected. Both empty: there is none.
struct WindFault {
  std::string key;
  std::string text;

  explicit operator bool() const { return !text.empty(); }
};

/// Whether a file must give a number.
enum class Given { always, perhaps };

inline constexpr Quantity kWindSpeed = Quantity::any("m/s");
inline constexpr Quantity kWindTime = Quantity::any("s");
inline constexpr Quantity kUp = Quantity::any("");
inline constexpr Quantity kGround = Quantity::any("m");
inline constexpr Quantity kReferenceHeight = Quantity::positive("m");
inline constexpr Quantity kShearExponent = Quantity::between(0.0, 1.0);
inline constexpr Quantity kTurbulenceScale = Quantity::positive("m");
inline constexpr Quantity kDeviationRatio = Quantity::between(0.0, 2.0);
inline constexpr Quantity kBoxHeight = Quantity::positive("m");
inline constexpr Count kBoxPoints{2, 100};  ///< along a side of the grid
/// Velocities of a box, each of three components: what fits into the memory of any machine.
inline constexpr double kMostBoxValues = 2e7;
/// Operations for the coherence of a box, some tens of seconds.
inline constexpr double kMostBoxOperations = 1e11;

/// Calls visit(key, value, range, given) for the numbers of a gust.
template <class G, class Visit>
requires std::is_same_v<std::remove_const_t<G>, WindGust>
void visit_fields(G& gust, const Visit& visit) {
  visit("amplitude", gust.amplitude, kWindSpeed, Given::always);
  visit("start", gust.start, kWindTime, Given::perhaps);
  visit("duration", gust.duration, Quantity::positive("s"), Given::perhaps);
}

/// Calls visit(key, value, range, given) for the numbers of turbulence that stand alone.
template <class T, class Visit>
requires std::is_same_v<std::remove_const_t<T>, WindTurbulence>
void visit_fields(T& turbulence, const Visit& visit) {
  visit("intensity", turbulence.intensity, Quantity{"", 0.0, 2.0, false}, Given::always);
  visit("seed", turbulence.seed, Count{0, 2147483647}, Given::perhaps);
  visit("coherence_decay", turbulence.coherence_decay, Quantity::between(1.0, 100.0),
        Given::perhaps);
  visit("width", turbulence.width, Quantity::positive("m"), Given::always);
  visit("time_step", turbulence.time_step, Quantity::positive("s"), Given::perhaps);
  visit("duration", turbulence.duration, Quantity::positive("s"), Given::perhaps);
}

/// Whether a file of this name is TurbSim's binary.
bool is_bts(const std::string& file);

/// Returns the direction of the wind, a unit vector: that of its velocity, +x if that is zero.
Eigen::Vector3d direction_of(const Wind& wind);

/// Finds a fault of a description, whatever stands in its file.
WindFault find_wind_fault(const Wind& wind);

}  // namespace spoke::air
