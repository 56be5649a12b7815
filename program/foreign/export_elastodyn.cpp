// Stations become shares of the length; stretch and twist, which ElastoDyn does without, are
// columns behind those that it reads, by the names of older files.

#include "program/foreign/export_elastodyn.h"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <cmath>
#include <variant>

#include "program/foreign/input_lines.h"
#include "program/foreign/mode_polynomials.h"

namespace spoke::foreign {
namespace {

/// What ElastoDyn's tables have of a beam, by station.
struct PlainBeam {
  std::vector<double> station, twist, mass, flap, lag, torsion, axial, flap_inertia, lag_inertia;
};

bool is_some(const std::vector<double>& values) {
  return std::any_of(values.begin(), values.end(), [](double value) { return value != 0.0; });
}

/// Returns the diagonal of sections that are given by matrices.
std::vector<double> diagonal(const std::vector<spatial::SectionMatrix>& matrices, int k) {
  std::vector<double> values;
  for (const auto& matrix : matrices) values.push_back(matrix(k, k));
  return values;
}

/// Returns what sections of one material have, in place of inertias that are not given.
std::vector<double> inertia_of(const std::vector<double>& given, const PlainBeam& beam,
                               const std::vector<double>& bending) {
  if (!given.empty()) return given;
  std::vector<double> values;
  for (std::size_t i = 0; i < bending.size(); ++i)
    values.push_back(beam.mass[i] * bending[i] / beam.axial[i]);
  return values;
}

PlainBeam make_plain(const spatial::Sections& s) {
  constexpr int kAxial = 0, kTorsion = 3, kFlap = 4, kLag = 5;
  PlainBeam beam;
  beam.station = s.station;
  beam.twist = s.twist.empty() ? std::vector<double>(s.station.size(), 0.0) : s.twist;
  const bool has_matrices = !s.stiffness_6x6.empty();
  beam.axial = has_matrices ? diagonal(s.stiffness_6x6, kAxial) : s.axial_stiffness;
  beam.torsion = has_matrices ? diagonal(s.stiffness_6x6, kTorsion) : s.torsion_stiffness;
  beam.flap = has_matrices ? diagonal(s.stiffness_6x6, kFlap) : s.flap_stiffness;
  beam.lag = has_matrices ? diagonal(s.stiffness_6x6, kLag) : s.lag_stiffness;
  if (!s.mass_6x6.empty()) {
    beam.mass = diagonal(s.mass_6x6, 0);
    beam.flap_inertia = diagonal(s.mass_6x6, kFlap);
    beam.lag_inertia = diagonal(s.mass_6x6, kLag);
  } else {
    beam.mass = s.mass_per_length;
    beam.flap_inertia = inertia_of(s.flap_inertia, beam, beam.flap);
    beam.lag_inertia = inertia_of(s.lag_inertia, beam, beam.lag);
  }
  return beam;
}

void note_shape(const spatial::Beam& beam, const std::string& what,
                std::vector<std::string>& left_out) {
  const spatial::Sections& s = beam.sections;
  if (is_some(s.sweep) || is_some(s.prebend))
    left_out.push_back("sweep and prebend of the " + what + ": ElastoDyn's beams are straight");
  if (!s.stiffness_6x6.empty() || !s.mass_6x6.empty())
    left_out.push_back("couplings of the " + what +
                       "'s matrices, of which the diagonal is written");
  if (!s.tension_center.empty() || !s.shear_center.empty() || !s.mass_center.empty())
    left_out.push_back("centres off the axis of the " + what);
  if (!s.flap_shear_stiffness.empty() || !s.lag_shear_stiffness.empty())
    left_out.push_back("shear of the " + what);
}

/// Returns the damping of a mode in per cent: what directions give, and the ratio of its number by
/// frequency.
double damping_of(const Scenario& scenario, double factor, double frequency, std::size_t number) {
  const auto& damping = scenario.space->damping;
  double ratio = 0.5 * (damping.stiffness_factor + factor) * frequency;
  if (const auto& ratios = damping.modes.ratios; !ratios.empty())
    ratio += number < ratios.size() ? ratios[number] : damping.modes.above.value_or(ratios.back());
  return 100.0 * ratio;
}

std::string value_line(double value, const std::string& key, const char* what) {
  return fmt::format("{:<22} {:<11} - {}\n", value, key, what);
}

std::string write_shape(const PolynomialMode& mode, const char* name, const char* what) {
  std::string text;
  for (int power = 2; power <= 6; ++power)
    text += value_line(mode.coefficient[static_cast<std::size_t>(power) - 2],
                       fmt::format("{}({})", name, power), power == 2 ? what : "");
  return text;
}

std::string share_of(const PlainBeam& beam, std::size_t i) {
  return i + 1 == beam.station.size() ? "1"
                                      : fmt::format("{}", beam.station[i] / beam.station.back());
}

std::string write_elastodyn_blade(const Scenario& scenario, const spatial::Beam& blade) {
  const PlainBeam beam = make_plain(blade.sections);
  const auto flap = find_polynomial_modes({beam.station, beam.mass, beam.flap, 0.0});
  const auto edge = find_polynomial_modes({beam.station, beam.mass, beam.lag, 0.0});
  const auto& directions = scenario.space->damping.directions;
  std::string text =
      "------- ELASTODYN V1.00.* INDIVIDUAL BLADE INPUT FILE, written by spoke export ---\n" +
      printable(scenario.title) +
      "\n---------------------- BLADE PARAMETERS ----------------------------------------\n";
  text += fmt::format("{:<22} {:<11} - Number of blade input stations (-)\n", beam.station.size(),
                      "NBlInpSt");
  const char* percent = "Structural damping in percent of critical (%)";
  text +=
      value_line(damping_of(scenario, directions.flap, flap[0].frequency, 0), "BldFlDmp1", percent);
  text +=
      value_line(damping_of(scenario, directions.flap, flap[1].frequency, 2), "BldFlDmp2", percent);
  text +=
      value_line(damping_of(scenario, directions.lag, edge[0].frequency, 1), "BldEdDmp1", percent);
  text += "---------------------- BLADE ADJUSTMENT FACTORS --------------------------------\n";
  for (const char* key : {"FlStTunr1", "FlStTunr2", "AdjBlMs", "AdjFlSt", "AdjEdSt"})
    text += value_line(1.0, key, "(-)");
  text +=
      "---------------------- DISTRIBUTED BLADE PROPERTIES ----------------------------\n"
      "BlFract  PitchAxis  StrcTwst  BMassDen  FlpStff  EdgStff  GJStff  EAStff  FlpIner  EdgIner\n"
      "(-)  (-)  (deg)  (kg/m)  (Nm^2)  (Nm^2)  (Nm^2)  (N)  (kg m)  (kg m)\n";
  for (std::size_t i = 0; i < beam.station.size(); ++i)
    text += fmt::format("{}  0.25  {}  {}  {}  {}  {}  {}  {}  {}\n", share_of(beam, i),
                        turned_degrees_of(beam.twist[i]), beam.mass[i], beam.flap[i], beam.lag[i],
                        beam.torsion[i], beam.axial[i], beam.flap_inertia[i], beam.lag_inertia[i]);
  text += "---------------------- BLADE MODE SHAPES ---------------------------------------\n";
  text += write_shape(flap[0], "BldFl1Sh", "Flap mode 1, coeff of x^2 and up");
  text += write_shape(flap[1], "BldFl2Sh", "Flap mode 2, coeff of x^2 and up");
  return text + write_shape(edge[0], "BldEdgSh", "Edge mode 1, coeff of x^2 and up");
}

/// The tower: the one beam that stands on the ground, with what it carries.
struct Tower {
  const spatial::Beam* beam = nullptr;
  double carried = 0.0;  ///< mass at its tip [kg]
};

double mass_of(const spatial::Beam& beam) {
  const PlainBeam plain = make_plain(beam.sections);
  double mass = 0.0;
  for (std::size_t i = 1; i < plain.station.size(); ++i)
    mass += 0.5 * (plain.mass[i] + plain.mass[i - 1]) * (plain.station[i] - plain.station[i - 1]);
  for (const spatial::PointMass& point : beam.point_masses) mass += point.mass;
  return mass;
}

Tower find_tower(const spatial::Model& model) {
  Tower tower;
  if (!model.support || model.subsystems.empty()) return tower;
  const spatial::Subsystem& support = model.subsystems.back();
  std::string name;
  for (const spatial::SubsystemJoint& joint : support.joints)
    if (joint.parent == "ground") name = joint.child;
  for (const spatial::Body& body : support.bodies) {
    const auto* beam = std::get_if<spatial::Beam>(&body.shape);
    if (beam && body.name == name)
      tower.beam = beam;
    else if (beam)
      tower.carried += mass_of(*beam);
    else if (const auto* rigid = std::get_if<spatial::RigidBody>(&body.shape))
      tower.carried += rigid->mass;
  }
  tower.carried += model.hub.mass;
  for (const spatial::Blade& blade : model.blades) tower.carried += mass_of(blade.beam);
  if (tower.beam)
    for (const spatial::PointMass& point : tower.beam->point_masses)
      if (point.position == tower.beam->length) tower.carried += point.mass;
  return tower;
}

std::string write_elastodyn_tower(const Scenario& scenario, const Tower& tower) {
  const PlainBeam beam = make_plain(tower.beam->sections);
  const auto fore = find_polynomial_modes({beam.station, beam.mass, beam.flap, tower.carried});
  const auto side = find_polynomial_modes({beam.station, beam.mass, beam.lag, tower.carried});
  const auto& directions = scenario.space->damping.directions;
  std::string text =
      "------- ELASTODYN V1.00.* TOWER INPUT FILE, written by spoke export ---------------\n" +
      printable(scenario.title) +
      "\n---------------------- TOWER PARAMETERS ----------------------------------------\n";
  text += fmt::format("{:<22} {:<11} - Number of tower input stations (-)\n", beam.station.size(),
                      "NTwInpSt");
  const char* percent = "Structural damping in percent of critical (%)";
  const std::pair<const char*, double> damping[] = {
      {"TwrFADmp(1)", damping_of(scenario, directions.flap, fore[0].frequency, 0)},
      {"TwrFADmp(2)", damping_of(scenario, directions.flap, fore[1].frequency, 2)},
      {"TwrSSDmp(1)", damping_of(scenario, directions.lag, side[0].frequency, 1)},
      {"TwrSSDmp(2)", damping_of(scenario, directions.lag, side[1].frequency, 3)}};
  for (const auto& [key, value] : damping) text += value_line(value, key, percent);
  text += "---------------------- TOWER ADJUSTMENT FACTORS --------------------------------\n";
  for (const char* key : {"FAStTunr(1)", "FAStTunr(2)", "SSStTunr(1)", "SSStTunr(2)", "AdjTwMa",
                          "AdjFASt", "AdjSSSt"})
    text += value_line(1.0, key, "(-)");
  text +=
      "---------------------- DISTRIBUTED TOWER PROPERTIES ----------------------------\n"
      "HtFract  TMassDen  TwFAStif  TwSSStif  TwGJStif  TwEAStif  TwFAIner  TwSSIner\n"
      "(-)  (kg/m)  (Nm^2)  (Nm^2)  (Nm^2)  (N)  (kg m)  (kg m)\n";
  for (std::size_t i = 0; i < beam.station.size(); ++i)
    text += fmt::format("{}  {}  {}  {}  {}  {}  {}  {}\n", share_of(beam, i), beam.mass[i],
                        beam.flap[i], beam.lag[i], beam.torsion[i], beam.axial[i],
                        beam.flap_inertia[i], beam.lag_inertia[i]);
  const std::pair<const char*, const PolynomialMode*> shapes[] = {{"TwFAM1Sh", &fore[0]},
                                                                  {"TwFAM2Sh", &fore[1]},
                                                                  {"TwSSM1Sh", &side[0]},
                                                                  {"TwSSM2Sh", &side[1]}};
  const char* heads[] = {"FORE-AFT", "", "SIDE-TO-SIDE", ""};
  for (std::size_t k = 0; k < std::size(shapes); ++k) {
    if (*heads[k])
      text += fmt::format("---------------------- TOWER {} MODE SHAPES ----------------------\n",
                          heads[k]);
    text += write_shape(*shapes[k].second, shapes[k].first, "coefficient of x^2 and up");
  }
  return text;
}

}  // namespace

ExportedFiles export_elastodyn(const Scenario& scenario, std::size_t blade,
                               const std::string& blade_file, const std::string& tower_file) {
  const spatial::Blade& chosen = choose_blade(scenario, blade);
  ExportedFiles exported;
  exported.files.push_back({blade_file, write_elastodyn_blade(scenario, chosen.beam)});
  note_shape(chosen.beam, "blade", exported.left_out);
  if (!chosen.beam.point_masses.empty())
    exported.left_out.emplace_back(
        "point masses of the blade; one at its tip is TipMass(1) of "
        "ElastoDyn's primary file");
  const Tower tower = find_tower(*scenario.space);
  if (tower.beam) {
    exported.files.push_back({tower_file, write_elastodyn_tower(scenario, tower)});
    note_shape(*tower.beam, "tower", exported.left_out);
  }
  exported.left_out.emplace_back(
      "stretch and twist, which stand in columns behind those that ElastoDyn reads; mode shapes "
      "are "
      "those of polynomials at rest, without gravity");
  exported.left_out.emplace_back("lengths, hub, nacelle, drive and all else of the primary file");
  return exported;
}

}  // namespace spoke::foreign
