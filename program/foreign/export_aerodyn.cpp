// Stations become nodes; places of the aerodynamic centre are found from the axis along the chord.

#include "program/foreign/export_aerodyn.h"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <variant>

#include "models/air/section_polar.h"
#include "models/error.h"
#include "models/space/reference_curve.h"
#include "program/foreign/input_lines.h"

namespace spoke::foreign {
namespace {

using spatial::BladeAerodynamics;
constexpr double kPerRadian = 180.0 / std::numbers::pi;

/// Returns a value by station, linear between; 0 if there are none.
double linear_at(const std::vector<double>& x, const std::vector<double>& y, double at) {
  if (y.empty()) return 0.0;
  const auto above = std::upper_bound(x.begin() + 1, x.end() - 1, at);
  const auto k = static_cast<std::size_t>(above - x.begin());
  return std::lerp(y[k - 1], y[k], (at - x[k - 1]) / (x[k] - x[k - 1]));
}

/// The axis of a blade.
space::ReferenceCurve make_axis_of(const spatial::Sections& s) {
  std::vector<space::Position> places;
  for (std::size_t i = 0; i < s.station.size(); ++i)
    places.emplace_back(s.station[i], s.sweep.empty() ? 0.0 : s.sweep[i],
                        s.prebend.empty() ? 0.0 : s.prebend[i]);
  return space::ReferenceCurve(places);
}

std::string node_line(const spatial::Blade& blade, const space::ReferenceCurve& axis, double span,
                      std::size_t i, std::size_t airfoil) {
  const BladeAerodynamics& air = *blade.aerodynamics;
  const spatial::Sections& s = blade.beam.sections;
  const double twist =
      (air.twist.empty() ? 0.0 : air.twist[i]) + linear_at(s.station, s.twist, span);
  const double center = air.center.empty() ? 0.0 : air.center[i];
  const space::Position place = axis.at(span), slope = axis.slope(span);
  return fmt::format("{}  {}  {}  {}  {}  {}  {}\n", span,
                     place.z() + center * std::sin(twist) + 0.0,
                     0.0 - place.y() - center * std::cos(twist),
                     kPerRadian * std::atan2(slope.z(), slope.x()) + 0.0, turned_degrees_of(twist),
                     air.chord[i], airfoil);
}

/// Returns names of aerofoils in the order of the blade, each once.
std::vector<std::string> names_of(const BladeAerodynamics& air) {
  std::vector<std::string> names;
  for (const std::string& name : air.airfoil)
    if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
  return names;
}

std::string write_aerodyn_blade(const spatial::Blade& blade, const std::vector<std::string>& names,
                                const std::string& title) {
  const BladeAerodynamics& air = *blade.aerodynamics;
  const space::ReferenceCurve axis = make_axis_of(blade.beam.sections);
  std::string rows;
  std::size_t count = air.station.size();
  const auto add = [&](double span, std::size_t i) {
    const auto found = std::find(names.begin(), names.end(), air.airfoil[i]);
    rows += node_line(blade, axis, span, i, static_cast<std::size_t>(found - names.begin()) + 1);
  };
  if (air.station.front() > 0.0) {  // AeroDyn's first node is at the root
    add(0.0, 0);
    ++count;
  }
  for (std::size_t i = 0; i < air.station.size(); ++i) add(air.station[i], i);
  return "------- AERODYN v15.00.* BLADE DEFINITION INPUT FILE, written by spoke export ---\n" +
         printable(title) +
         "\n======  Blade Properties ==========================================================\n" +
         fmt::format("{:<22} NumBlNds    - Number of blade nodes (-)\n", count) +
         "BlSpn  BlCrvAC  BlSwpAC  BlCrvAng  BlTwist  BlChord  BlAFID\n"
         "(m)  (m)  (m)  (deg)  (deg)  (m)  (-)\n" +
         rows;
}

std::string write_airfoil(const spatial::Airfoil& airfoil) {
  constexpr double million = 1e6;
  std::string text =
      "! ------------ AirfoilInfo v1.01.x Input File, written by spoke export ------------\n! " +
      printable(airfoil.name) +
      "\nDEFAULT       InterpOrd         ! Interpolation order\n"
      "1             NonDimArea        ! Area by the chord squared\n"
      "0             NumCoords         ! Number of coordinates\n";
  text += fmt::format("{:<13} NumTabs           ! Number of tables\n", airfoil.polars.size());
  for (const spatial::Polar& polar : airfoil.polars) {
    const double reynolds = polar.reynolds > 0.0 ? polar.reynolds / million : 1.0;
    text += fmt::format("{:<13} Re                ! Reynolds number in millions\n", reynolds);
    text +=
        "0             UserProp          ! Control setting\n"
        "False         InclUAdata        ! No unsteady data\n";
    text += fmt::format("{:<13} NumAlf            ! Number of rows\n", polar.angle.size());
    text += "!  Alpha  Cl  Cd  Cm\n!  (deg)  (-)  (-)  (-)\n";
    for (std::size_t i = 0; i < polar.angle.size(); ++i)
      text += fmt::format("{}  {}  {}  {}\n", turned_degrees_of(-polar.angle[i]), polar.lift[i],
                          polar.drag[i], polar.moment.empty() ? 0.0 : polar.moment[i]);
  }
  return text;
}

/// The beam of a support with drag, and its foot's height over the ground.
struct AiredTower {
  const spatial::BodyDrag* drag = nullptr;
};

AiredTower find_aired_tower(const spatial::Model& model) {
  if (!model.support || model.subsystems.empty()) return {};
  for (const spatial::Body& body : model.subsystems.back().bodies)
    if (body.drag && std::holds_alternative<spatial::Beam>(body.shape)) return {&*body.drag};
  return {};
}

std::string write_tower_table(const AiredTower& tower, double ground) {
  std::string text =
      "======  Tower Influence and Aerodynamics ==========================================\n" +
      fmt::format("{:<22} NumTwrNds   - Number of tower nodes (-)\n",
                  tower.drag ? tower.drag->station.size() : 0) +
      "TwrElev  TwrDiam  TwrCd  TwrTI  TwrCb\n(m)  (m)  (-)  (-)  (-)\n";
  if (!tower.drag) return text;
  for (std::size_t i = 0; i < tower.drag->station.size(); ++i)
    text += fmt::format("{}  {}  {}  0.1  0\n", tower.drag->station[i] - ground,
                        tower.drag->diameter[i], tower.drag->coefficient[i]);
  return text;
}

std::string write_primary_file(const Scenario& scenario, const AiredTower& tower,
                               const std::vector<std::string>& airfoil_files,
                               const std::string& blade_file) {
  const spatial::Air& air = *scenario.space->air;
  std::string text =
      "------- AERODYN INPUT FILE for OpenFAST, written by spoke export -----------------\n" +
      printable(scenario.title) + '\n';
  const auto head = [&](const char* what) {
    text += fmt::format("======  {}  {}\n", what, std::string(60, '='));
  };
  const auto line = [&](const std::string& value, const char* key, const char* what) {
    text += fmt::format("{:<22} {:<18} - {}\n", value, key, what);
  };
  const auto flag = [](bool is_on) { return std::string(is_on ? "True" : "False"); };
  const bool has_momentum = air.induction == spatial::Induction::momentum,
             is_dynamic = air.inflow == spatial::Inflow::dynamic;
  head("General Options");
  line("False", "Echo", "Echo input data (flag)");
  line("\"default\"", "DTAero", "Time interval (s)");
  line(has_momentum ? "1" : "0", "Wake_Mod", "0=none, 1=BEMT, 3=OLAF (switch)");
  line(std::to_string(tower.drag ? static_cast<int>(tower.drag->potential) : 0), "TwrPotent",
       "0=none, 1=potential flow, 2=with Bak's correction (switch)");
  line(tower.drag && tower.drag->shadow != spatial::TowerShadow::none ? "1" : "0", "TwrShadow",
       "0=none, 1=Powles, 2=Eames (switch)");
  line(flag(tower.drag != nullptr), "TwrAero", "Loads on the tower (flag)");
  line("False", "CavitCheck", "Cavitation (flag)");
  line("False", "Buoyancy", "Buoyancy (flag)");
  line("False", "NacelleDrag", "Drag of the nacelle (flag)");
  line("False", "CompAA", "Noise (flag)");
  line("\"unused\"", "AA_InputFile", "Noise (quoted string)");
  head("Environmental Conditions");
  line(fmt::format("{}", air.density), "AirDens", "Air density (kg/m^3)");
  line(fmt::format("{}", air.viscosity), "KinVisc", "Kinematic viscosity (m^2/s)");
  line("\"default\"", "SpdSound", "Speed of sound (m/s)");
  line("\"default\"", "Patm", "Pressure (Pa)");
  line("\"default\"", "Pvap", "Vapour pressure (Pa)");
  head("Blade-Element/Momentum Theory Options");
  line("1", "BEM_Mod", "1=legacy, 2=polar (switch)");
  text += "--- Skew correction\n";
  line("1", "Skew_Mod", "Skewed wake (switch)");
  line("False", "SkewMomCorr", "Skew momentum correction (flag)");
  line("default", "SkewRedistr_Mod", "Redistribution in skewed wakes (switch)");
  line("default", "SkewRedistrFactor", "Its constant (-)");
  text += "--- BEM algorithm\n";
  line("True", "TipLoss", "Tip loss (flag)");
  line("True", "HubLoss", "Hub loss (flag)");
  line("True", "TanInd", "Tangential induction (flag)");
  line("False", "AIDrag", "Drag in the axial induction (flag)");
  line("False", "TIDrag", "Drag in the tangential induction (flag)");
  line("default", "IndToler", "Tolerance (-)");
  line("100", "MaxIter", "Most iterations (-)");
  text += "--- Shear correction\n";
  line("False", "SectAvg", "Sector averaging (flag)");
  line("default", "SectAvgWeighting", "(switch)");
  line("default", "SectAvgNPoints", "(-)");
  line("default", "SectAvgPsiBwd", "(deg)");
  line("default", "SectAvgPsiFwd", "(deg)");
  text += "--- Dynamic wake/inflow\n";
  line(is_dynamic ? "2" : "0", "DBEMT_Mod", "0=quasi-steady, 2=time-dependent tau1 (switch)");
  line("4", "tau1_const", "Time constant (s)");
  head("OLAF");
  line("\"unused\"", "OLAFInputFileName", "(quoted string)");
  head("Unsteady Airfoil Aerodynamics Options");
  line("True", "AoA34", "Angle of attack at the 3/4 chord (flag)");
  line(air.stall == spatial::Stall::dynamic ? "6" : "0", "UA_Mod", "0=none, 6=Oye (switch)");
  line("True", "FLookup", "Separation from the polars (flag)");
  line("3", "IntegrationMethod", "(switch)");
  line("0", "UAStartRad", "(-)");
  line("1", "UAEndRad", "(-)");
  head("Airfoil Information");
  line("2", "AFTabMod", "1=first table, 2=by Reynolds number (switch)");
  line("1", "InCol_Alfa", "Column of the angle of attack (-)");
  line("2", "InCol_Cl", "Column of the lift (-)");
  line("3", "InCol_Cd", "Column of the drag (-)");
  line("4", "InCol_Cm", "Column of the moment (-)");
  line("0", "InCol_Cpmin", "Column of the least pressure (-)");
  line(std::to_string(airfoil_files.size()), "NumAFfiles", "Number of airfoil files (-)");
  for (std::size_t i = 0; i < airfoil_files.size(); ++i)
    text += '"' + airfoil_files[i] + '"' +
            (i == 0 ? "    AFNames            - Airfoil files" : "") + '\n';
  head("Rotor/Blade Properties");
  line("True", "UseBlCm", "Pitching moment (flag)");
  for (const char* key : {"ADBlFile(1)", "ADBlFile(2)", "ADBlFile(3)"})
    line('"' + blade_file + '"', key, "Blade file (quoted string)");
  head("Hub Properties");
  line("0", "VolHub", "(m^3)");
  line("0", "HubCenBx", "(m)");
  head("Nacelle Properties");
  line("0", "VolNac", "(m^3)");
  text +=
      "0, 0, 0   NacCenB  - (m)\n0, 0, 0   NacArea  - (m^2)\n0, 0, 0   NacCd  - (-)\n"
      "0, 0, 0   NacDragAC  - (m)\n";
  head("Tail Fin Aerodynamics");
  line("False", "TFinAero", "Tail fin (flag)");
  line("\"unused\"", "TFinFile", "(quoted string)");
  text += write_tower_table(tower, air.wind.ground);
  head("Outputs");
  line("False", "SumPrint", "Summary (flag)");
  line("0", "NBlOuts", "Blade nodes to output (-)");
  line("1", "BlOutNd", "These nodes (-)");
  line("0", "NTwOuts", "Tower nodes to output (-)");
  line("1", "TwOutNd", "These nodes (-)");
  return text +
         "              OutList            - The next lines are outputs\n"
         "END of input file\n"
         "-------------------------------------------------------------------------\n";
}

}  // namespace

ExportedFiles export_aerodyn(const Scenario& scenario, std::size_t blade,
                             const std::string& primary_file, const std::string& blade_file,
                             const std::function<std::string(const std::string&)>& airfoil_file) {
  const spatial::Blade& chosen = choose_blade(scenario, blade);
  if (!chosen.aerodynamics || !scenario.space->air)
    throw InputError(
        "blade.aerodynamics: is missing, expected a blade with aerodynamics, and [air]");
  if (chosen.aerodynamics->leads_backward)
    throw InputError(
        "blade.aerodynamics.leading_edge: is \"-y\", expected \"+y\": rotors of AeroDyn turn so");
  const std::vector<std::string> names = names_of(*chosen.aerodynamics);
  for (const spatial::Airfoil& airfoil : scenario.space->air->airfoils)
    if (air::find_choice(airfoil) == air::ChosenBy::mach &&
        std::find(names.begin(), names.end(), airfoil.name) != names.end())
      throw InputError("airfoil \"" + airfoil.name +
                       "\": has polars by Mach number, expected such by Reynolds number: files of "
                       "AeroDyn have no others");
  std::vector<std::string> airfoil_files;
  ExportedFiles exported;
  for (const std::string& name : names) airfoil_files.push_back(airfoil_file(name));
  exported.files.push_back(
      {primary_file,
       write_primary_file(scenario, find_aired_tower(*scenario.space), airfoil_files, blade_file)});
  exported.files.push_back({blade_file, write_aerodyn_blade(chosen, names, scenario.title)});
  for (std::size_t k = 0; k < names.size(); ++k)
    for (const spatial::Airfoil& airfoil : scenario.space->air->airfoils)
      if (airfoil.name == names[k])
        exported.files.push_back({airfoil_files[k], write_airfoil(airfoil)});
  if (chosen.aerodynamics->station.front() > 0.0)
    exported.left_out.emplace_back(
        "that there is no load inboard of the first station: AeroDyn's first node is at the root, "
        "with the chord there");
  if (scenario.space->air->inflow_factor != 1.0)
    exported.left_out.emplace_back("inflow_factor: AeroDyn has none");
  exported.left_out.emplace_back(
      "wind, and all else that is not aerodynamics of the blade and tower");
  return exported;
}

}  // namespace spoke::foreign
