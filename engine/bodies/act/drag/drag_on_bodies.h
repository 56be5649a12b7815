#pragma once

// Drag of bodies in the wind, as an actor: forces at places on beams and rigid bodies, by the
// wind's velocity against them.

#include <memory>
#include <vector>

#include "engine/bodies/table/step_data.h"
#include "engine/load.h"

namespace spoke {

class DragOnBodies final : public Actor<Space> {
 public:
  /// Puts drag on every subsystem that has some. System and table must outlive it.
  DragOnBodies(const System<Space>& system, StepData<Space>& data);

  static bool acts(const System<Space>& system);

  Stage stage() const override { return {"drag", StageRole::terms}; }
  void add_nodes(const PassNodes& pass, PassPlace place, int i) const override;
  void list_parts_on(int i, int j, PartList& parts) const override;

 private:
  /// Drag on a subsystem. Its markers are the stretches, then the blocks, in the order of bodies.
  struct Drag {
    std::vector<PlacedMarker<Space>> markers;
    std::vector<space::Position> areas;          ///< by marker: across a beam x is not in use [m^2]
    std::vector<bool> is_beam;                   ///< by marker
    ArenaVector<SectionWrench<Space>> wrenches;  ///< by marker
    graph::PartId part;                          ///< of the wrenches
    // Results of the kernel: rewritten at every evaluation, no part of the table.
    std::vector<MarkerMotion> motions;
    std::vector<space::HandleMotion> sections;
  };

  void place_on(std::size_t i, SubsystemData<Space>& own);
  void evaluate(std::size_t i, double t) const noexcept;

  const System<Space>& system_;
  StepData<Space>& data_;
  std::vector<std::unique_ptr<Drag>> subsystems_;  ///< null: it has none
};

}  // namespace spoke
