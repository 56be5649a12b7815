#pragma once

// Loads of the user's in the table: where they act, their evaluation, and their share in the
// bodies' equations of motion.

#include <string>
#include <vector>

#include "engine/table/step_data.h"

namespace spoke {

/// Asks loads for their markers. Throws InputError if a load is none or has no marker, LoadError if
/// it throws.
std::vector<AskedLoad> ask_loads(const Loads& loads);

/// Whether a load has markers on several blades: these are then coupled (StepData::is_coupled).
bool ties_blades(const std::vector<AskedLoad>& loads) noexcept;

/// Puts loads on the table of a system, which is allocated, coupled if a load ties blades. Throws
/// InputError, naming the load, if a marker is on no body of the system.
void place_loads(const std::vector<AskedLoad>& loads, StepData<Plane>& data);

/// A marker on the table; `whose` begins the message. Throws InputError if it is on no body.
PlacedMarker<Plane> place_marker(const std::string& whose, const Marker& marker,
                                 const StepData<Plane>& data);

/// Load number `index` of those placed. Throws InputError if there is none.
LoadData<Plane>& find_load(int index, StepData<Plane>& data);

/// Throws InputError unless a load can take the place of another's.
void require_same_markers(const std::shared_ptr<const Load>& load, const LoadData<Plane>& data);

/// Evaluates a load at time `t` [s] and the state in the table. If it fails, its wrenches are no
/// numbers, which ends the step, and `load.thrown` says why.
void evaluate_load(double t, const System<Plane>& system, const StepData<Plane>& data,
                   LoadData<Plane>& load) noexcept;

/// Adds the wrenches on a body to its right-hand side, and their power; `twist`: of its frame.
void add_applied(const Twist& twist, BodyData<Plane>& body) noexcept;

/// "the load NAME of blade 2 failed AT: REASON" of the first load that has thrown since, in the
/// order of the blades; `at` says when. Precondition: data.is_any_load_failed().
std::string describe_failed_load(const StepData<Plane>& data, const std::string& at);

}  // namespace spoke
