// Where in the table each part lies.

#include "engine/step/step_parts.h"

#include <string>

namespace spoke {
namespace {

using graph::bytes_of;
using graph::PartId;
using graph::StepGraphBuilder;
using Memory = std::vector<std::span<std::byte>>;

template <class Layout>
void add_flex(Memory& memory, double* flex, const Layout& layout) {
  layout.for_parts([&](int first, int n) {
    memory.push_back(bytes_of(flex[first], static_cast<std::size_t>(n)));
  });
}

/// A node touches the record of its step.
template <class Ring>
PartId add_ring(const std::string& name, Ring& records, StepGraphBuilder& builder) {
  return builder.add_part(name, {bytes_of(records[0], records.size())}, sizeof(records[0]));
}

template <class Matrix>
std::span<std::byte> memory_of(Matrix& matrix) {
  return bytes_of(*matrix.data(), static_cast<std::size_t>(matrix.size()));
}

// What parts hold, by world.

template <class T>
std::span<std::byte> memory_of(T* first, std::size_t count) {
  return bytes_of(*first, count);
}

void add_joint_coordinates(BodyData<Plane>&, Memory&, Memory&, Memory&) {}
void add_joint_coordinates(BodyData<Space>& body, Memory& coordinates, Memory& history,
                           Memory& accelerations) {
  const CoordinateBlock& block = body.joint.coordinates;
  if (block.size == 0) return;
  const auto n = static_cast<std::size_t>(block.size);
  coordinates.push_back(memory_of(block.q, n));
  coordinates.push_back(memory_of(block.v, n));
  coordinates.push_back(bytes_of(body.joint.rotation->reference));
  accelerations.push_back(memory_of(block.a, n));
  for (double* h : block.history)
    if (h) history.push_back(memory_of(h, n));
  history.push_back(bytes_of(body.joint.rotation->sum));
}

Memory memory_of_motions(SubsystemData<Plane>& data) {
  return {bytes_of(data.joints[0], data.joints.size())};
}
Memory memory_of_motions(SubsystemData<Space>& data) {
  Memory memory{bytes_of(data.joints[0], data.joints.size())};
  for (BodyData<Space>& body : data.bodies) {
    memory.push_back(
        memory_of(body.work.handles, static_cast<std::size_t>(body.work.port.handles)));
    memory.push_back(bytes_of(body.alpha));
    const int driven = body.model->joint.joint.driven;
    if (driven > 0)
      memory.push_back(memory_of(body.joint.driven, static_cast<std::size_t>(driven)));
  }
  return memory;
}

Memory memory_of_slides(SubsystemData<Plane>&) { return {}; }
Memory memory_of_slides(SubsystemData<Space>& data) {
  Memory memory;
  for (BodyData<Space>& body : data.bodies)
    if (body.model->joint.slide) memory.push_back(bytes_of(body.slide));
  return memory;
}

Memory memory_of_wrenches(SubsystemData<Plane>& data) {
  return {bytes_of(data.wrenches[0], data.wrenches.size())};
}
Memory memory_of_wrenches(SubsystemData<Space>& data) {
  Memory memory{bytes_of(data.wrenches[0], data.wrenches.size())};
  for (BodyData<Space>& body : data.bodies) {
    memory.push_back(
        memory_of(body.work.wrenches, static_cast<std::size_t>(body.work.port.handles)));
    const CoordinateBlock& joint = body.joint.coordinates;
    if (joint.size > 0 && body.joint.a_found != joint.a)
      memory.push_back(memory_of(body.joint.a_found, static_cast<std::size_t>(joint.size)));
  }
  return memory;
}

Memory memory_of_terms(BodyData<Space>& body) {
  Memory memory{bytes_of(body.terms)};
  if (body.joint.coordinates.size > 0) memory.push_back(bytes_of(*body.joint.forces));
  if (const space::FlexibleBody* flexible = body.model->body->flexible())
    memory.push_back(memory_of(
        body.work.rows, static_cast<std::size_t>(space::kNodeRows * flexible->node_count())));
  return memory;
}

Memory memory_of_inverse(BodyData<Space>& body) {
  const space::FlexibleBody* flexible = body.model->body->flexible();
  if (!flexible) return {};
  Memory memory{bytes_of(body.work.condensed.S_inverse), bytes_of(body.work.condensed.p)};
  const int first = flexible->first_node();
  memory.push_back(
      memory_of(body.work.half + space::kNodeRows * first,
                static_cast<std::size_t>(space::kNodeRows * (flexible->node_count() - first))));
  memory.push_back(memory_of(body.work.condensed.X, flexible->handles.size()));
  return memory;
}

Memory memory_of_port(BodyData<Space>& body) {
  const tree::MultiPort<Space>& port = body.work.port;
  const auto n = static_cast<std::size_t>(port.handles);
  Memory memory{memory_of(port.diagonal, n), memory_of(port.free, n)};
  const int pairs = tree::MultiPort<Space>::count_pairs(port.handles);
  if (pairs > 0) memory.push_back(memory_of(port.pairs, static_cast<std::size_t>(pairs)));
  return memory;
}

Memory memory_of_scratch(BodyData<Space>& body) {
  const space::FlexibleBody* flexible = body.model->body->flexible();
  if (!flexible) return {};
  const auto nodes = static_cast<std::size_t>(flexible->node_count());
  const std::size_t slots =
      space::kSlot * (space::kNodeSlots * nodes + static_cast<std::size_t>(flexible->elements));
  const space::BodyWork& work = body.work;
  Memory memory{memory_of(work.slots, slots), memory_of(work.momenta, slots),
                memory_of(work.force, space::kTwist * nodes)};
  if (flexible->directions) memory.push_back(memory_of(work.lanes, count_lanes(*flexible)));
  for (double* nodal : work.nodal) memory.push_back(memory_of(nodal, space::kTwist * nodes));
  return memory;
}

void add_tension_part(BodyData<Plane>&, const std::string&, StepGraphBuilder&, BodyParts&) {}
void add_tension_part(BodyData<Space>& body, const std::string& name, StepGraphBuilder& builder,
                      BodyParts& parts) {
  if (!body.tension) return;
  space::ImplicitTension& tension = *body.tension;
  space::ElasticBlock& block = tension.block;
  Memory memory{bytes_of(tension.w), bytes_of(tension.turn), bytes_of(block.C_W)};
  const auto add = [&memory](auto& values) {
    if (!values.empty()) memory.push_back(bytes_of(values[0], values.size()));
  };
  add(tension.elements);
  add(tension.stiffness.diagonal);
  add(tension.stiffness.below);
  add(tension.lean);
  for (std::vector<double>* values : {&block.inverse, &block.below, &block.W_t}) add(*values);
  for (std::vector<double>& Z : block.Z) add(Z);
  add(block.Z_W);
  add(block.Z_diagonal);
  add(block.Z_pairs);
  parts.tension.push_back(builder.add_part(name + "tension", memory));
}

Memory memory_of_terms(BodyData<Plane>& body) {
  Memory memory{bytes_of(body.terms)};
  add_flex(memory, body.c_theta, body.layout);
  add_flex(memory, body.Q_f, body.layout);
  if (!body.element_forces.empty())
    memory.push_back(memory_of(body.element_forces.data(), body.element_forces.size()));
  return memory;
}

Memory memory_of_inverse(PlanarCondensed& body, const FlexLayout& layout) {
  Memory memory{bytes_of(body.port)};
  add_flex(memory, body.W_theta, layout);
  add_flex(memory, body.z, layout);
  return memory;
}

Memory memory_of_workspace(PlanarCondensed& body, const FlexLayout& layout) {
  return {bytes_of(*body.scratch, static_cast<std::size_t>(layout.scratch_size()))};
}

// What the formulation structured keeps of a body besides the elimination of its joint.

void add_condensed_parts(SystemContext<Plane>& context, int i, int j, const std::string& name,
                         StepGraphBuilder& builder, BodyParts& parts) {
  structured::BodyWork<Plane>& work = context.work.structured[i].bodies[j];
  const FlexLayout& layout = context.data.subsystems[i].bodies[j].layout;
  parts.inverse = builder.add_part(name + "inverse", memory_of_inverse(work, layout));
  parts.workspace = builder.add_part(name + "workspace", memory_of_workspace(work, layout));
}
void add_condensed_parts(SystemContext<Space>& context, int i, int j, const std::string& name,
                         StepGraphBuilder& builder, BodyParts& parts) {
  BodyData<Space>& body = context.data.subsystems[i].bodies[j];
  parts.inverse = builder.add_part(name + "inverse", memory_of_inverse(body));
  parts.port = builder.add_part(name + "port", memory_of_port(body));
}

template <class World>
void add_inverse_parts(SystemContext<World>& context, int i, int j, const std::string& name,
                       StepGraphBuilder& builder, BodyParts& parts) {
  if (context.formulation == Formulation::structured) {
    add_condensed_parts(context, i, j, name, builder, parts);
    if (!parts.is_root)
      parts.joint =
          builder.add_part(name + "joint", {bytes_of(context.work.structured[i].bodies[j].joint)});
  } else if (context.formulation == Formulation::subsystem) {
    subsystem::BodyWork<World>& work = context.work.subsystem[i].bodies[j];
    parts.inverse = builder.add_part(
        name + "inverse",
        {memory_of(work.inverse_columns), memory_of(work.products), memory_of(work.biases)});
    parts.workspace =
        builder.add_part(name + "workspace", {memory_of(work.mass), memory_of(work.jacobians)});
  }
}

template <class World>
BodyParts add_body_parts(SystemContext<World>& context, int i, int j, StepGraphBuilder& builder) {
  BodyData<World>& data = context.data.subsystems[i].bodies[j];
  CoordinateBlock& block = data.coordinates;
  const std::string name =
      "blade " + std::to_string(i + 1) + " / body " + std::to_string(j + 1) + " / ";
  Memory coordinates, history, accelerations{bytes_of(data.X)};
  add_flex(coordinates, block.q, data.layout);
  add_flex(coordinates, block.v, data.layout);
  add_flex(accelerations, block.a, data.layout);
  for (double* h : block.history)
    if (h) add_flex(history, h, data.layout);
  add_joint_coordinates(data, coordinates, history, accelerations);
  BodyParts parts;
  parts.is_root = data.model->parent < 0;
  parts.coordinates = builder.add_part(name + "coordinates", coordinates);
  parts.history = builder.add_part(name + "history", history);
  parts.accelerations = builder.add_part(name + "accelerations", accelerations);
  parts.terms = builder.add_part(name + "terms", memory_of_terms(data));
  Memory report{bytes_of(data.report.change), bytes_of(data.report.step_change),
                bytes_of(data.report.deflection), bytes_of(data.report.failed)};
  if constexpr (tree::kHasJointCoordinates<World>) {
    report.push_back(bytes_of(data.report.drive_power));
    parts.scratch = builder.add_part(name + "scratch", memory_of_scratch(data));
  }
  parts.report = builder.add_part(name + "report", report);
  add_tension_part(data, name, builder, parts);
  add_inverse_parts(context, i, j, name, builder, parts);
  return parts;
}

/// What the subsystem synthesis finds of a whole subsystem, and what it works on.
template <class World>
void add_synthesis_memory(subsystem::SubsystemWork<World>& work, Memory& effective,
                          Memory& workspace) {
  effective.push_back(memory_of(work.solution));
  workspace.push_back(memory_of(work.D));
  if (work.columns.size() == 0) return;
  effective.push_back(memory_of(work.response));
  for (Eigen::MatrixXd* matrix : {&work.columns, &work.inverse_columns, &work.inertia})
    workspace.push_back(memory_of(*matrix));
}

template <class World>
SubsystemParts add_subsystem_parts(SystemContext<World>& context, int i,
                                   StepGraphBuilder& builder) {
  SubsystemData<World>& data = context.data.subsystems[i];
  const std::string name = "blade " + std::to_string(i + 1) + " / ";
  const std::size_t count = data.bodies.size();
  SubsystemParts parts;
  parts.rotations = builder.add_part(name + "rotations", memory_of_motions(data));
  parts.twists = builder.add_part(name + "twists", {bytes_of(data.twists[0], count)});
  parts.poses = builder.add_part(name + "poses", {bytes_of(data.poses[0], count)});
  if (!data.drag_poses.empty())
    parts.drag_poses =
        builder.add_part(name + "poses for drag", {bytes_of(data.drag_poses[0], count)});
  if (!data.applied_forces.empty()) {
    Memory sums = memory_of_slides(data);
    sums.push_back(bytes_of(data.applied_forces[0], data.applied_forces.size()));
    parts.applied_forces = builder.add_part(name + "applied forces", sums);
  }
  parts.wrenches = builder.add_part(name + "wrenches", memory_of_wrenches(data));
  parts.samples = add_ring(name + "samples", data.samples, builder);
  parts.joint_loads = builder.add_part(
      name + "joint loads", {bytes_of(data.root_load), bytes_of(data.joint_loads[0], count)});
  if (data.reading_count > 0)
    parts.readings = builder.add_part(name + "readings",
                                      {bytes_of(data.reading_ring[0], data.reading_ring.size())},
                                      data.reading_count * sizeof(double));
  if (context.formulation != Formulation::augmented) {
    Memory effective{bytes_of(data.effective)}, workspace;
    if (context.formulation == Formulation::subsystem) {
      add_synthesis_memory(context.work.subsystem[i], effective, workspace);
    } else {
      structured::SubsystemWork<World>& work = context.work.structured[i];
      effective.push_back(bytes_of(work.roots[0], work.roots.size()));
      for (structured::BodyWork<World>& body : work.bodies)
        workspace.push_back(bytes_of(body.branch));
    }
    parts.workspace = builder.add_part(name + "workspace", workspace);
    parts.effective = builder.add_part(name + "effective inertia", effective);
  }
  for (std::size_t j = 0; j < count; ++j)
    parts.bodies.push_back(add_body_parts(context, i, static_cast<int>(j), builder));
  if constexpr (tree::kHasJointCoordinates<World>)
    if (context.formulation == Formulation::structured) parts.ports = parts.all(&BodyParts::port);
  for (LoadData<World>& load : data.loads)
    parts.loads.push_back(builder.add_part(name + "load " + std::to_string(parts.loads.size() + 1),
                                           {bytes_of(load.wrenches[0], load.wrenches.size())}));
  return parts;
}

/// What subsystems follow: one progress and hub motion of the system, or their own.
template <class World>
void add_time_parts(SystemContext<World>& context, StepGraphBuilder& builder, StepParts& parts) {
  StepData<World>& data = context.data;
  if (data.is_coupled) {
    parts.progress = builder.add_part("progress", {bytes_of(data.progress[0])});
    parts.hub_state = builder.add_part("hub state", {bytes_of(data.hub)});
    parts.hub_solution = builder.add_part("hub solution", {bytes_of(data.hub_solution)});
    parts.flight_acceleration =
        builder.add_part("flight acceleration", {bytes_of(data.flight_acceleration)});
  }
  for (std::size_t i = 0; i < data.subsystems.size(); ++i) {
    SubsystemParts& blade = parts.subsystems[i];
    if (data.is_coupled) {
      blade.progress = parts.progress;
      blade.hub_state = parts.hub_state;
      blade.hub_acceleration = parts.hub_solution;
      continue;
    }
    SubsystemData<World>& subsystem = data.subsystems[i];
    const std::string name = "blade " + std::to_string(i + 1) + " / ";
    blade.progress = builder.add_part(name + "progress", {bytes_of(data.progress[i])});
    blade.hub_state = blade.hub_acceleration =
        builder.add_part(name + "hub motion", {bytes_of(subsystem.prescribed)});
    blade.records = add_ring(name + "records", subsystem.records, builder);
  }
}

}  // namespace

std::vector<PartId> SubsystemParts::all(PartId BodyParts::*member) const {
  std::vector<PartId> list;
  for (const BodyParts& body : bodies) list.push_back(body.*member);
  return list;
}

std::vector<PartId> SubsystemParts::joints() const {
  std::vector<PartId> list;
  for (const BodyParts& body : bodies)
    if (!body.is_root) list.push_back(body.joint);
  return list;
}

std::vector<PartId> StepParts::all(PartId BodyParts::*member) const {
  std::vector<PartId> list;
  for (const SubsystemParts& subsystem : subsystems)
    for (const BodyParts& body : subsystem.bodies) list.push_back(body.*member);
  return list;
}

std::vector<PartId> StepParts::all(PartId SubsystemParts::*member) const {
  std::vector<PartId> list;
  for (const SubsystemParts& subsystem : subsystems) list.push_back(subsystem.*member);
  return list;
}

template <class World>
StepParts add_parts(SystemContext<World>& context, StepGraphBuilder& builder) {
  StepData<World>& data = context.data;
  CoordinateBlock& hub = data.hub_coordinates;
  Memory history;
  for (double* h : hub.history)
    if (h) history.push_back(bytes_of(*h, World::kTwist));
  Memory coordinates{bytes_of(*hub.q, World::kTwist), bytes_of(*hub.v, World::kTwist),
                     bytes_of(*hub.a, World::kTwist)};
  if constexpr (tree::kHasJointCoordinates<World>) {
    coordinates.push_back(bytes_of(data.hub_attitude.reference));
    coordinates.push_back(bytes_of(data.hub_attitude.mount_spin));
    history.push_back(bytes_of(data.hub_attitude.sum));
  }
  StepParts parts;
  parts.hub_coordinates = builder.add_part("hub coordinates", coordinates);
  parts.hub_history = builder.add_part("hub history", history);
  parts.records = add_ring("records", data.records, builder);
  if (context.formulation == Formulation::augmented)
    parts.augmented_solution =
        builder.add_part("augmented solution", {memory_of(context.work.augmented.solution)});
  for (std::size_t i = 0; i < data.subsystems.size(); ++i)
    parts.subsystems.push_back(add_subsystem_parts(context, static_cast<int>(i), builder));
  add_time_parts(context, builder, parts);
  return parts;
}

template StepParts add_parts(SystemContext<Plane>&, StepGraphBuilder&);
template StepParts add_parts(SystemContext<Space>&, StepGraphBuilder&);

}  // namespace spoke
