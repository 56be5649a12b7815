#pragma once

// Operations of one evaluation of the accelerations for the paper's model: equal blades in a
// clamped frame, without stiffening, damping and loads. The drive, the integrator's own arithmetic
// and checks are left out.

#include <array>
#include <string_view>

#include "bench/reproduce/kernel_operations.h"
#include "engine/formulation.h"

namespace spoke::reproduce {

struct RotorSize {
  std::int64_t blades = 3;
  std::int64_t bodies = 4;    ///< per blade
  std::int64_t elements = 4;  ///< per body
};

/// The parts of an evaluation, as the paper's Table 2 divides it.
enum class Stage {
  kinematics,     ///< position and velocity analysis
  terms,          ///< mass, inertia and force
  inverse,        ///< the factorisation, or the banded solves, in place of M_sub^-1
  effective,      ///< effective mass and force with the products of M_sub^-1 that they need
  hub,            ///< hub acceleration, or reaction
  accelerations,  ///< multipliers and accelerations of the blades
};
inline constexpr std::array kStages{Stage::kinematics, Stage::terms, Stage::inverse,
                                    Stage::effective,  Stage::hub,   Stage::accelerations};
std::string_view name_of(Stage stage);

/// Returns the operations of a stage for all blades in one evaluation.
Operations count(Formulation formulation, Stage stage, const RotorSize& size = {});
/// Returns the sum over the stages.
Operations count(Formulation formulation, const RotorSize& size = {});

}  // namespace spoke::reproduce
