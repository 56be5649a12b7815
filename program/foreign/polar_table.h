#pragma once

// Polars of other programs' aerofoils: mixed, and written as tables that scenarios name.

#include <string>
#include <vector>

#include "program/foreign/found_air.h"

namespace spoke::foreign {

/// Coefficients of an aerofoil by angle of attack, as files have them.
struct FoundPolar {
  double reynolds = 0.0;       ///< of use where there are several
  std::vector<double> angle;   ///< [degrees]
  std::vector<double> lift;    ///< c_l
  std::vector<double> drag;    ///< c_d
  std::vector<double> moment;  ///< c_m, nose up; empty: none
};
/// One polar, or several by ascending Reynolds number.
using FoundPolars = std::vector<FoundPolar>;

/// Returns (1 - share) a + share b: linear in the angle of attack and in the logarithm of the
/// Reynolds number between those of either, constant beyond, as scenarios take them. A moment that
/// one of both lacks is zero there.
FoundPolars mix_polars(const FoundPolars& a, const FoundPolars& b, double share);

/// Makes an aerofoil of polars: a plain table of one, a file as AeroDyn's of several. Throws
/// InputError for polars that are none; its text begins with `from`.
FoundAirfoil make_airfoil(const FoundPolars& polars, const std::string& name,
                          const std::string& from);

/// Returns a name as scenarios allow it, unlike those of the aerofoils.
std::string choose_airfoil_name(const std::string& wish, const std::vector<FoundAirfoil>& airfoils);

}  // namespace spoke::foreign
