#pragma once

// Wind conditions of IEC 61400-1, third edition, as descriptions of wind. docs/wind.md has the
// formulas.

#include <optional>
#include <string>
#include <string_view>

#include "models/wind.h"
#include "spoke/export.h"

namespace spoke {

/// Classes of wind turbines: I to III by the reference speed, A to C by turbulence.
enum class IecClass { i_a, i_b, i_c, ii_a, ii_b, ii_c, iii_a, iii_b, iii_c };

/// Wind conditions, by the standard's names.
enum class IecCase {
  nwp,  ///< normal wind profile
  ntm,  ///< normal turbulence
  etm,  ///< extreme turbulence
  eog,  ///< extreme operating gust
  edc,  ///< extreme direction change
  ecd,  ///< extreme coherent gust with direction change
  ews,  ///< extreme wind shear
  ewm   ///< extreme wind speed
};

/// The direction of extreme shear.
enum class IecShear { vertical, horizontal };

/// A wind condition of the standard.
struct IecWind {
  IecClass turbine = IecClass::i_a;
  IecCase condition = IecCase::nwp;
  std::optional<double> speed{};  ///< mean, at the hub [m/s]; none with ewm, whose class has it
  double start = 0.0;             ///< of eog, edc, ecd and ews [s]
  int sign = 1;                   ///< 1 or -1: of edc, ecd and ews
  IecShear shear = IecShear::vertical;     ///< of ews
  int period = 50;                         ///< of recurrence, 1 or 50 years: of ewm
  bool turbulent = false;                  ///< of ewm: the turbulent model, not the steady one
  int seed = 1;                            ///< of turbulence
  std::optional<double> rotor_diameter{};  ///< [m]; of eog, edc, ews and the box of turbulence
};

/// Returns "IA" to "IIIC".
SPOKE_EXPORT std::string_view name_of(IecClass turbine);
/// Returns "NWP" and so on.
SPOKE_EXPORT std::string_view name_of(IecCase condition);
/// Returns "vertical" or "horizontal".
SPOKE_EXPORT std::string_view name_of(IecShear shear);

/// Whether a condition has turbulence.
SPOKE_EXPORT bool has_turbulence(const IecWind& iec);

/// Returns the wind of a condition: of `along`, which has the height of the hub for its
/// reference_height, the direction of its velocity, up and ground. Turbulence has a box of 1.2
/// rotor diameters. Throws InputError with the key within "iec" and what is wrong.
SPOKE_EXPORT Wind make_iec_wind(const IecWind& iec, const Wind& along);

}  // namespace spoke
