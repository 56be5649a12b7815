#pragma once

// An actor of few lines, as one that somebody adds: drag that follows the velocity with a delay.

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>
#include <vector>

#include "engine/bodies/act/marker_parts.h"
#include "engine/bodies/act/user_load/load_markers.h"
#include "engine/bodies/kernels/applied_forces.h"
#include "engine/bodies/kernels/kinematics.h"
#include "engine/bodies/kernels/marker_motion.h"

namespace spoke::test {

/// A force -c w at the end of the first body of each subsystem, with T dw/dt = v - w from its
/// velocity v, both in the inertial frame.
class DelayedDrag final : public Actor<Space> {
 public:
  static constexpr double kDrag = 3.0;   ///< c [N s/m]
  static constexpr double kDelay = 0.1;  ///< T [s]

  DelayedDrag(const System<Space>& system, StepData<Space>& data) : system_(system), data_(data) {
    for (std::size_t i = 0; i < data.subsystems.size(); ++i) {
      SubsystemData<Space>& own = data.subsystems[i];
      auto at = std::make_unique<At>();
      at->marker = place_marker("the drag", {static_cast<int>(i), 0, 1.0}, data);
      at->wrench = ArenaVector<SectionWrench<Space>>(1, *own.arena);
      at->part = own.part_maker.cover("delayed drag", Mark::none, at->wrench);
      at->velocity = &add_states("delayed velocity", 3, own);
      own.bodies[0].applied.push_back({&at->marker.section, at->wrench.data()});
      places_.push_back(std::move(at));
    }
  }

  Stage stage() const override { return {"delayed drag", StageRole::terms}; }

  void add_nodes(const PassNodes& pass, PassPlace place, int i) const override {
    if (place != PassPlace::on_motion) return;
    At& at = *places_[static_cast<std::size_t>(i)];
    const StepProgress& progress = *data_.subsystems[static_cast<std::size_t>(i)].progress;
    pass.builder.add_node(
        pass.label(stage(), i),
        graph::reads(marker_inputs(data_, {i}, std::vector{at.marker}), at.velocity->kept_part),
        graph::writes(at.part, at.velocity->reached_part),
        unless_halted(progress, [this, &at, &progress, h = pass.step]() noexcept {
          const bool is_between = progress.control.is_between_steps();
          const double begin = static_cast<double>(progress.step - (is_between ? 0 : 1)) * h;
          evaluate(at, progress.control.time - begin);
        }));
  }

  void list_parts_on(int i, int j, PartList& parts) const override {
    if (j == 0) parts.push_back(places_[static_cast<std::size_t>(i)]->part);
  }

  void advance(std::size_t i, double elapsed) noexcept override { evaluate(*places_[i], elapsed); }

  void list_shown(int i, PartList& parts) const override {
    parts.push_back(places_[static_cast<std::size_t>(i)]->velocity->reached_part);
  }
  std::size_t count_values(std::size_t) const override { return 3; }
  void keep_values(std::size_t i, double /*t*/, double* into) const noexcept override {
    std::copy_n(places_[i]->velocity->reached.data(), 3, into);
  }
  std::vector<ActorColumn> columns(ColumnPlace place) const override {
    if (place != ColumnPlace::last) return {};
    return {{"drag.x", "N"}, {"drag.y", "N"}, {"drag.z", "N"}};
  }
  /// Sums over the subsystems.
  void append_values(ColumnPlace place, std::int64_t, std::span<const double* const> kept,
                     std::vector<double>& values) const override {
    if (place != ColumnPlace::last) return;
    for (std::size_t c = 0; c < 3; ++c) {
      double sum = 0.0;
      for (const double* const w : kept) sum -= kDrag * w[c];
      values.push_back(sum);
    }
  }

 private:
  struct At {
    PlacedMarker<Space> marker;
    ArenaVector<SectionWrench<Space>> wrench;
    graph::PartId part;
    StatePair* velocity = nullptr;
  };

  void evaluate(At& at, double elapsed) const noexcept {
    const auto i = static_cast<std::size_t>(at.marker.subsystem);
    const Subsystem<Space>& subsystem = system_.subsystems[i];
    const SubsystemData<Space>& own = data_.subsystems[i];
    const MarkerMotion motion = calc_load_motion(subsystem, own, at.marker);
    StatePair& states = *at.velocity;
    const double share = states.has_begun() ? -std::expm1(-elapsed / kDelay) : 1.0;
    space::Position w;
    for (int c = 0; c < space::kPosition; ++c) {
      const auto k = static_cast<std::size_t>(c);
      w[c] = states.kept[k] + share * (motion.velocity[c] - states.kept[k]);
      states.reached[k] = w[c];
    }
    states.reached.back() = 1.0;
    const space::Rotation R = own.hub->R * calc_rotation_to_hub(subsystem, own, 0);
    at.wrench[0] = {R.inverse() * space::Position(-kDrag * w), space::Angular::Zero()};
  }

  const System<Space>& system_;
  StepData<Space>& data_;
  std::vector<std::unique_ptr<At>> places_;  ///< by subsystem
};

/// Adds it to an allocated table.
inline void add_delayed_drag(SystemContext<Space>& context) {
  context.data.actors.push_back(std::make_unique<DelayedDrag>(context.system, context.data));
  place_applied_forces(context.data);
}

}  // namespace spoke::test
