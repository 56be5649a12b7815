#pragma once

// Tables of wind over time, as text.

#include <optional>
#include <string>
#include <string_view>

#include "models/curve.h"

namespace spoke::air {

/// A wind that is equal at all places of one height.
struct WindTable {
  Curve speed;                            ///< at the reference height [m/s]
  Curve direction{};                      ///< about up, from the direction of the wind [rad]
  Curve vertical_speed{};                 ///< upwards [m/s]
  std::optional<Curve> shear_exponent{};  ///< of the power law
};

/// Reads the text of a table; `file` names it in messages. A line holds numbers: time [s], speed
/// [m/s], and perhaps direction [rad], vertical speed [m/s] and shear exponent, in this order or in
/// that of the names on the first line. What follows #, ! or % is left out. Throws InputError
/// "file:line: what is wrong, what is expected".
WindTable parse_wind_table(std::string_view text, const std::string& file);

}  // namespace spoke::air
