// Makes the table and files of modes.

#include "program/steady_report/mode_files.h"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <numbers>

#include "engine/support/csv_cell.h"
#include "engine/support/plain_zero.h"
#include "program/steady_report/mode_json.h"

namespace spoke::steady_report {
namespace {

Json parts(const Eigen::Vector3cd& v, bool imaginary) {
  const Eigen::Vector3d part = imaginary ? Eigen::Vector3d(v.imag()) : Eigen::Vector3d(v.real());
  return Json::array({part.x(), part.y(), part.z()});
}

Json shape_json(const Mode& mode) {
  Json blades = Json::array();
  for (const std::vector<Eigen::Vector3cd>& nodes : mode.shape) {
    Json real = Json::array(), imag = Json::array();
    for (const Eigen::Vector3cd& p : nodes) {
      real.push_back(parts(p, false));
      imag.push_back(parts(p, true));
    }
    blades.push_back({{"real", real}, {"imag", imag}});
  }
  return blades;
}

Json energy_json(const ModeEnergy& energy, const std::vector<std::string>& bodies) {
  Json by_body = Json::array();
  for (std::size_t k = 0; k < bodies.size(); ++k)
    by_body.push_back({{"body", bodies[k]}, {"share", energy.bodies[k]}});
  return {{"flap", energy.flap},       {"lag", energy.lag}, {"axial", energy.axial},
          {"torsion", energy.torsion}, {"hub", energy.hub}, {"support", energy.support},
          {"bodies", by_body}};
}

Json harmonics_json(const Mode& mode) {
  Json list = Json::array();
  for (const ModeHarmonic& harmonic : mode.harmonics)
    list.push_back({{"multiple", harmonic.multiple},
                    {"frequency_rad_per_s", harmonic.frequency},
                    {"share", harmonic.share},
                    {"share_of_hub", harmonic.of_hub}});
  return list;
}

}  // namespace

Json mode_json(const Mode& mode, const std::vector<std::string>& bodies) {
  return {{"of", mode.of},
          {"name", mode.name},
          {"kind", mode.kind},
          {"frequency_Hz", hertz(mode.frequency)},
          {"frequency_rad_per_s", mode.frequency},
          {"damping_ratio", damping_of(mode)},
          {"eigenvalue_real_per_s", mode.eigenvalue.real()},
          {"eigenvalue_imag_rad_per_s", mode.eigenvalue.imag()},
          {"grows", mode.grows()},
          {"energy", energy_json(mode.energy, bodies)},
          {"harmonics", harmonics_json(mode)},
          {"shape", shape_json(mode)}};
}

Json nodes_json(const EquilibriumResult& equilibrium) {
  Json nodes = Json::array();
  for (const BladeEquilibrium& blade : equilibrium.blades) {
    Json list = Json::array();
    for (const Eigen::Vector3d& p : blade.nodes) list.push_back(Json::array({p.x(), p.y(), p.z()}));
    nodes.push_back({{"name", blade.name}, {"nodes_m", list}});
  }
  return nodes;
}

namespace {

constexpr int kHarmonics = 4;  ///< in modes.csv, to either side of the strongest

double share_of(int multiple, const Mode& mode) {
  for (const ModeHarmonic& harmonic : mode.harmonics)
    if (harmonic.multiple == multiple) return harmonic.share;
  return 0.0;
}

/// Returns a cell with the comma before it; less than 1e-9 is round-off.
std::string share_cell(double share) { return fmt::format(",{:.6g}", share < 1e-9 ? 0.0 : share); }

}  // namespace

double hertz(double frequency) { return frequency / (2.0 * std::numbers::pi); }

std::string name_of(ModeFrame frame) {
  switch (frame) {
    case ModeFrame::turning:
      return "turning";
    case ModeFrame::fixed:
      return "fixed";
    case ModeFrame::floquet:
      break;
  }
  return "floquet";
}

std::string describe(ModeFrame frame) {
  switch (frame) {
    case ModeFrame::turning:
      return "in the frame that turns with the hub";
    case ModeFrame::fixed:
      return "in the frame that stands";
    case ModeFrame::floquet:
      break;
  }
  return "of the strongest harmonics, blades in the frame that turns, the hub in the one that "
         "stands";
}

double damping_of(const Mode& mode) {
  return std::abs(mode.damping_ratio) < 1e-6 ? 0.0 : mode.damping_ratio;
}

report::Table make_mode_table(const ModesResult& result) {
  using report::Align;
  report::Table table{.caption = "Modes",
                      .columns = {{"of"},
                                  {"mode"},
                                  {"Hz", Align::number},
                                  {"rad/s", Align::number},
                                  {"damping ratio", Align::number}}};
  for (const Mode& mode : result.modes)
    table.rows.push_back(
        {{mode.of, mode.name, fmt::format("{:.6g}", hertz(mode.frequency)),
          fmt::format("{:.6g}", mode.frequency), fmt::format("{:.4g}", damping_of(mode))},
         mode.grows() ? report::Tone::bad : report::Tone::plain});
  return table;
}

std::string describe_speeds(const EquilibriumResult& result) {
  if (result.rotors.empty()) return fmt::format("{:.6g} rad/s", result.speed);
  std::string text;
  for (const RotorEquilibrium& rotor : result.rotors)
    text += fmt::format("{}{} {:.6g}", text.empty() ? "" : ", ", rotor.name, rotor.speed);
  return text + " rad/s";
}

Json speeds_json(const EquilibriumResult& result) {
  Json rotors = Json::array();
  for (const RotorEquilibrium& rotor : result.rotors)
    rotors.push_back({{"name", rotor.name}, {"speed_rad_per_s", rotor.speed}});
  return rotors;
}

std::string describe_growth(const ModesResult& result) {
  std::string names;
  for (const Mode& mode : result.modes)
    if (mode.grows())
      names += fmt::format("{}{} of {} (by {:.3g} per s)", names.empty() ? "" : ", ", mode.name,
                           mode.of, mode.eigenvalue.real());
  return names.empty() ? names
                       : "the equilibrium is unstable: " + names + " grow" +
                             (names.find(',') == std::string::npos ? "s" : "");
}

std::string make_json(const ModesResult& result) {
  Json modes = Json::array();
  for (const Mode& mode : result.modes) modes.push_back(mode_json(mode, result.bodies));
  Json json = {{"speed_rad_per_s", result.equilibrium.speed},   {"frame", name_of(result.frame)},
               {"blades_couple", result.are_blades_coupled},    {"notes", result.notes},
               {"equilibrium", nodes_json(result.equilibrium)}, {"modes", modes}};
  if (!result.equilibrium.rotors.empty()) json.set("rotors", speeds_json(result.equilibrium));
  return json.dump_lines();
}

std::string make_csv(const ModesResult& result) {
  std::string text =
      "of,mode,frequency_Hz,frequency_rad_per_s,damping_ratio,eigenvalue_real_per_s,grows,"
      "share_flap,share_lag,share_axial,share_torsion,share_hub";
  if (result.equilibrium.hub) text += ",share_support";
  for (std::string body : result.bodies) {
    std::replace(body.begin(), body.end(), ',', ';');
    text += ',' + csv_cell("share_of " + body);
  }
  if (result.frame == ModeFrame::floquet)
    for (int k = -kHarmonics; k <= kHarmonics; ++k) text += fmt::format(",harmonic_{}", k);
  text += '\n';
  for (const Mode& mode : result.modes) {
    text += fmt::format("{},{},{},{},{},{},{}", quoted_csv_cell(mode.of), csv_cell(mode.name),
                        hertz(mode.frequency), mode.frequency, damping_of(mode),
                        plain_zero(mode.eigenvalue.real()), mode.grows() ? 1 : 0);
    const ModeEnergy& energy = mode.energy;
    for (const double share : {energy.flap, energy.lag, energy.axial, energy.torsion, energy.hub})
      text += share_cell(share);
    if (result.equilibrium.hub) text += share_cell(energy.support);
    for (const double share : energy.bodies) text += share_cell(share);
    if (result.frame == ModeFrame::floquet)
      for (int k = -kHarmonics; k <= kHarmonics; ++k) text += share_cell(share_of(k, mode));
    text += '\n';
  }
  return text;
}

}  // namespace spoke::steady_report
