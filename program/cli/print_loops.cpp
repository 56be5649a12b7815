// Lines of loops: what each closes, what is left to move, what is locked twice.

#include "program/cli/print_loops.h"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <string>
#include <vector>

#include "models/count_text.h"
#include "program/cli/report.h"

namespace spoke::cli {
namespace {

constexpr std::size_t kMostMoved = 12;     // joints that are named
constexpr std::size_t kMostRedundant = 4;  // loops that are named for one redundant row

/// Names a place; `own`: the blade.
std::string describe(const LoopPlace& place, const std::string& own) {
  if (place.carrier == LoopPlace::Carrier::hub) return "the hub";
  if (place.carrier == LoopPlace::Carrier::mount) return "the mount";
  std::string name = place.name.empty() ? own : place.name;
  if (place.carrier == LoopPlace::Carrier::elsewhere)
    name = place.subsystem.empty() ? "blade " + std::to_string(place.blade)
                                   : place.subsystem + " / " + place.name;
  if (place.carrier == LoopPlace::Carrier::anchor || !place.station) return name;
  return fmt::format("{} at {:.6g} m", name, *place.station);
}

std::string describe(const Loop& loop, const std::string& own, bool in_plane) {
  const int rows = in_plane ? count_locked_in_plane(loop.kind) : count_locked(loop.kind);
  int soft = 0;
  for (const double stiffness : loop.stiffness) soft += stiffness > 0.0;
  if (loop.matrices) soft = rows;
  std::string locks = counted(rows, "row");
  if (soft == rows) locks += rows == 1 ? ", sprung" : ", all sprung";
  if (soft > 0 && soft < rows) locks += fmt::format(", {} sprung", soft);
  return fmt::format("{} ({}, {}), {} to {}", loop.name, name_of(loop.kind), locks,
                     describe(loop.from, own), describe(loop.to, own));
}

/// Returns "gear (coupling, 1 row): 4 a + 1 b = 0", where coordinates are from their start.
std::string describe(const Coupling& coupling) {
  std::string sum;
  for (const CoupledJoint& at : coupling.joints) {
    sum += sum.empty() ? (at.ratio < 0.0 ? "-" : "") : at.ratio < 0.0 ? " - " : " + ";
    sum += fmt::format("{:.6g} {}", std::abs(at.ratio), at.joint);
    if (at.coordinate > 1) sum += fmt::format("[{}]", at.coordinate);
  }
  return fmt::format("{} (coupling, 1 row{}), {} kept", coupling.name,
                     coupling.stiffness > 0.0 ? ", sprung" : "", sum);
}

struct OwnLoops {
  std::string name;
  const std::vector<Loop>* loops;
  const std::vector<Coupling>* couplings;  ///< null: there cannot be any
};

/// Returns the blades and subsystems that have loops or couplings.
std::vector<OwnLoops> find_owners(const Scenario& scenario) {
  std::vector<OwnLoops> owners;
  const auto add = [&owners](const std::string& name, const auto& of) {
    OwnLoops own{name, &of.loops, nullptr};
    bool has_any = !of.loops.empty();
    if constexpr (requires { of.couplings; }) {
      own.couplings = &of.couplings;
      has_any |= !of.couplings.empty();
    }
    if (has_any) owners.push_back(own);
  };
  const auto add_blades = [&add](const auto& blades) {
    for (std::size_t i = 0; i < blades.size(); ++i)
      add("blade " + std::to_string(i + 1), blades[i]);
  };
  if (!scenario.space) {
    add_blades(scenario.rotor.blades);
    return owners;
  }
  add_blades(scenario.space->blades);
  for (const spatial::Subsystem& subsystem : scenario.space->subsystems)
    add(subsystem.name, subsystem);
  return owners;
}

/// Returns those of a blade or subsystem. Precondition: it has loops or couplings.
const SubsystemFreedoms& find_freedoms(const LoopsAtStart& start, const std::string& name) {
  const auto at = std::find_if(start.subsystems.begin(), start.subsystems.end(),
                               [&name](const SubsystemFreedoms& own) { return own.name == name; });
  assert(at != start.subsystems.end());
  return *at;
}

std::string describe(const SubsystemFreedoms& own) {
  std::string text = counted(own.joints, "free joint coordinate");
  if (own.deformations > 0) text += " and " + std::to_string(own.deformations) + " of deformation";
  text += fmt::format(", less {}", counted(own.independent, "row"));
  if (own.rows > own.independent)
    text += fmt::format(" ({} of {} redundant)", own.rows - own.independent, own.rows);
  return text + ": mobility " + std::to_string(own.mobility);
}

void print_loop_lines(const std::string& label, const std::vector<std::string>& lines) {
  for (std::size_t k = 0; k < lines.size(); ++k) print_line(k == 0 ? label : "", lines[k]);
}

void print_changed_speeds(const std::vector<ChangedSpeed>& speeds) {
  std::vector<std::string> lines;
  for (std::size_t k = 0; k < speeds.size() && k < kMostMoved; ++k)
    lines.push_back(fmt::format(
        "{} from {:.6g} to {:.6g} {}, so that loops stay closed; hold = true on it keeps it",
        speeds[k].joint, speeds[k].from, speeds[k].to, speeds[k].unit));
  if (speeds.size() > kMostMoved)
    lines.push_back(fmt::format("and {} further joints", speeds.size() - kMostMoved));
  print_loop_lines("speeds", lines);
}

/// Returns the lines of redundant rows, "ring / hinge_6: displacement along x": those that follow
/// one another and differ by their loops alone as one.
std::vector<std::string> join_redundant(const std::vector<std::string>& rows) {
  std::vector<std::string> lines;
  for (std::size_t k = 0; k < rows.size();) {
    const std::string direction = rows[k].substr(rows[k].rfind(": "));
    std::string text;
    std::size_t count = 0;
    for (; k < rows.size() && rows[k].ends_with(direction); ++k)
      if (count++ < kMostRedundant)
        text += (text.empty() ? "" : ", ") + rows[k].substr(0, rows[k].size() - direction.size());
    if (count > kMostRedundant)
      text += " and " + counted(static_cast<int>(count - kMostRedundant), "further loop");
    lines.push_back(text + direction);
  }
  return lines;
}

}  // namespace

void print_loops(const Simulation& simulation) {
  const LoopsAtStart start = simulation.loops_at_start();
  const std::vector<OwnLoops> owners = find_owners(simulation.scenario());
  const bool in_plane = !simulation.scenario().space;
  std::vector<std::string> before, lines;
  std::string example;
  for (std::size_t k = 0; k < owners.size(); ++k) {
    std::vector<std::string> own;
    for (const Loop& loop : *owners[k].loops) own.push_back(describe(loop, "the blade", in_plane));
    if (owners[k].couplings)
      for (const Coupling& coupling : *owners[k].couplings) own.push_back(describe(coupling));
    own.push_back(describe(find_freedoms(start, owners[k].name)));
    if (own == before) {
      lines.push_back(owners[k].name + ": as " + example);
      continue;
    }
    for (const std::string& line : own) lines.push_back(owners[k].name + ": " + line);
    before = own;
    example = owners[k].name;
  }
  print_loop_lines("loops", lines);
  print_loop_lines("redundant", join_redundant(start.redundant));
  print_moved_joints(simulation);
}

void print_moved_joints(const Simulation& simulation) {
  const std::vector<MovedJoint> moved = simulation.loops_at_start().moved;
  std::vector<std::string> lines;
  for (std::size_t k = 0; k < moved.size() && k < kMostMoved; ++k)
    lines.push_back(fmt::format("{} by {:.6g} {}, so that loops are closed", moved[k].joint,
                                moved[k].by, moved[k].unit));
  if (moved.size() > kMostMoved)
    lines.push_back(fmt::format("and {} further joints", moved.size() - kMostMoved));
  print_loop_lines("moved", lines);
  print_changed_speeds(simulation.loops_at_start().speeds);
}

}  // namespace spoke::cli
