#pragma once

// Air around rotors in space: wind, aerofoils, the aerodynamics of blades, and how induction,
// inflow and stall are modelled.

#include <Eigen/Core>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "models/wind.h"
#include "spoke/export.h"

namespace spoke::spatial {

/// Coefficients of an aerofoil by angle of attack, at one Reynolds or Mach number.
struct Polar {
  double reynolds = 0.0;       ///< 0: the only one, or by Mach number
  std::vector<double> angle;   ///< of attack, ascending from -pi to pi [rad]
  std::vector<double> lift;    ///< c_l
  std::vector<double> drag;    ///< c_d
  std::vector<double> moment;  ///< c_m about the aerodynamic centre, nose up; empty: 0
  std::optional<double> mach = std::nullopt;  ///< in place of the Reynolds number

  friend bool operator==(const Polar&, const Polar&) = default;
};

/// An aerofoil.
struct Airfoil {
  std::string name;           ///< name, unlike that of any other
  std::vector<Polar> polars;  ///< one, or several by ascending Reynolds or Mach number

  friend bool operator==(const Airfoil&, const Airfoil&) = default;
};

/// Aerodynamics of a blade: values at stations, linear between them.
///
/// The chord of a section lies along its y axis, turned about +x by `twist`; the leading edge is
/// ahead in the direction of +y, and the suction side towards +z: a rotor that turns about +z has
/// thrust along +z at positive angles of attack. Positive twist raises the leading edge towards +z.
struct BladeAerodynamics {
  std::vector<double> station;       ///< from the root, ascending, two or more [m]
  std::vector<double> chord;         ///< [m]
  std::vector<double> twist;         ///< of the chord against the section's y [rad]; empty: 0
  std::vector<double> center;        ///< aerodynamic centre, along the chord ahead of the axis [m]
  std::vector<std::string> airfoil;  ///< names in Air::airfoils
  bool leads_backward = false;       ///< the leading edge is towards -y: the rotor turns about -z

  friend bool operator==(const BladeAerodynamics&, const BladeAerodynamics&) = default;
};

/// How the flow around a tower's section is found, by wind that comes along x.
enum class TowerPotential {
  none,
  cylinder,  ///< potential flow around a cylinder
  bak        ///< with Bak's correction (2001): shifted, and with a source by the drag
};
/// What a tower leaves behind.
enum class TowerShadow {
  none,
  powles  ///< a deficit of Powles (1983), by the drag
};

/// Drag of a body of a subsystem or a support in the wind, rho its density and v its velocity
/// against the body.
///
/// Of a beam it acts across the axis: 1/2 rho c d |v| v on a unit of length, with the part of v
/// across the axis. Of a rigid body it is 1/2 rho |v| A v at a point, A by the axes of its frame.
struct BodyDrag {
  std::vector<double> station;      ///< of a beam, from its root, ascending, two or more [m]
  std::vector<double> diameter;     ///< by station, linear between: width across the flow d [m]
  std::vector<double> coefficient;  ///< likewise, c
  Eigen::Vector3d area = Eigen::Vector3d::Zero();   ///< of a rigid body: coefficient by area [m^2]
  Eigen::Vector3d point = Eigen::Vector3d::Zero();  ///< of a rigid body, in its frame [m]
  // What blades meet of a beam of a support, by its diameter and its coefficient.
  TowerPotential potential = TowerPotential::none;
  TowerShadow shadow = TowerShadow::none;
};

/// How the rotor's own induced velocity is found.
enum class Induction {
  none,     ///< there is none
  momentum  ///< blade-element momentum theory, by annuli
};
/// The thrust of a disc that induces much, where momentum theory fails.
enum class HighThrust {
  buhl,     ///< Buhl's curve (2005), from a = 0.4
  glauert,  ///< Glauert's empirical one, 4 F a (1 - a (5 - 3 a) / 4), from a = 1/3
  hawc2     ///< the polynomial a(C_T) of Madsen et al. (2020), at all a of a turbine
};
/// The velocity that carries air through a disc in skewed flow.
enum class MassFlow {
  glauert,  ///< its size: of the part normal to the disc and of that in it
  normal    ///< the part normal to the disc
};
/// How induction follows its cause.
enum class Inflow {
  quasi_steady,  ///< at once
  dynamic        ///< with two time constants, by Oye
};
/// How the flow around a section follows its angle of attack.
enum class Stall {
  steady,  ///< at once
  dynamic  ///< separation lags, by Oye
};

/// How lift follows the angle of attack while flow is attached.
enum class AttachedFlow {
  steady,   ///< at once
  unsteady  ///< the wake that a section sheds delays it: Wagner's function, by Jones
};

/// Return the words of the scenario: "momentum", "buhl", "glauert", "quasi_steady", "static",
/// "steady".
SPOKE_EXPORT std::string_view name_of(Induction induction);
SPOKE_EXPORT std::string_view name_of(HighThrust relation);
SPOKE_EXPORT std::string_view name_of(MassFlow flow);
SPOKE_EXPORT std::string_view name_of(Inflow inflow);
SPOKE_EXPORT std::string_view name_of(Stall stall);
SPOKE_EXPORT std::string_view name_of(AttachedFlow flow);
/// Returns "none", "cylinder" or "bak".
SPOKE_EXPORT std::string_view name_of(TowerPotential potential);
/// Returns "none" or "powles".
SPOKE_EXPORT std::string_view name_of(TowerShadow shadow);

/// Air around a rotor.
struct Air {
  double density = 1.225;      ///< [kg/m^3]
  double viscosity = 1.5e-5;   ///< kinematic [m^2/s]
  double sound_speed = 340.3;  ///< [m/s]
  Wind wind{};
  Induction induction = Induction::momentum;
  HighThrust high_thrust = HighThrust::buhl;
  MassFlow mass_flow = MassFlow::glauert;
  Inflow inflow = Inflow::dynamic;
  AttachedFlow attached_flow = AttachedFlow::steady;
  Stall stall = Stall::dynamic;
  double inflow_factor = 1.0;  ///< axial induced velocity by that of momentum theory, 1 to 2
  std::vector<Airfoil> airfoils;
};

}  // namespace spoke::spatial
