#pragma once

// Checkpoints: a state in a file, and what `spoke run` has recorded up to it. docs/checkpoint.md
// describes the format.

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "engine/results.h"
#include "engine/saved_state.h"
#include "engine/sensor_file.h"
#include "spoke/export.h"

namespace spoke {

/// The largest deflection of a blade's tip so far.
struct TipExtreme {
  double largest = 0.0;  ///< across the undeformed blade [m]
  double time = 0.0;     ///< when it was first reached [s]
};

/// What a run has recorded up to a checkpoint.
struct RunRecord {
  double output_interval = 0.0;     ///< of the rows [s]
  double next_multiple = 0.0;       ///< see OutputTimes
  double last_row = 0.0;            ///< time of the last row [s]
  double wall_time = 0.0;           ///< of the integration loop so far [s]
  std::vector<SensorRange> ranges;  ///< by sensor
  std::vector<TipExtreme> tips;     ///< by blade
  SensorFileMark rows;              ///< how far sensors.csv went
};

/// What a checkpoint file holds.
struct Checkpoint {
  std::string program;              ///< version of Spoke that wrote it
  SavedState state;                 ///< of the simulation
  std::optional<RunRecord> record;  ///< absent if no `spoke run` wrote it
  std::string instructions;         ///< of the process that wrote it: "baseline", "avx512", ...
};

/// The bytes of a checkpoint file; `program` is this version of Spoke, `instructions` are those
/// that this process computes with.
SPOKE_EXPORT std::string make_checkpoint(const SavedState& state,
                                         const std::optional<RunRecord>& record = {});

/// Reads the bytes of a checkpoint file called `name`. Throws InputError, "NAME: " and the reason,
/// if they are damaged, truncated, no checkpoint, or of another format. Whether the state fits a
/// simulation is left to Simulation::restore().
SPOKE_EXPORT Checkpoint parse_checkpoint(std::string_view bytes, const std::string& name);

/// Writes a checkpoint so that, whenever the process or the machine stops, the file is the old one
/// or the new one as a whole. Throws InputError if it cannot be written.
SPOKE_EXPORT void save_checkpoint(const std::string& file, const SavedState& state,
                                  const std::optional<RunRecord>& record = {});

/// Throws InputError like parse_checkpoint(), or if the file cannot be read.
SPOKE_EXPORT Checkpoint load_checkpoint(const std::string& file);

}  // namespace spoke
