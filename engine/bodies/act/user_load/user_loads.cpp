// Calls the user's loads, and resolves their forces in the frames of the bodies.

#include "engine/bodies/act/user_load/user_loads.h"

#include <algorithm>
#include <cassert>
#include <exception>
#include <limits>
#include <memory>
#include <stdexcept>
#include <string_view>

#include "engine/bodies/act/marker_parts.h"
#include "engine/bodies/kernels/applied_forces.h"
#include "engine/bodies/kernels/kinematics.h"
#include "engine/bodies/kernels/marker_motion.h"
#include "models/count_text.h"
#include "models/error.h"

namespace spoke {
namespace {

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

/// Finds the places of a load's markers.
template <class World>
std::unique_ptr<LoadData<World>> place(int number, const AskedLoad& asked,
                                       const StepData<World>& table) {
  auto placed = std::make_unique<LoadData<World>>();
  LoadData<World>& load = *placed;
  load.number = number;
  load.load = asked.load;
  load.given = asked.markers;
  load.subsystems = subsystems_of(asked.markers);
  for (const Marker& marker : asked.markers)
    load.markers.push_back(place_marker(called(*asked.load), marker, table));
  return placed;
}

/// Takes memory for a load, number `k` of its first subsystem.
template <class World>
void allocate(int k, LoadData<World>& load, SubsystemData<World>& first) {
  const std::size_t count = load.markers.size();
  load.wrenches = ArenaVector<SectionWrench<World>>(count, *first.arena);
  for (SectionWrench<World>& wrench : load.wrenches) set_all(0.0, wrench);
  load.part = first.part_maker.cover("load " + std::to_string(k + 1), Mark::none, load.wrenches);
  load.motions.resize(count);
  load.forces.resize(count);
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
UserLoads<World>::UserLoads(const std::vector<AskedLoad>& asked, const System<World>& system,
                            StepData<World>& data)
    : system_(system), data_(data) {
  for (const AskedLoad& load : asked)
    loads_.push_back(place(static_cast<int>(loads_.size()), load, data));
  std::stable_sort(loads_.begin(), loads_.end(), [](const auto& a, const auto& b) {
    return a->subsystems.front() < b->subsystems.front();
  });
  int k = 0, before = -1;
  for (const auto& load : loads_) {
    const int first = load->subsystems.front();
    k = first == before ? k + 1 : 0;
    before = first;
    allocate(k, *load, data.subsystems[static_cast<std::size_t>(first)]);
    apply(*load, data);
  }
}

template <class World>
LoadData<World>& UserLoads<World>::find(int index) {
  for (const auto& load : loads_)
    if (load->number == index) return *load;
  throw InputError("load index " + std::to_string(index) + ", expected " +
                   range_text(0, static_cast<int>(loads_.size()) - 1));
}

template <class World>
FailedLoad UserLoads<World>::find_failed(const std::vector<std::string>& names,
                                         const std::string& at) const {
  assert(has_failed());
  for (const auto& load : loads_)
    if (load->thrown)
      return {called(*load->load) + " of " + text_of(load->subsystems, names) + " failed " + at +
                  ": " + reason_of(load->thrown),
              load->thrown};
  return {};
}

template <class World>
void UserLoads<World>::add_nodes(const PassNodes& pass, PassPlace place, int i) const {
  if (place != PassPlace::on_motion) return;
  for (const auto& placed : loads_) {
    LoadData<World>& load = *placed;
    if (load.subsystems.front() != i) continue;
    graph::NodeLabel label = pass.label(stage(), load.subsystems.size() > 1 ? -1 : i);
    if (loads_.size() > 1) label.item = "load " + std::to_string(load.number + 1);
    const PartList scratch = marker_scratch(data_, load.markers);
    const StepProgress& progress = *data_.subsystems[static_cast<std::size_t>(i)].progress;
    pass.builder.add_node(label, graph::reads(marker_inputs(data_, load.subsystems, load.markers)),
                          graph::updates(scratch), graph::writes(load.part),
                          unless_halted(progress, [this, &progress, &load]() noexcept {
                            evaluate(progress.control.time, load);
                          }));
  }
}

template <class World>
void UserLoads<World>::list_parts_on(int i, int j, PartList& parts) const {
  for (const auto& load : loads_)
    if (std::any_of(load->markers.begin(), load->markers.end(),
                    [i, j](const PlacedMarker<World>& marker) {
                      return marker.subsystem == i && marker.body == j;
                    }))
      parts.push_back(load->part);
}

template <class World>
bool UserLoads<World>::has_failed() const {
  return std::any_of(loads_.begin(), loads_.end(),
                     [](const auto& load) { return load->thrown != nullptr; });
}

template <class World>
void UserLoads<World>::clear_failures() {
  for (const auto& load : loads_) load->thrown = nullptr;
}

template <class World>
void UserLoads<World>::evaluate(double t, LoadData<World>& load) const noexcept {
  assert(load.motions.size() == load.markers.size() && load.forces.size() == load.markers.size());
  assert(load.wrenches.size() == load.markers.size());
  try {
    call(t, system_, data_, load);
  } catch (...) {
    if (!load.thrown) load.thrown = std::current_exception();
    for (SectionWrench<World>& wrench : load.wrenches)
      set_all(std::numeric_limits<double>::quiet_NaN(), wrench);
  }
}

template <class World>
UserLoads<World>& place_loads(const std::vector<AskedLoad>& loads, const System<World>& system,
                              StepData<World>& data) {
  auto placed = std::make_unique<UserLoads<World>>(loads, system, data);
  UserLoads<World>& made = *placed;
  data.actors.push_back(std::move(placed));
  place_applied_forces(data);
  return made;
}

template class UserLoads<Plane>;
template UserLoads<Plane>& place_loads(const std::vector<AskedLoad>&, const System<Plane>&,
                                       StepData<Plane>&);
template class UserLoads<Space>;
template UserLoads<Space>& place_loads(const std::vector<AskedLoad>&, const System<Space>&,
                                       StepData<Space>&);

}  // namespace spoke
