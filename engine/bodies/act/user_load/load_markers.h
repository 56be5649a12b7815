#pragma once

// The markers of the user's loads: asked for, checked, and placed on the bodies of the table.

#include <exception>
#include <memory>
#include <string>
#include <vector>

#include "engine/bodies/table/step_data.h"
#include "engine/load.h"

namespace spoke {

/// A load, and the markers that it asked for.
struct AskedLoad {
  std::shared_ptr<const Load> load;
  std::vector<Marker> markers;
};

/// Asks loads for their markers. Throws InputError if a load is none or has no marker, LoadError if
/// it throws.
std::vector<AskedLoad> ask_loads(const Loads& loads);

/// Whether a load has markers on several subsystems: these are then coupled (StepData::is_coupled).
bool ties_subsystems(const std::vector<AskedLoad>& loads) noexcept;

/// Returns the place of a marker in the table; `whose` begins the message. Throws InputError if it
/// is on no body.
template <class World>
PlacedMarker<World> place_marker(const std::string& whose, const Marker& marker,
                                 const StepData<World>& data);

/// Throws InputError unless a load can take the place of one that has given these markers.
void require_same_markers(const std::shared_ptr<const Load>& load,
                          const std::vector<Marker>& given);

/// Returns `the load "NAME"`, as messages call it.
std::string called(const Load& load);
/// Returns what an exception says.
std::string reason_of(const std::exception_ptr& thrown);

}  // namespace spoke
