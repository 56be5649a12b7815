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
  double time = 0.0;     ///< at which it was first reached [s]
};

/// Records of a run up to a checkpoint.
struct RunRecord {
  double output_interval = 0.0;     ///< between output rows [s]
  double next_multiple = 0.0;       ///< OutputTimes::next_multiple()
  double last_row = 0.0;            ///< time of the last row [s]
  double wall_time = 0.0;           ///< of the integration loop so far [s]
  std::vector<SensorRange> ranges;  ///< by sensor
  std::vector<TipExtreme> tips;     ///< by blade
  SensorFileMark rows;              ///< end of sensors.csv at that time
};

/// Content of a checkpoint file.
struct Checkpoint {
  std::string program;              ///< version of Spoke that wrote it
  SavedState state;                 ///< of the simulation
  std::optional<RunRecord> record;  ///< absent if no `spoke run` wrote it
  std::string instructions;         ///< of the process that wrote it: "baseline", "avx512", ...
};

/// Returns the bytes of a checkpoint file. Its `program` is this version of Spoke, its
/// `instructions` are those with which this process computes.
SPOKE_EXPORT std::string make_checkpoint(const SavedState& state,
                                         const std::optional<RunRecord>& record = {});

/// Reads the bytes of a checkpoint file called `name`. Throws InputError, "NAME: " and the reason,
/// if they are damaged, truncated, no checkpoint, or of another format. Does not check whether the
/// state fits a simulation: Simulation::restore() does.
SPOKE_EXPORT Checkpoint parse_checkpoint(std::string_view bytes, const std::string& name);

/// Writes a checkpoint. Whenever the process or the machine stops, the file is the old one or the
/// new one as a whole. Throws InputError if it cannot be written.
SPOKE_EXPORT void save_checkpoint(const std::string& file, const SavedState& state,
                                  const std::optional<RunRecord>& record = {});

/// Reads a checkpoint file. Throws InputError like parse_checkpoint(), or if the file cannot be
/// read.
SPOKE_EXPORT Checkpoint load_checkpoint(const std::string& file);

}  // namespace spoke
