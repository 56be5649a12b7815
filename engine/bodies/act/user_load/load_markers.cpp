// Asks loads for their markers, and places markers on the bodies of the table.

#include "engine/bodies/act/user_load/load_markers.h"

#include <algorithm>
#include <cassert>
#include <exception>

#include "engine/bodies/kernels/marker_rules.h"
#include "engine/bodies/table/body_kind.h"
#include "models/count_text.h"
#include "models/error.h"

namespace spoke {
namespace {

std::string name_of(const Load& load) {
  try {
    return load.name();
  } catch (...) {
    return "(without a name: " + reason_of(std::current_exception()) + ")";
  }
}

std::vector<Marker> ask_markers(const Load& load) {
  try {
    return load.markers();
  } catch (...) {
    std::throw_with_nested(LoadError(
        called(load) + " does not tell its markers: " + reason_of(std::current_exception())));
  }
}

/// Throws InputError unless 0 <= index < count.
void require_index(const std::string& whose, const char* what, int index, std::size_t count) {
  if (index >= 0 && static_cast<std::size_t>(index) < count) return;
  throw InputError(whose + ": " + what + " index " + std::to_string(index) + ", expected " +
                   range_text(0, static_cast<int>(count) - 1));
}

// Functions that differ by world.

plane::Section place_section(const std::string& whose, const Marker& marker,
                             const BodyData<Plane>& body) {
  require_on_beam(whose, marker);
  return make_section(*body.model->body, body.layout, marker.station);
}

space::Section place_section(const std::string& whose, const Marker& marker,
                             const BodyData<Space>& body) {
  return body.kind->place_marker(whose, marker, *body.model->body);
}

}  // namespace

std::string reason_of(const std::exception_ptr& thrown) {
  try {
    std::rethrow_exception(thrown);
  } catch (const std::exception& error) {
    return error.what();
  } catch (...) {
    return "it threw what is no std::exception";
  }
}

std::string called(const Load& load) { return "the load \"" + name_of(load) + "\""; }

template <class World>
PlacedMarker<World> place_marker(const std::string& whose, const Marker& marker,
                                 const StepData<World>& data) {
  require_index(whose, "blade", marker.blade, data.subsystems.size());
  const SubsystemData<World>& subsystem = data.subsystems[static_cast<std::size_t>(marker.blade)];
  require_index(whose, "body", marker.body, subsystem.bodies.size());
  const BodyData<World>& body = subsystem.bodies[static_cast<std::size_t>(marker.body)];
  return {marker.blade, marker.body, place_section(whose, marker, body)};
}

void require_same_markers(const std::shared_ptr<const Load>& load,
                          const std::vector<Marker>& given) {
  if (!load) throw InputError("a load is a null pointer");
  if (ask_markers(*load) != given)
    throw InputError(called(*load) + ": its markers are not those of the load that it replaces");
}

std::vector<AskedLoad> ask_loads(const Loads& loads) {
  std::vector<AskedLoad> asked;
  for (const std::shared_ptr<const Load>& load : loads) {
    if (!load) throw InputError("a load is a null pointer");
    asked.push_back({load, ask_markers(*load)});
    if (asked.back().markers.empty())
      throw InputError(called(*load) + ": it has no marker, expected one or more");
  }
  return asked;
}

bool ties_subsystems(const std::vector<AskedLoad>& loads) noexcept {
  assert(std::none_of(loads.begin(), loads.end(),
                      [](const AskedLoad& asked) { return asked.markers.empty(); }));
  return std::any_of(loads.begin(), loads.end(), [](const AskedLoad& asked) {
    const int first = asked.markers.front().blade;
    return std::any_of(asked.markers.begin(), asked.markers.end(),
                       [first](const Marker& marker) { return marker.blade != first; });
  });
}

template PlacedMarker<Plane> place_marker(const std::string&, const Marker&,
                                          const StepData<Plane>&);
template PlacedMarker<Space> place_marker(const std::string&, const Marker&,
                                          const StepData<Space>&);

}  // namespace spoke
