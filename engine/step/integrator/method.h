#pragma once

// The integrator of a simulation: one of the two methods.

#include <variant>

#include "engine/step/integrator/generalized_alpha.h"
#include "engine/step/integrator/rk4.h"

namespace spoke {

/// A time integration method with its coefficients.
using Method = std::variant<GeneralizedAlpha, Rk4>;

}  // namespace spoke
