#pragma once

// Operations of one evaluation of the accelerations, for blades alike in a clamped frame, without
// stiffening, damping and loads: the paper's model. Left out are the drive, the integrator's own
// arithmetic and checks.

#include <array>
#include <string_view>

#include "bench/reproduce/kernel_operations.h"
#include "engine/formulation/formulation.h"

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
  inverse,        ///< what stands for M_sub^-1: the factorisation, or the banded solves
  effective,      ///< effective mass and force with what they need of M_sub^-1
  hub,            ///< hub acceleration, or reaction
  accelerations,  ///< multipliers and accelerations of the blades
};
inline constexpr std::array kStages{Stage::kinematics, Stage::terms, Stage::inverse,
                                    Stage::effective,  Stage::hub,   Stage::accelerations};
std::string_view name_of(Stage stage);

/// Of all blades, one evaluation.
Operations count(Formulation formulation, Stage stage, const RotorSize& size = {});
/// The sum over the stages.
Operations count(Formulation formulation, const RotorSize& size = {});

}  // namespace spoke::reproduce
