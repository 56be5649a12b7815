#pragma once

// A shaft of steel with two discs in bearings at its ends: the rotor of the examples and tests of
// ROSS, after Friswell, Penny, Garvey and Lees, Dynamics of Rotating Machines (2010), section 5.9.

#include <numbers>
#include <sstream>
#include <string>

#include "models/scenario.h"

namespace spoke::test {

/// A shaft of six elements. Its bearings are at its ends, by [N/m] and [N s/m].
struct Shaft {
  double speed = 0.0;          ///< [rad/s]
  double second_disc = 0.28;   ///< outer diameter [m]
  double lag_stiffness = 1.0;  ///< of bending in one direction, by that in the other
  /// Stiffness and damping of bearings across the shaft: numbers, or matrices.
  std::string bearing = "[1e6, 0.8e6]";
  std::string damping = "[0.0, 0.0]";
  std::string strain = "automatic";  ///< of the beam
};

/// Returns the keys of a disc of thickness 0.07 m with a bore of the shaft's diameter.
inline std::string make_disc(const std::string& name, double diameter) {
  constexpr double kDensity = 7810.0, kWidth = 0.07, kBore = 0.05;
  const double square = diameter * diameter, bore = kBore * kBore;
  const double mass = 0.25 * kDensity * std::numbers::pi * kWidth * (square - bore);
  const double polar = mass * (square + bore) / 8.0;
  const double across = mass * (3.0 * (square + bore) / 4.0 + kWidth * kWidth) / 12.0;
  std::ostringstream keys;
  keys.precision(17);
  keys << "[[subsystem.body]]\nname = \"" << name << "\"\nkind = \"rigid\"\nmass = " << mass
       << "\ninertia = [" << polar << ", " << across << ", " << across << "]\n";
  return keys.str();
}

inline std::string make_sections(double lag_stiffness) {
  constexpr double kDensity = 7810.0, kYoung = 211e9, kShear = 81.2e9, kDiameter = 0.05;
  const double area = 0.25 * std::numbers::pi * kDiameter * kDiameter;
  const double second = area * kDiameter * kDiameter / 16.0;
  const double poisson = kYoung / (2.0 * kShear) - 1.0;
  const double factor = 6.0 * (1.0 + poisson) / (7.0 + 6.0 * poisson);
  std::ostringstream keys;
  keys.precision(17);
  keys << "[subsystem.body.sections]\nmass_per_length = " << kDensity * area
       << "\nflap_inertia = " << kDensity * second << "\nlag_inertia = " << kDensity * second
       << "\naxial_stiffness = " << kYoung * area << "\nflap_stiffness = " << kYoung * second
       << "\nlag_stiffness = " << lag_stiffness * kYoung * second
       << "\ntorsion_stiffness = " << 2.0 * kShear * second
       << "\nflap_shear_stiffness = " << factor * kShear * area
       << "\nlag_shear_stiffness = " << factor * kShear * area << '\n';
  return keys.str();
}

inline std::string make_shaft_text(const Shaft& shaft) {
  std::ostringstream text;
  text.precision(17);
  text << "world = \"space\"\n[hub]\naxis = [1, 0, 0]\nmass = 1.0\ninertia = 1.0\n"
          "drive = { kind = \"constant\", speed = "
       << shaft.speed
       << " }\n[integration]\nstep = 1e-5\nduration = 0.01\n"
          "[[subsystem]]\nname = \"rotor\"\n[[subsystem.body]]\nname = \"shaft\"\nkind = \"beam\"\n"
          "length = 1.5\nbodies = 1\nelements = 6\nstrain = \""
       << shaft.strain << "\"\n"
       << make_sections(shaft.lag_stiffness) << make_disc("first", 0.28)
       << make_disc("second", shaft.second_disc)
       << "[[subsystem.joint]]\nparent = \"hub\"\nchild = \"shaft\"\nkind = \"bushing\"\n"
          "free = [\"y\", \"z\", \"about y\", \"about z\"]\n"
          "[[subsystem.joint]]\nparent = \"shaft\"\nchild = \"first\"\nstation = 0.5\n"
          "kind = \"fixed\"\n"
          "[[subsystem.joint]]\nparent = \"shaft\"\nchild = \"second\"\nstation = 1.0\n"
          "kind = \"fixed\"\n";
  for (const double station : {0.0, 1.5})
    text << "[[subsystem.loop]]\nname = \"" << (station == 0.0 ? "left" : "right")
         << "\"\nkind = \"bearing\"\naxis = [1, 0, 0]\nfrom = { body = \"shaft\", station = "
         << station << " }\nto = { body = \"mount\", point = [" << station
         << ", 0, 0] }\nstiffness = " << shaft.bearing << "\ndamping = " << shaft.damping << '\n';
  return text.str();
}

inline Scenario make_shaft(const Shaft& shaft) {
  return parse_scenario(make_shaft_text(shaft), "shaft.toml");
}

}  // namespace spoke::test
