// Finds the memory of each part in the table.

#include "engine/step/step_parts.h"

#include <cassert>
#include <string>

#include "engine/formulation/body_memory.h"

namespace spoke {
namespace {

using graph::bytes_of;
using graph::PartId;
using graph::StepGraphBuilder;

/// Adds the part of a ring of records; a node touches the record of its step.
template <class Ring>
PartId add_ring(const std::string& name, Ring& records, StepGraphBuilder& builder) {
  assert(!records.empty());
  return builder.add_part(name, {bytes_of(records[0], records.size())}, sizeof(records[0]));
}

template <class Matrix>
std::span<std::byte> memory_of(Matrix& matrix) {
  return bytes_of(*matrix.data(), static_cast<std::size_t>(matrix.size()));
}

/// Adds what the elimination of the joint of `body` sets for each of its coordinates.
template <class World, class Elimination>
void add_response(const BodyData<World>& body, Elimination& elimination, Memory& memory) {
  if constexpr (tree::kHasJointCoordinates<World>) {
    tree::JointResponse<World>& response = elimination.response;
    memory.push_back(bytes_of(response.wrench));
    const auto n = static_cast<std::size_t>(body.model->joint.joint.coordinates);
    if (n == 0) return;
    for (auto* columns : {&response.H, &response.gain})
      memory.push_back(bytes_of(*columns->data(), n * World::kTwist));
    for (auto* values : {&response.given, &response.yield})
      memory.push_back(bytes_of((*values)[0], n));
  }
}

template <class World>
Memory memory_of_joint(const BodyData<World>& body, tree::JointElimination<World>& joint) {
  Memory memory{bytes_of(joint.Pi), bytes_of(joint.rhs)};
  add_response(body, joint, memory);
  return memory;
}

template <class World>
void add_inverse_parts(SystemContext<World>& context, int i, int j, const std::string& name,
                       StepGraphBuilder& builder, BodyParts& parts) {
  if (context.formulation == Formulation::structured) {
    BodyData<World>& body = context.data.subsystems[i].bodies[j];
    structured::BodyWork<World>& work = context.work.structured[i].bodies[j];
    parts.inverse = builder.add_part(name + "inverse", memory_of_inverse(body, work));
    if (Memory memory = memory_of_workspace(body, work); !memory.empty())
      parts.workspace = builder.add_part(name + "workspace", memory);
    if (Memory memory = memory_of_port(body, work.by_mass); !memory.empty())
      parts.port = builder.add_part(name + "port", memory);
    if (!parts.is_root)
      parts.joint = builder.add_part(name + "joint", memory_of_joint(body, work.joint));
  } else if (context.formulation == Formulation::subsystem) {
    subsystem::BodyWork<World>& work = context.work.subsystem[i].bodies[j];
    parts.inverse = builder.add_part(
        name + "inverse",
        {memory_of(work.inverse_columns), memory_of(work.products), memory_of(work.biases)});
    parts.workspace =
        builder.add_part(name + "workspace", {memory_of(work.mass), memory_of(work.jacobians)});
  }
}

/// Adds the parts of the slices of a solid.
template <class World>
void add_slice_parts(SystemContext<World>& context, BodyData<World>& body, const std::string& name,
                     StepGraphBuilder& builder, BodyParts& parts) {
  const auto add = [&](const std::vector<Memory>& slices, const char* what) {
    std::vector<PartId> list;
    for (const Memory& memory : slices)
      list.push_back(builder.add_part(
          name + "slice " + std::to_string(list.size() + 1) + " / " + what, memory));
    return list;
  };
  const SliceMemory slices = memory_of_slices(body);
  parts.tiles = add(slices.tiles, "terms");
  if (context.formulation != Formulation::structured) return;
  parts.halves = add(slices.halves, "half solutions");
  parts.solution = add(slices.solution, "accelerations");
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
  const Memory wrenches = memory_of_wrenches_at_start(data);
  coordinates.insert(coordinates.end(), wrenches.begin(), wrenches.end());
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
  if (Memory memory = memory_of_tension(data); !memory.empty())
    parts.tension.push_back(builder.add_part(name + "tension", memory));
  add_inverse_parts(context, i, j, name, builder, parts);
  add_slice_parts(context, data, name, builder, parts);
  return parts;
}

/// Adds the results of the subsystem synthesis for a whole subsystem, and its workspace.
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

/// Adds the parts of one loop that the formulation finds.
template <class World>
void add_loop_columns(SystemContext<World>& context, int i, std::size_t k, const std::string& name,
                      StepGraphBuilder& builder, LoopParts& parts) {
  LoopData<World>& loops = context.data.subsystems[i].loops;
  const LoopPath& path = loops.paths[k];
  const auto row = static_cast<std::size_t>(path.first_row);
  const auto rows = static_cast<std::size_t>(path.rows);
  Memory columns{bytes_of(loops.hub[row], rows), bytes_of(loops.free[row], rows)};
  const std::string own = name + "loop " + std::to_string(k + 1) + " / ";
  if (context.formulation == Formulation::structured) {
    columns.push_back(bytes_of(loops.branches[path.first_branch], path.branches()));
    for (auto* of_joints : {&loops.joints, &loops.joint_forces})
      columns.push_back(bytes_of((*of_joints)[path.first_joint], path.columns()));
    if (!context.work.structured[i].by_mass)
      parts.scratch.push_back(builder.add_part(
          own + "scratch",
          {bytes_of(loops.scratch[path.first_handle], static_cast<std::size_t>(path.handles))}));
  } else {
    auto& work = context.work.subsystem[i].loops[k];
    columns.push_back(memory_of(work.right));
    columns.push_back(memory_of(work.solution));
    if (work.response.size() > 0) columns.push_back(memory_of(work.response));
  }
  parts.columns.push_back(builder.add_part(own + "columns", columns));
}

/// Adds the parts of a subsystem's loops.
template <class World>
LoopParts add_loop_parts(SystemContext<World>& context, int i, const std::string& name,
                         StepGraphBuilder& builder) {
  LoopParts parts;
  LoopData<World>& loops = context.data.subsystems[i].loops;
  if (loops.is_empty()) return parts;
  parts.is_empty = false;
  const auto rows = static_cast<std::size_t>(loops.rows);
  parts.motion = builder.add_part(
      name + "loop motion",
      {bytes_of(loops.poses[0], loops.poses.size()),
       bytes_of(loops.accelerations[0], static_cast<std::size_t>(loops.last_body + 1)),
       bytes_of(loops.states[0], rows)});
  Memory factor{bytes_of(loops.multipliers[0], rows)};
  if (context.formulation != Formulation::augmented) {
    for (std::size_t k = 0; k < loops.paths.size(); ++k)
      add_loop_columns(context, i, k, name, builder, parts);
    factor.push_back(bytes_of(loops.matrix.values()[0], loops.matrix.values().size()));
    factor.push_back(bytes_of(loops.half_hub[0], rows));
    factor.push_back(bytes_of(loops.half[0], rows));
    for (auto* pivots : {&loops.pivots, &loops.first_explicit, &loops.first_implicit})
      factor.push_back(bytes_of((*pivots)[0], rows));
  }
  parts.factor = builder.add_part(name + "loop factor", factor);
  parts.report = builder.add_part(name + "loop report", {bytes_of(loops.report)});
  return parts;
}

template <class World>
SubsystemParts add_subsystem_parts(SystemContext<World>& context, int i,
                                   StepGraphBuilder& builder) {
  SubsystemData<World>& data = context.data.subsystems[i];
  const std::string name = "blade " + std::to_string(i + 1) + " / ";
  const std::size_t count = data.bodies.size();
  SubsystemParts parts;
  parts.rotations = builder.add_part(name + "rotations", memory_of_motions(data));
  parts.twists = builder.add_part(name + "twists", memory_of_twists(data));
  parts.poses = builder.add_part(name + "poses", {bytes_of(data.poses[0], count)});
  if (!data.drag_poses.empty())
    parts.drag_poses =
        builder.add_part(name + "poses for drag", {bytes_of(data.drag_poses[0], count)});
  if (!data.applied_forces.empty()) {
    Memory sums = memory_of_slides(data);
    sums.push_back(bytes_of(data.applied_forces[0], data.applied_forces.size()));
    parts.applied_forces = builder.add_part(name + "applied forces", sums);
  }
  if (!data.modal_forces.empty())
    parts.modal_forces = builder.add_part(
        name + "modal forces", {bytes_of(data.modal_forces[0], data.modal_forces.size())});
  if (!data.controls.empty())
    parts.controls =
        builder.add_part(name + "control", {bytes_of(data.controls[0], data.controls.size())});
  Memory wrenches = memory_of_wrenches(data);
  if (context.formulation == Formulation::structured)
    for (structured::BodyWork<World>& body : context.work.structured[i].bodies)
      if (body.by_mass) wrenches.push_back(bytes_of(body.X));
  parts.wrenches = builder.add_part(name + "wrenches", wrenches);
  parts.samples = add_ring(name + "samples", data.samples, builder);
  Memory joint_loads{bytes_of(data.root_load), bytes_of(data.joint_loads[0], count)};
  LoopData<World>& loops = data.loops;
  if (!loops.is_empty())
    joint_loads.push_back(bytes_of(loops.kept_multipliers[0], loops.kept_multipliers.size()));
  parts.joint_loads = builder.add_part(name + "joint loads", joint_loads);
  parts.loops = add_loop_parts(context, i, name, builder);
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
      for (std::size_t k = 0; k < work.roots.size(); ++k) {
        tree::RootElimination<World>& root = work.roots[k];
        effective.push_back(bytes_of(root.mass));
        effective.push_back(bytes_of(root.free));
        add_response(data.bodies[static_cast<std::size_t>(work.root_bodies[k])], root, effective);
      }
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
  if (data.air) {
    AirData<World>& air = *data.air;
    parts.air = builder.add_part(
        name + "air", {bytes_of(air.wrenches[0], air.wrenches.size()),
                       bytes_of(air.stations[0], air.stations.size()), bytes_of(air.sum)});
    parts.air_reached = builder.add_part(name + "air states reached",
                                         {bytes_of(air.reached[0], air.reached.size())});
    parts.air_states =
        builder.add_part(name + "air states", {bytes_of(air.states[0], air.states.size())});
  }
  return parts;
}

/// Adds the parts of rotors on supports.
void add_rotor_parts(StepData<Plane>&, StepGraphBuilder&, StepParts&) {}
void add_rotor_parts(StepData<Space>& data, StepGraphBuilder& builder, StepParts& parts) {
  for (RotorData<Space>& rotor : data.rotors) {
    const std::string name = "rotor " + std::to_string(parts.rotors.size() + 1) + " / ";
    RotorParts& own = parts.rotors.emplace_back();
    own.hub =
        builder.add_part(name + "hub motion",
                         {bytes_of(rotor.hub), bytes_of(rotor.acceleration), bytes_of(rotor.turn)});
    own.carried = builder.add_part(name + "carried inertia", {bytes_of(rotor.carried)});
  }
}

/// Adds the parts that subsystems follow: one progress and hub motion of the system, or their own.
template <class World>
void add_time_parts(SystemContext<World>& context, StepGraphBuilder& builder, StepParts& parts) {
  StepData<World>& data = context.data;
  if (data.is_coupled) {
    parts.progress = builder.add_part("progress", {bytes_of(data.progress[0])});
    parts.hub_state = builder.add_part("hub state", {bytes_of(data.hub)});
    parts.hub_solution = builder.add_part("hub solution", {bytes_of(data.hub_solution)});
    Memory flight{bytes_of(data.flight_acceleration)};
    for (RotorData<World>& rotor : data.rotors)
      flight.push_back(bytes_of(rotor.flight_acceleration));
    parts.flight_acceleration = builder.add_part("flight acceleration", flight);
  }
  add_rotor_parts(data, builder, parts);
  for (std::size_t i = 0; i < data.subsystems.size(); ++i) {
    SubsystemParts& own = parts.subsystems[i];
    if (const int r = context.system.subsystems[i].rotor; r >= 0) {
      const SupportedRotor& rotor = context.system.rotors[static_cast<std::size_t>(r)];
      own.progress = parts.progress;
      own.hub_state = parts.rotors[static_cast<std::size_t>(r)].hub;
      own.hub_acceleration = parts.subsystems[static_cast<std::size_t>(rotor.subsystem)]
                                 .bodies[static_cast<std::size_t>(rotor.body)]
                                 .accelerations;
      continue;
    }
    if (data.is_coupled) {
      own.progress = parts.progress;
      own.hub_state = parts.hub_state;
      own.hub_acceleration = parts.hub_solution;
      continue;
    }
    SubsystemData<World>& subsystem = data.subsystems[i];
    const std::string name = "blade " + std::to_string(i + 1) + " / ";
    own.progress = builder.add_part(name + "progress", {bytes_of(data.progress[i])});
    own.hub_state = own.hub_acceleration =
        builder.add_part(name + "hub motion", {bytes_of(subsystem.prescribed)});
    own.records = add_ring(name + "records", subsystem.records, builder);
  }
}

}  // namespace

std::vector<PartId> SubsystemParts::all(PartId BodyParts::*member) const {
  std::vector<PartId> list;
  for (const BodyParts& body : bodies) list.push_back(body.*member);
  return list;
}

std::vector<PartId> SubsystemParts::tiles() const {
  std::vector<PartId> list;
  for (const BodyParts& body : bodies)
    list.insert(list.end(), body.tiles.begin(), body.tiles.end());
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
