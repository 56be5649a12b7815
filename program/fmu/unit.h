#pragma once

// Units of signals in the base units of SI.

#include <array>
#include <optional>
#include <string_view>

namespace spoke::fmu {

/// The base units that an FMU may use, in the order of the exponents of a Unit.
inline constexpr std::array<std::string_view, 4> kBaseUnits{"kg", "m", "s", "rad"};

/// A unit as a product of powers of base units; its factor is 1.
struct Unit {
  std::array<int, kBaseUnits.size()> exponents{};  ///< of kg, m, s, rad

  friend bool operator==(const Unit&, const Unit&) = default;
};

/// Reads a unit as Spoke writes it, "N m/rad" or "kg m^2/s": what stands behind the stroke divides.
/// None if a word of it is not known.
std::optional<Unit> parse_unit(std::string_view text);

}  // namespace spoke::fmu
