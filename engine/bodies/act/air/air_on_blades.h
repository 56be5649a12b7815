#pragma once

// Air on blades: an actor that places the stations of blades, hands their motion and the wind to
// the kernel (engine/bodies/air/), and its forces on to the bodies.

#include <memory>
#include <vector>

#include "engine/bodies/air/blade_air.h"
#include "engine/bodies/air/tower_flow.h"
#include "engine/bodies/table/step_data.h"

namespace spoke {

/// What air does to the hub of a rotor. Part of the table: doubles only.
struct AirSum {
  double thrust = 0.0;  ///< along the axis [N]
  double torque = 0.0;  ///< about the axis [N m]
  double wind = 0.0;    ///< wind at the hub against it, along the axis [m/s]
};

/// A tower that disturbs the wind of a blade: its markers are the points of its axis. Motions and
/// what follows from them are the kernel's, rewritten at every evaluation, no part of the table.
struct TowerBeside {
  const DragModel::Tower* model;
  std::vector<PlacedMarker<Space>> markers;
  std::vector<MarkerMotion> motions;
  std::vector<space::HandleMotion> sections;
  std::vector<air::TowerPoint> axis;
};

/// Air on a blade: its markers are the stations.
struct AirData {
  std::shared_ptr<const air::BladeAir> blade;
  std::vector<PlacedMarker<Space>> markers;
  ArenaVector<SectionWrench<Space>> wrenches;  ///< by marker
  ArenaVector<air::StationAir> stations;       ///< by marker: what the evaluation has found
  AirSum sum;                                  ///< over the stations
  StatePair* states = nullptr;                 ///< of inflow and stall
  graph::PartId part;                          ///< of wrenches, stations and sum
  // Arguments and results of the kernel: rewritten at every evaluation, no part of the table.
  std::vector<MarkerMotion> motions;
  std::vector<space::HandleMotion> sections;  ///< their motion against the frames of their bodies
  std::vector<Eigen::Vector3d> winds;
  std::vector<Wrench> forces;
  std::vector<TowerBeside> towers;
};

class AirOnBlades final : public Actor<Space> {
 public:
  /// Puts air on every subsystem of the table that has some, in equilibrium. System and table must
  /// outlive it.
  AirOnBlades(const System<Space>& system, StepData<Space>& data);

  static bool acts(const System<Space>& system);
  static std::size_t count_values(const Subsystem<Space>& subsystem);
  /// Returns what it has of subsystem `i`; null: no air acts there.
  const AirData* on(std::size_t i) const { return blades_[i].get(); }

  Stage stage() const override { return {"air", StageRole::terms}; }
  void add_nodes(const PassNodes& pass, PassPlace place, int i) const override;
  void list_parts_on(int i, int j, PartList& parts) const override;
  void list_shown(int i, PartList& parts) const override;
  void advance(std::size_t i, double elapsed) noexcept override;
  std::size_t count_values(std::size_t i) const override;
  void keep_values(std::size_t i, double t, double* into) const noexcept override;
  std::vector<ActorColumn> columns(ColumnPlace place) const override;
  /// Sums over the blades of each rotor.
  void append_values(ColumnPlace place, std::int64_t step, std::span<const double* const> kept,
                     std::vector<double>& values) const override;
  /// Linear between stations.
  std::optional<space::Twist> read(std::size_t i,
                                   const Reading<Space>& asked) const noexcept override;

 private:
  /// Evaluates the air on a subsystem at time `t` [s], `elapsed` [s] after its states were kept, at
  /// the kinematics in the table: sets its wrenches, and the states reached. iterates: an
  /// evaluation at this time precedes, whose induced velocities are kept.
  void evaluate(std::size_t i, double t, double elapsed, bool iterates) const noexcept;
  /// Adds to the winds of a blade's stations what towers do there.
  void disturb(AirData& own) const noexcept;

  const System<Space>& system_;
  StepData<Space>& data_;
  std::vector<std::unique_ptr<AirData>> blades_;  ///< by subsystem
  std::vector<int> rotors_;  ///< rotors whose blades are in air, as Subsystem::rotor has them
};

}  // namespace spoke
