#pragma once

// The controllers of pitch joints as an actor: when they take samples, and of what speed. Their law
// is engine/bodies/kernels/pitch_control.h. Angles that are demanded from outside, between steps
// (engine/simulation/control_loop.h), have their states here, too, and no nodes.

#include "engine/bodies/table/step_data.h"

namespace spoke {

/// Each subsystem has states of its controllers of its own (SubsystemData::controls).
class PitchControllers final : public Actor<Space> {
 public:
  /// Puts the controllers of all subsystems on the table, at their start. System and table must
  /// outlive it.
  PitchControllers(const System<Space>& system, StepData<Space>& data);

  static bool acts(const System<Space>& system);
  static std::size_t count_values(const Subsystem<Space>& subsystem) {
    return kValues * subsystem.controls.size();
  }

  Stage stage() const override { return {"control", StageRole::given}; }
  /// In the first pass of a step the node reads the speed of the hub as the last step has left it:
  /// it stands before all nodes that change the hub's motion.
  void add_nodes(const PassNodes& pass, PassPlace place, int i) const override;
  void list_courses(int i, PartList& parts) const override;
  void list_shown(int i, PartList& parts) const override { list_courses(i, parts); }

  std::size_t count_values(std::size_t i) const override {
    return count_values(system_.subsystems[i]);
  }
  void keep_values(std::size_t i, double t, double* into) const noexcept override;
  std::vector<ActorColumn> columns(ColumnPlace place) const override;
  /// Those of the first controller of the first subsystem that has one: all are equal.
  void append_values(ColumnPlace place, std::int64_t step, std::span<const double* const> kept,
                     std::vector<double>& values) const override;

 private:
  /// Values of a controller, in the order of its columns: demand [rad], angle [rad], rate [rad/s].
  static constexpr std::size_t kValues = 3;

  PartList speed_inputs(int i) const;
  double hub_speed(std::size_t i, double t) const;
  void take_samples(std::size_t i, double h) const noexcept;

  const System<Space>& system_;
  StepData<Space>& data_;
  std::vector<graph::PartId> parts_;  ///< by subsystem; invalid: none
};

}  // namespace spoke
