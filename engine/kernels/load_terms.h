#pragma once

// Loads of the user's in the table: where they act, their evaluation, and their share in the
// bodies' equations of motion.

#include <exception>
#include <string>
#include <vector>

#include "engine/table/step_data.h"

namespace spoke {

/// Asks loads for their markers. Throws InputError if a load is none or has no marker, LoadError if
/// it throws.
std::vector<AskedLoad> ask_loads(const Loads& loads);

/// Whether a load has markers on several subsystems: these are then coupled (StepData::is_coupled).
bool ties_subsystems(const std::vector<AskedLoad>& loads) noexcept;

/// Puts loads on the table of a system, which is allocated, coupled if a load ties subsystems.
/// Throws InputError, naming the load, if a marker is on no body of the system.
template <class World>
void place_loads(const std::vector<AskedLoad>& loads, StepData<World>& data);

/// Returns the place of a marker in the table; `whose` begins the message. Throws InputError if it
/// is on no body.
template <class World>
PlacedMarker<World> place_marker(const std::string& whose, const Marker& marker,
                                 const StepData<World>& data);

/// Returns load number `index` of those placed. Throws InputError if there is none.
template <class World>
LoadData<World>& find_load(int index, StepData<World>& data);

/// Throws InputError unless a load can take the place of another's.
template <class World>
void require_same_markers(const std::shared_ptr<const Load>& load, const LoadData<World>& data);

/// Evaluates a load at time `t` [s] and the state in the table. If it fails, its wrenches are no
/// numbers, which ends the step, and `load.thrown` says why.
template <class World>
void evaluate_load(double t, const System<World>& system, const StepData<World>& data,
                   LoadData<World>& load) noexcept;

/// A load that has thrown.
struct FailedLoad {
  std::string sentence;  ///< "the load NAME of blade 2 failed AT: REASON"
  std::exception_ptr thrown;
};

/// Returns the first load that has thrown since, in the order of the subsystems; `at` says when,
/// `names` what subsystems are called. Precondition: data.is_any_load_failed().
template <class World>
FailedLoad find_failed_load(const StepData<World>& data, const std::vector<std::string>& names,
                            const std::string& at);

}  // namespace spoke
