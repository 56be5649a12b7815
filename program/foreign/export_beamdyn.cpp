// Stations become key points and sections; numbers have the digits that give the same bits.

#include "program/foreign/export_beamdyn.h"

#include <spdlog/fmt/fmt.h>

#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <cmath>

#include "models/error.h"
#include "models/reader/spatial/section_reader.h"
#include "models/tree/space_beam.h"
#include "program/foreign/blade_axis.h"
#include "program/foreign/export_files.h"
#include "program/foreign/input_lines.h"

namespace spoke::foreign {
namespace {

using spatial::Beam;
using spatial::Sections;

double value_at(const std::vector<double>& values, std::size_t i) {
  return values.empty() ? 0.0 : values[i];
}

double turned(double value) { return value == 0.0 ? 0.0 : -value; }

std::vector<KeyPoint> make_key_points(const Sections& s) {
  std::vector<KeyPoint> points;
  for (std::size_t i = 0; i < s.station.size(); ++i)
    points.push_back(
        {s.station[i], value_at(s.sweep, i), value_at(s.prebend, i), value_at(s.twist, i), {}});
  return points;
}

/// BeamDyn takes three key points or more: puts one between two.
void ensure_three(const BladeAxis& axis, std::vector<KeyPoint>& points) {
  if (points.size() == 2) points.insert(points.begin() + 1, axis.at(0.5 * points.back().x));
}

std::string write_primary(const std::vector<KeyPoint>& points, const std::string& title,
                          const std::string& blade_file) {
  std::string text = "--------- BEAMDYN with OpenFAST INPUT FILE, written by spoke export ---\n" +
                     printable(title) + '\n';
  const auto line = [&](const std::string& value, const char* key, const char* what) {
    text += fmt::format("{:<14} {:<17}- {}\n", value, key, what);
  };
  text += "---------------------- SIMULATION CONTROL ------------------------------\n";
  line("False", "Echo", "Echo input data (flag)");
  line("True", "QuasiStaticInit", "Begin at the equilibrium of rotation (flag)");
  line("0", "rhoinf", "Damping of the generalized-alpha integrator");
  line("2", "quadrature", "1=Gaussian, 2=Trapezoidal (switch)");
  line("DEFAULT", "refine", "Refinement of the trapezoidal quadrature (-)");
  line("DEFAULT", "n_fact", "Factorization frequency (-)");
  line("DEFAULT", "DTBeam", "Time step (s)");
  line("DEFAULT", "load_retries", "Number of retries with smaller loads");
  line("DEFAULT", "NRMax", "Most iterations of Newton-Raphson (-)");
  line("DEFAULT", "stop_tol", "Tolerance of these (-)");
  line("DEFAULT", "tngt_stf_fd", "Tangent stiffness by finite differences (flag)");
  line("DEFAULT", "tngt_stf_comp", "Compare both tangent stiffnesses (flag)");
  line("DEFAULT", "tngt_stf_pert", "Perturbation of finite differences (-)");
  line("DEFAULT", "tngt_stf_difftol", "Largest difference of both (-)");
  line("True", "RotStates", "Orient states in the rotating frame (flag)");
  text += "---------------------- GEOMETRY PARAMETER ------------------------------\n";
  line("1", "member_total", "Number of members (-)");
  line(std::to_string(points.size()), "kp_total", "Number of key points (-)");
  text += fmt::format("1  {}   - Member number; number of its key points\n", points.size());
  text += "kp_xr  kp_yr  kp_zr  initial_twist\n(m)  (m)  (m)  (deg)\n";
  for (const KeyPoint& point : points)
    text += fmt::format("{}  {}  {}  {}\n", point.prebend, turned(point.sweep), point.x,
                        turned_degrees_of(point.twist));
  text += "---------------------- MESH PARAMETER ----------------------------------\n";
  line("10", "order_elem", "Order of interpolation (-)");
  text += "---------------------- MATERIAL PARAMETER ------------------------------\n";
  line('"' + blade_file + '"', "BldFile", "Name of the blade file (quoted string)");
  text += "---------------------- PITCH ACTUATOR PARAMETERS -----------------------\n";
  line("False", "UsePitchAct", "Whether there is a pitch actuator (flag)");
  line("1", "PitchJ", "Its inertia (kg-m^2)");
  line("0", "PitchK", "Its stiffness (kg-m^2/s^2)");
  line("0", "PitchC", "Its damping (kg-m^2/s)");
  text += "---------------------- OUTPUTS -----------------------------------------\n";
  line("False", "SumPrint", "Print a summary (flag)");
  line("\"ES16.8E2\"", "OutFmt", "Format of the output");
  line("0", "NNodeOuts", "Number of nodes to output (-)");
  line("0", "OutNd", "These nodes (-)");
  text +=
      "              OutList          - The next lines are outputs\n"
      "\"TipTDxr, TipTDyr, TipTDzr\"\nEND of input file\n"
      "-------------------------------------------------------------------------\n";
  return text;
}

/// Writes six rows; minus zero is written as zero.
std::string write_matrix(const SectionMatrix& matrix) {
  std::string text;
  for (int r = 0; r < 6; ++r) {
    for (int c = 0; c < 6; ++c) text += fmt::format("  {}", matrix(r, c) + 0.0);
    text += '\n';
  }
  return text + '\n';
}

std::array<double, 6> factors_of(const DirectionDamping& d, double common) {
  return {common + d.flap_shear.value_or(d.flap),
          common + d.lag_shear.value_or(d.lag),
          common + d.axial,
          common + d.lag,
          common + d.flap,
          common + d.torsion};
}

/// A section's matrices in Spoke's axes.
struct Matrices {
  SectionMatrix stiffness, mass;
};

/// Returns the matrices of a station. Where a section is rigid in shear, BeamDyn needs a stiffness:
/// the axial one.
Matrices find_matrices(const Sections& s, const space::Beam& beam, std::size_t i,
                       bool& is_rigid_in_shear) {
  Matrices found;
  const space::SectionMatrices section = beam.section(s.station[i]);
  if (!s.stiffness_6x6.empty()) {
    found.stiffness = s.stiffness_6x6[i];
  } else {
    space::TwistMatrix compliance = section.compliance;
    for (const int k : {1, 2})
      if (compliance(k, k) == 0.0) {
        compliance(k, k) = compliance(0, 0);
        is_rigid_in_shear = true;
      }
    const Eigen::Matrix<double, 6, 6> inverse = Eigen::Matrix<double, 6, 6>(compliance).inverse();
    found.stiffness = 0.5 * (inverse + inverse.transpose());
  }
  if (!s.mass_6x6.empty()) {
    found.mass = s.mass_6x6[i];
    return found;
  }
  const space::MassMoments& m = section.mass;
  Eigen::Matrix<double, 6, 6> mass = Eigen::Matrix<double, 6, 6>::Zero();
  mass.diagonal().head<3>().setConstant(m.mass);
  Eigen::Matrix3d cross;
  cross << 0.0, -m.first.z(), m.first.y(), m.first.z(), 0.0, -m.first.x(), -m.first.y(),
      m.first.x(), 0.0;
  mass.topRightCorner<3, 3>() = -cross;
  mass.bottomLeftCorner<3, 3>() = cross;
  const Eigen::Matrix3d second = m.second;
  mass.bottomRightCorner<3, 3>() = second.trace() * Eigen::Matrix3d::Identity() - second;
  found.mass = mass;
  return found;
}

std::string write_blade(const Beam& blade, const BladeAxis& axis, const Scenario& scenario,
                        std::vector<std::string>& left_out) {
  const Sections& s = blade.sections;
  const space::Beam beam = spatial::make_space_beam(blade);
  const auto mu =
      factors_of(scenario.space->damping.directions, scenario.space->damping.stiffness_factor);
  const bool is_damped = std::any_of(mu.begin(), mu.end(), [](double f) { return f != 0.0; });
  std::string text =
      " ------- BEAMDYN V1.00.* INDIVIDUAL BLADE INPUT FILE, written by spoke export ---\n" +
      printable(scenario.title) + '\n' +
      " ---------------------- BLADE PARAMETERS -------------------------------\n";
  text +=
      fmt::format("{}   station_total    - Number of blade input stations (-)\n", s.station.size());
  text += fmt::format("{}   damp_type        - Damping type: 0: no damping; 1: damped\n",
                      is_damped ? 1 : 0);
  text +=
      " ---------------------- DAMPING COEFFICIENT ---------------------------\n"
      "mu1  mu2  mu3  mu4  mu5  mu6\n(-)  (-)  (-)  (-)  (-)  (-)\n";
  text += fmt::format("{}  {}  {}  {}  {}  {}\n", mu[0], mu[1], mu[2], mu[3], mu[4], mu[5]);
  text += " ---------------------- DISTRIBUTED PROPERTIES ------------------------\n";
  bool is_rigid_in_shear = false;
  for (std::size_t i = 0; i < s.station.size(); ++i) {
    const bool is_last = i + 1 == s.station.size();
    const double eta = is_last ? 1.0 : axis.arc_length(s.station[i]) / axis.whole_arc_length();
    const Matrices found = find_matrices(s, beam, i, is_rigid_in_shear);
    text += fmt::format("  {}\n", eta) + write_matrix(spatial::swap_beamdyn_axes(found.stiffness)) +
            write_matrix(spatial::swap_beamdyn_axes(found.mass));
  }
  if (is_rigid_in_shear)
    left_out.emplace_back(
        "shear that the scenario holds rigid: BeamDyn's shear stiffness is the "
        "axial one");
  return text;
}

void note_left_out(const Scenario& scenario, const spatial::Blade& blade,
                   std::vector<std::string>& left_out) {
  if (!blade.beam.point_masses.empty()) left_out.emplace_back("point masses of the blade");
  if (!blade.joints.empty()) left_out.emplace_back("joints of the blade");
  if (!blade.loops.empty()) left_out.emplace_back("closed loops of the blade");
  if (!scenario.space->damping.modes.ratios.empty()) left_out.emplace_back("damping by mode");
  if (scenario.space->damping.mass_factor != 0.0) left_out.emplace_back("damping by mass_factor");
  left_out.emplace_back("hub, drive, loads and all else that is not the blade");
}

}  // namespace

BeamDynFiles export_beamdyn(const Scenario& scenario, std::size_t blade,
                            const std::string& blade_file) {
  const spatial::Blade& chosen = choose_blade(scenario, blade);
  const Sections& s = chosen.beam.sections;
  if (value_at(s.sweep, 0) != 0.0 || value_at(s.prebend, 0) != 0.0)
    throw InputError(
        "the axis of the blade does not begin at its root, expected sweep and prebend "
        "0 at station 0, as BeamDyn has it");
  std::vector<KeyPoint> points = make_key_points(s);
  const BladeAxis axis(points);
  ensure_three(axis, points);
  BeamDynFiles files;
  files.primary = write_primary(points, scenario.title, blade_file);
  files.blade = write_blade(chosen.beam, axis, scenario, files.left_out);
  note_left_out(scenario, chosen, files.left_out);
  return files;
}

}  // namespace spoke::foreign
