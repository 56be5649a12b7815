#pragma once

// The blades of a family, each where it is part of a subsystem: alone, or with those that loops tie
// to it.

#include <string>
#include <vector>

#include "engine/small_motions/vibration/mode_parts.h"
#include "engine/small_motions/vibration/multi_blade.h"

namespace spoke::vibration {

/// A range of entries.
struct Entries {
  Eigen::Index first = 0, count = 0;

  auto of(const auto& vector) const { return vector.segment(first, count); }
  bool has(Eigen::Index k) const { return first <= k && k < first + count; }
};

/// A blade of a family.
struct FamilyBlade {
  const steady::SteadyModel* model = nullptr;  ///< in which it is a subsystem of its own
  std::size_t own = 0;                         ///< its number there
  std::size_t subsystem = 0;                   ///< of all: the one that it is part of
  // Where it is in that one.
  Entries coordinates, independent, outputs;

  const std::string& name() const { return model->name_of(own); }
  double azimuth() const { return model->azimuth(own); }
};

/// Returns the blades of a family, in its order.
std::vector<FamilyBlade> list_blades(const BladeFamily& family, const Linearised& all);

/// Returns the independent coordinates of a blade, by names without that of the blade.
std::vector<steady::SubsystemCoordinate> list_independent(const FamilyBlade& blade,
                                                          const steady::LinearModel& linear);

}  // namespace spoke::vibration
