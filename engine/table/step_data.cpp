// Allocates the table, each blade's data in pages of its own.

#include "engine/table/step_data.h"

#include <algorithm>
#include <utility>

namespace spoke {
namespace {

constexpr int kFlexVectors = 6;  // q, v, a, c_theta, Q_f, a_found

/// Sets the linear range of a body. The deflection between two nodes is at most
/// (v1 + v2) / 2 + l / 8 (psi1 - psi2) in the middle: by the Cauchy-Schwarz inequality no more than
/// sqrt(1/2 + l^2/32) times the root of the sum of the squares.
void set_linear_range(double range, BodyData& data) {
  const FlexibleBody& body = *data.model->body;
  const double l = body.length / body.elements;
  data.linear_range = range * body.length;
  data.surely_linear = data.linear_range * data.linear_range / std::max(1.0, 0.5 + l * l / 32.0);
}

void allocate(const Subsystem& subsystem, int history, SubsystemData& data) {
  const std::size_t count = subsystem.bodies.size();
  Arena& arena = *data.arena;
  data.bodies = ArenaVector<BodyData>(count, arena);
  data.rotations = ArenaVector<Rotation>(count, arena);
  data.poses = ArenaVector<Pose>(count, arena);
  data.twists = ArenaVector<Twist>(count, Twist::Zero(), arena);
  data.joint_loads = ArenaVector<Twist>(count, Twist::Zero(), arena);
  data.wrenches = ArenaVector<HandleWrenches>(count, {Twist::Zero(), Twist::Zero()}, arena);
  std::size_t total = FlexLayout::kPad;
  for (std::size_t j = 0; j < count; ++j) {
    const FlexibleBody& body = *subsystem.bodies[j].body;
    data.bodies[j].model = &subsystem.bodies[j];
    data.bodies[j].layout = {body.axial(), body.bending()};
    for (int c = 0; c < kTwist; ++c) {
      data.bodies[j].inboard_at[c] = data.bodies[j].layout.offset(body.inboard.coordinate[c]);
      data.bodies[j].outboard_at[c] = data.bodies[j].layout.offset(body.outboard.coordinate[c]);
    }
    total += static_cast<std::size_t>(data.bodies[j].layout.stride() * (kFlexVectors + history));
  }
  data.storage = ArenaVector<double>(total, 0.0, arena);
  double* next = data.storage.data();
  for (BodyData& body : data.bodies) {
    const auto take = [&] { return std::exchange(next, next + body.layout.stride()); };
    body.coordinates.size = body.layout.size();
    body.coordinates.margin = FlexLayout::kPad;
    body.coordinates.gap_begin = body.layout.u_end();
    body.coordinates.gap_end = body.layout.v();
    body.coordinates.q = take();
    body.coordinates.v = take();
    body.coordinates.a = take();
    body.c_theta = take();
    body.Q_f = take();
    body.a_found = take();
    for (int k = 0; k < history; ++k) body.coordinates.history[k] = take();
    body.X.setZero();
    body.report = {};
  }
}

/// The sections at which loads act on a body.
template <class Load>
std::vector<PlacedLoad<Load>> place(const std::vector<Load>& loads, const BodyData& data) {
  std::vector<PlacedLoad<Load>> placed;
  for (const Load& load : loads) {
    placed.push_back({&load, {}});
    for (const LoadPoint& point : load.points) {
      Section section = make_section(*data.model->body, data.layout, point.element, point.s);
      section.x = point.x;
      placed.back().sections.push_back(section);
    }
  }
  return placed;
}

/// Whether drag on a body depends on where it is in the hub's frame.
bool has_drag_in_hub(const ChainBody& member) {
  return std::any_of(member.drags.begin(), member.drags.end(),
                     [](const BodyDrag& drag) { return drag.relative_to == DragFrame::hub; });
}

/// Points a subsystem to the progress and hub motion that it follows.
void follow_progress(std::size_t i, StepData& data, SubsystemData& subsystem) {
  subsystem.prescribed = {data.hub, Twist::Zero()};
  subsystem.progress = &data.progress[data.is_coupled ? 0 : i];
  subsystem.hub = data.is_coupled ? &data.hub : &subsystem.prescribed.state;
  subsystem.hub_acceleration =
      data.is_coupled ? &data.hub_solution.acceleration : &subsystem.prescribed.acceleration;
}

}  // namespace

void allocate(const System& system, const TableOptions& options, StepData& data) {
  data.hub_storage.fill(Twist::Zero());
  CoordinateBlock& hub = data.hub_coordinates;
  hub.size = kTwist;
  hub.q = data.hub_storage[0].data();
  hub.v = data.hub_storage[1].data();
  hub.a = data.hub_storage[2].data();
  for (int k = 0; k < options.history; ++k) hub.history[k] = data.hub_storage[3 + k].data();
  data.hub = {Position::Zero(), {}, Twist::Zero()};
  data.hub_solution = {Twist::Zero(), Twist::Zero(), 0.0, Twist::Zero(), 0.0};
  data.is_coupled = options.is_coupled;
  data.window = {};
  data.progress.assign(options.is_coupled ? 1 : system.subsystems.size(), StepProgress{});
  data.records.assign(static_cast<std::size_t>(options.window_steps), {});
  data.subsystems = std::vector<SubsystemData>(system.subsystems.size());
  data.arenas.clear();
  for (std::size_t i = 0; i < system.subsystems.size(); ++i) {
    SubsystemData& subsystem = data.subsystems[i];
    subsystem.arena = data.arenas.emplace_back(std::make_unique<Arena>()).get();
    allocate(system.subsystems[i], options.history, subsystem);
    for (BodyData& body : subsystem.bodies) {
      set_linear_range(options.linear_range, body);
      body.loads = place(body.model->loads, body);
      body.drags = place(body.model->drags, body);
    }
    const std::vector<ChainBody>& bodies = system.subsystems[i].bodies;
    if (std::any_of(bodies.begin(), bodies.end(), has_drag_in_hub))
      subsystem.drag_poses = ArenaVector<Pose>(bodies.size(), *subsystem.arena);
    follow_progress(i, data, subsystem);
    subsystem.samples = ArenaVector<SubsystemSample>(data.records.size(), *subsystem.arena);
    if (!options.is_coupled)
      subsystem.records = ArenaVector<StepRecord>(data.records.size(), *subsystem.arena);
  }
}

}  // namespace spoke
