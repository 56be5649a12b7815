#pragma once

// What the constants of a solid are computed from, whether its matrices come from a mesh or from
// another program.

#include <memory>
#include <optional>

#include "models/solid/constraints.h"
#include "models/solid/solid.h"
#include "models/solid/stiffening.h"

namespace spoke::solid {

struct SolidProblem {
  std::vector<space::Position> nodes;  ///< places in B at rest [m]
  NodeMatrices matrices;
  std::vector<HeldNodes> interfaces;  ///< points in B
  std::vector<HeldNodes> sets;        ///< points in B
  spatial::SolidCoordinates coordinates = spatial::SolidCoordinates::reduced;
  spatial::SolidFrame frame = spatial::SolidFrame::clamped;
  std::optional<int> modes{};
  std::optional<double> up_to{};  ///< [Hz]
  bool is_stiffened = true;
  // Stresses follow from mesh and material, or `stresses` has their geometric stiffness.
  std::shared_ptr<const spatial::SolidMesh> mesh;
  std::optional<spatial::SolidMaterial> material{};
  std::optional<StressMatrices> stresses{};
};

/// Computes the constants but damping and stress. Throws InputError as make_constants() does.
space::SolidConstants calc_constants(const SolidProblem& problem, const Control& control);

/// Writes damping ratios, one for all modes, one each, or none: 0. Throws InputError, its
/// place().key "damping", if there are as many as neither.
void set_damping(const std::vector<double>& ratios, space::SolidConstants& constants);

}  // namespace spoke::solid
