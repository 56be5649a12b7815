// Checks and places the user's loads, calls them, and turns their forces into terms of bodies.

#include "engine/kernels/load_terms.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "engine/kernels/blade_loads.h"
#include "engine/kernels/kinematics.h"
#include "engine/kernels/marker_motion.h"
#include "models/count_text.h"
#include "models/error.h"

namespace spoke {
namespace {

std::string reason_of(const std::exception_ptr& thrown) {
  try {
    std::rethrow_exception(thrown);
  } catch (const std::exception& error) {
    return error.what();
  } catch (...) {
    return "it threw what is no std::exception";
  }
}

std::string name_of(const Load& load) {
  try {
    return load.name();
  } catch (...) {
    return "(without a name: " + reason_of(std::current_exception()) + ")";
  }
}

std::string called(const Load& load) { return "the load \"" + name_of(load) + "\""; }

std::vector<Marker> ask_markers(const Load& load) {
  try {
    return load.markers();
  } catch (...) {
    throw LoadError(called(load) +
                    " does not tell its markers: " + reason_of(std::current_exception()));
  }
}

/// Throws InputError unless 0 <= index < count.
void require_index(const std::string& whose, const char* what, int index, std::size_t count) {
  if (index >= 0 && static_cast<std::size_t>(index) < count) return;
  throw InputError(whose + ": " + what + " index " + std::to_string(index) + ", expected " +
                   range_text(0, static_cast<int>(count) - 1));
}

std::vector<int> blades_of(const std::vector<Marker>& markers) {
  std::vector<int> blades;
  for (const Marker& marker : markers) blades.push_back(marker.blade);
  std::sort(blades.begin(), blades.end());
  blades.erase(std::unique(blades.begin(), blades.end()), blades.end());
  return blades;
}

/// "blade 2", "blades 1, 2 and 3"
std::string text_of(const std::vector<int>& blades) {
  std::string text = blades.size() == 1 ? "blade " : "blades ";
  for (std::size_t k = 0; k < blades.size(); ++k) {
    if (k > 0) text += k + 1 == blades.size() ? " and " : ", ";
    text += std::to_string(blades[k] + 1);
  }
  return text;
}

/// Lists a load's wrenches with the bodies that they act on.
void apply(LoadData<Plane>& load, StepData<Plane>& data) {
  for (std::size_t k = 0; k < load.markers.size(); ++k) {
    const PlacedMarker<Plane>& marker = load.markers[k];
    data.subsystems[static_cast<std::size_t>(marker.blade)]
        .bodies[static_cast<std::size_t>(marker.body)]
        .applied.push_back({&marker.section, &load.wrenches[k]});
  }
}

/// The load of one of its blades, the first, in the table: there its data lie.
LoadData<Plane>& add_load_data(const AskedLoad& asked, StepData<Plane>& table) {
  const std::vector<Marker>& markers = asked.markers;
  LoadData<Plane> data;
  data.load = asked.load;
  data.given = markers;
  data.blades = blades_of(markers);
  for (const Marker& marker : markers)
    data.markers.push_back(place_marker(called(*asked.load), marker, table));
  SubsystemData<Plane>& subsystem = table.subsystems[static_cast<std::size_t>(data.blades.front())];
  data.wrenches = ArenaVector<SectionWrench<Plane>>(markers.size(), *subsystem.arena);
  data.motions.resize(markers.size());
  data.forces.resize(markers.size());
  return subsystem.loads.emplace_back(std::move(data));
}

void require_planar(const Wrench& wrench) {
  if (!wrench.force.allFinite() || !wrench.moment.allFinite())
    throw std::domain_error("its force or moment is not finite");
  if (wrench.force.z() != 0.0 || wrench.moment.x() != 0.0 || wrench.moment.y() != 0.0)
    throw std::domain_error(
        "the system moves in the x-y plane, expected no force along z and no moment about x or y");
}

void call(double t, const System<Plane>& system, const StepData<Plane>& data,
          LoadData<Plane>& load) {
  for (std::size_t k = 0; k < load.markers.size(); ++k) {
    const auto blade = static_cast<std::size_t>(load.markers[k].blade);
    load.motions[k] =
        calc_marker_motion(system.subsystems[blade], data.subsystems[blade], load.markers[k]);
  }
  std::fill(load.forces.begin(), load.forces.end(), Wrench{});
  load.load->evaluate(t, load.motions, load.forces);
  for (std::size_t k = 0; k < load.markers.size(); ++k) {
    const Wrench& wrench = load.forces[k];
    require_planar(wrench);
    const SubsystemData<Plane>& subsystem =
        data.subsystems[static_cast<std::size_t>(load.markers[k].blade)];
    const Rotation R = subsystem.hub->R * calc_rotation_to_hub(subsystem, load.markers[k].body);
    load.wrenches[k].force = R.inverse() * Position{wrench.force.x(), wrench.force.y()};
    load.wrenches[k].moment = wrench.moment.z();
  }
}

}  // namespace

PlacedMarker<Plane> place_marker(const std::string& whose, const Marker& marker,
                                 const StepData<Plane>& data) {
  require_index(whose, "blade", marker.blade, data.subsystems.size());
  const SubsystemData<Plane>& subsystem = data.subsystems[static_cast<std::size_t>(marker.blade)];
  require_index(whose, "body", marker.body, subsystem.bodies.size());
  if (!(marker.station >= 0.0 && marker.station <= 1.0))
    throw InputError(whose + ": station " + std::to_string(marker.station) + ", expected 0 to 1");
  const BodyData<Plane>& body = subsystem.bodies[static_cast<std::size_t>(marker.body)];
  return {marker.blade, marker.body, make_section(*body.model->body, body.layout, marker.station)};
}

LoadData<Plane>& find_load(int index, StepData<Plane>& data) {
  std::size_t count = 0;
  for (SubsystemData<Plane>& subsystem : data.subsystems)
    for (LoadData<Plane>& load : subsystem.loads) {
      if (load.number == index) return load;
      ++count;
    }
  throw InputError("load index " + std::to_string(index) + ", expected " +
                   range_text(0, static_cast<int>(count) - 1));
}

void require_same_markers(const std::shared_ptr<const Load>& load, const LoadData<Plane>& data) {
  if (!load) throw InputError("a load is a null pointer");
  if (ask_markers(*load) != data.given)
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

bool ties_blades(const std::vector<AskedLoad>& loads) noexcept {
  return std::any_of(loads.begin(), loads.end(), [](const AskedLoad& asked) {
    const int first = asked.markers.front().blade;
    return std::any_of(asked.markers.begin(), asked.markers.end(),
                       [first](const Marker& marker) { return marker.blade != first; });
  });
}

void place_loads(const std::vector<AskedLoad>& loads, StepData<Plane>& data) {
  int number = 0;
  for (const AskedLoad& asked : loads) add_load_data(asked, data).number = number++;
  for (SubsystemData<Plane>& subsystem : data.subsystems)
    for (LoadData<Plane>& load : subsystem.loads) apply(load, data);
}

void evaluate_load(double t, const System<Plane>& system, const StepData<Plane>& data,
                   LoadData<Plane>& load) noexcept {
  try {
    call(t, system, data, load);
  } catch (...) {
    if (!load.thrown) load.thrown = std::current_exception();
    constexpr double none = std::numeric_limits<double>::quiet_NaN();
    std::fill(load.wrenches.begin(), load.wrenches.end(), SectionWrench<Plane>{{none, none}, none});
  }
}

void add_applied(const Twist& twist, BodyData<Plane>& body) noexcept {
  for (const auto& [section, wrench] : body.applied)
    add_wrench(*section, wrench->force, wrench->moment, twist, body);
}

std::string describe_failed_load(const StepData<Plane>& data, const std::string& at) {
  assert(data.is_any_load_failed());
  for (const SubsystemData<Plane>& subsystem : data.subsystems)
    for (const LoadData<Plane>& load : subsystem.loads)
      if (load.thrown)
        return called(*load.load) + " of " + text_of(load.blades) + " failed " + at + ": " +
               reason_of(load.thrown);
  return {};
}

}  // namespace spoke
