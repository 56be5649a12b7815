#include "engine/load_terms.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "engine/kinematics.h"
#include "engine/marker_motion.h"
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
void demand_index(const std::string& whose, const char* what, int index, std::size_t count) {
  if (index >= 0 && static_cast<std::size_t>(index) < count) return;
  throw InputError(whose + ": " + what + " index " + std::to_string(index) + ", expected 0 to " +
                   std::to_string(static_cast<int>(count) - 1));
}

/// The one blade of a load's markers.
int demand_blade(const Load& load, const std::vector<Marker>& markers) {
  if (markers.empty()) throw InputError(called(load) + ": it has no marker, expected one or more");
  for (const Marker& marker : markers)
    if (marker.blade != markers.front().blade)
      throw InputError(called(load) +
                       ": its markers are on different blades, expected one load for each blade");
  return markers.front().blade;
}

/// Lists a load's wrenches with the bodies that they act on.
void apply(LoadData& load, SubsystemData& subsystem) {
  for (std::size_t k = 0; k < load.markers.size(); ++k)
    subsystem.bodies[static_cast<std::size_t>(load.markers[k].body)].applied.push_back(
        {&load.markers[k].section, &load.wrenches[k]});
}

LoadData make_load_data(const std::shared_ptr<const Load>& load, const std::vector<Marker>& markers,
                        StepData& table) {
  LoadData data;
  data.load = load;
  data.given = markers;
  for (const Marker& marker : markers)
    data.markers.push_back(place_marker(called(*load), marker, table));
  SubsystemData& subsystem = table.subsystems[static_cast<std::size_t>(markers.front().blade)];
  data.wrenches = ArenaVector<SectionWrench>(markers.size(), *subsystem.arena);
  data.motions.resize(markers.size());
  data.forces.resize(markers.size());
  return data;
}

void demand_planar(const Wrench& wrench) {
  if (!wrench.force.allFinite() || !wrench.moment.allFinite())
    throw std::domain_error("its force or moment is not finite");
  if (wrench.force.z() != 0.0 || wrench.moment.x() != 0.0 || wrench.moment.y() != 0.0)
    throw std::domain_error(
        "the system moves in the x-y plane, expected no force along z and no moment about x or y");
}

void call(double t, const Subsystem& subsystem, const SubsystemData& data, LoadData& load) {
  for (std::size_t k = 0; k < load.markers.size(); ++k)
    load.motions[k] = calc_marker_motion(subsystem, data, load.markers[k]);
  std::fill(load.forces.begin(), load.forces.end(), Wrench{});
  load.load->evaluate(t, load.motions, load.forces);
  for (std::size_t k = 0; k < load.markers.size(); ++k) {
    const Wrench& wrench = load.forces[k];
    demand_planar(wrench);
    const Rotation R = data.hub->R * calc_rotation_to_hub(data, load.markers[k].body);
    load.wrenches[k].force = R.inverse() * Position{wrench.force.x(), wrench.force.y()};
    load.wrenches[k].moment = wrench.moment.z();
  }
}

/// Applies to all loads, until one is true.
template <class Check>
bool any_load(const StepData& data, Check&& check) {
  return std::any_of(data.subsystems.begin(), data.subsystems.end(), [&](const SubsystemData& s) {
    return std::any_of(s.loads.begin(), s.loads.end(), check);
  });
}

}  // namespace

PlacedMarker place_marker(const std::string& whose, const Marker& marker, const StepData& data) {
  demand_index(whose, "blade", marker.blade, data.subsystems.size());
  const SubsystemData& subsystem = data.subsystems[static_cast<std::size_t>(marker.blade)];
  demand_index(whose, "body", marker.body, subsystem.bodies.size());
  if (!(marker.station >= 0.0 && marker.station <= 1.0))
    throw InputError(whose + ": station " + std::to_string(marker.station) + ", expected 0 to 1");
  const BodyData& body = subsystem.bodies[static_cast<std::size_t>(marker.body)];
  return {marker.body, make_section(*body.model->body, body.layout, marker.station)};
}

LoadData& find_load(int index, StepData& data) {
  std::size_t count = 0;
  for (SubsystemData& subsystem : data.subsystems)
    for (LoadData& load : subsystem.loads) {
      if (load.number == index) return load;
      ++count;
    }
  throw InputError("load index " + std::to_string(index) + ", expected 0 to " +
                   std::to_string(static_cast<int>(count) - 1));
}

void demand_same_markers(const std::shared_ptr<const Load>& load, const LoadData& data) {
  if (!load) throw InputError("a load is a null pointer");
  if (ask_markers(*load) != data.given)
    throw InputError(called(*load) + ": its markers are not those of the load that it replaces");
}

void place_loads(const Loads& loads, StepData& data) {
  int number = 0;
  for (const std::shared_ptr<const Load>& load : loads) {
    if (!load) throw InputError("a load is a null pointer");
    const std::vector<Marker> markers = ask_markers(*load);
    const int blade = demand_blade(*load, markers);
    LoadData placed = make_load_data(load, markers, data);
    SubsystemData& subsystem = data.subsystems[static_cast<std::size_t>(blade)];
    subsystem.loads.push_back(std::move(placed));
    subsystem.loads.back().number = number++;
  }
  for (SubsystemData& subsystem : data.subsystems)
    for (LoadData& load : subsystem.loads) apply(load, subsystem);
}

void evaluate_load(double t, const Subsystem& subsystem, const SubsystemData& data,
                   LoadData& load) noexcept {
  try {
    call(t, subsystem, data, load);
  } catch (...) {
    if (!load.thrown) load.thrown = std::current_exception();
    constexpr double none = std::numeric_limits<double>::quiet_NaN();
    std::fill(load.wrenches.begin(), load.wrenches.end(), SectionWrench{{none, none}, none});
  }
}

void add_applied(const Twist& twist, BodyData& body) noexcept {
  for (const auto& [section, wrench] : body.applied) {
    const Twist q = section_values(*section, body.coordinates.q);
    const Twist v = section_values(*section, body.coordinates.v);
    const Position s{section->x + q[0], q[1]};
    const Position& force = wrench->force;
    const double torque = s.x() * force.y() - s.y() * force.x() + wrench->moment;
    body.terms.Q += Twist(force.x(), force.y(), torque);
    for (std::size_t k = 0; k < section->axial.size(); ++k)
      if (const int at = section->axial_at[k]; at > 0)
        body.Q_f[at] += section->axial[k] * force.x();
    for (std::size_t k = 0; k < section->deflection.size(); ++k)
      if (const int at = section->bending_at[k]; at > 0)
        body.Q_f[at] += section->deflection[k] * force.y() + section->slope[k] * wrench->moment;
    body.terms.load_power +=
        force.dot(Position(twist.head<kPosition>()) + Position(v.head<kPosition>())) +
        torque * twist[kRotation] + wrench->moment * v[kRotation];
  }
}

void clear_load_failures(StepData& data) noexcept {
  for (SubsystemData& subsystem : data.subsystems)
    for (LoadData& load : subsystem.loads) load.thrown = nullptr;
}

FailedLoad find_failed_load(const StepData& data) {
  for (std::size_t i = 0; i < data.subsystems.size(); ++i)
    for (const LoadData& load : data.subsystems[i].loads)
      if (load.thrown) return {static_cast<int>(i), name_of(*load.load), reason_of(load.thrown)};
  return {};
}

bool has_loads(const StepData& data) noexcept {
  return any_load(data, [](const LoadData&) { return true; });
}

bool is_any_load_failed(const StepData& data) noexcept {
  return any_load(data, [](const LoadData& load) { return load.thrown != nullptr; });
}

}  // namespace spoke
