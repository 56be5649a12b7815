#pragma once

// Loads of the user's in the table: where they act, their evaluation, and their share in the
// bodies' equations of motion.

#include <string>

#include "engine/step_data.h"

namespace spoke {

/// Puts loads on the table of `system`, which is allocated. Throws InputError, naming the load, if
/// a marker is on no body of the system, or markers are on several blades.
void place_loads(const Loads& loads, StepData& data);

/// A marker on the table; `whose` begins the message. Throws InputError if it is on no body.
PlacedMarker place_marker(const std::string& whose, const Marker& marker, const StepData& data);

/// Load number `index` of those placed. Throws InputError if there is none.
LoadData& find_load(int index, StepData& data);

/// Throws InputError unless a load can take the place of another's.
void demand_same_markers(const std::shared_ptr<const Load>& load, const LoadData& data);

/// Evaluates a load at time `t` [s] and the state in the table. If it fails, its wrenches are no
/// numbers, which ends the step, and `load.thrown` says why.
void evaluate_load(double t, const Subsystem& subsystem, const SubsystemData& data,
                   LoadData& load) noexcept;

/// Adds the wrenches on a body to its right-hand side, and their power; `twist`: of its frame.
void add_applied(const Twist& twist, BodyData& body) noexcept;

/// Forgets what loads have thrown.
void clear_load_failures(StepData& data) noexcept;

/// A load that has thrown since.
struct FailedLoad {
  int blade = -1;  ///< -1: none has
  std::string name;
  std::string reason;
};
/// The first one, in the order of the blades. What std::exception it threw says the reason.
FailedLoad find_failed_load(const StepData& data);

bool has_loads(const StepData& data) noexcept;
bool is_any_load_failed(const StepData& data) noexcept;

}  // namespace spoke
