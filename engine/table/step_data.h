#pragma once

// Everything that changes during a step, as a table: one structure per producing node of the step
// graph. Any bits are a value of each member (see Flag), so that the graph can check declared
// accesses by memory.

#include <array>
#include <limits>
#include <memory>
#include <span>
#include <vector>

#include "engine/table/body_data.h"
#include "engine/table/reading.h"
#include "engine/table/step_table.h"

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
  /// Wrench of the support and drive on the hub, hub frame [N, N m].
  TwistOf<World> reaction;
  double applied_torque;  ///< of a torque drive [N m]
  TwistOf<World> load;    ///< of the loads on the hub, about its axis, hub frame [N, N m]
  double change;          ///< of a free coordinate in this iteration [m, rad]
  double step_change;     ///< see PassReport; of the first iteration of a step, else 0
  StepError error;        ///< of the first iteration of a step; else 0
};

/// What the sensors show of a subsystem at the end of a step.
template <class World>
struct SubsystemSample {
  PositionOf<World> tip = PositionOf<World>::Zero();  ///< displacement, hub frame [m]
  double kinetic = 0.0;                               ///< energy, stiffening term included [J]
  double strain = 0.0;                                ///< energy [J]
  /// Work of gravity since the undeformed start [J]; of gravity that rises 0: it is work of loads.
  double gravity = 0.0;
  TwistOf<World> root = TwistOf<World>::Zero();  ///< see SubsystemData::root_load
};

/// What a subsystem, or a coupled system, did in a step.
template <class World>
struct ReactionRecord {
  StepRecord step;
  /// Of the support and drive on the hub at its end, hub frame [N, N m].
  TwistOf<World> reaction = TwistOf<World>::Zero();
};

/// The step as a whole: what all subsystems did, and the hub.
template <class World>
struct SystemRecord : ReactionRecord<World> {
  double applied_torque = 0.0;  ///< of a torque drive at the step's end [N m]
  /// Of the hub, inertial frame: x, y [m], angle [rad].
  TwistOf<World> position = TwistOf<World>::Zero();
  TwistOf<World> velocity = TwistOf<World>::Zero();  ///< [m/s, rad/s]
  /// Hub frame to inertial frame, in space; in the plane nothing.
  [[no_unique_address]] typename BodyTypes<World>::RecordedRotation hub_rotation;
};

/// One subsystem's share of the table; vectors by body, parents before children.
template <class World>
struct alignas(kInterferenceSize) SubsystemData {
  using Types = BodyTypes<World>;
  Arena* arena = nullptr;  ///< of its arrays
  ArenaVector<BodyData<World>> bodies;
  /// From the parent's frame (that of the hub, where the hub carries the body) to the body's: R is
  /// R_PB.
  ArenaVector<typename BodyTypes<World>::JointMotion> joints;
  ArenaVector<TwistOf<World>> twists;  ///< of the body frames, in the body frames
  EffectiveInertia<World> effective;
  ArenaVector<typename Types::HandleWrenches> wrenches;
  ArenaVector<PoseOf<World>> poses;  ///< in the hub frame; for sensors, no part of a step
  ArenaVector<PoseOf<World>>
      drag_poses;                      ///< the same during a step; none unless drag depends on them
  ArenaVector<double> storage;         ///< of all flex vectors
  std::vector<LoadData<World>> loads;  ///< of the user's, whose first blade this is
  /// By body, the sum of the forces that are applied to it and to all that it carries, as the joint
  /// that carries it hands it on, hub frame [N], and at the end that of all that is applied; empty
  /// unless a tension depends on them.
  ArenaVector<PositionOf<World>> applied_forces;
  /// StepData::flight_acceleration if the hub flies and its tension depends on it; else null.
  const PositionOf<World>* flight_acceleration = nullptr;

  // What the subsystem's nodes follow: the system's if it is coupled, else its own.
  StepProgress* progress = nullptr;
  const HubState<World>* hub = nullptr;
  const TwistOf<World>* hub_acceleration = nullptr;  ///< hub frame, less gravity

  PrescribedHub<World> prescribed;              ///< if not coupled
  ArenaVector<ReactionRecord<World>> records;   ///< ring by step, if not coupled
  ArenaVector<SubsystemSample<World>> samples;  ///< ring by step

  // At the end of the last step, by its last evaluation.
  /// What the blade does to the hub, in the blade's axes [N, N m]. In space: what all bodies on the
  /// hub do, in H, about the origin of the first one.
  TwistOf<World> root_load = TwistOf<World>::Zero();
  ArenaVector<TwistOf<World>>
      joint_loads;  ///< on the inboard handle of each body, body frames [N, N m]

  // Sensors of the scenario's.
  std::vector<Reading<World>> readings;
  std::size_t reading_count = 0;     ///< values that they take
  ArenaVector<double> reading_ring;  ///< by step, reading_count each
};

/// Values of the readings of a step in the ring.
template <class World>
double* readings_of(SubsystemData<World>& data, std::int64_t step) {
  return data.reading_ring.data() +
         data.reading_count * (static_cast<std::size_t>(step) % data.samples.size());
}
template <class World>
const double* readings_of(const SubsystemData<World>& data, std::int64_t step) {
  return readings_of(const_cast<SubsystemData<World>&>(data), step);
}

template <class World>
class StepData final : public StepTable {
 public:
  HubState<World> hub;
  HubSolution<World> hub_solution;
  CoordinateBlock hub_coordinates;
  std::array<TwistOf<World>, 7> hub_storage;  ///< of hub_coordinates
  /// What the hub's orientation has besides hub_coordinates; nothing in the plane.
  typename BodyTypes<World>::Attitude hub_attitude;
  std::vector<std::unique_ptr<Arena>> arenas;  ///< by subsystem; they outlive what lies in them
  std::vector<SubsystemData<World>> subsystems;
  double length = 1.0;  ///< of the model, by which errors of places are measured [m]
  std::vector<SystemRecord<World>> records;  ///< ring by step
  SystemRecord<World> evaluated;             ///< see take_evaluated_record()
  bool flies = false;                        ///< whether the hub's translation is free
  double mass = 0.0;                         ///< of hub and bodies [kg]
  bool has_hub_loads = false;                ///< forces on the hub
  /// Of a hub that flies: what the applied forces accelerate the mass centre by, hub frame [m/s^2].
  PositionOf<World> flight_acceleration = PositionOf<World>::Zero();

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

/// What the table's size depends on besides the system.
struct TableOptions {
  int history = 0;          ///< flex vectors per body that the integrator keeps
  bool is_coupled = false;  ///< see StepData
  int window_steps = 1;     ///< steps between the first without a record and the last begun
  /// Deflections by the length of their body up to which linear elasticity holds.
  double linear_range = std::numeric_limits<double>::infinity();
};

/// What the rings hold of a step, `readings` values of sensors of the scenario's among it [bytes].
template <class World>
double ring_bytes(const System<World>& system, std::size_t readings) {
  return sizeof(SystemRecord<World>) + static_cast<double>(readings) * sizeof(double) +
         static_cast<double>(system.subsystems.size()) *
             (sizeof(ReactionRecord<World>) + sizeof(SubsystemSample<World>));
}

/// Allocates the table for a system, at rest and undeformed. What depends on the method is left to
/// allocate(StepContext&). The system must outlive the data, which must not move.
template <class World>
void allocate(const System<World>& system, const TableOptions& options, StepData<World>& data);

/// The record of a step in a ring.
template <class Ring>
auto& of_step(Ring& ring, std::int64_t step) {
  return ring[static_cast<std::size_t>(step) % ring.size()];
}

/// Memory of a structure of doubles, or of `count` of them in a row.
template <class T>
std::span<double> doubles(T& first, std::size_t count = 1) {
  static_assert(sizeof(T) % sizeof(double) == 0);
  return {reinterpret_cast<double*>(&first), count * sizeof(T) / sizeof(double)};
}

}  // namespace spoke
