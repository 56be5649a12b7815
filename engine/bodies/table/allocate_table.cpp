// Allocates the table, each subsystem's data in pages of its own.

#include <algorithm>
#include <cassert>
#include <string>
#include <type_traits>
#include <utility>

#include "engine/bodies/table/body_kind.h"
#include "engine/bodies/table/body_parts.h"
#include "engine/bodies/table/step_data.h"
#include "models/system/spatial_system.h"

namespace spoke {
namespace {

// A body's own fields, by world.

std::size_t count_joint_state(const TreeBody<Plane>&, int) { return 0; }
void place_joint_state(const TreeBody<Plane>&, const TableOptions&, double*, BodyData<Plane>&) {}
std::size_t count_joint_state(const TreeBody<Space>& model, int history) {
  return space::count_state(model.joint.joint, history);
}
void place_joint_state(const TreeBody<Space>& model, const TableOptions& options, double* memory,
                       BodyData<Space>& data) {
  space::place_state(model.joint.joint, options.history, memory, data);
  if (options.is_explicit) data.joint.a_found = data.joint.coordinates.a;
}

double mass_of(const plane::FlexibleBody& body) { return body.mass; }
double mass_of(const space::Body& body) { return body.mass(); }

/// Returns the length by which deformations are measured [m].
double extent_of(const plane::FlexibleBody& body) { return body.length; }
double extent_of(const space::Body& body) { return body.extent(); }

// What follows from the kind of a body, which in the plane is one.

void choose_kind(BodyData<Plane>&) {}
void choose_kind(BodyData<Space>& data) { data.kind = &kind_of(*data.model->body); }

double find_surely_linear(const BodyData<Plane>& data) {
  return calc_surely_linear(*data.model->body, data.linear_range);
}
double find_surely_linear(const BodyData<Space>& data) {
  return data.kind->calc_surely_linear(*data.model->body, data.linear_range);
}

std::size_t count_fields(const BodyData<Plane>& data) { return count_fields(*data.model->body); }
std::size_t count_fields(const BodyData<Space>& data) {
  return data.kind->count_work(*data.model->body);
}

void place_fields(double* memory, BodyData<Plane>& data) {
  place_fields(*data.model->body, memory, data);
}
void place_fields(double* memory, BodyData<Space>& data) {
  data.work = data.kind->place_work(*data.model->body, memory);
}

/// Lays out the coordinates of a body.
template <class World>
void lay_out(double range, BodyData<World>& data) {
  const typename World::Body& body = *data.model->body;
  data.layout = make_layout(body);
  data.linear_range = range * extent_of(body);
  data.surely_linear = find_surely_linear(data);
  set_extent(data.layout, data.coordinates);
}

/// Declares the coordinates of body j, what the integrator keeps of them, and their accelerations.
template <class World>
void declare_coordinates(std::size_t j, SubsystemData<World>& data) {
  const PartMaker maker = maker_of_body(j, data);
  BodyData<World>& body = data.bodies[j];
  BodyParts& parts = data.parts.bodies[j];
  CoordinateBlock& block = body.coordinates;
  const auto flex = [&body](std::initializer_list<double*> vectors) {
    Memory memory;
    for (double* vector : vectors) add_flex(memory, vector, body.layout);
    return memory;
  };
  parts.is_root = body.model->parent < 0;
  parts.coordinates = maker.cover("coordinates", Mark::state, flex({block.q, block.v}));
  parts.history = maker.cover("history", Mark::state);
  for (double* h : block.history)
    if (h) maker.add(parts.history, flex({h}));
  parts.accelerations = maker.cover("accelerations", Mark::state, body.X, flex({block.a}));
  if (body.a_found != block.a)
    parts.found = maker.cover("accelerations found", Mark::none, flex({body.a_found}));
  add_joint_coordinates(j, data);
}

/// Declares the parts of a subsystem whose memory is placed.
template <class World>
void declare_parts(SubsystemData<World>& data) {
  const PartMaker& maker = data.part_maker;
  SubsystemParts& parts = data.parts;
  declare_motions(data);
  parts.poses = maker.cover("poses", Mark::none, data.poses);
  parts.joint_loads = maker.cover("joint loads", Mark::state, data.root_load, data.joint_loads);
  if (!data.modal_forces.empty())
    parts.modal_forces = maker.cover("modal forces", Mark::none, data.modal_forces);
  parts.bodies.resize(data.bodies.size());
  for (std::size_t j = 0; j < data.bodies.size(); ++j) {
    declare_coordinates(j, data);
    declare_terms(j, data);
  }
}

template <class World>
void allocate(const Subsystem<World>& subsystem, const TableOptions& options,
              SubsystemData<World>& data) {
  const auto none = TwistOf<World>::Zero();
  const std::size_t count = subsystem.bodies.size();
  const int flex_vectors = 4 + options.history;  // q, v, a, a_found
  Arena& arena = *data.arena;
  data.bodies = ArenaVector<BodyData<World>>(count, arena);
  data.joints = ArenaVector<typename BodyTypes<World>::JointMotion>(count, arena);
  data.poses = ArenaVector<PoseOf<World>>(count, arena);
  data.twists = ArenaVector<TwistOf<World>>(count, none, arena);
  data.joint_loads = ArenaVector<TwistOf<World>>(count, none, arena);
  data.wrenches = ArenaVector<typename BodyTypes<World>::HandleWrenches>(count, arena);
  std::size_t state = BodyTypes<World>::Layout::kPad, fields = state;
  for (std::size_t j = 0; j < count; ++j) {
    data.bodies[j].model = &subsystem.bodies[j];
    choose_kind(data.bodies[j]);
    lay_out(options.linear_range, data.bodies[j]);
    state += static_cast<std::size_t>(data.bodies[j].layout.stride() * flex_vectors) +
             count_joint_state(subsystem.bodies[j], options.history);
    fields += count_fields(data.bodies[j]);
  }
  data.modal_forces = ArenaVector<double>(subsystem.modal_factors.size(), 0.0, arena);
  data.state = ArenaVector<double>(state, 0.0, arena);
  data.fields = ArenaVector<double>(fields, 0.0, arena);
  double *next = data.state.data(), *next_fields = data.fields.data();
  for (BodyData<World>& body : data.bodies) {
    const auto take = [&] { return std::exchange(next, next + body.layout.stride()); };
    body.coordinates.q = take();
    body.coordinates.v = take();
    body.coordinates.a = take();
    body.a_found = take();
    for (int k = 0; k < options.history; ++k) body.coordinates.history[k] = take();
    if (options.is_explicit) body.a_found = body.coordinates.a;
    place_joint_state(*body.model, options,
                      std::exchange(next, next + count_joint_state(*body.model, options.history)),
                      body);
    place_fields(std::exchange(next_fields, next_fields + count_fields(body)), body);
    body.X.setZero();
    body.report = {};
  }
  declare_parts(data);
}

/// Finds the places at which a load of the scenario acts on a body.
template <class Load>
PlacedLoad<Plane, Load> place(const Load& load, const BodyData<Plane>& data) {
  PlacedLoad<Plane, Load> placed{&load, {}};
  for (const auto& point : load.points) {
    placed.sections.push_back(make_section(*data.model->body, data.layout, point.element, point.s));
    placed.sections.back().x = point.x;
  }
  return placed;
}

/// Places loads and drag; in space there is no drag.
void place_loads(BodyData<Plane>& body) {
  for (const BodyLoad<Plane>& load : body.model->loads) body.loads.push_back(place(load, body));
  for (const BodyDrag<Plane>& drag : body.model->drags) body.drags.push_back(place(drag, body));
}
void place_loads(BodyData<Space>& body) {
  assert(body.model->drags.empty());
  for (const BodyLoad<Space>& load : body.model->loads)
    body.loads.push_back(body.kind->place_load(load, *body.model->body));
}

/// Whether drag on a body depends on where it is in the hub's frame.
template <class World>
bool has_drag_in_hub(const TreeBody<World>& member) {
  return std::any_of(member.drags.begin(), member.drags.end(), [](const BodyDrag<World>& drag) {
    return drag.relative_to == DragFrame::hub;
  });
}

/// Points a subsystem to the progress and hub motion that it follows, the system's or its own.
template <class World>
void follow_progress(std::size_t i, StepData<World>& data, SubsystemData<World>& subsystem) {
  subsystem.prescribed = {data.hub, TwistOf<World>::Zero()};
  subsystem.progress = &data.progress[data.is_coupled ? 0 : i];
  subsystem.hub = data.is_coupled ? &data.hub : &subsystem.prescribed.state;
  subsystem.hub_acceleration =
      data.is_coupled ? &data.hub_solution.acceleration : &subsystem.prescribed.acceleration;
  SubsystemParts& parts = subsystem.parts;
  if (data.is_coupled) {
    parts.progress = data.parts.progress;
    parts.hub_state = data.parts.hub_state;
    parts.hub_acceleration = data.parts.hub_solution;
    return;
  }
  const PartMaker& maker = subsystem.part_maker;
  parts.progress = maker.cover("progress", Mark::state, data.progress[i]);
  parts.hub_state = parts.hub_acceleration =
      maker.cover("hub motion", Mark::state, subsystem.prescribed);
}

/// Points the subsystems of rotors on supports to their hubs, and the hubs to what they carry.
void follow_rotors(const System<Plane>&, StepData<Plane>&) {}
void follow_rotors(const System<Space>& system, StepData<Space>& data) {
  assert(system.rotors.empty() || data.is_coupled);
  data.rotors = std::vector<RotorData<Space>>(system.rotors.size());
  for (std::size_t r = 0; r < system.rotors.size(); ++r) {
    const SupportedRotor& rotor = system.rotors[r];
    SubsystemData<Space>& support = data.subsystems[static_cast<std::size_t>(rotor.subsystem)];
    BodyData<Space>& hub = support.bodies[static_cast<std::size_t>(rotor.body)];
    BodyParts& hub_parts = support.parts.bodies[static_cast<std::size_t>(rotor.body)];
    RotorData<Space>& made = data.rotors[r];
    made.hub = data.hub;
    made.records.assign(data.records.size(), {});
    made.path = find_path(system, rotor);
    hub.carried = &made.carried;
    const PartMaker maker = PartMaker(data.all_parts).of("rotor " + std::to_string(r + 1));
    RotorParts& parts = data.parts.rotors.emplace_back();
    parts.hub = maker.cover("hub motion", Mark::state, made.hub, made.acceleration, made.turn);
    parts.carried = maker.cover("carried inertia", Mark::none, made.carried);
    parts.records = maker.ring("records", made.records);
    hub_parts.carried = parts.carried;
    PartMaker(data.all_parts).add(data.parts.flight_acceleration, made.flight_acceleration);
    for (std::size_t i = 0; i < data.subsystems.size(); ++i) {
      if (system.subsystems[i].rotor != static_cast<int>(r)) continue;
      data.subsystems[i].rotor = static_cast<int>(r);
      data.subsystems[i].hub = &made.hub;
      data.subsystems[i].axle = &made.turn;
      data.subsystems[i].hub_acceleration = &hub.X;
      data.subsystems[i].parts.hub_state = data.parts.rotors[r].hub;
      data.subsystems[i].parts.hub_acceleration = hub_parts.accelerations;
      if (rotor.is_moved) data.subsystems[i].moved_acceleration = &made.acceleration;
    }
  }
}

/// Declares the parts of the system.
template <class World>
void declare_system_parts(StepData<World>& data) {
  const PartMaker maker(data.all_parts);
  SystemParts& parts = data.parts;
  CoordinateBlock& hub = data.hub_coordinates;
  const auto of = [](double* vector) { return memory_of(vector, World::kTwist); };
  parts.hub_coordinates =
      maker.cover("hub coordinates", Mark::state, of(hub.q), of(hub.v), of(hub.a));
  parts.hub_history = maker.cover("hub history", Mark::state);
  for (double* h : hub.history)
    if (h) maker.add(parts.hub_history, of(h));
  if constexpr (tree::kHasJointCoordinates<World>) {
    maker.add(parts.hub_coordinates, data.hub_attitude.reference, data.hub_attitude.mount_spin);
    maker.add(parts.hub_history, data.hub_attitude.sum);
  }
  parts.records = maker.ring("records", data.records);
  if (!data.is_coupled) return;
  parts.progress = maker.cover("progress", Mark::state, data.progress[0]);
  parts.hub_state = maker.cover("hub state", Mark::state, data.hub);
  parts.hub_solution = maker.cover("hub solution", Mark::none, data.hub_solution);
  parts.flight_acceleration =
      maker.cover("flight acceleration", Mark::none, data.flight_acceleration);
}

}  // namespace

template <class World>
void allocate(const System<World>& system, const TableOptions& options, StepData<World>& data) {
  assert(options.window_steps >= 1 && options.linear_range >= 0.0 && options.history >= 0);
  assert(3 + options.history <= static_cast<int>(data.hub_storage.size()));
  data.hub_storage.fill(TwistOf<World>::Zero());
  CoordinateBlock& hub = data.hub_coordinates;
  hub.size = World::kTwist;
  hub.q = data.hub_storage[0].data();
  hub.v = data.hub_storage[1].data();
  hub.a = data.hub_storage[2].data();
  for (int k = 0; k < options.history; ++k) hub.history[k] = data.hub_storage[3 + k].data();
  data.hub = {PositionOf<World>::Zero(), {}, TwistOf<World>::Zero()};
  data.hub_attitude = {};
  data.hub_solution = {
      TwistOf<World>::Zero(), TwistOf<World>::Zero(), 0.0, TwistOf<World>::Zero(), 0.0, 0.0, {}};
  data.is_coupled = options.is_coupled;
  data.flies = !is_prescribed(system.hub, 0);
  data.mass = system.hub.mass;
  for (const Subsystem<World>& subsystem : system.subsystems)
    for (const TreeBody<World>& body : subsystem.bodies) data.mass += mass_of(*body.body);
  data.has_hub_loads =
      std::any_of(system.hub_loads.begin(), system.hub_loads.end(),
                  [](const typename World::HubLoad& load) { return !load.force.isZero(0.0); });
  data.flight_acceleration = PositionOf<World>::Zero();
  data.window = {};
  data.progress.assign(options.is_coupled ? 1 : system.subsystems.size(), StepProgress{});
  data.records.assign(static_cast<std::size_t>(options.window_steps), {});
  data.all_parts = {};
  data.parts = {};
  declare_system_parts(data);
  data.actors.clear();
  data.subsystems = std::vector<SubsystemData<World>>(system.subsystems.size());
  data.arenas.clear();
  for (std::size_t i = 0; i < system.subsystems.size(); ++i) {
    SubsystemData<World>& subsystem = data.subsystems[i];
    subsystem.arena = data.arenas.emplace_back(std::make_unique<Arena>()).get();
    subsystem.part_maker = PartMaker(data.all_parts, static_cast<int>(i), *data.names);
    allocate(system.subsystems[i], options, subsystem);
    for (BodyData<World>& body : subsystem.bodies) place_loads(body);
    const std::vector<TreeBody<World>>& bodies = system.subsystems[i].bodies;
    const PartMaker& maker = subsystem.part_maker;
    if (std::any_of(bodies.begin(), bodies.end(), has_drag_in_hub<World>)) {
      subsystem.drag_poses = ArenaVector<PoseOf<World>>(bodies.size(), *subsystem.arena);
      subsystem.parts.drag_poses = maker.cover("poses for drag", Mark::none, subsystem.drag_poses);
    }
    follow_progress(i, data, subsystem);
    subsystem.samples = ArenaVector<SubsystemSample<World>>(data.records.size(), *subsystem.arena);
    subsystem.parts.samples = maker.ring("samples", subsystem.samples);
    if (!options.is_coupled) {
      subsystem.records = ArenaVector<ReactionRecord<World>>(data.records.size(), *subsystem.arena);
      subsystem.parts.records = maker.ring("records", subsystem.records);
    }
  }
  follow_rotors(system, data);
  constexpr std::size_t kCache = 1 << 17;  // doubles
  std::size_t doubles = 0;
  for (const SubsystemData<World>& own : data.subsystems)
    doubles += own.state.size() + own.fields.size();
  for (SubsystemData<World>& own : data.subsystems) own.outgrows_cache = doubles > kCache;
}

template void allocate(const System<Plane>&, const TableOptions&, StepData<Plane>&);
template void allocate(const System<Space>&, const TableOptions&, StepData<Space>&);

}  // namespace spoke
