// Checks and places the user's loads, calls them, and turns their forces into terms of bodies.

#include "engine/kernels/load_terms.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <exception>
#include <limits>
#include <stdexcept>
#include <string_view>

#include "engine/kernels/applied_forces.h"
#include "engine/kernels/kinematics.h"
#include "engine/kernels/marker_motion.h"
#include "engine/kernels/marker_rules.h"
#include "engine/table/body_kind.h"
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

std::vector<int> subsystems_of(const std::vector<Marker>& markers) {
  std::vector<int> subsystems;
  for (const Marker& marker : markers) subsystems.push_back(marker.blade);
  std::sort(subsystems.begin(), subsystems.end());
  subsystems.erase(std::unique(subsystems.begin(), subsystems.end()), subsystems.end());
  return subsystems;
}

/// Names subsystems: "blade 2", "blades 1, 2 and 3", "blade 1 and arm".
std::string text_of(const std::vector<int>& subsystems, const std::vector<std::string>& names) {
  constexpr std::string_view kBlade = "blade ";
  std::vector<std::string> called;
  for (const int i : subsystems) called.push_back(names[static_cast<std::size_t>(i)]);
  std::string text;
  if (called.size() > 1 && std::all_of(called.begin(), called.end(), [&](const std::string& name) {
        return name.starts_with(kBlade);
      })) {
    text = "blades ";
    for (std::string& name : called) name.erase(0, kBlade.size());
  }
  for (std::size_t k = 0; k < called.size(); ++k) {
    if (k > 0) text += k + 1 == called.size() ? " and " : ", ";
    text += called[k];
  }
  return text;
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

void require_fitting(const Wrench& wrench, const BodyData<Plane>&) {
  if (wrench.force.z() != 0.0 || wrench.moment.x() != 0.0 || wrench.moment.y() != 0.0)
    throw std::domain_error(
        "the system moves in the x-y plane, expected no force along z and no moment about x or y");
}
void require_fitting(const Wrench&, const BodyData<Space>&) {}

/// Resolves a wrench, given in the inertial frame, in the frame of a body.
SectionWrench<Plane> resolve(const Wrench& wrench, const Subsystem<Plane>&,
                             const SubsystemData<Plane>& data, int body) {
  const plane::Rotation R = data.hub->R * calc_rotation_to_hub(data, body);
  return {R.inverse() * Position{wrench.force.x(), wrench.force.y()}, wrench.moment.z()};
}
SectionWrench<Space> resolve(const Wrench& wrench, const Subsystem<Space>& subsystem,
                             const SubsystemData<Space>& data, int body) {
  const space::Rotation R = (data.hub->R * calc_rotation_to_hub(subsystem, data, body)).inverse();
  return {R * space::Position(wrench.force), R * space::Angular(wrench.moment)};
}

void set_all(double value, SectionWrench<Plane>& wrench) {
  wrench = {Position::Constant(value), value};
}
void set_all(double value, SectionWrench<Space>& wrench) {
  wrench = {space::Position::Constant(value), space::Angular::Constant(value)};
}

/// Lists a load's wrenches with the bodies that they act on.
template <class World>
void apply(LoadData<World>& load, StepData<World>& data) {
  for (std::size_t k = 0; k < load.markers.size(); ++k) {
    const PlacedMarker<World>& marker = load.markers[k];
    data.subsystems[static_cast<std::size_t>(marker.subsystem)]
        .bodies[static_cast<std::size_t>(marker.body)]
        .applied.push_back({&marker.section, &load.wrenches[k]});
  }
}

/// Adds a load to the table; its data lie with the first of its subsystems.
template <class World>
LoadData<World>& add_load_data(const AskedLoad& asked, StepData<World>& table) {
  const std::vector<Marker>& markers = asked.markers;
  LoadData<World> data;
  data.load = asked.load;
  data.given = markers;
  data.subsystems = subsystems_of(markers);
  for (const Marker& marker : markers)
    data.markers.push_back(place_marker(called(*asked.load), marker, table));
  SubsystemData<World>& subsystem =
      table.subsystems[static_cast<std::size_t>(data.subsystems.front())];
  data.wrenches = ArenaVector<SectionWrench<World>>(markers.size(), *subsystem.arena);
  for (SectionWrench<World>& wrench : data.wrenches) set_all(0.0, wrench);
  std::vector<graph::PartId>& parts = subsystem.parts.loads;
  parts.push_back(subsystem.part_maker.cover("load " + std::to_string(parts.size() + 1), Mark::none,
                                             data.wrenches));
  data.motions.resize(markers.size());
  data.forces.resize(markers.size());
  return subsystem.loads.emplace_back(std::move(data));
}

template <class World>
void call(double t, const System<World>& system, const StepData<World>& data,
          LoadData<World>& load) {
  for (std::size_t k = 0; k < load.markers.size(); ++k) {
    const auto i = static_cast<std::size_t>(load.markers[k].subsystem);
    load.motions[k] = calc_load_motion(system.subsystems[i], data.subsystems[i], load.markers[k]);
  }
  std::fill(load.forces.begin(), load.forces.end(), Wrench{});
  load.load->evaluate(t, load.motions, load.forces);
  for (std::size_t k = 0; k < load.markers.size(); ++k) {
    const Wrench& wrench = load.forces[k];
    if (!wrench.force.allFinite() || !wrench.moment.allFinite())
      throw std::domain_error("its force or moment is not finite");
    const auto i = static_cast<std::size_t>(load.markers[k].subsystem);
    const int body = load.markers[k].body;
    const SubsystemData<World>& subsystem = data.subsystems[i];
    require_fitting(wrench, subsystem.bodies[static_cast<std::size_t>(body)]);
    load.wrenches[k] = resolve(wrench, system.subsystems[i], subsystem, body);
  }
}

}  // namespace

template <class World>
PlacedMarker<World> place_marker(const std::string& whose, const Marker& marker,
                                 const StepData<World>& data) {
  require_index(whose, "blade", marker.blade, data.subsystems.size());
  const SubsystemData<World>& subsystem = data.subsystems[static_cast<std::size_t>(marker.blade)];
  require_index(whose, "body", marker.body, subsystem.bodies.size());
  const BodyData<World>& body = subsystem.bodies[static_cast<std::size_t>(marker.body)];
  return {marker.blade, marker.body, place_section(whose, marker, body)};
}

template <class World>
LoadData<World>& find_load(int index, StepData<World>& data) {
  std::size_t count = 0;
  for (SubsystemData<World>& subsystem : data.subsystems)
    for (LoadData<World>& load : subsystem.loads) {
      if (load.number == index) return load;
      ++count;
    }
  throw InputError("load index " + std::to_string(index) + ", expected " +
                   range_text(0, static_cast<int>(count) - 1));
}

template <class World>
void require_same_markers(const std::shared_ptr<const Load>& load, const LoadData<World>& data) {
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

bool ties_subsystems(const std::vector<AskedLoad>& loads) noexcept {
  assert(std::none_of(loads.begin(), loads.end(),
                      [](const AskedLoad& asked) { return asked.markers.empty(); }));
  return std::any_of(loads.begin(), loads.end(), [](const AskedLoad& asked) {
    const int first = asked.markers.front().blade;
    return std::any_of(asked.markers.begin(), asked.markers.end(),
                       [first](const Marker& marker) { return marker.blade != first; });
  });
}

template <class World>
void place_loads(const std::vector<AskedLoad>& loads, StepData<World>& data) {
  int number = 0;
  for (const AskedLoad& asked : loads) add_load_data(asked, data).number = number++;
  for (SubsystemData<World>& subsystem : data.subsystems)
    for (LoadData<World>& load : subsystem.loads) apply(load, data);
  place_applied_forces(data);
}

template <class World>
void evaluate_load(double t, const System<World>& system, const StepData<World>& data,
                   LoadData<World>& load) noexcept {
  assert(load.motions.size() == load.markers.size() && load.forces.size() == load.markers.size());
  assert(load.wrenches.size() == load.markers.size());
  try {
    call(t, system, data, load);
  } catch (...) {
    if (!load.thrown) load.thrown = std::current_exception();
    for (SectionWrench<World>& wrench : load.wrenches)
      set_all(std::numeric_limits<double>::quiet_NaN(), wrench);
  }
}

template <class World>
FailedLoad find_failed_load(const StepData<World>& data, const std::vector<std::string>& names,
                            const std::string& at) {
  assert(data.is_any_load_failed());
  for (const SubsystemData<World>& subsystem : data.subsystems)
    for (const LoadData<World>& load : subsystem.loads)
      if (load.thrown)
        return {called(*load.load) + " of " + text_of(load.subsystems, names) + " failed " + at +
                    ": " + reason_of(load.thrown),
                load.thrown};
  return {};
}

template void place_loads(const std::vector<AskedLoad>&, StepData<Plane>&);
template PlacedMarker<Plane> place_marker(const std::string&, const Marker&,
                                          const StepData<Plane>&);
template LoadData<Plane>& find_load(int, StepData<Plane>&);
template void require_same_markers(const std::shared_ptr<const Load>&, const LoadData<Plane>&);
template void evaluate_load(double, const System<Plane>&, const StepData<Plane>&,
                            LoadData<Plane>&) noexcept;
template FailedLoad find_failed_load(const StepData<Plane>&, const std::vector<std::string>&,
                                     const std::string&);
template void place_loads(const std::vector<AskedLoad>&, StepData<Space>&);
template PlacedMarker<Space> place_marker(const std::string&, const Marker&,
                                          const StepData<Space>&);
template LoadData<Space>& find_load(int, StepData<Space>&);
template void require_same_markers(const std::shared_ptr<const Load>&, const LoadData<Space>&);
template void evaluate_load(double, const System<Space>&, const StepData<Space>&,
                            LoadData<Space>&) noexcept;
template FailedLoad find_failed_load(const StepData<Space>&, const std::vector<std::string>&,
                                     const std::string&);

}  // namespace spoke
