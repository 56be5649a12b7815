// Checks that a checkpoint fits the run, and writes the next one when it is due.

#include "program/cli/checkpoints.h"

#include <spdlog/spdlog.h>

#include <algorithm>
#include <fstream>
#include <string>
#include <utility>

#include "models/count_text.h"
#include "models/error.h"
#include "models/support/instructions.h"
#include "program/cli/report.h"
#include "program/cli/standard_streams.h"
#include "program/run_report/tip_deflections.h"

namespace spoke::cli {
namespace {

[[noreturn]] void refuse(const std::filesystem::path& file, const std::string& reason) {
  throw InputError(file.string() + ": cannot be resumed: " + reason);
}

/// Throws InputError, saying why, unless the record is one of this run.
void require_fit(const std::filesystem::path& file, const RunRecord& record,
                 const Simulation& simulation) {
  const double interval = simulation.scenario().output.interval;
  if (record.output_interval != interval)
    refuse(file, fmt::format("output.interval is {} in the checkpoint and {} here",
                             record.output_interval, interval));
  const std::size_t sensors = simulation.sensor_names().size();
  const std::size_t tips = run_report::count_tips(simulation.scenario());
  if (record.ranges.size() != sensors || record.tips.size() != tips)
    refuse(file, fmt::format("it has records of {} and {}, expected {} and {}",
                             counted(std::ssize(record.ranges), "sensor"),
                             counted(std::ssize(record.tips), "tip"), sensors, tips));
}

}  // namespace

namespace {

/// Throws InputError if the rows are of other sensors. Other faults of the file are found when it
/// is opened.
void require_columns(const std::filesystem::path& file, const Simulation& simulation) {
  const std::filesystem::path rows = file.parent_path() / "sensors.csv";
  std::ifstream stream(rows);
  std::string header;
  if (!std::getline(stream, header)) return;
  std::string expected = "t";
  for (const std::string& head : column_heads(simulation)) expected += "," + head;
  if (header != expected)
    refuse(file, rows.string() + " has other columns than the sensors of the scenario");
}

}  // namespace

Checkpoint resume(const std::filesystem::path& file, Simulation& simulation) {
  Checkpoint checkpoint = load_checkpoint(file);
  if (!checkpoint.record)
    refuse(file, "it holds a state without the records of a run: expected one of spoke run");
  try {
    simulation.restore(checkpoint.state);
  } catch (const InputError& error) {
    refuse(file, error.what());
  }
  if (checkpoint.instructions != instructions_in_use())
    refuse(file, fmt::format("it was computed with the instructions \"{}\", here they are \"{}\", "
                             "which have other bits (see --instructions)",
                             checkpoint.instructions, instructions_in_use()));
  require_fit(file, *checkpoint.record, simulation);
  require_columns(file, simulation);
  if (simulation.steps() > simulation.planned_steps())
    refuse(file, fmt::format("it stands at t = {:.6g} s, beyond the duration of {:.6g} s",
                             simulation.time(), simulation.scenario().integration.duration));
  return checkpoint;
}

void warn_of_version(const std::filesystem::path& file, const Checkpoint& checkpoint) {
  if (checkpoint.program == SPOKE_VERSION) return;
  print_error(fmt::format("warning: {}: written by Spoke {}; with {} the last bits may differ",
                          one_line(file.string()), one_line(checkpoint.program), SPOKE_VERSION));
}

Checkpoints::Checkpoints(std::filesystem::path file, std::optional<double> every)
    : file_(std::move(file)), every_(every) {
  start_waiting();
}

void Checkpoints::start_waiting() {
  // Beyond a year nobody waits, and clocks count in nanoseconds.
  constexpr double most = 3e7;  // s
  if (!every_) return;
  next_ = Clock::now() + std::chrono::duration_cast<Clock::duration>(
                             std::chrono::duration<double>(std::min(*every_, most)));
}

void Checkpoints::save(const Simulation& simulation, const RunRecord& record) {
  save_checkpoint(file_, simulation.save(), record);
  spdlog::debug("{}: t = {:.6g} s", file_.string(), simulation.time());
  start_waiting();
}

}  // namespace spoke::cli
