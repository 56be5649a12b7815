// Makes the sentence, the table and the files of a critical value.

#include "program/steady_report/critical_files.h"

#include <spdlog/fmt/fmt.h>

#include "engine/small_motions/steady/steady_warnings.h"
#include "engine/support/csv_cell.h"
#include "engine/support/plain_zero.h"
#include "models/support/json.h"
#include "program/steady_report/mode_files.h"
#include "program/steady_report/mode_json.h"

namespace spoke::steady_report {
namespace {

using report::Align;

/// Returns the mode of a branch at value k; null if there is none.
const Mode* mode_at(const CriticalResult& result, const CampbellBranch& branch, std::size_t k) {
  return branch.modes[k] ? &result.states[k].modes[*branch.modes[k]] : nullptr;
}

bool is_critical(const CriticalResult& result, const CampbellBranch& branch, std::size_t k) {
  return result.critical && result.critical->state == k && result.critical->mode &&
         branch.modes[k] == result.critical->mode;
}

/// Returns what becomes of the critical mode.
std::string describe_kind(const CriticalPoint& critical) {
  switch (critical.kind) {
    case CriticalKind::buckling:
      return "its stiffness is zero there";
    case CriticalKind::divergence:
      return "its stiffness is zero there, and it grows beyond";
    case CriticalKind::flutter:
      return fmt::format("it grows beyond, vibrating with {:.6g} Hz", hertz(critical.frequency));
    case CriticalKind::critical_speed:
      return "its frequency in the turning frame is zero there, once per revolution from outside";
    case CriticalKind::limit_point:
      return "its stiffness is zero where the equilibrium ends";
    case CriticalKind::jump:
      return "the steady state that was followed ends there, and another one is far from it";
    case CriticalKind::no_equilibrium:
      break;
  }
  return "no equilibrium is found beyond";
}

/// Returns which body bends most in a steady state, and by how much.
std::string describe_state(const EquilibriumResult& state) {
  const steady::LargestBending largest = steady::find_largest_bending(state);
  if (largest.ratio == 0.0) return "with nothing bent";
  return fmt::format("with {} bent by {:.3g} %", steady::name_body(state, largest),
                     100.0 * largest.ratio);
}

Json critical_json(const CriticalResult& result) {
  if (!result.critical) return {};
  const CriticalPoint& critical = *result.critical;
  const ModesResult& state = result.states[critical.state];
  Json mode;
  if (critical.mode) {
    mode = mode_json(state.modes[*critical.mode], state.bodies);
    mode.set("name", critical.name);
    mode.set("of", critical.of);
  }
  Json beyond;
  if (critical.beyond)
    beyond = {{"value", result.values[*critical.beyond]},
              {"equilibrium", nodes_json(result.states[*critical.beyond].equilibrium)}};
  return {{"kind", name_of(critical.kind)},
          {"value", critical.value},
          {"resolution", critical.resolution},
          {"speed_rad_per_s", state.equilibrium.speed},
          {"frequency_Hz", hertz(critical.frequency)},
          {"frequency_rad_per_s", critical.frequency},
          {"equilibrium", nodes_json(state.equilibrium)},
          {"mode", mode},
          {"beyond", beyond}};
}

}  // namespace

std::string VariedQuantity::with_unit(double value, int digits) const {
  return fmt::format("{:.{}g}{}", value, digits, unit.empty() ? "" : ' ' + unit);
}

VariedQuantity name_varied(const CriticalOptions& options) {
  if (options.of == "speed") return {"speed", "rad/s", "speed_rad_per_s"};
  const std::string name = options.of.substr(options.of.find('=') + 1);
  return {name == "gravity" ? "factor of gravity" : "factor of the load " + name, "",
          "load_factor"};
}

std::string describe_critical(const CriticalResult& result, const CriticalOptions& options) {
  const VariedQuantity varied = name_varied(options);
  if (!result.critical)
    return fmt::format("none: the equilibrium is stable from {} to {}",
                       varied.with_unit(options.from, 6), varied.with_unit(options.to, 6));
  const CriticalPoint& critical = *result.critical;
  std::string text = fmt::format("{} at {}", name_of(critical.kind),
                                 (varied.is_speed() ? "" : "a " + varied.name + " of ") +
                                     varied.with_unit(critical.value, 10));
  if (critical.beyond)
    return text + fmt::format(
                      ": the steady state that was followed ends there, {}; beyond, another one is "
                      "found, {}",
                      describe_state(result.states[critical.state].equilibrium),
                      describe_state(result.states[*critical.beyond].equilibrium));
  if (critical.mode) text += ", " + critical.name + " of " + critical.of;
  return text + ": " + describe_kind(critical);
}

report::Table make_branch_table(const CriticalResult& result, const CriticalOptions& options) {
  const VariedQuantity varied = name_varied(options);
  const auto column = [&](std::size_t k) {
    return report::Column{"Hz at " + varied.with_unit(result.values[k], 6), Align::number};
  };
  std::vector<std::size_t> shown{0};
  if (result.critical) shown.push_back(result.critical->state);
  if (shown.back() + 1 < result.values.size()) shown.push_back(result.values.size() - 1);
  report::Table table{.caption = "Modes", .columns = {{"of"}, {"mode"}}};
  for (const std::size_t k : shown) table.columns.push_back(column(k));
  for (const CampbellBranch& branch : result.branches) {
    std::vector<std::string> cells{branch.of, branch.name};
    bool is_bad = false;
    for (const std::size_t k : shown) {
      const Mode* mode = mode_at(result, branch, k);
      cells.push_back(mode ? fmt::format("{:.6g}", hertz(mode->frequency)) : "");
      is_bad = is_bad || is_critical(result, branch, k);
    }
    table.rows.push_back({cells, is_bad ? report::Tone::bad : report::Tone::plain});
  }
  return table;
}

std::string make_csv(const CriticalResult& result, const CriticalOptions& options) {
  std::string text = name_varied(options).column +
                     ",branch,of,mode,frequency_Hz,frequency_rad_per_s,damping_ratio,"
                     "eigenvalue_real_per_s,grows,critical\n";
  for (std::size_t k = 0; k < result.values.size(); ++k)
    for (std::size_t b = 0; b < result.branches.size(); ++b)
      if (const Mode* mode = mode_at(result, result.branches[b], k))
        text +=
            fmt::format("{},{},{},{},{},{},{},{},{},{}\n", result.values[k], b + 1,
                        quoted_csv_cell(result.branches[b].of), csv_cell(result.branches[b].name),
                        hertz(mode->frequency), mode->frequency, damping_of(*mode),
                        plain_zero(mode->eigenvalue.real()), mode->grows() ? 1 : 0,
                        is_critical(result, result.branches[b], k) ? 1 : 0);
  return text;
}

std::string make_json(const CriticalResult& result, const CriticalOptions& options) {
  Json branches = Json::array();
  for (const CampbellBranch& branch : result.branches) {
    Json frequencies = Json::array(), damping = Json::array(), growth = Json::array();
    for (std::size_t k = 0; k < result.values.size(); ++k) {
      const Mode* mode = mode_at(result, branch, k);
      frequencies.push_back(mode ? Json(mode->frequency) : Json());
      damping.push_back(mode ? Json(damping_of(*mode)) : Json());
      growth.push_back(mode ? Json(plain_zero(mode->eigenvalue.real())) : Json());
    }
    branches.push_back({{"of", branch.of},
                        {"mode", branch.name},
                        {"frequencies_rad_per_s", frequencies},
                        {"damping_ratios", damping},
                        {"eigenvalues_real_per_s", growth}});
  }
  const VariedQuantity varied = name_varied(options);
  const Json json = {{"of", options.of},
                     {"unit", varied.is_speed() ? varied.unit : "1"},
                     {"from", options.from},
                     {"to", options.to},
                     {"critical", critical_json(result)},
                     {"values", result.values},
                     {"branches", branches}};
  return json.dump_lines();
}

}  // namespace spoke::steady_report
