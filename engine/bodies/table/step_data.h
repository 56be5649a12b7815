#pragma once

// Everything that changes during a step, as a table: one structure per producing node of the step
// graph. Any bits are a value of each member (see Flag), so that the graph can check declared
// accesses by memory.

#include <array>
#include <cassert>
#include <limits>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "engine/bodies/table/actor.h"
#include "engine/bodies/table/body_data.h"
#include "engine/bodies/table/control_data.h"
#include "engine/bodies/table/loop_data.h"
#include "engine/bodies/table/part_handles.h"
#include "engine/bodies/table/parts.h"
#include "engine/bodies/table/reading.h"
#include "engine/bodies/table/state_pair.h"
#include "engine/bodies/table/step_table.h"

namespace spoke {

/// A subsystem as the hub feels it, (P 10), in the hub frame.
template <class World>
struct EffectiveInertia {
  TwistMatrixOf<World> mass;                            ///< M^C
  TwistOf<World> force;                                 ///< Q^C
  typename BodyTypes<World>::HubStiffening stiffening;  ///< summed over the bodies
};

/// Hub motion at the evaluated state.
template <class World>
struct HubState {
  PositionOf<World> p;   ///< in the inertial frame [m]
  RotationOf<World> R;   ///< hub frame to inertial frame
  TwistOf<World> twist;  ///< velocity (resolved in the hub frame) and angular velocity
};

/// Hub of a rotor on a support at the end of a step, as SystemRecord has the hub.
template <class World>
struct RotorRecord {
  TwistOf<World> position = TwistOf<World>::Zero();
  TwistOf<World> velocity = TwistOf<World>::Zero();
  TwistOf<World> reaction = TwistOf<World>::Zero();  ///< wrench of the axle on the hub, hub frame
  double applied_torque = 0.0;
  [[no_unique_address]] typename BodyTypes<World>::RecordedRotation rotation;
};

/// A rotor on a support, see SupportedRotor: its hub, and what its subsystems add to it.
template <class World>
struct RotorData {
  HubState<World> hub;
  /// Acceleration of the hub by the last iterate, hub frame, less gravity; in implicit passes, and
  /// if the hub's origin moves as prescribed.
  TwistOf<World> acceleration = TwistOf<World>::Zero();
  DriveMotion turn;  ///< about the axle; its acceleration by the last iterate, if it is free
  typename BodyTypes<World>::CarriedInertia carried;
  std::vector<int> path{};  ///< bodies of the support from its base to the hub
  /// StepData::flight_acceleration in the frame of this hub.
  PositionOf<World> flight_acceleration = PositionOf<World>::Zero();
  std::vector<RotorRecord<World>> records{};  ///< ring by step
  RotorRecord<World> kept{}, evaluated{};     ///< as StepData has them of the system
};

/// Hub motion that support and drive prescribe.
template <class World>
struct PrescribedHub {
  HubState<World> state;
  TwistOf<World> acceleration;  ///< hub frame, less gravity: a - g (see solve_hub)
};

/// Result of (P 9).
template <class World>
struct HubSolution {
  TwistOf<World> acceleration;  ///< hub frame, less gravity: a - g (see solve_hub)
  /// Wrench of support and drive on the hub, hub frame [N, N m].
  TwistOf<World> reaction;
  double applied_torque;  ///< torque of the drive, where it gives one [N m]
  TwistOf<World> load;    ///< wrench of the loads on the hub, about its axis, hub frame [N, N m]
  double change;          ///< largest change of a free coordinate in this iteration [m, rad]
  double step_change;     ///< see PassReport; only in the first iteration of a step, else 0
  StepError error;        ///< only in the first iteration of a step, else 0
};

/// Sample of a subsystem at the end of a step, for the sensors.
template <class World>
struct SubsystemSample {
  PositionOf<World> tip = PositionOf<World>::Zero();  ///< displacement, hub frame [m]
  double kinetic = 0.0;                               ///< energy, stiffening term included [J]
  double strain = 0.0;                                ///< energy [J]
  /// Work of gravity since the undeformed start [J]; 0 for gravity that rises, whose work is that
  /// of loads.
  double gravity = 0.0;
  TwistOf<World> root = TwistOf<World>::Zero();  ///< see SubsystemData::root_load
};

/// Work and reaction of a subsystem, or of a coupled system, in a step.
template <class World>
struct ReactionRecord {
  StepRecord step;
  /// Wrench of support and drive on the hub at its end, hub frame [N, N m].
  TwistOf<World> reaction = TwistOf<World>::Zero();
};

/// The step as a whole: the sums over all subsystems, and the hub.
template <class World>
struct SystemRecord : ReactionRecord<World> {
  double applied_torque = 0.0;  ///< torque of the drive at the step's end, where it gives one [N m]
  /// Place of the hub, inertial frame: x, y [m], angle [rad].
  TwistOf<World> position = TwistOf<World>::Zero();
  TwistOf<World> velocity = TwistOf<World>::Zero();  ///< [m/s, rad/s]
  /// Rotation from the hub frame to the inertial frame; empty in the plane.
  [[no_unique_address]] typename BodyTypes<World>::RecordedRotation hub_rotation;
};

/// One subsystem's share of the table; vectors by body, parents before children.
template <class World>
struct alignas(kInterferenceSize) SubsystemData {
  using Types = BodyTypes<World>;
  Arena* arena = nullptr;  ///< memory of its arrays
  ArenaVector<BodyData<World>> bodies;
  /// From the parent's frame (that of the hub, where the hub carries the body) to the body's: R is
  /// R_PB.
  ArenaVector<typename BodyTypes<World>::JointMotion> joints;
  ArenaVector<TwistOf<World>> twists;  ///< body frames' twists, each in its body frame
  EffectiveInertia<World> effective;
  ArenaVector<typename Types::HandleWrenches> wrenches;
  ArenaVector<PoseOf<World>> poses;  ///< in the hub frame; for sensors, no part of a step
  ArenaVector<PoseOf<World>>
      drag_poses;  ///< poses during a step; empty unless drag depends on them
  /// Whether the bodies of all subsystems together have more memory than caches near a processor:
  /// then what is next is fetched ahead.
  bool outgrows_cache = false;
  ArenaVector<double> state;   ///< memory of all coordinates and their history
  ArenaVector<double> fields;  ///< memory of the bodies' fields that are no state
  std::vector<std::unique_ptr<StatePair>> delayed;  ///< states of actors, see add_states()
  std::vector<std::span<double>> saved;  ///< what saved states hold of actors, those among it
  /// By body, the sum of the forces that are applied to it and to all that it carries, as the joint
  /// that carries it hands it on, hub frame [N], and at the end that of all that is applied; empty
  /// unless a tension depends on them.
  ArenaVector<PositionOf<World>> applied_forces;
  /// Forces of the modes that damp its beams, modal_factors times the modes' velocities; empty if
  /// there are none.
  ArenaVector<double> modal_forces;
  LoopData<World> loops;
  ArenaVector<ControlState> controls;  ///< by Subsystem::controls
  /// StepData::flight_acceleration if the hub flies and its tension depends on it; else null.
  const PositionOf<World>* flight_acceleration = nullptr;

  int rotor = -1;                     ///< rotor on a support whose hub carries it; -1: none
  const DriveMotion* axle = nullptr;  ///< turn of that rotor's hub about its axle; null: none
  /// RotorData::acceleration of a rotor whose hub moves as prescribed; else null.
  const TwistOf<World>* moved_acceleration = nullptr;
  // Progress and hub that the subsystem's nodes follow: the system's if it is coupled, else its
  // own.
  StepProgress* progress = nullptr;
  const HubState<World>* hub = nullptr;
  const TwistOf<World>* hub_acceleration = nullptr;  ///< hub frame, less gravity

  PrescribedHub<World> prescribed;              ///< if not coupled
  ArenaVector<ReactionRecord<World>> records;   ///< ring by step, if not coupled
  ArenaVector<SubsystemSample<World>> samples;  ///< ring by step

  // Values at the end of the last step, by its last evaluation.
  /// Wrench of the subsystem on the hub, in the axes of its root bracket [N, N m]. In space: of all
  /// bodies on the hub, in H, about the origin of the first one.
  TwistOf<World> root_load = TwistOf<World>::Zero();
  ArenaVector<TwistOf<World>>
      joint_loads;  ///< on the inboard handle of each body, body frames [N, N m]

  // Sensors of the scenario's.
  std::vector<Reading<World>> readings;
  std::size_t reading_count = 0;     ///< values that the readings take
  ArenaVector<double> reading_ring;  ///< by step, reading_count each

  PartMaker part_maker;  ///< declares its parts
  SubsystemParts parts;
};

/// Returns what declares the parts of body j: "blade 1 / body 2 / terms".
template <class World>
PartMaker maker_of_body(std::size_t j, const SubsystemData<World>& data) {
  assert(j < data.bodies.size());
  return data.part_maker.of_body(static_cast<int>(j));
}

/// Adds states of an actor that follow the motion with a delay, `count` of them, in equilibrium.
template <class World>
StatePair& add_states(const std::string& name, std::size_t count, SubsystemData<World>& data) {
  StatePair& pair = *data.delayed.emplace_back(std::make_unique<StatePair>());
  pair.kept = ArenaVector<double>(count + 1, 0.0, *data.arena);
  pair.reached = ArenaVector<double>(count + 1, 0.0, *data.arena);
  pair.reached_part = data.part_maker.cover(name + " reached", Mark::none, pair.reached);
  pair.kept_part = data.part_maker.cover(name, Mark::state, pair.kept);
  data.saved.push_back(pair.kept);
  return pair;
}

/// Keeps the delayed states that the last evaluation has reached.
template <class World>
void keep_states(SubsystemData<World>& data) noexcept {
  for (const auto& pair : data.delayed) pair->keep();
}

/// Returns the values of the readings of a step in the ring.
template <class World>
double* readings_of(SubsystemData<World>& data, std::int64_t step) {
  assert(step >= 0 && !data.samples.empty());
  return data.reading_ring.data() +
         data.reading_count * (static_cast<std::size_t>(step) % data.samples.size());
}
template <class World>
const double* readings_of(const SubsystemData<World>& data, std::int64_t step) {
  return readings_of(const_cast<SubsystemData<World>&>(data), step);
}

/// Allocates the ring of the readings; their number must be known.
template <class World>
void place_reading_ring(SubsystemData<World>& data) {
  data.reading_ring =
      ArenaVector<double>(data.reading_count * data.samples.size(), 0.0, *data.arena);
  if (data.reading_count > 0)
    data.parts.readings = data.part_maker.ring("readings", data.reading_ring, data.reading_count);
}

template <class World>
class StepData final : public StepTable {
 public:
  HubState<World> hub;
  HubSolution<World> hub_solution;
  CoordinateBlock hub_coordinates;
  /// Memory of hub_coordinates: q, v, a and the integrator's history.
  std::array<TwistOf<World>, 3 + std::tuple_size_v<decltype(CoordinateBlock::history)>> hub_storage;
  /// State of the hub's orientation besides hub_coordinates; empty in the plane.
  typename BodyTypes<World>::Attitude hub_attitude;
  std::vector<RotorData<World>> rotors;        ///< rotors on supports; it must not move
  std::vector<std::unique_ptr<Arena>> arenas;  ///< by subsystem; they outlive what lies in them
  std::vector<SubsystemData<World>> subsystems;
  double length = 1.0;  ///< length of the model, by which errors of places are measured [m]
  std::vector<SystemRecord<World>> records;  ///< ring by step
  SystemRecord<World> evaluated;             ///< see take_evaluated_record()
  bool flies = false;                        ///< whether the hub's translation is free
  double mass = 0.0;                         ///< mass of hub and bodies [kg]
  bool has_hub_loads = false;                ///< whether forces act on the hub itself
  /// Acceleration that the applied forces give the mass centre of a hub that flies, hub frame
  /// [m/s^2].
  PositionOf<World> flight_acceleration = PositionOf<World>::Zero();
  SharedLoopData<World> shared_loops;                 ///< loops between subsystems
  std::vector<std::unique_ptr<Actor<World>>> actors;  ///< what acts on the bodies
  /// What subsystems and bodies are called; set before the table is allocated.
  std::shared_ptr<const graph::NodeNames> names =
      std::make_shared<const graph::NodeNames>(graph::NodeNames{"blade", {}, {}});
  Parts all_parts;    ///< of this table, in the order of their handles
  SystemParts parts;  ///< those of the system

  std::size_t ring_size() const override { return records.size(); }
  std::int64_t passes_of(std::size_t index, std::int64_t step) const override;
  std::int64_t most_passes_of(std::int64_t step) const override;
  void for_each_block(const std::function<void(CoordinateBlock&)>& apply) override;
  std::vector<std::span<std::byte>> state_memory() override;
  void take_state(std::int64_t step, std::vector<double>& values) override;
  void put_state(std::span<const double> values, std::int64_t step) override;
  void keep_record(std::int64_t step) override;
  void take_evaluated_record(std::int64_t step) override;
  void return_record(std::int64_t step) override;
  bool has_loads() const override;
  bool is_any_load_failed() const override;
  void clear_load_failures() override;

 private:
  SystemRecord<World> kept_;
};

/// Returns the parts by which actors act on body `j` of subsystem `i`.
template <class World>
PartList loads_on(std::size_t i, std::size_t j, const StepData<World>& data);
/// Returns the parts of actors that prescribed joints of subsystem `i` follow.
template <class World>
PartList courses_of(std::size_t i, const StepData<World>& data);

/// Options, besides the system, on which the table's size depends.
struct TableOptions {
  int history = 0;  ///< flex vectors per body that the integrator keeps
  /// Whether accelerations that a pass finds take the place of the integrator's at once.
  bool is_explicit = false;
  bool is_coupled = false;  ///< see StepData
  int window_steps = 1;     ///< steps between the first without a record and the last begun
  /// Deflections by the length of their body up to which linear elasticity holds.
  double linear_range = std::numeric_limits<double>::infinity();
};

/// Returns the bytes that the rings hold for one step, with `readings` values of the scenario's
/// sensors.
template <class World>
double ring_bytes(const System<World>& system, std::size_t readings) {
  return sizeof(SystemRecord<World>) + static_cast<double>(readings) * sizeof(double) +
         static_cast<double>(system.subsystems.size()) *
             (sizeof(ReactionRecord<World>) + sizeof(SubsystemSample<World>));
}

/// Allocates the table for a system, at rest and undeformed. Memory that depends on the method is
/// left to allocate(StepContext&). The system must outlive the data, which must not move.
template <class World>
void allocate(const System<World>& system, const TableOptions& options, StepData<World>& data);

/// Returns the record of a step in a ring.
template <class Ring>
auto& of_step(Ring& ring, std::int64_t step) {
  assert(step >= 0 && !ring.empty());
  return ring[static_cast<std::size_t>(step) % ring.size()];
}

/// Views a structure of doubles, or `count` of them in a row, as doubles.
template <class T>
std::span<double> doubles(T& first, std::size_t count = 1) {
  static_assert(sizeof(T) % sizeof(double) == 0);
  return {reinterpret_cast<double*>(&first), count * sizeof(T) / sizeof(double)};
}

}  // namespace spoke
