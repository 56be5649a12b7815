#pragma once

// Springs of joints that relax, as an actor: each a spring and a damper in series (Maxwell) on a
// coordinate q. The force on the coordinate is -z with
//   z' = k q' - z/T,
// which is integrated exactly over a step in which q is linear.

#include <memory>
#include <vector>

#include "engine/bodies/table/step_data.h"

namespace spoke {

class RelaxingSprings final : public Actor<Space> {
 public:
  /// Puts the springs of all joints on the table, relaxed. System and table must outlive it.
  RelaxingSprings(const System<Space>& system, StepData<Space>& data);

  static bool acts(const System<Space>& system);

  Stage stage() const override { return {"relaxation", StageRole::terms}; }
  void add_nodes(const PassNodes& pass, PassPlace place, int i) const override;
  void list_parts_on(int i, int j, PartList& parts) const override;
  /// The energy that springs hold is shown with that of their joints.
  void list_shown(int i, PartList& parts) const override;
  void advance(std::size_t i, double elapsed) noexcept override;
  void list_relaxing(std::size_t i, std::vector<RelaxingState>& list) const override;

 private:
  struct Spring {
    std::size_t body = 0;  ///< carried by the joint
    space::RelaxingSpring law;
  };
  /// The springs of a subsystem. States: z [N m, N] and q [rad, m] of each.
  struct Springs {
    std::vector<Spring> springs;
    ArenaVector<space::JointEffort> efforts;  ///< by spring
    graph::PartId part;                       ///< of the efforts
    StatePair* states = nullptr;
  };

  double coordinate_of(std::size_t i, const Spring& spring) const noexcept;
  void evaluate(std::size_t i, double elapsed) const noexcept;

  const System<Space>& system_;
  StepData<Space>& data_;
  std::vector<std::unique_ptr<Springs>> subsystems_;  ///< null: it has none
};

}  // namespace spoke
