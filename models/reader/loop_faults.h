#pragma once

// Rules for closed loops and anchors, in the plane and in space, for models from files and models
// filled in code.

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "models/reader/spatial/fault.h"
#include "models/scenario.h"

namespace spoke {

using spatial::Fault;

/// A body that may carry places of loops.
struct LoopBody {
  std::string_view name{};                      ///< empty: the blade
  std::optional<double> length = std::nullopt;  ///< of a beam [m]; none: it is rigid
  int parts = 1;                                ///< in the plane, bodies that the beam is cut into
  const spatial::SolidBody* solid = nullptr;    ///< null: it is none
};

/// What carries the bodies that loops are on.
enum class LoopBase {
  axle,       ///< a hub, whose axle the mount holds
  free,       ///< a free hub
  supported,  ///< a hub on a support
  ground,     ///< of a support, the ground, or the mount that moves in it
  fuselage,   ///< of a support that is free, the fuselage
};

/// What the loops of a blade or a subsystem may be fixed to. Valid as long as what it was made of.
struct LoopSurroundings {
  bool in_plane = false;
  LoopBase base = LoopBase::axle;
  const std::vector<Anchor>* anchors = nullptr;
  std::vector<LoopBody> bodies{};
  int rotor = 0;  ///< number of the rotor whose hub carries it

  bool is_blade() const { return bodies.size() == 1 && bodies.front().name.empty(); }
  bool is_support() const { return base == LoopBase::ground || base == LoopBase::fuselage; }
  /// Returns what files call the carrier `hub`: "hub", or what the support stands on.
  std::string_view base_name() const;
  /// Returns the body that carries a place; null if there is none of its name.
  const LoopBody* find(const LoopPlace& place) const;
};
LoopSurroundings surroundings_of(const Blade& blade, const Hub& hub,
                                 const std::vector<Anchor>& anchors);
LoopSurroundings surroundings_of(const spatial::Blade& blade, const spatial::Model& model);
LoopSurroundings surroundings_of(const spatial::Subsystem& subsystem, const spatial::Model& model);

/// Returns how many of the directions that a closure locks are displacements; they come first.
int count_locked_places(LoopKind kind, bool in_plane);
/// Returns the number of directions that a closure locks.
int count_locked(LoopKind kind, bool in_plane);

/// Finds a fault of the place of a loop.
Fault find_fault(const LoopPlace& place, const LoopSurroundings& around);
/// Finds the first fault of the loops of a blade or a subsystem, "loop.2.from.station".
Fault find_fault(const std::vector<Loop>& loops, const LoopSurroundings& around);

/// Finds a fault of an anchor. `before`: those that stand before it; `mount_fault`: of anchors of
/// the frame `mount`, empty if there may be some.
Fault find_fault(const Anchor& anchor, const std::vector<Anchor>& before,
                 const std::string& mount_fault, bool in_plane);
/// Finds an anchor of the frame `axle` where there is no support, or no drive that prescribes the
/// hub's angle.
Fault find_axle_frame_fault(const spatial::Model& model);
/// Returns what is wrong with anchors of the frame `mount`; empty if nothing is.
std::string find_mount_fault(HubSupport support);
std::string find_mount_fault(const spatial::Model& model);

/// Returns what is wrong with the spectral radius, a number in its range, where loops of the
/// scenario's model are rigid; empty if nothing is.
std::string find_radius_fault(const Integration& integration, const Scenario& scenario);

}  // namespace spoke
